"""Test protocols of shock absorbers: one page as PDF or HTML, and the same as JSON beside it."""

from __future__ import annotations

import datetime
import json
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.errors import unknown
from jounce.core.serialise import check_writable, to_json, to_plain, write_atomically
from jounce.inspection.grading import GradedInspection, VehicleGrade, grade_vehicle
from jounce.inspection.quantities import LANGUAGES, Language
from jounce.inspection.record import day_of
from jounce.plots import rendered
from jounce.plots.inspection import inspection_curves
from jounce.report.inline import inline_svg
from jounce.report.protocol_content import SAID, protocol_content

if TYPE_CHECKING:
    import xarray as xr

SCHEMA = "jounce.protocol/1"
SUFFIXES = (".pdf", ".html")
_MOST = 24  # reasons and remarks
_COUNTING = 8.0  # dots per inch suffice to count pages
_LONGEST_WORD, _PIECE = 24, 12
_HEIGHTS = {1: 3.2, 2: 1.75}  # inches of the curves of one axle


def write_protocol(
    graded: VehicleGrade | GradedInspection,
    path: Path | str,
    *,
    records: Mapping[str, xr.Dataset] | None = None,
    language: Language = "en",
    about: Mapping[str, str] | None = None,
    force: bool = False,
) -> list[Path]:
    """Write the protocol of a test.

    Parameters
    ----------
    graded : VehicleGrade or GradedInspection
        One or two axles.
    path : Path or str
        ``.pdf`` or ``.html``.
    records : mapping of str to xarray.Dataset, optional
        Records by axle (``"front"``, ``"rear"``, or ``""`` where it is not known), for the force over time.
    language : {"en", "de"}
        Of the page.
    about : mapping of str to str, optional
        ``vehicle``, ``plate_number``, ``date``, ``tester``, ``place``, ``operator``, ``comment``, ``record``; by
        default what the records say.
    force : bool
        Overwrite what exists.

    Returns
    -------
    list of Path
        The page, and the JSON file of the same name beside it with all values.

    Raises
    ------
    OutputError
        For another suffix, an existing file without ``force``, or a missing folder; nothing is written then.
    DescriptionError
        For an unknown language.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.inspection import Inspection, WheelResult
    >>> from jounce.inspection.grading import grade
    >>> wheels = [WheelResult(side, static_load=4e3, phase_angle_min_deg=51.0) for side in ("left", "right")]
    >>> graded = grade(Inspection(tuple(wheels), methods=("egea",)))
    >>> [file.name for file in write_protocol(graded, tempfile.mkdtemp() + "/car.html", about={"vehicle": "A6"})]
    ['car.html', 'car.json']
    """
    file = check_protocol(path, force=force)
    vehicle = graded if isinstance(graded, VehicleGrade) else grade_vehicle([graded])
    said = {**facts_of(vehicle), **(about or {})}
    make = protocol_pdf if file.suffix.lower() == ".pdf" else protocol_html
    page = make(vehicle, records=records, language=language, about=said)
    data = to_json(protocol_data(vehicle, said))
    beside = file.with_suffix(".json")
    return [write_atomically(file, page, force=force), write_atomically(beside, f"{data}\n", force=True)]


def check_protocol(path: Path | str, *, force: bool = False) -> Path:
    """Refuse, before the work, a protocol that could not be written after it; give its path.

    Raises
    ------
    OutputError
        For a wrong suffix, an existing page or JSON file beside it without ``force``, a missing folder.
    """
    file = check_writable(path, what="protocols", suffixes=SUFFIXES, force=force)
    check_writable(file.with_suffix(".json"), force=force)
    return file


def facts_of(vehicle: VehicleGrade) -> dict[str, str]:
    """What the records say for the head of the page; texts of two records that differ are both given."""
    found: dict[str, str] = {}
    for name in SAID:
        texts = [str(one.inspection.facts[name]) for one in vehicle.axles if one.inspection.facts.get(name)]
        if texts:
            found[name] = ", ".join(dict.fromkeys(texts))
    return found


def protocol_data(vehicle: VehicleGrade, about: Mapping[str, str]) -> dict[str, Any]:
    """Everything behind the page as one plain JSON object, SI."""
    plain: dict[str, Any] = to_plain(
        {"schema": SCHEMA, "software": _software(), "about": dict(about), **vehicle.to_dict()}
    )
    return plain


def protocol_html(
    vehicle: VehicleGrade,
    *,
    records: Mapping[str, xr.Dataset] | None = None,
    language: Language = "en",
    about: Mapping[str, str] | None = None,
) -> str:
    """Give the protocol as one self-contained HTML text; arguments as in `write_protocol`."""
    from markupsafe import Markup

    from jounce.report.render import _environment, _templates

    content = protocol_content(vehicle, _said(vehicle, about), language=_language(language), software=_software())
    figures = _figures(vehicle, records, language)
    alternative = content["words"]["curves"]
    text: str = (
        _environment()
        .get_template("protocol.html.j2")
        .render(
            c=content,
            css=(_templates() / "protocol.css").read_text(encoding="utf-8"),
            svg=lambda axle: Markup(
                inline_svg(
                    figures[axle["figure"]], axle["figure"].removesuffix(".svg"), f"{alternative}, {axle['title']}"
                )
            ),
        )
    )
    return text


