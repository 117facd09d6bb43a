"""The workbench: a browser page for a folder of rigs, records and results, and its HTTP interface.

:func:`serve` opens it on this machine only. The page computes nothing: it uses an HTTP interface (``/openapi.json``)
that is also available to scripts and calls the same public functions and commands.
"""

from __future__ import annotations

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
