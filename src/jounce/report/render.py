"""A page into one self-contained HTML text and the files beside it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from jounce.core.errors import OutputError
from jounce.plots import add_note, rendered
from jounce.report.folder import check_folder, write_folder
from jounce.report.inline import inline_svg
from jounce.report.page import Findings, Page, Table, slug, unique_slugs, worst_first

_SEVERITIES = {"problem": "Problems", "warning": "Warnings", "note": "Notes"}
_MOST_PLACES = 6


def write_page(
    page: Page, out: Path | str, *, force: bool = False, progress: Callable[[str], None] = lambda _text: None
) -> list[Path]:
    """Write a page with its figures into a folder.

    Parameters
    ----------
    page : Page
        What is to be said.
    out : Path or str
        Folder; made where it is missing, refused when it holds something and ``force`` is not given.
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
        For a folder that is not empty, or cannot be written; two figures of the same name.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.report import Page, Paragraph, Section
    >>> page = Page("A run", (Section("What was done", (Paragraph("One obstacle was driven over."),)),))
    >>> [file.name for file in write_page(page, Path(tempfile.mkdtemp()) / "report")]
    ['report.html']
    """
    check_folder(out, force=force)
    figures = _draw(page, progress)
    progress("write: files")
    vectors = {name: formats[".svg"] for name, formats in figures.items()}
    files: dict[str, bytes | str] = {page.name: page_html(page, vectors), **dict(page.files)}
    for name, formats in figures.items():
        for suffix, content in formats.items():
            files[f"figures/{name}{suffix}"] = content
    return write_folder(out, files, force=force)


def _draw(page: Page, progress: Callable[[str], None]) -> dict[str, dict[str, bytes]]:
    found: dict[str, dict[str, bytes]] = {}
    pictures = page.pictures()
    for k, picture in enumerate(pictures, 1):
        if picture.name in found:
            raise OutputError("two figures have the same name", where=page.title, found=picture.name)
        progress(f"draw: figure {k} of {len(pictures)}")
        add_note(picture.figure, page.figure_note)
        found[picture.name] = rendered(picture.figure, (".svg", ".png"), salt=picture.name)
    return found


def page_html(page: Page, figures: Mapping[str, bytes]) -> str:
    """Give the page as HTML text with its figures (name to SVG) inside."""
    anchors = unique_slugs([section.title for section in page.sections])
    template = _environment().get_template("page.html.j2")
    text: str = template.render(
        page=page,
        sections=list(zip(anchors, page.sections, strict=True)),
        css=(_templates() / "page.css").read_text(encoding="utf-8"),
        svg=lambda picture: _safe(inline_svg(figures[picture.name], f"fig-{slug(picture.name)}", picture.alternative)),
    )
    return text


def _templates() -> Path:
    return Path(__file__).parent / "templates"


def _safe(text: str) -> Any:
    from markupsafe import Markup

    return Markup(text)


@cache
def _environment() -> Any:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(_templates()),
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
    """Group findings by severity, worst first; the same sentence about many places becomes one.

    Returns
    -------
    list of (severity, heading, list of (places, message))
        Only severities that occur.
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
