"""A page into one self-contained HTML text, and a folder of files written whole or not at all."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from hashlib import sha256
from html import escape
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from jounce.core.errors import OutputError, unknown
from jounce.core.findings import DrawingError, Finding, not_drawn
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.text import slug
from jounce.core.waiting import progress_through
from jounce.core.workbooks import CONTROL
from jounce.core.writing import Formats, check_folder, working_folder, write_files
from jounce.recordings.files import write_recording
from jounce.report.chart import CSS, SCALED_CSS, Chart, chart_svg, panel_svg
from jounce.report.document import TABLES, page_pdf, table_csv, tables_of, tables_xlsx
from jounce.report.live import Viewer, bundle, live_data
from jounce.report.page import Page, Picture, alignments, group_findings, unique_slugs
from jounce.report.typeset import TYPESETTER, typeset

if TYPE_CHECKING:
    import xarray as xr


TEMPLATES = Path(__file__).parent / "templates"


def write_page(
    page: Page | Callable[[], Page],
    out: Path | str,
    *,
    files: Mapping[str, bytes | str] = MappingProxyType({}),
    force: bool = False,
    figures: Sequence[str] = (),
    tables: Sequence[str] = (),
    pdf: bool = False,
    progress: Callable[[str], None] = lambda _text: None,
) -> list[Path]:
    """Write a page into a folder, with its figures beside it by wish: what was computed first, then what is drawn.

    Parameters
    ----------
    page : Page or callable
        What is to be said, or a function that gives it: it is called once ``files`` are on the disk.
    out : Path or str
        Folder; made where it is missing, refused when it holds something and ``force`` is not given.
    files : mapping of str to bytes or str
        Further files of what was computed, path and content, beside those of a ``Page``.
    force : bool
        Replace files of the same names in an existing folder; others stay.
    figures : sequence of str
        Formats in which every figure is also written as ``figures/<name>.<format>``: ``"svg"``, ``"png"``.
    tables : sequence of str
        Formats in which the tables are also written: ``"csv"``, one file each in the folder ``tables``; ``"xlsx"``,
        all of them in the workbook ``tables.xlsx``.
    pdf : bool
        Whether the page is also written as a PDF document of the same name.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    list of Path
        ``report.html`` (one file that needs nothing else), the page's further files, and the figures.

    Raises
    ------
    OutputError
        For a folder that is not empty, or cannot be written.
    DrawingError
        For pictures or sections that cannot be drawn; everything else is written by then.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.report import Page, Paragraph, Section
    >>> page = Page("A run", (Section("What was done", (Paragraph("One obstacle was driven over."),)),))
    >>> [file.name for file in write_page(page, Path(tempfile.mkdtemp()) / "report")]
    ['report.html']
    """
    computed = {**files, **(dict(page.files) if isinstance(page, Page) else {})}
    check_folder(out, force=force)
    for asked, known, what in ((figures, FIGURES, "figures"), (tables, TABLES, "tables")):
        for name in asked:
            if name not in known:
                raise unknown(name, known, what=f"format of {what}", where=what)
    if pdf or "png" in figures:
        require(*TYPESETTER)
    if computed:
        progress("write: results")
        first_name = page.name if isinstance(page, Page) else Page.name
        write_folder(out, {first_name: _NOT_YET, **computed}, force=force)
        force = True
    try:
        whole = page if isinstance(page, Page) else page()
        inside, beside, missing = _draw(whole, figures, progress)
        for name, make in _documents(whole, tables, pdf=pdf).items():
            progress(Phrase("write: {name}", name=name))
            try:
                beside |= make()
            except Exception as error:  # noqa: BLE001 - whatever it is, the page is written
                missing.append(not_drawn(name, error))
        progress("write: files")
        drawn: dict[str, bytes | str] = {whole.name: page_html(whole, inside)}
        drawn |= {name: content for name, content in whole.files if name not in computed}
        written = write_folder(out, drawn | beside, force=force)
    except Exception as error:
        raise DrawingError([not_drawn("report", error)]) from error
    if whole.missing or missing:
        raise DrawingError([*whole.missing, *missing])
    first, *others = written
    return [first, *(Path(out) / name for name in computed), *others]


_NOT_YET = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Not drawn yet</title>
<p>What was computed is in the files beside this page. The page is drawn after them: where you read this, it is being
drawn, or it could not be.</p></html>
"""


