"""The workbench: a page in the browser over a folder of rigs, records and results, and the interface underneath it.

:func:`serve` opens it on this machine only. The page computes nothing: it asks an interface (``/openapi.json``) that
scripts may use, too, and that calls the functions and commands which everybody else calls.
"""

from __future__ import annotations

from jounce.web.serving import serve

__all__ = ["serve"]
