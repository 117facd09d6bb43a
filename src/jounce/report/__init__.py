"""Documents: pages of text, tables and figures, each one HTML file with optional figure and data files.

:func:`write_campaign` reports a bench campaign, :func:`write_protocol` the test of a car's shock absorbers; any other
page is assembled from :class:`Page` and :class:`Section` and written by :func:`write_page`. No physical quantities
are computed here. The names are those of ``__init__.pyi``; each is loaded on first use.
"""

import lazy_loader

from jounce.core.old_names import with_old_names

_load, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__getattr__ = with_old_names(__name__, {"Table": "PageTable"}, _load)
