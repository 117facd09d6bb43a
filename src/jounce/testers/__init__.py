"""Simulated testers of shock absorbers: a rig on a plate, and the record that a tester writes."""
