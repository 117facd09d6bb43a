"""Common style of all figures, and writing of figures to SVG, PNG and PDF: equal figures give equal bytes."""

from __future__ import annotations

import contextlib
import io
import logging
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec

from jounce.core.process_settings import PROCESS_SETTINGS, collect_warnings
from jounce.core.workbooks import CONTROL
from jounce.core.writing import Formats
from jounce.plots.display import raise_exponents

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.core.types import Array


P = ParamSpec("P")
_LOG = logging.getLogger("jounce")

INK, MUTED, GRID = "#22262b", "#666d75", "#e3e6ea"
MEASURED, BEFORE, AFTER = "#30353b", "#d98a1f", "#0067a8"
PALETTE = ("#0067a8", "#d55e00", "#00896b", "#a64d8f", "#b8860b", "#3fa0d8")
"""Line colours without a fixed meaning, distinguishable with any colour blindness (after Okabe and Ito)."""
GRADES = {"excellent": "#2b6ea3", "good": "#a9cce6", "fair": "#f3d79b", "poor": "#e39a7b"}
"""Fill of each ISO/TS 18571 grade: from blue to orange, which needs no distinction of red and green."""
VERDICTS = {
    "holds": "#2b6ea3",
    "holds partly": "#b7791f",
    "does not hold": "#b5472a",
    "not usable": "#737980",
}
WIDTH = 7.6
"""Width of a full figure in inches."""

_SETTINGS: dict[str, Any] = {
    "font.family": ["DejaVu Sans"],
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlepad": 6.0,
    "axes.titlecolor": INK,
    "axes.labelsize": 9.0,
    "axes.labelcolor": INK,
    "axes.edgecolor": "#9aa1a9",
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.use_mathtext": False,
    "axes.formatter.useoffset": False,
    "axes.unicode_minus": True,
    "text.parse_math": False,  # names are plain text, whatever characters they contain
    "axes.xmargin": 0.02,
    "axes.ymargin": 0.08,
    "grid.color": GRID,
    "grid.linewidth": 0.7,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "xtick.color": "#9aa1a9",
    "ytick.color": "#9aa1a9",
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "text.color": INK,
    "lines.linewidth": 1.3,
    "lines.solid_capstyle": "round",
    "legend.fontsize": 8.5,
    "legend.frameon": False,
    "legend.handlelength": 1.8,
    "legend.borderaxespad": 0.2,
    "figure.facecolor": "white",
    "figure.dpi": 100,
    "figure.constrained_layout.h_pad": 0.06,
    "figure.constrained_layout.w_pad": 0.06,
    "savefig.facecolor": "white",
    "path.simplify": True,
    "path.simplify_threshold": 0.2,  # of a point, a sixth of a line width: no visible detail is lost
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
}


def library() -> Any:
    """Import matplotlib even if MPLBACKEND names an unavailable GUI backend: jounce opens no windows."""
    with PROCESS_SETTINGS:
        asked = "" if "matplotlib" in sys.modules else os.environ.pop("MPLBACKEND", "")
        import matplotlib as mpl

        if asked:
            os.environ["MPLBACKEND"] = asked
            with contextlib.suppress(ValueError):
                mpl.rcParams["backend"] = asked
        return mpl


@contextmanager
def style() -> Iterator[None]:
    """Create and write figures in jounce's style: one thread at a time, because the style is process-wide."""
    mpl = library()
    settings: dict[Any, Any] = {**mpl.rcParamsDefault, **_SETTINGS}
    del settings[
        "backend"
    ]  # the user's setting, which a context would not restore; figures are drawn without one
    with PROCESS_SETTINGS, mpl.rc_context(settings):
        yield


def in_style(draw: Callable[P, Figure]) -> Callable[P, Figure]:
    """Decorate a drawing function to use jounce's style, independently of the user's settings."""

    @wraps(draw)
    def wrapper(*arguments: P.args, **options: P.kwargs) -> Figure:
        with style():
            return draw(*arguments, **options)

    return wrapper


