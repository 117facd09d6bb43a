"""Interactive results and rigs in notebook cells.

:func:`viewer` shows recordings, runs and sweeps with the report viewer. :func:`live` recomputes a rig's response
whenever a slider is moved (extra ``notebook``). Tables of results need neither.
"""

from __future__ import annotations

from jounce.core.old_names import with_old_names
from jounce.notebook.sliders import live
from jounce.notebook.viewing import EmbeddedPage, viewer

__all__ = ["EmbeddedPage", "live", "viewer"]
__getattr__ = with_old_names(__name__, {"Cell": "EmbeddedPage"})
