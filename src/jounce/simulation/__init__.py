"""Runs, equilibrium, linear models and modes of rigs.

The names are those of ``__init__.pyi``; each is loaded on first use.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
