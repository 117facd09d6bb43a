"""Constants shared by several packages."""

GRAVITY = 9.81
"""Gravity, m/s^2; default of every description."""
NORMAL_95 = 1.959964
"""Half width of a 95 % interval in standard deviations (1), where the errors are normal."""
