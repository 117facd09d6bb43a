"""Limits, and what they say of values: bands, verdicts, reasons."""
