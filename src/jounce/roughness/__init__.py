"""Road roughness: spectra and classes of measured profiles, and the international roughness index."""
