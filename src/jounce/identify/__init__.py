"""Numbers from measurements: stiffness, damping and damper laws with their uncertainty, and models updated."""