def new_figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure with constrained layout; ``height`` and ``width`` are in inches."""
    return figure_type()(figsize=(width, height), layout="constrained")


@cache
def figure_type() -> type[Figure]:
    """Return the figure class; notebooks show it as it is written to files, once per cell, whatever their settings."""
    from matplotlib.figure import Figure

    class NotebookFigure(Figure):
        _shown_in: int | None = None

        def _ipython_display_(self) -> None:
            from IPython import get_ipython
            from IPython.display import SVG, display

            cell = getattr(get_ipython(), "execution_count", None)
            if cell is None or cell != self._shown_in:
                self._shown_in = cell
                display(SVG(render_figure(self, [".svg"])[".svg"].decode()))

    NotebookFigure.__name__ = NotebookFigure.__qualname__ = "Figure"
    return NotebookFigure


def log_axes(axes: Axes, which: str = "xy") -> None:
    """Set logarithmic scales with tick labels without markup: 0.1, 1, 10, and powers such as 10⁻⁴ beyond."""
    from matplotlib.ticker import LogFormatter

    class PlainPowers(LogFormatter):
        def __call__(self, x: float, pos: int | None = None) -> str:
            if not super().__call__(x, pos):  # a minor tick if there are enough major ones
                return ""
            text = f"{x:.4g}"
            mantissa, e, exponent = text.partition("e")
            power = str(int(exponent or 0)).translate(_SUPERSCRIPT)
            return (f"10{power}" if mantissa == "1" else f"{mantissa}·10{power}") if e else text

    for name in which:
        axes.set(**{f"{name}scale": "log"})
        axis = getattr(axes, f"{name}axis")
        axis.set_major_formatter(PlainPowers())
        axis.set_minor_formatter(PlainPowers(labelOnlyBase=False))


_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def legend_above(axes: Axes, columns: int = 4, handles: Sequence[Any] | None = None) -> None:
    """Put the legend above the axes, right-aligned in the title's line, where no curve can hide it."""
    shown = handles if handles is not None else axes.get_legend_handles_labels()[0]
    axes.legend(
        handles=shown,
        loc="lower right",
        bbox_to_anchor=(1.0, 1.0),
        ncols=columns,
        columnspacing=1.4,
    )


_BESIDE_TITLE = 0.55  # of a figure's width: maximum width of a legend next to the title


