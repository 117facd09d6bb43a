"""Measured and simulated signals: one schema, readers, quality checks, sensors, filters, alignment.

Names are loaded on first use, so that a process that only reads files starts at once; the one list of them is
``__init__.pyi``.
"""

from __future__ import annotations

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
