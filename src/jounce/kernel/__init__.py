"""Expression graphs to machine code, and the integrators that run it: arrays in, arrays out.

- ``lowering``, ``packing``, ``native``: expression graphs become native functions; ``machine``: by LLVM, for this
  processor; ``cache``: kept on disk;
- ``engine``: inputs and outputs of a run; ``arrays``: memory layout of its arrays;
- ``methods``: ``explicit`` and ``implicit`` steps, ``exact`` propagation; ``poses``: a mechanism along given motions;
- ``loops``: the loops of these methods, compiled when jounce is built; ``call``: lookup and calls of that code.
"""

from __future__ import annotations

from jounce.core.sources import digest_of
from jounce.kernel.loops import SOURCES

# Before any module is loaded: `cache` keeps nothing that is made of modules edited since, and no loop is taken that is
# made of later ones.
digest_of("kernel")
digest_of(*SOURCES)
