"""Interactive results and rigs in the cells of a notebook.

:func:`viewer` shows recordings, runs and sweeps with the viewer of the reports; :func:`live` draws a rig's response
anew whenever one of its numbers is moved (extra ``notebook``). Tables of results need neither.
"""

from __future__ import annotations

from jounce.core.old_names import with_old_names
from jounce.notebook.sliders import live
from jounce.notebook.viewing import EmbeddedPage, viewer

__all__ = ["EmbeddedPage", "live", "viewer"]
__getattr__ = with_old_names(__name__, {"Cell": "EmbeddedPage"})
