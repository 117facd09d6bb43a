"""The damper's workbench: maps of force over velocity and clicks from the records of a test rig (dyno)."""
