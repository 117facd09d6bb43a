"""Analyse measured records: statistics, spectra, transfer functions, modes, and motion from accelerations."""