def protocol_pdf(
    vehicle: VehicleGrade,
    *,
    records: Mapping[str, xr.Dataset] | None = None,
    language: Language = "en",
    about: Mapping[str, str] | None = None,
) -> bytes:
    """Give the protocol as PDF of one page; arguments as in `write_protocol`.

    The same content gives the same bytes: the document's date is the day of the test, and where that is known the file
    is PDF/A-2b. Reasons and remarks that find no room are counted, never cut: the JSON file holds all of them.
    """
    files, day = _fitted(vehicle, records, _language(language), _said(vehicle, about))
    pages: bytes = compiled(files, "pdf", **({"pdf_standards": "a-2b"} if day is not None else {}))
    return pages


def protocol_png(
    vehicle: VehicleGrade,
    *,
    records: Mapping[str, xr.Dataset] | None = None,
    language: Language = "en",
    about: Mapping[str, str] | None = None,
    ppi: float = 110.0,
) -> list[bytes]:
    """Give the pages of the PDF as pictures of ``ppi`` dots per inch; other arguments as in `write_protocol`."""
    files, _ = _fitted(vehicle, records, _language(language), _said(vehicle, about))
    pages: list[bytes] = compiled(files, "png", ppi=ppi)
    return pages


def _fitted(
    vehicle: VehicleGrade, records: Mapping[str, xr.Dataset] | None, language: Language, said: Mapping[str, str]
) -> tuple[dict[str, bytes], tuple[int, int, int] | None]:
    """Files of the typst document with as many reasons and remarks as one page holds, and the day of the test."""
    figures = _figures(vehicle, records, language)
    fits, too_many = 0, _MOST + 1
    while True:
        most = (fits + too_many) // 2 if too_many <= _MOST else _MOST
        content = protocol_content(vehicle, said, language=language, software=_software(), most=most)
        day = _day(content["date"])
        files = _typst_files({**content, "day": day}, figures)
        if len(compiled(files, "png", ppi=_COUNTING)) == 1:
            fits = most
            if most == _MOST or too_many - fits == 1:
                return files, day
        elif most == 0:
            return files, day
        else:
            too_many = most


def compiled(files: Mapping[str, bytes], form: str, **options: Any) -> Any:
    """Let typst set a document: PDF as bytes, pictures as a list of pages."""
    import typst

    compile_files: Any = typst.compile  # its types do not know files by name
    made = compile_files(dict(files), format=form, font_paths=[str(_fonts())], ignore_system_fonts=True, **options)
    return [made] if form == "png" and isinstance(made, bytes) else made


def _fonts() -> Path:
    import matplotlib as mpl

    return Path(mpl.get_data_path()) / "fonts" / "ttf"


def _typst_files(content: Mapping[str, Any], figures: Mapping[str, bytes]) -> dict[str, bytes]:
    from jounce.report.render import _templates

    data = json.dumps(_breakable(content), ensure_ascii=False)
    return {
        "main.typ": (_templates() / "protocol.typ").read_bytes(),
        "protocol.json": data.encode("utf-8", "replace"),
        **figures,
    }


def _breakable(value: Any) -> Any:
    """Let words that are longer than any column be broken."""
    if isinstance(value, Mapping):
        return {key: item if key == "figure" else _breakable(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_breakable(item) for item in value]
    if not isinstance(value, str):
        return value
    return " ".join(_pieces(word) if len(word) > _LONGEST_WORD else word for word in value.split(" "))


def _pieces(word: str) -> str:
    return "\u200b".join(word[i : i + _PIECE] for i in range(0, len(word), _PIECE))


def _figures(vehicle: VehicleGrade, records: Mapping[str, xr.Dataset] | None, language: Language) -> dict[str, bytes]:
    """Curves of each axle as SVG by file name."""
    found = {}
    for i, graded in enumerate(vehicle.axles):
        egea = graded.limits.methods.get("egea")
        figure = inspection_curves(
            graded.inspection,
            (records or {}).get(graded.axle),
            language=language,
            phase_limit=None if egea is None else egea.passing_from(),
            height=_HEIGHTS[len(vehicle.axles)],
        )
        found[f"axle{i}.svg"] = rendered(figure, [".svg"], salt=f"axle{i}")[".svg"]
    return found


def _said(vehicle: VehicleGrade, about: Mapping[str, str] | None) -> dict[str, str]:
    return {**facts_of(vehicle), **(about or {})}


def _language(language: str) -> Language:
    for known in LANGUAGES:
        if language == known:
            return known
    raise unknown(language, LANGUAGES, what="language", where="protocol")


def _day(date: str) -> tuple[int, int, int] | None:
    """Year, month and day of a text that is a date."""
    try:
        found = datetime.date.fromisoformat(day_of(date))
    except ValueError:
        return None
    return found.year, found.month, found.day


def _software() -> str:
    return f"jounce {metadata.version('jounce')}"


__all__ = ["check_protocol", "protocol_data", "protocol_html", "protocol_pdf", "write_protocol"]
