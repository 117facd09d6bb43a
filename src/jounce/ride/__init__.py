"""Ride comfort, road holding and spectra from measured or simulated signals; stationary responses, ride studies."""
