"""Figures of all results, in one style. They show values and never compute them.

``jn.plots.show(result)`` draws any result. Each function below draws one kind of result and returns a matplotlib
``Figure``, which :func:`write_figure` writes as SVG, PNG or PDF. The names are listed in ``__init__.pyi``; each is
loaded on first use.
"""

import lazy_loader

from jounce.core.old_names import with_old_names

_load, _, __all__ = lazy_loader.attach_stub(__name__, __file__)
__getattr__ = with_old_names(
    __name__,
    {"integrated": "integrated_motion", "rendered": "render_figure", "styled": "in_style"},
    _load,
)


def __dir__() -> list[str]:
    """List the functions that draw and write figures."""
    return [name for name in __all__ if name[0].islower()]
