"""The workbench: a page in the browser over a folder of rigs, records and results, and the interface underneath it.

:func:`serve` opens it on this machine only. The page computes nothing: it asks an interface (``/openapi.json``) that
scripts may use, too, and that calls the functions and commands which everybody else calls.
"""

from __future__ import annotations

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
