"""Expression graphs to machine code, and the integrators that run it: arrays in, arrays out."""
