"""Expression graphs to machine code, and the integrators that run it: arrays in, arrays out.

- ``lowering``, ``packing``, ``native``: expression graphs become native functions, kept on disk;
- ``engine``: what a run is computed from and into; ``signals``: its inputs, samples and commands; ``events``;
- ``methods``: ``adaptive`` steps, ``explicit`` or ``implicit``, and ``exact`` propagation;
- ``poses``: a mechanism along prescribed motions; ``call``: how the loops are compiled.
"""
