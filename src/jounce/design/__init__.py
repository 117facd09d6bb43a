"""Design: springs, dampers and other numbers from what a rig shall do; adjustments; models made simpler."""
