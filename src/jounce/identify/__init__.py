"""Identify stiffness, damping and damper laws with their uncertainty, and update models, from measurements."""
