"""A page into one self-contained HTML text, and a folder of files written whole or not at all."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache
from html import escape
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from jounce.core.errors import DrawingError, OutputError
from jounce.core.findings import Finding, not_drawn
from jounce.core.writing import is_empty, working_folder, write_files
from jounce.plots import add_note, rendered
from jounce.recordings.files import write_recording
from jounce.report.page import Findings, Page, Table, slug, unique_slugs, worst_first

if TYPE_CHECKING:
    import xarray as xr


TEMPLATES = Path(__file__).parent / "templates"
_SEVERITIES = {"problem": "Problems", "warning": "Warnings", "note": "Notes"}
_MOST_PLACES = 6


def write_page(
    page: Page | Callable[[], Page],
    out: Path | str,
    *,
    files: Mapping[str, bytes | str] = MappingProxyType({}),
    force: bool = False,
    progress: Callable[[str], None] = lambda _text: None,
) -> list[Path]:
    """Write a page with its figures into a folder: what was computed first, then what is drawn.

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
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    list of Path
        ``report.html`` (one file that needs nothing else), the page's further files, and each figure as
        ``figures/<name>.svg`` and ``.png``.

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
    if computed:
        progress("write: results")
        name = page.name if isinstance(page, Page) else Page.name
        write_folder(out, {name: _NOT_YET, **computed}, force=force)
        force = True
    try:
        whole = page if isinstance(page, Page) else page()
        figures, missing = _draw(whole, progress)
        progress("write: files")
        vectors = {name: formats[".svg"] for name, formats in figures.items()}
        drawn: dict[str, bytes | str] = {whole.name: page_html(whole, vectors)}
        drawn |= {name: content for name, content in whole.files if name not in computed}
        for name, formats in figures.items():
            for suffix, content in formats.items():
                drawn[f"figures/{name}{suffix}"] = content
        written = write_folder(out, drawn, force=force)
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


def _draw(page: Page, progress: Callable[[str], None]) -> tuple[dict[str, dict[str, bytes]], list[Finding]]:
    found: dict[str, dict[str, bytes]] = {}
    missing: list[Finding] = []
    pictures = page.pictures()
    names = [picture.name for picture in pictures]
    for k, picture in enumerate(pictures, 1):
        if names.index(picture.name) < k - 1:
            raise OutputError("two figures have the same name", where=page.title, found=picture.name)
        progress(f"draw: figure {k} of {len(pictures)}")
        try:
            add_note(picture.figure, page.figure_note)
            found[picture.name] = rendered(picture.figure, (".svg", ".png"), salt=picture.name)
        except Exception as error:  # noqa: BLE001 - whatever it is, the other figures are drawn
            missing.append(not_drawn(f"figure {picture.name}", error))
    return found, missing


def page_html(page: Page, figures: Mapping[str, bytes]) -> str:
    """Give the page as HTML text with its figures (name to SVG) inside, those that there are."""
    anchors = unique_slugs([section.title for section in page.sections])
    return filled(
        "page",
        page=page,
        sections=list(zip(anchors, page.sections, strict=True)),
        svg=lambda picture: (
            inline_svg(figures[picture.name], f"fig-{slug(picture.name)}", picture.alternative)
            if picture.name in figures
            else f'<p class="bad">This figure could not be drawn: {escape(picture.alternative)}</p>'
        ),
    )


def filled(template: str, **content: Any) -> str:
    """Fill an HTML template, whose style sheet has the same name."""
    css = (TEMPLATES / f"{template}.css").read_text(encoding="utf-8")
    text: str = _environment().get_template(f"{template}.html.j2").render(css=css, **content)
    return text


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
    environment.filters["grouped"] = grouped
    environment.filters["alignments"] = alignments
    return environment


def alignments(table: Table) -> list[str]:
    """Name the alignment of each column: ``left``, ``right`` or ``centre``."""
    letters = table.align.ljust(len(table.header), "l")
    return [{"l": "left", "r": "right", "c": "centre"}[letter] for letter in letters]


def grouped(findings: Findings) -> list[tuple[str, str, list[tuple[str, str]]]]:
    """Group findings by severity, worst first: (severity, heading, (places, message) of each).

    The same sentence about many places becomes one.
    """
    messages: dict[tuple[str, str], list[str]] = {}
    ordered = worst_first(findings.items)
    for finding in ordered:
        places = messages.setdefault((finding.severity, finding.message), [])
        if finding.place not in places:
            places.append(finding.place)
    shown = list(messages.items())[: findings.most]
    result = []
    for severity, heading in _SEVERITIES.items():
        rows = [(_places(places), message) for (kind, message), places in shown if kind == severity]
        if rows:
            result.append((severity, heading, rows))
    return result


def _places(places: list[str]) -> str:
    more = f" and {len(places) - _MOST_PLACES} more" if len(places) > _MOST_PLACES else ""
    return ", ".join(places[:_MOST_PLACES]) + more


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


def check_folder(out: Path | str, *, force: bool = False) -> Path:
    """Refuse a folder that holds something (without ``force``) or a file of that name; give its resolved path."""
    folder = Path(out).expanduser().resolve()
    if folder.exists() and not folder.is_dir():
        raise OutputError("the output is a file, not a folder", where=str(folder), hint="Choose another name.")
    if folder.is_dir() and not force and not is_empty(folder):
        raise OutputError(
            "the output folder is not empty", where=str(folder), hint="Choose another name or allow it with --force."
        )
    return folder


def write_folder(out: Path | str, files: Mapping[str, bytes | str], *, force: bool = False) -> list[Path]:
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
