"""Kinematics and compliance: the tests of a laboratory, simulated and measured, and what differs between them."""
