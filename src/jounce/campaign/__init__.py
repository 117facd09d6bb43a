"""Bench campaigns: from a folder of measurements to an updated model with its evidence.

Names are loaded on first use, so that a list of files loads no fit; the one list of them is ``__init__.pyi``.
"""

from __future__ import annotations

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
