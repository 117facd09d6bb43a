"""Rendering of pages as self-contained HTML, and atomic writing of a folder of files."""

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
    """Write a page into a folder, with optional separate figures: computed files first, then drawings.

    Parameters
    ----------
    page : Page or callable
        The page, or a function that returns it and is called once ``files`` are written.
    out : Path or str
        Output folder; created if it does not exist. A folder that is not empty requires ``force``.
    files : mapping of str to bytes or str
        Further files with results, path to content, in addition to those of a ``Page``.
    force : bool
        Replace files of the same names in an existing folder; other files are kept.
    figures : sequence of str
        Formats in which every figure is also written as ``figures/<name>.<format>``: ``"svg"``, ``"png"``.
    tables : sequence of str
        Formats in which the tables are also written: ``"csv"``, one file per table in the folder ``tables``;
        ``"xlsx"``, all in the workbook ``tables.xlsx``.
    pdf : bool
        Whether to also write the page as a PDF document of the same name.
    progress : callable
        Called with a one-line message at each stage.

    Returns
    -------
    list of Path
        ``report.html`` (self-contained), the page's further files, and the figures.

    Raises
    ------
    OutputError
        If the folder is not empty or cannot be written.
    DrawingError
        If figures or sections cannot be drawn; all other files have been written by then.

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
            except Exception as error:  # noqa: BLE001 - the page is written in any case
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
    """Return the further requested outputs of a page: their names, and functions that create the files."""
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
    """Draw all figures; return HTML by name, files by path, and the figures that could not be drawn."""
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
        except Exception as error:  # noqa: BLE001 - the other figures are still drawn
            missing.append(not_drawn(f"figure {picture.name}", error))
            continue
        inside[picture.name] = str(files.pop("page"))
        beside |= {f"figures/{picture.name}.{name}": content for name, content in files.items()}
    return inside, beside, missing


FIGURES = ("svg", "png")
"""Formats of separate figure files."""


def figures_here() -> tuple[str, ...]:
    """Return the formats of separate figure files that the installed packages support."""
    return FIGURES if find_spec(TYPESETTER[0]) else ("svg",)


def _files(picture: Picture | Chart, note: str, formats: Sequence[str]) -> dict[str, bytes | str]:
    """Render a figure as HTML (``page``) and in other formats."""
    identity = f"fig-{slug(picture.name)}"
    if isinstance(picture, Chart):
        files: dict[str, bytes | str] = {"page": chart_html(picture)}
        if formats:
            whole = chart_svg(picture, chart_style(), note)
            files |= {name: whole if name == "svg" else png_of(whole) for name in formats}
        return files
    suffixes = dict.fromkeys((".svg", *(f".{name}" for name in formats)))
    drawn = picture.draw(tuple(suffixes), note)
    page = inline_svg(drawn[".svg"], identity, picture.alternative)
    return {"page": page, **{name: drawn[f".{name}"] for name in formats}}


def _panels(picture: Picture | Chart) -> dict[str, bytes]:
    """Return the panels of a figure as SVG files for a document, in light colours only."""
    name = slug(picture.name)
    if isinstance(picture, Chart):
        last = picture.panels[-1].x_label  # on paper, panels are side by side
        panels = (replace(panel, x_label=panel.x_label or last) for panel in picture.panels)
        alone = (Chart((panel,), picture.name, "", picture.alternative) for panel in panels)
        return {
            f"{name}-{k}.svg": plain_colours(chart_svg(panel, chart_style())).encode()
            for k, panel in enumerate(alone)
        }
    return {f"{name}.svg": picture.draw((".svg",))[".svg"]}


def _write_html(page: Page, file: Path) -> None:
    inside, _, missing = _draw(page, (), lambda _text: None)
    file.write_text(page_html(page, inside), encoding="utf-8", newline="\n")
    if missing or page.missing:
        raise DrawingError([*page.missing, *missing])


def _write_pdf(page: Page, file: Path) -> None:
    panels = {picture.name: _panels(picture) for picture in page.pictures()}
    file.write_bytes(page_pdf(page, panels, (TEMPLATES / "page.typ").read_bytes()))


REPORTS = Formats("reports", {".html": _write_html, ".pdf": _write_pdf}, {".pdf": TYPESETTER})
"""Writers of a page as a single file: self-contained HTML, or PDF."""


def chart_html(chart: Chart) -> str:
    """Return the panels of a chart as SVG elements for a page."""
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
    """Render an SVG file as PNG at a scale, with the fonts of matplotlib for identical output on all systems."""
    source = '#set page(width: auto, height: auto, margin: 0pt)\n#image("figure.svg")\n'
    files = {"main.typ": source.encode(), "figure.svg": plain_colours(svg).encode()}
    (made,) = typeset(files, "png", ppi=96.0 * scale)
    return bytes(made)


def plain_colours(svg: str) -> str:
    """Substitute colours and line widths for CSS variables, which SVG renderers outside browsers do not support."""
    colours = dict(re.findall(r"--([\w-]+):\s*([^;}]+);", light_colours()))
    plain = re.sub(r"var\(--([\w-]+)\)", lambda match: colours[match[1]].strip(), svg)
    return plain.replace("</style>", f"{SCALED_CSS}</style>", 1)


def light_colours() -> str:
    """Return the colours of a light page as a CSS rule."""
    text = _css("colours")
    return text[: text.index("}") + 1]


def chart_style() -> str:
    """Return the style sheet of a standalone figure."""
    return light_colours() + CSS


def page_html(page: Page, figures: Mapping[str, str]) -> str:
    """Return the page as HTML with its available figures (name to HTML) and viewers."""

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
    """Fill an HTML template with its style sheet (of the same name), viewers and the common page script."""
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
            + (_css("blocks") if template == "page" else "")
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
    """Allow line breaks in a long name only after its word separators."""
    from markupsafe import Markup, escape

    return Markup(_JOINTS.sub(r"\1<wbr>", str(escape(text))))


_STYLE = re.compile(r"<style type=\"text/css\">.*?</style>", re.DOTALL)
_PIXELS_PER_POINT = 1.6  # on a wide screen: 9 pt text gets the size of the page's text
_FULL_WIDTH = 547.0  # points
_SIZE = re.compile(r' (?:width|height)="[\d.]+pt"')


def inline_svg(svg: bytes, name: str, alternative: str) -> str:
    """Convert a matplotlib SVG file into an ``<svg>`` element that scales with its HTML page.

    Every id inside the figure begins with ``name``; ``alternative`` is the text for screen readers.
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
    """Write all files into a folder, or none; with ``force``, the folder need not be empty.

    Parameters
    ----------
    out : Path or str
        Output folder; created if missing. With ``force``, files of the same names are replaced and others are kept.
    files : mapping of str to bytes or str
        Content by path within the folder.
    force : bool
        Write into a folder that is not empty.

    Returns
    -------
    list of Path
        The files, in the order given.

    Raises
    ------
    OutputError
        If the folder is not empty, is a file, or cannot be written; nothing is changed then.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp()) / "report"
    >>> [file.name for file in write_folder(folder, {"report.html": "<p>", "figures/one.svg": "<svg/>"})]
    ['report.html', 'one.svg']
    """
    return write_files(check_folder(out, force=force), files, force=force)


def curve_files(name: str, signals: xr.Dataset) -> tuple[tuple[str, bytes], ...]:
    """Return a recording as ``curves/<name>.csv`` and ``curves/<name>.nc``, path to content."""
    with working_folder() as folder:
        files = [write_recording(signals, folder / f"{name}{suffix}") for suffix in (".csv", ".nc")]
        return tuple((f"curves/{file.name}", file.read_bytes()) for file in files)
