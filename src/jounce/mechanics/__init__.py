"""Symbolic authoring of mechanical systems: bodies, joints, loops, force elements -> equations of motion.

The names are those of ``__init__.pyi``; each is loaded on first use.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
