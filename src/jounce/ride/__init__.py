"""Ride comfort, road holding, spectra and road roughness from measured or simulated signals."""
