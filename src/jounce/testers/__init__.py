"""Simulated shock absorber testers: a rig on a plate, and the record that a tester writes."""
