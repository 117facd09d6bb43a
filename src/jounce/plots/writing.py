"""Figures into files: SVG, PNG and PDF, the same bytes for the same figure."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.core.serialise import check_writable, write_atomically
from jounce.plots.style import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SUFFIXES = (".svg", ".png", ".pdf")
_DOTS_PER_INCH = 130


def write_figure(figure: Figure, path: Path | str, *, force: bool = False) -> Path:
    """Write a figure; the suffix chooses the format.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        As the functions of :mod:`jounce.plots` give it.
    path : Path or str
        ``.svg`` (text stays text), ``.png`` (130 dots per inch) or ``.pdf``.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or another suffix.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> from jounce.plots import road_profile
    >>> figure = road_profile(jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"))
    >>> write_figure(figure, pathlib.Path(tempfile.mkdtemp()) / "road.svg").name
    'road.svg'
    """
    file = check_figure(path, force=force)
    suffix = file.suffix.lower()
    return write_atomically(file, rendered(figure, [suffix])[suffix], force=force)


def check_figure(path: Path | str, *, force: bool = False) -> Path:
    """Refuse, before the work, a file that no figure could be written to; give the path."""
    return check_writable(path, what="figures", suffixes=SUFFIXES, force=force)


def rendered(figure: Figure, suffixes: Sequence[str] = (".svg", ".png"), salt: str = "jounce") -> dict[str, bytes]:
    """Draw a figure once and give its bytes in several formats.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Its layout is computed once, so that all formats look alike.
    suffixes : sequence of str
        Some of ``.svg``, ``.png``, ``.pdf``.
    salt : str
        Makes the names inside an SVG differ from those of other figures on the same page.

    Returns
    -------
    dict
        Suffix to content; the same figure gives the same bytes.
    """
    import matplotlib as mpl

    found = {}
    with style():
        mpl.rcParams["svg.hashsalt"] = salt
        figure.draw_without_rendering()
        engine = figure.get_layout_engine()
        figure.set_layout_engine("none")
        try:
            for suffix in suffixes:
                found[suffix] = _content(figure, suffix)
        finally:
            figure.set_layout_engine(engine)
    return found


def _content(figure: Figure, suffix: str) -> bytes:
    """Draw once in one format; ``figure.savefig`` would draw everything twice."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    stream = io.BytesIO()
    canvas, dots = figure.canvas, figure.dpi
    try:
        if suffix == ".svg":
            FigureCanvasSVG(figure).print_svg(stream, metadata={"Date": None, "Creator": None})  # type: ignore[no-untyped-call]
        elif suffix == ".pdf":
            undated = {"CreationDate": None, "Creator": None, "Producer": None}
            FigureCanvasPdf(figure).print_pdf(stream, metadata=undated)  # type: ignore[no-untyped-call]
        else:
            figure.set_dpi(_DOTS_PER_INCH)
            FigureCanvasAgg(figure).print_png(stream, metadata={"Software": None})  # type: ignore[no-untyped-call]
    finally:
        figure.set_dpi(dots)
        figure.set_canvas(canvas)
    return stream.getvalue()
