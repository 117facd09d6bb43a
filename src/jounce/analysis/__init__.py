"""What a laboratory looks at first: statistics, spectra, transfer functions, modes and motion of measured records."""
