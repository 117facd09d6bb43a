"""Symbolic authoring of mechanical systems: bodies, joints, loops, force elements -> equations of motion.

The names are those of ``__init__.pyi``; each is loaded on first use.
"""

import lazy_loader

from jounce.core.old_names import with_old_names

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__getattr__ = with_old_names(__name__, {"Facts": "ModelFacts", "combined": "combine_solids"}, _load)