def _documents(
    page: Page, tables: Sequence[str], *, pdf: bool
) -> dict[str, Callable[[], Mapping[str, bytes | str]]]:
    """Give what else a page is written as by wish: what it is, and how its files are made."""
    wanted: dict[str, Callable[[], Mapping[str, bytes | str]]] = {}
    if "csv" in tables:
        wanted["tables as CSV"] = lambda: {
            f"tables/{k}.csv": table_csv(table) for k, table in tables_of(page).items()
        }
    if "xlsx" in tables:
        wanted["workbook"] = lambda: {"tables.xlsx": tables_xlsx(page)}
    if pdf:
        template = (TEMPLATES / "page.typ").read_bytes()
        name = str(Path(page.name).with_suffix(".pdf"))
        wanted["PDF"] = lambda: {
            name: page_pdf(
                page, {picture.name: _panels(picture) for picture in page.pictures()}, template
            )
        }
    return wanted


def _draw(
    page: Page, formats: Sequence[str], progress: Callable[[str], None]
) -> tuple[dict[str, str], dict[str, bytes | str], list[Finding]]:
    """Draw all figures: as HTML by name, as files by path, and which could not be drawn."""
    inside: dict[str, str] = {}
    beside: dict[str, bytes | str] = {}
    missing: list[Finding] = []
    pictures = page.pictures()
    names = [picture.name for picture in pictures]
    for k, picture in enumerate(pictures, 1):
        if names.index(picture.name) < k - 1:
            raise OutputError(
                "two figures have the same name", where=page.title, found=picture.name
            )
        progress(progress_through("draw: figure {which} of {count}", k, len(pictures)))
        try:
            files = _files(picture, page.figure_note, formats)
        except Exception as error:  # noqa: BLE001 - whatever it is, the other figures are drawn
            missing.append(not_drawn(f"figure {picture.name}", error))
            continue
        inside[picture.name] = str(files.pop("page"))
        beside |= {f"figures/{picture.name}.{name}": content for name, content in files.items()}
    return inside, beside, missing


FIGURES = ("svg", "png")
"""Formats of figures beside a page."""


def figures_here() -> tuple[str, ...]:
    """Formats of figures beside a page that can be written with what is installed."""
    return FIGURES if find_spec(TYPESETTER[0]) else ("svg",)


def _files(picture: Picture | Chart, note: str, formats: Sequence[str]) -> dict[str, bytes | str]:
    """Figure of a page as HTML (``page``) and in other formats."""
    identity = f"fig-{slug(picture.name)}"
    if isinstance(picture, Chart):
        files: dict[str, bytes | str] = {"page": chart_html(picture)}
        if formats:
            whole = chart_svg(picture, chart_style(), note)
            files |= {name: whole if name == "svg" else png_of(whole) for name in formats}
        return files
    from jounce.plots.figures import add_note, render_figure

    figure = picture.figure
    add_note(figure, note)
    suffixes = dict.fromkeys((".svg", *(f".{name}" for name in formats)))
    drawn = render_figure(figure, tuple(suffixes), salt=picture.name)
    page = inline_svg(drawn[".svg"], identity, picture.alternative)
    return {"page": page, **{name: drawn[f".{name}"] for name in formats}}


