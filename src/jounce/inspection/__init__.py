"""Shock-absorber inspection: records of testers, their evaluation and grading, the record store of a lane."""