def legend_outside(
    figure: Figure, handles: Sequence[Any], labels: Sequence[str], columns: int
) -> None:
    """Put one legend of a figure above its axes, or below them if it would overlap the title; nothing is cut off.

    ``columns`` is the maximum number of columns.
    """
    texts = [at_tick(label, _LONGEST_LABEL) for label in labels]
    room = float(figure.get_size_inches()[0]) * figure.dpi

    def wide(count: int) -> float:
        legend = figure.legend(handles, texts, ncols=count)
        share = float(legend.get_window_extent().width) / room
        legend.remove()
        return share

    widths = {count: wide(count) for count in range(min(columns, len(texts)), 0, -1)}
    most = max(widths)
    if widths[most] <= _BESIDE_TITLE:
        figure.legend(handles, texts, loc="outside upper right", ncols=most)
        return
    fitting = next((count for count, share in widths.items() if share <= 1.0), 1)
    if widths[fitting] > 1.0:
        figure.set_size_inches(
            1.02 * widths[fitting] * room / figure.dpi, figure.get_size_inches()[1]
        )
    height = 0.19 * -(-len(texts) // fitting)  # inches added, which keeps the height of the axes
    figure.set_size_inches(figure.get_size_inches()[0], figure.get_size_inches()[1] + height)
    figure.legend(handles, texts, loc="outside lower right", ncols=fitting)


_LONGEST_LINE, _LONGEST_LABEL, _LONGEST_TICK = 120, 60, 40  # characters


def in_legend(name: str) -> str:
    """Convert a user's name to a visible label: matplotlib hides labels that begin with an underscore."""
    return f" {name}" if name.startswith("_") else name


def at_tick(name: str, most: int = _LONGEST_TICK) -> str:
    """Truncate a user's name to leave room for the drawing; accompanying tables show it in full."""
    return name if len(name) <= most else f"{name[: most - 1]}…"


def in_lines(name: str, most: int) -> str:
    r"""Break a name at dots and spaces into lines of at most ``most`` characters, if its parts are short enough.

    >>> in_lines("strut.damper.coefficient", 14), in_lines("max tyre.force", 14)
    ('strut.damper.\ncoefficient', 'max tyre.force')
    """
    lines = [""]
    for part in re.findall(r"[^. ]*[. ]?", at_tick(name)):
        if lines[-1] and len(lines[-1] + part.strip()) > most:
            lines.append("")
        lines[-1] += part
    return "\n".join(line.rstrip(" ") for line in lines)


def columns_of(count: int, most: int = 3) -> int:
    """Return the number of columns for a grid of ``count`` panels; four panels form a square.

    >>> [columns_of(count) for count in (1, 2, 3, 4, 5)]
    [1, 2, 3, 2, 3]
    """
    return 2 if count == 4 and most == 3 else min(most, count)


def _shorten(figure: Figure) -> None:
    """Truncate long labels that would leave no room for the axes."""
    from matplotlib.legend import Legend
    from matplotlib.text import Text

    for legend in figure.findobj(Legend):
        assert isinstance(legend, Legend)
        for text in legend.get_texts():
            text.set_text(at_tick(text.get_text(), _LONGEST_LABEL))
    for text in figure.findobj(Text):
        assert isinstance(text, Text)
        lines = CONTROL.sub(" ", text.get_text()).split("\n")
        text.set_text("\n".join(at_tick(line, _LONGEST_LINE) for line in lines))


def name_figure(figure: Figure, title: str) -> Figure:
    """Set the title of a figure unless it has one, and return the figure."""
    if title and not figure.get_suptitle():
        with style():
            figure.suptitle(raise_exponents(title), x=0.01, ha="left", fontsize=10)
    return figure


def add_note(figure: Figure, text: str) -> None:
    """Write a small note at the bottom of a figure, below everything else; an empty text changes nothing."""
    if not text:
        return
    engine = figure.get_layout_engine()
    share = 0.2 / float(figure.get_figheight())
    if engine is not None:
        engine.set(rect=(0.0, share, 1.0, 1.0 - share))  # type: ignore[call-arg]
    figure.text(
        0.995,
        0.05 / float(figure.get_figheight()),
        text,
        ha="right",
        va="bottom",
        fontsize=7.5,
        color="#a33f1f",
    )


def fill_cells(axes: Axes, values: Array, colours: Any) -> Any:
    """Fill a cell for each value from -1 to 1, first row on top, with vector areas, which dark pages can recolour."""
    rows, columns = values.shape
    edges = [i - 0.5 for i in range(columns + 1)], [i - 0.5 for i in range(rows + 1)]
    filled = axes.pcolormesh(
        *edges, values, cmap=colours, vmin=-1.0, vmax=1.0, linewidth=0.3, edgecolors="face"
    )
    axes.set_ylim(rows - 0.5, -0.5)
    axes.grid(visible=False)
    return filled


def limits(axes: Axes, low: float, high: float) -> None:
    """Set the limits of the horizontal axis in its display unit, unless they are empty."""
    if high > low:
        axes.set_xlim(low, high)


_DOTS_PER_INCH = 130


def write_figure(figure: Figure, path: Path | str, *, force: bool = False) -> Path:
    """Write a figure; the suffix chooses the format.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Figure from a function of :mod:`jounce.plots`.
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
        For an existing file without ``force``, a missing folder, or an unknown suffix.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> from jounce.plots import road_profile
    >>> figure = road_profile(jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"))
    >>> write_figure(figure, pathlib.Path(tempfile.mkdtemp()) / "road.svg").name
    'road.svg'
    """
    return FIGURES.write(figure, path, force=force)


def _write(figure: Figure, file: Path) -> None:
    suffix = file.suffix.lower()
    file.write_bytes(render_figure(figure, [suffix])[suffix])


FIGURES = Formats("figures", dict.fromkeys((".svg", ".png", ".pdf"), _write))


def render_figure(
    figure: Figure, suffixes: Sequence[str] = (".svg", ".png"), salt: str = "jounce"
) -> dict[str, bytes]:
    """Draw a figure once and return its bytes in several formats.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Its layout is computed once, which makes all formats look alike.
    suffixes : sequence of str
        Some of ``.svg``, ``.png``, ``.pdf``.
    salt : str
        Makes the identifiers in an SVG differ from those of other figures on the same page.

    Returns
    -------
    dict
        Suffix to content; the same figure gives the same bytes.
    """
    import matplotlib as mpl

    contents = {}
    with style(), _report_missing_glyphs():
        mpl.rcParams["svg.hashsalt"] = salt
        _shorten(figure)
        # the solved layout depends on its start, which is therefore restored for the next time
        before = [
            (axes, axes.get_position(original=True).frozen(), axes.get_in_layout())
            for axes in figure.axes
        ]
        lay_out(figure)
        engine = figure.get_layout_engine()
        figure.set_layout_engine("none")
        for axes in figure.axes:  # layouts are equal only up to rounding
            if axes.get_axes_locator() is None:
                axes.set_position(
                    tuple(round(x, 9) for x in axes.get_position(original=True).bounds),
                    which="original",
                )
                axes.apply_aspect()
                axes.set_in_layout(
                    True
                )  # a set position would exclude the axes from the next layout
        try:
            for suffix in suffixes:
                contents[suffix] = _content(figure, suffix)
        finally:
            figure.set_layout_engine(engine)
            for axes, place, is_in_layout in before:
                axes.set_position(place)
                axes.set_in_layout(is_in_layout)
    return contents


_GLYPH = re.compile(r"Glyph (\d+) .*missing from")


@contextmanager
def _report_missing_glyphs() -> Iterator[None]:
    """Log all characters missing from the font in one message, instead of one per character and drawing."""
    with collect_warnings() as caught:
        yield
    missing: set[str] = set()
    for warning in caught:
        match = _GLYPH.match(str(warning.message))
        if match:
            missing.add(chr(int(match[1])))
        else:
            warnings.warn_explicit(
                warning.message, warning.category, warning.filename, warning.lineno
            )
    if missing:
        _LOG.warning(
            "characters missing from the font of figures are drawn as boxes: %s",
            "".join(sorted(missing)),
        )


def lay_out(figure: Figure) -> None:
    """Solve the layout of a figure without drawing it; a full draw would take half as long again."""
    engine = figure.get_layout_engine()
    if engine is None:
        figure.draw_without_rendering()
        return
    for axes in figure.axes:
        if axes.get_axes_locator() is None:
            axes.apply_aspect()
    engine.execute(figure)


def _content(figure: Figure, suffix: str) -> bytes:
    """Draw in one format, only once; ``figure.savefig`` would draw everything twice."""
    stream = io.BytesIO()
    canvas, dots = figure.canvas, figure.dpi
    try:
        if suffix == ".svg":
            from matplotlib.backends.backend_svg import FigureCanvasSVG

            FigureCanvasSVG(figure).print_svg(stream, metadata={"Date": None, "Creator": None})  # type: ignore[no-untyped-call]
        elif suffix == ".pdf":  # takes half a second to import
            from matplotlib.backends.backend_pdf import FigureCanvasPdf

            undated = {"CreationDate": None, "Creator": None, "Producer": None}
            FigureCanvasPdf(figure).print_pdf(stream, metadata=undated)  # type: ignore[no-untyped-call]
        else:
            from matplotlib.backends.backend_agg import FigureCanvasAgg

            figure.set_dpi(_DOTS_PER_INCH)
            FigureCanvasAgg(figure).print_png(stream, metadata={"Software": None})  # type: ignore[no-untyped-call]
    finally:
        figure.set_dpi(dots)
        figure.set_canvas(canvas)
    return stream.getvalue()