def _panels(picture: Picture | Chart) -> dict[str, bytes]:
    """Give the panels of a figure as SVG files for a document, which knows light colours only."""
    name = slug(picture.name)
    if isinstance(picture, Chart):
        last = picture.panels[-1].x_label  # on paper panels stand side by side
        panels = (replace(panel, x_label=panel.x_label or last) for panel in picture.panels)
        alone = (Chart((panel,), picture.name, "", picture.alternative) for panel in panels)
        return {
            f"{name}-{k}.svg": plain_colours(chart_svg(panel, chart_style())).encode()
            for k, panel in enumerate(alone)
        }
    from jounce.plots.figures import render_figure

    return {f"{name}.svg": render_figure(picture.figure, (".svg",), salt=picture.name)[".svg"]}


def _write_html(page: Page, file: Path) -> None:
    inside, _, missing = _draw(page, (), lambda _text: None)
    file.write_text(page_html(page, inside), encoding="utf-8", newline="\n")
    if missing or page.missing:
        raise DrawingError([*page.missing, *missing])


def _write_pdf(page: Page, file: Path) -> None:
    panels = {picture.name: _panels(picture) for picture in page.pictures()}
    file.write_bytes(page_pdf(page, panels, (TEMPLATES / "page.typ").read_bytes()))


REPORTS = Formats("reports", {".html": _write_html, ".pdf": _write_pdf}, {".pdf": TYPESETTER})
"""How a page is written as one file: one HTML file that needs nothing else, or PDF."""


def chart_html(chart: Chart) -> str:
    """Give the panels of a chart as SVG elements for a page."""
    identity = f"fig-{slug(chart.name)}"
    return "\n".join(
        panel_svg(
            panel,
            f"{identity}-{k}",
            chart.alternative if k == 0 else panel.title or panel.x_label or "panel",
        )
        for k, panel in enumerate(chart.panels)
    )


def png_of(svg: str, scale: float = 2.0) -> bytes:
    """Draw an SVG file as PNG, enlarged by a scale, with the fonts of matplotlib: the same everywhere."""
    source = '#set page(width: auto, height: auto, margin: 0pt)\n#image("figure.svg")\n'
    files = {"main.typ": source.encode(), "figure.svg": plain_colours(svg).encode()}
    (made,) = typeset(files, "png", ppi=96.0 * scale)
    return bytes(made)


def plain_colours(svg: str) -> str:
    """Write colours and widths of lines as they are: what draws SVG outside browsers knows no variables."""
    colours = dict(re.findall(r"--([\w-]+):\s*([^;}]+);", light_colours()))
    plain = re.sub(r"var\(--([\w-]+)\)", lambda match: colours[match[1]].strip(), svg)
    return plain.replace("</style>", f"{SCALED_CSS}</style>", 1)


def light_colours() -> str:
    """Colours of a light page as a rule of a style sheet."""
    text = _css("colours")
    return text[: text.index("}") + 1]


def chart_style() -> str:
    """Style sheet of a figure that stands by itself."""
    return light_colours() + CSS


def page_html(page: Page, figures: Mapping[str, str]) -> str:
    """Give the page as HTML text with its figures (name to HTML) and viewers inside, those that there are."""

    def figure_html(picture: Picture | Chart) -> str:
        if picture.name in figures:
            return figures[picture.name]
        return f'<p class="bad">This figure could not be drawn: {escape(picture.alternative)}</p>'

    anchors = unique_slugs([section.title for section in page.sections])
    return fill_template(
        "page",
        page.viewers(),
        page=page,
        sections=list(zip(anchors, page.sections, strict=True)),
        svg=figure_html,
        chart=figure_html,
    )


