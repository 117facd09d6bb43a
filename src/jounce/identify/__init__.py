"""Numbers from measurements: stiffness, damping and damper laws with their uncertainty, and the bench itself."""