def fill_template(template: str, viewers: Sequence[Viewer], **content: Any) -> str:
    """Fill an HTML template, whose style sheet has the same name, with its viewers and the script of all pages."""
    script = bundle("viewer.js" if viewers else "page.js")
    data = (
        json.dumps(live_data(viewers), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
        if viewers
        else ""
    )
    text: str = (
        _environment()
        .get_template(f"{template}.html.j2")
        .render(
            css=_css("colours")
            + _css("figures")
            + _css(template)
            + CSS
            + (bundle("viewer.css") if viewers else ""),
            viewers=viewers,
            data=data.replace("<", "\\u003c"),
            script=script,
            script_hash=base64.b64encode(sha256(script.encode()).digest()).decode(),
            **content,
        )
    )
    return CONTROL.sub(" ", text)


@cache
def _css(name: str) -> str:
    return (TEMPLATES / f"{name}.css").read_text(encoding="utf-8")


@cache
def _environment() -> Any:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["kind"] = lambda block: type(block).__name__
    environment.filters["grouped"] = group_findings
    environment.filters["alignments"] = alignments
    environment.filters["parted"] = with_break_points
    return environment


_JOINTS = re.compile(r"(?<=[^\W\d_]{2})([._])(?=[^\W_]{2})")


def with_break_points(text: str) -> Any:
    """Let a long name break behind the joints between its words, so that a narrow column breaks it nowhere else."""
    from markupsafe import Markup, escape

    return Markup(_JOINTS.sub(r"\1<wbr>", str(escape(text))))


_STYLE = re.compile(r"<style type=\"text/css\">.*?</style>", re.DOTALL)
_PIXELS_PER_POINT = 1.6  # on a wide screen: text of 9 pt becomes as large as that of the page
_FULL_WIDTH = 547.0  # points
_SIZE = re.compile(r' (?:width|height)="[\d.]+pt"')


def inline_svg(svg: bytes, name: str, alternative: str) -> str:
    """Make an SVG file of matplotlib one ``<svg>`` element that scales with its HTML page.

    Every name inside the figure begins with ``name``; ``alternative`` is for readers who cannot see.
    """
    text = svg.decode()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = _STYLE.sub("", text)
    text = re.sub(r'\bid="([^"]+)"', rf'id="{name}-\1"', text)
    text = re.sub(r"url\(#([^)]+)\)", rf"url(#{name}-\1)", text)
    text = re.sub(r'xlink:href="#([^"]+)"', rf'href="#{name}-\1"', text)
    head, _, body = text.partition(">")
    width = re.search(r' width="([\d.]+)pt"', head)
    limit = ""
    if width is not None:
        points = float(width[1])
        share = min(points / _FULL_WIDTH, 1.0)
        limit = f' style="max-width: {_PIXELS_PER_POINT * points:.0f}px; --share: {share:.2f}"'
    head = _SIZE.sub("", head).replace(' version="1.1"', "")
    head = re.sub(r' xmlns:xlink="[^"]+"', "", head)
    label = f'role="img" aria-labelledby="{name}-title"'
    return f'{head} {label}{limit}><title id="{name}-title">{escape(alternative)}</title>{body}'.strip()


def write_folder(
    out: Path | str, files: Mapping[str, bytes | str], *, force: bool = False
) -> list[Path]:
    """Write files into a folder that is empty or, with ``force``, keeps what else it holds: all of them, or none.

    Parameters
    ----------
    out : Path or str
        Folder; made where it is missing. With ``force``, files of the same names in it are replaced, others stay.
    files : mapping of str to bytes or str
        Path within the folder to content.
    force : bool
        Write into a folder that is not empty.

    Returns
    -------
    list of Path
        The files, in the order given.

    Raises
    ------
    OutputError
        For a folder that is not empty, a file in its place, or a disk that refuses; nothing is changed then.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp()) / "report"
    >>> [file.name for file in write_folder(folder, {"report.html": "<p>", "figures/one.svg": "<svg/>"})]
    ['report.html', 'one.svg']
    """
    return write_files(check_folder(out, force=force), files, force=force)


def curve_files(name: str, signals: xr.Dataset) -> tuple[tuple[str, bytes], ...]:
    """Give a recording as ``curves/<name>.csv`` and ``curves/<name>.nc``, path and content each."""
    with working_folder() as folder:
        files = [write_recording(signals, folder / f"{name}{suffix}") for suffix in (".csv", ".nc")]
        return tuple((f"curves/{file.name}", file.read_bytes()) for file in files)
