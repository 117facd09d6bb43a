"""Test protocols of shock absorbers: one page as PDF or HTML, and a JSON file with the same data."""

from __future__ import annotations

import datetime
import json
import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.display import current_units, local_units
from jounce.core.errors import unknown
from jounce.core.findings import DrawingError, not_drawn
from jounce.core.serialise import to_json, to_plain
from jounce.core.writing import Formats, check_writable, write_atomically
from jounce.inspection.findings import sentence_of
from jounce.inspection.grading import (
    Difference,
    GradedInspection,
    VehicleGrade,
    WheelGrade,
    grade_vehicle,
)
from jounce.inspection.limits import Criterion, Limits, VerdictBand
from jounce.inspection.methods import METHODS, QUANTITIES, method_names
from jounce.inspection.quantities import LANGUAGES, Language, WheelQuantity, with_decimal_sign
from jounce.inspection.reasons import Reason, verdict_words
from jounce.inspection.record import day_of, is_simulated
from jounce.inspection.result import NOT_GRADED, WheelResult
from jounce.plots import render_figure
from jounce.plots.inspection import inspection_curves
from jounce.report.live import Pane, Viewer
from jounce.report.page import as_printed
from jounce.report.recordings import DIFFERENCE, curve_blocks
from jounce.report.render import TEMPLATES, fill_template, inline_svg
from jounce.report.typeset import TYPESETTER, breakable, typeset

if TYPE_CHECKING:
    import xarray as xr


SCHEMA = "jounce.protocol/1"
_MOST = 24  # reasons and remarks
_COUNTING = 8.0  # dots per inch; sufficient for counting pages
_HEIGHTS = {1: 3.2, 2: 1.6}  # height of the curves of one axle in inches, by number of axles


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
        Records by axle (``"front"``, ``"rear"``, or ``""`` if unknown), for plots of force against time.
    language : {"en", "de"}
        Language of the page.
    about : mapping of str to str, optional
        ``vehicle``, ``plate_number``, ``date``, ``tester``, ``place``, ``operator``, ``comment``, ``record``; by
        default taken from the records.
    force : bool
        Overwrite existing files.

    Returns
    -------
    list of Path
        The page, and a JSON file of the same name with all values.

    Raises
    ------
    OutputError
        For an unsupported suffix, an existing file without ``force``, or a missing folder; nothing is written then.
    DescriptionError
        For an unknown language.
    DrawingError
        If the page cannot be drawn; the JSON file has been written by then.

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
    page = _Page(vehicle, records, _language(language), said)
    data = to_json(protocol_data(vehicle, said))
    values = write_atomically(file.with_suffix(".json"), f"{data}\n", force=force)
    try:
        return [PROTOCOLS.write(page, file, force=force), values]
    except Exception as error:
        raise DrawingError([not_drawn(str(file), error)]) from error


def check_protocol(path: Path | str, *, force: bool = False) -> Path:
    """Check in advance that a protocol and its JSON file can be written; return the protocol's path."""
    file = PROTOCOLS.check(path, force=force)
    check_writable(file.with_suffix(".json"), force=force)
    return file


@dataclass(frozen=True)
class _Page:
    """Inputs of a protocol, as passed to `write_protocol`."""

    vehicle: VehicleGrade
    records: Mapping[str, xr.Dataset] | None
    language: Language
    about: Mapping[str, str]


def _write_pdf(page: _Page, file: Path) -> None:
    file.write_bytes(
        protocol_pdf(page.vehicle, records=page.records, language=page.language, about=page.about)
    )


def _write_html(page: _Page, file: Path) -> None:
    text = protocol_html(
        page.vehicle, records=page.records, language=page.language, about=page.about
    )
    file.write_bytes(text.encode())


PROTOCOLS = Formats("protocols", {".pdf": _write_pdf, ".html": _write_html}, {".pdf": TYPESETTER})


def facts_of(vehicle: VehicleGrade) -> dict[str, str]:
    """Return header fields found in the records; if the two records differ, both texts are included."""
    facts: dict[str, str] = {}
    for name in SAID:
        texts = [
            str(axle.inspection.facts[name])
            for axle in vehicle.axles
            if axle.inspection.facts.get(name)
        ]
        if texts:
            facts[name] = ", ".join(dict.fromkeys(texts))
    return facts


def protocol_data(vehicle: VehicleGrade, about: Mapping[str, str]) -> dict[str, Any]:
    """Return all data of the page as a plain JSON object in SI units."""
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
    """Return the protocol as self-contained HTML; arguments as in `write_protocol`."""
    content = protocol_content(
        vehicle, _facts(vehicle, about), language=_language(language), software=_software()
    )
    figures = _figures(vehicle, records, language)
    alternative = content["words"]["curves"]
    return fill_template(
        "protocol",
        _viewers(vehicle, records or {}, content["words"]),
        c=content,
        svg=lambda axle: inline_svg(
            figures[axle["figure"]],
            axle["figure"].removesuffix(".svg"),
            f"{alternative}, {axle['title']}",
        ),
    )


def _viewers(
    vehicle: VehicleGrade, records: Mapping[str, xr.Dataset], words: Mapping[str, str]
) -> tuple[Viewer, ...]:
    """Return a zoomable viewer per axle of the recorded channels over time, with the two wheels overlaid."""
    groups: dict[str, dict[str, xr.Dataset]] = {}
    for graded in vehicle.axles:
        record = records.get(graded.axle)
        if record is None:
            continue
        sides = {
            side: [name for name in record.data_vars if str(name).startswith(f"{side}.plate.")]
            for side in _SIDES
        }
        wheels = {
            words[side]: _of_side(record[names], side)
            for side, names in sides.items()
            if f"{side}.plate.force" in names
        }
        if wheels:
            groups[words[graded.axle] if graded.axle in words else words["axle"]] = wheels
    if not groups:
        return ()
    with local_units("metric"):
        blocks = curve_blocks(groups, ["plate.force"], title="")
    return tuple(_in_words(block, words) for block in blocks if isinstance(block, Viewer))


def _in_words(viewer: Viewer, words: Mapping[str, str]) -> Viewer:
    """Rename channels to match the rest of the page; differences are second wheel minus first."""
    between = " − ".join(label for _, label, _ in reversed(viewer.roles))

    def pane(pane_of_wheel: Pane) -> Pane:
        mark = DIFFERENCE if pane_of_wheel.name.startswith(DIFFERENCE) else ""
        channel = pane_of_wheel.name.removeprefix(DIFFERENCE)
        name = mark + words.get(channel.replace(".", "_"), channel)
        return replace(pane_of_wheel, name=name, words=f"{name}: {between}" if mark else name)

    scenes = (replace(scene, panes=tuple(map(pane, scene.panes))) for scene in viewer.scenes)
    return replace(viewer, scenes=tuple(scenes), words=words["time"])


def _of_side(record: xr.Dataset, side: str) -> xr.Dataset:
    """Return the channels of one side, with the side removed from their names."""
    names = [name for name in record.data_vars if str(name).startswith(f"{side}.plate.")]
    own = record[names].rename({name: str(name).removeprefix(f"{side}.") for name in names})
    for channel in own.data_vars.values():
        channel.attrs["long_name"] = str(channel.attrs.get("long_name", "")).replace(f"{side} ", "")
    return own


def protocol_pdf(
    vehicle: VehicleGrade,
    *,
    records: Mapping[str, xr.Dataset] | None = None,
    language: Language = "en",
    about: Mapping[str, str] | None = None,
) -> bytes:
    """Return the protocol as a one-page PDF; arguments as in `write_protocol`.

    Identical content gives identical bytes: the document's date is the day of the test, and if that is known the file
    is PDF/A-2b. Reasons and remarks that do not fit are counted, never truncated: the JSON file contains all of them.
    """
    files, day = _fit_on_page(vehicle, records, _language(language), _facts(vehicle, about))
    pages: bytes = typeset(files, "pdf", **({"pdf_standards": "a-2b"} if day is not None else {}))
    return pages


def protocol_png(
    vehicle: VehicleGrade,
    *,
    records: Mapping[str, xr.Dataset] | None = None,
    language: Language = "en",
    about: Mapping[str, str] | None = None,
    ppi: float = 110.0,
) -> list[bytes]:
    """Render the pages of the PDF as images with ``ppi`` pixels per inch; other arguments as in `write_protocol`."""
    files, _ = _fit_on_page(vehicle, records, _language(language), _facts(vehicle, about))
    pages: list[bytes] = typeset(files, "png", ppi=ppi)
    return pages


def _fit_on_page(
    vehicle: VehicleGrade,
    records: Mapping[str, xr.Dataset] | None,
    language: Language,
    said: Mapping[str, str],
) -> tuple[dict[str, bytes], tuple[int, int, int] | None]:
    """Return the typst files with as many reasons and remarks as fit on one page, and the day of the test."""
    figures = _figures(vehicle, records, language)
    fits, too_many = 0, _MOST + 1
    while True:
        most = (fits + too_many) // 2 if too_many <= _MOST else _MOST
        content = protocol_content(
            vehicle, said, language=language, software=_software(), most=most
        )
        day = _day(content["date"])
        data = json.dumps(breakable({**content, "day": day}), ensure_ascii=False)
        files = {
            "main.typ": (TEMPLATES / "protocol.typ").read_bytes(),
            "protocol.json": data.encode("utf-8", "replace"),
            **figures,
        }
        if len(typeset(files, "png", ppi=_COUNTING)) == 1:
            fits = most
            if most == _MOST or too_many - fits == 1:
                return files, day
        elif most == 0:
            return files, day
        else:
            too_many = most


def _figures(
    vehicle: VehicleGrade, records: Mapping[str, xr.Dataset] | None, language: Language
) -> dict[str, bytes]:
    """Return the curves of each axle as SVG, by file name."""
    files = {}
    for i, graded in enumerate(vehicle.axles):
        egea = graded.limits.methods.get("egea")
        with local_units("metric"):
            figure = inspection_curves(
                graded.inspection,
                (records or {}).get(graded.axle),
                language=language,
                phase_limit=None if egea is None else egea.passing_from(),
                phase_failure=None if egea is None else egea.failing_below(),
                height=_HEIGHTS[len(vehicle.axles)],
            )
        files[f"axle{i}.svg"] = render_figure(figure, [".svg"], salt=f"axle{i}")[".svg"]
    return files


def _facts(vehicle: VehicleGrade, about: Mapping[str, str] | None) -> dict[str, str]:
    return {**facts_of(vehicle), **(about or {})}


def _language(language: str) -> Language:
    for known in LANGUAGES:
        if language == known:
            return known
    raise unknown(language, LANGUAGES, what="language", where="protocol")


def _day(date: str) -> tuple[int, int, int] | None:
    """Parse a date into year, month and day; ``None`` if the text is not a date."""
    try:
        parsed = datetime.date.fromisoformat(day_of(date))
    except ValueError:
        return None
    return parsed.year, parsed.month, parsed.day


def _software() -> str:
    return f"jounce {metadata.version('jounce')}"


TONES = {"pass": "green", "advise": "yellow", "fail": "red", NOT_GRADED: "grey"}
HEAD = ("vehicle", "plate_number", "date", "tester", "place", "operator")
SAID = (*HEAD, "comment")
"""Header fields of a record that appear in the head of the page."""
_SIDES = ("left", "right")
_LONGEST_TEXT, _LONGEST_HEAD = 160, 64
_EXPLAINING = {
    "disagree", "mass", "tyre", "rigidity", "lifted", "limits_differ", "one_wheel", "may_be", "counts",
    "unreliable_difference",
}  # fmt: skip
_ORDER = {"fail": 0, NOT_GRADED: 1, "advise": 2}

Plain = dict[str, Any]


@cache
def words_in(language: Language) -> Mapping[str, str]:
    """Return the wording of the protocol in a language."""
    words: dict[str, dict[str, str]] = tomllib.loads(
        (TEMPLATES / "protocol.toml").read_text(encoding="utf-8")
    )
    return words[language]


def protocol_content(
    vehicle: VehicleGrade,
    about: Mapping[str, str],
    *,
    language: Language = "en",
    software: str = "",
    most: int = 99,
) -> Plain:
    """Assemble the texts of a protocol with their colours (``green``, ``yellow``, ``orange``, ``red``, ``grey``).

    At most ``most`` reasons and remarks are shown; the remaining ones are only counted.
    """
    words = dict(words_in(language))
    if (
        current_units() != "metric"
    ):  # limits and the values compared with them are in the units of the test methods
        words["differences_note"] += f" {words['units_note']}"
    reasons, remarks = _reasons(vehicle, language), _remarks(vehicle, language)
    shown = reasons[:most]
    noted = remarks[: max(most - len(shown), 0)]
    left_out = len(reasons) + len(remarks) - len(shown) - len(noted)
    limits = vehicle.axles[0].limits
    return {
        "language": language,
        "words": words,
        "title": words["title"],
        "simulated": any(is_simulated(axle.inspection.facts) for axle in vehicle.axles),
        "head": [
            {"label": words[name], "text": _head_text(name, about, language)} for name in HEAD
        ],
        "date": about.get("date", ""),
        "comment": {"label": words["comment"], "text": _head_text("comment", about, language)},
        "deciding": method_names(vehicle.axles[0].deciding) or "–",
        "verdict": _verdict(vehicle.verdict, language),
        "axles": [_axle(axle, i, language) for i, axle in enumerate(vehicle.axles)],
        "front_rear": _front_rear(vehicle, language),
        "reasons": shown
        or [{"place": "", "text": words["fine"], "tone": "green"}][: vehicle.verdict == "pass"],
        "remarks": noted,
        "more": words["more"].format(count=left_out) if left_out else "",
        "sources": _sources(vehicle, limits, language),
        "foot": _foot(limits, about, software, words),
    }


def _head_text(name: str, about: Mapping[str, str], language: Language) -> str:
    text = about.get(name, "")
    german = (
        re.fullmatch(r"(\d{4})-(\d\d)-(\d\d)", text)
        if name == "date" and language == "de"
        else None
    )
    return f"{german[3]}.{german[2]}.{german[1]}" if german else shorten(text, _LONGEST_HEAD)


def shorten(text: str, longest: int = _LONGEST_TEXT) -> str:
    r"""Return a text on one line without control characters, truncated to ``longest``; an en dash if empty.

    Examples
    --------
    >>> shorten("a\tb\n"), shorten(""), shorten("abcdef", 4)
    ('a b', '–', 'abc…')
    """
    line = " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
    return (line if len(line) <= longest else f"{line[: longest - 1]}…") or "–"


def _verdict(verdict: str, language: Language) -> Plain:
    return {"text": verdict_words(verdict, language), "tone": TONES.get(verdict, "grey")}


def _axle(graded: GradedInspection, index: int, language: Language) -> Plain:
    words = words_in(language)
    wheels = {wheel.wheel: wheel for wheel in graded.wheels}
    return {
        "title": words[graded.axle] if graded.axle in words else words["axle"],
        "verdict": _verdict(graded.verdict, language),
        "wheels": [
            _verdict(wheels[side].verdict, language)
            if side in wheels
            else {"text": words["not_tested"], "tone": "grey"}
            for side in _SIDES
        ],
        "rows": [_load_row(wheels, language), *_value_rows(graded, wheels, language)],
        "figure": f"axle{index}.svg",
    }


def _load_row(wheels: Mapping[str, WheelResult], language: Language) -> Plain:
    loads = {side: wheel.static_load for side, wheel in wheels.items()}
    cells = [_cell("–" if loads.get(side) is None else f"{loads[side]:.0f} N") for side in _SIDES]
    left, right = (loads.get(side) for side in _SIDES)
    difference = _cell("")
    if left is not None and right is not None and max(left, right) > 0.0:
        share = 100.0 * abs(left - right) / max(left, right)
        difference = _cell(f"{abs(left - right):.0f} N · {_number(share, 1, language)} %")
    return {
        "label": _capital(words_in(language)["static_load"]),
        "cells": [*cells, difference, _cell("")],
        "decides": False,
    }


def _cell(text: str, half: str = "", band: str = "", tone: str = "") -> Plain:
    return {"text": text, "half": half, "band": band, "tone": tone}


def _number(value: float, decimals: int, language: Language) -> str:
    return with_decimal_sign(f"{value:.{decimals}f}", language)


def _value_rows(
    graded: GradedInspection, wheels: Mapping[str, WheelResult], language: Language
) -> list[Plain]:
    rows = []
    for name, quantity in QUANTITIES.items():
        methods = {m: band for m, band in graded.limits.methods.items() if band.quantity == name}
        asked = set(methods) & {*graded.deciding, *graded.inspection.methods}
        if not asked and all(wheel.value(name) is None for wheel in wheels.values()):
            continue
        if (
            not asked
            and name == "theta_rig"
            and all(wheel.theta_rig == wheel.theta_road for wheel in wheels.values())
        ):
            continue  # a rigid plate has no value
        cells = [_value_cell(graded, wheels.get(side), quantity, language) for side in _SIDES]
        limiting = next(iter(methods.values()), None) or _condition(graded.limits, name)
        difference = next(
            (candidate for candidate in graded.differences if candidate.quantity == name), None
        )
        decides = bool(set(methods) & set(graded.deciding))
        passing = _limit_text(limiting, language)
        apart = _gap_limit(graded.limits, name, language) if decides else ""
        label = _capital(quantity.words(language))
        rows.append(
            {
                "label": label,
                "cells": [
                    *cells,
                    _gap_cell(difference, quantity, language, graded.limits),
                    _cell(passing, apart),
                ],
                "decides": decides,
            }
        )
    return rows


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _value_cell(
    graded: GradedInspection, wheel: WheelResult | None, quantity: WheelQuantity, language: Language
) -> Plain:
    if wheel is None:
        return _cell("–")
    value, half = wheel.value(quantity.name), wheel.uncertainty.get(quantity.name)
    grade = graded.grade_of(wheel.wheel)
    band, criterion = _band_of(graded.limits, grade, quantity.name, value)
    edges = criterion.edges() if criterion is not None else ()
    text = quantity.text(value, language, apart_from=edges)
    shown = "" if half is None or value is None else f"± {quantity.rounded_up(half, language)}"
    if (
        quantity.name == "phase_angle_min_deg"
        and value is not None
        and wheel.phase_frequency_hz is not None
    ):
        place = f"{words_in(language)['at']} {_number(wheel.phase_frequency_hz, 1, language)} Hz"
        shown = f"{shown} {place}".strip()
    if quantity.name == "adhesion" and wheel.lift_off and value is not None:
        shown = ", ".join(filter(None, (shown, words_in(language)["lift_off"])))
    if band is None:
        return _cell(text, shown)
    return _cell(text, shown, shorten(band.words(language), 60), _tone(band, criterion))


def _tone(band: VerdictBand, criterion: Criterion | None) -> str:
    """Return the colour of a band; grey if its limits are not decisive."""
    return band.colour if criterion is None or criterion.verified else TONES[NOT_GRADED]


def _band_of(
    limits: Limits, grade: WheelGrade | None, name: str, value: float | None
) -> tuple[VerdictBand | None, Criterion | None]:
    """Return the band of a value from its grading method or condition; ``None`` for an ungraded record."""
    for method, criterion in limits.methods.items():
        if criterion.quantity == name and grade is not None and method in grade.bands:
            return grade.bands[method], criterion
    condition = _condition(limits, name)
    if condition is not None and value is not None and grade is not None and grade.bands:
        return condition.band_of(value), condition
    return None, condition


def _condition(limits: Limits, name: str) -> Criterion | None:
    return next(
        (condition for condition in limits.conditions.values() if condition.quantity == name), None
    )


def _gap_cell(
    difference: Difference | None,
    quantity: WheelQuantity,
    language: Language,
    limits: Limits | None = None,
) -> Plain:
    if difference is None:
        return _cell("–")
    text = quantity.text(difference.absolute, language, with_unit=False)
    if difference.uncertainty is not None:
        text += f" ± {quantity.rounded_up(difference.uncertainty, language, with_unit=False)}"
    unit = ("pp" if language == "en" else "%-P.") if quantity.unit == "%" else quantity.unit
    text = f"{text}{unit}" if unit == "°" else f"{text} {unit}".strip()
    if difference.relative is not None:
        text += f" · {_number(100.0 * difference.relative, 1, language)} %"
    if difference.unreliable:
        return _cell(text, verdict_words(NOT_GRADED, language))
    name, band = next(iter(difference.bands.items()), ("", None))
    if band is None:
        return _cell(text)
    criterion = None if limits is None else limits.differences.get(name)
    return _cell(text, "", shorten(band.words(language), 60), _tone(band, criterion))


def _gap_limit(limits: Limits, name: str, language: Language) -> str:
    """Return the allowed difference between two wheels by the decisive limits, e.g. ``Δ up to 12°``."""
    between = (
        limit
        for limit in limits.differences.values()
        if (limit.quantity, limit.across) == (name, "wheels")
    )
    texts = [text for limit in between if (text := _limit_text(limit, language)) not in ("", "–")]
    return f"Δ {texts[0]}" if texts else ""


def _limit_text(criterion: Criterion | None, language: Language) -> str:
    """Return the passing limit, and the failing limit if it differs: ``from 45°, fail below 30°``."""
    text, below = (
        _passing(criterion, language),
        None if criterion is None else criterion.failing_below(),
    )
    if (
        criterion is None
        or not criterion.verified
        or below is None
        or below == criterion.passing_from()
    ):
        return text
    words = f"{verdict_words('fail', language)} {'below' if language == 'en' else 'unter'}"
    return f"{text}, {words} {criterion.kind.limit_text(below, language)}"


def _passing(criterion: Criterion | None, language: Language) -> str:
    """Return the range in which a value passes, e.g. ``from 35°``."""
    if criterion is None or not criterion.verified:
        return ""
    passing = [i for i, band in enumerate(criterion.bands) if band.verdict == "pass"]
    if not passing:
        return "–"
    first, last = criterion.bands[passing[0]], criterion.bands[passing[-1]]
    start = criterion.kind.limit_text(first.start, language) if passing[0] > 0 else ""
    end = (
        criterion.kind.limit_text(last.end, language)
        if passing[-1] < len(criterion.bands) - 1
        else ""
    )
    since, up_to, to = ("from", "up to", "to") if language == "en" else ("ab", "bis", "bis")
    if start and end:
        return f"{start.removesuffix(criterion.kind.unit).strip()} {to} {end}"
    if start:
        return f"{since} {start}"
    return f"{up_to} {end}" if end else "–"


def _places(graded: GradedInspection, side: str, language: Language) -> str:
    key = f"{graded.axle}_{side}"
    return words_in(language).get(key, words_in(language)[side])


def _join_places(places: Sequence[str], vehicle: VehicleGrade, language: Language) -> str:
    """Join wheel positions concisely: an axle replaces its two wheels, "all wheels" replaces the two axles."""
    words, remaining = words_in(language), list(dict.fromkeys(places))
    for graded in vehicle.axles:
        wheels = [_places(graded, side, language) for side in _SIDES]
        title = words["both_" + graded.axle] if graded.axle in words else words["both_wheels"]
        if set(wheels) <= set(remaining):
            remaining[remaining.index(wheels[0])] = title
            remaining.remove(wheels[1])
    both = [words["both_front"], words["both_rear"]]
    return words["all_wheels"] if sorted(remaining) == sorted(both) else ", ".join(remaining)


def _reasons(vehicle: VehicleGrade, language: Language) -> list[Plain]:
    """Return the reasons for the verdict (failures, uncertain values, disagreeing methods), most severe first."""
    reasons: dict[str, tuple[Reason, list[str]]] = {}
    for graded in vehicle.axles:
        for grade in graded.grades:
            for reason in grade.reasons:
                if _must_be_read(reason, graded):
                    place = _places(graded, grade.wheel, language)
                    text = _reason_text(reason, graded, language)
                    reasons.setdefault(text, (reason, []))[1].append(place)
        title = words_in(language).get(graded.axle, words_in(language)["axle"])
        for reason in graded.reasons:
            if reason.kind != "wheel" and _must_be_read(reason, graded):
                reasons.setdefault(_reason_text(reason, graded, language), (reason, []))[1].append(
                    title
                )
    for reason in vehicle.reasons:
        if reason.kind == "difference" and reason.verdict not in ("", "pass"):
            text = _reason_text(reason, vehicle.axles[0], language)
            reasons.setdefault(text, (reason, []))[1].append(words_in(language)["front_rear"])
    deciding = vehicle.axles[0].deciding
    listed = sorted(
        reasons.items(),
        key=lambda item: (_is_information(item[1][0], deciding), _ORDER.get(item[1][0].verdict, 3)),
    )
    return [
        {
            "place": _join_places(places, vehicle, language),
            "text": shorten(as_printed(text), 400),
            "tone": TONES.get(reason.verdict, ""),
        }
        for text, (reason, places) in listed
    ]


def _reason_text(reason: Reason, graded: GradedInspection, language: Language) -> str:
    text = reason.text(language, with_source=False)
    return (
        words_in(language)["information"] + text
        if _is_information(reason, graded.deciding)
        else _capital(text)
    )


def _is_information(reason: Reason, deciding: Sequence[str]) -> bool:
    """Whether a reason is the grade of a method that does not decide the verdict."""
    return reason.kind in ("band", "unverified") and reason.values["method"] not in deciding


def _must_be_read(reason: Reason, graded: GradedInspection) -> bool:
    if reason.kind in _EXPLAINING or reason.kind == "finding":
        return True
    if reason.kind in (
        "missing",
        "outside",
        "unlimited",
        "unverified",
        "unreliable",
        "near",
        "over_range",
    ):
        return reason.values.get("method") in graded.deciding
    return reason.verdict not in ("", "pass")


def _remarks(vehicle: VehicleGrade, language: Language) -> list[Plain]:
    """Return the findings of the evaluation that the reasons do not already cover."""
    remarks: dict[str, list[str]] = {}
    for graded in vehicle.axles:
        title = words_in(language).get(graded.axle, words_in(language)["axle"])
        for finding in graded.inspection.findings:
            if finding.severity != "problem":
                remarks.setdefault(sentence_of(finding, language), []).append(title)
        for wheel in graded.wheels:
            for finding in wheel.findings:
                if finding.severity != "problem":
                    remarks.setdefault(sentence_of(finding, language), []).append(
                        _places(graded, wheel.wheel, language)
                    )
    return [
        {
            "place": _join_places(places, vehicle, language),
            "text": _capital(shorten(as_printed(text), 400)),
            "tone": "",
        }
        for text, places in remarks.items()
    ]


def _front_rear(vehicle: VehicleGrade, language: Language) -> list[Plain]:
    """Return front-to-rear differences of the graded values, one line per side."""
    names = {
        method_limits.quantity: METHODS[method].name
        for method, method_limits in vehicle.axles[0].limits.methods.items()
    }
    lines = []
    for side in _SIDES:
        differences = [
            difference
            for difference in vehicle.differences
            if difference.place == side and difference.quantity in names
        ]
        texts = [
            f"{names[difference.quantity]} {_gap_cell(difference, QUANTITIES[difference.quantity], language)['text']}"
            for difference in differences
        ]
        if texts:
            lines.append({"place": words_in(language)[side], "text": "; ".join(texts)})
    return lines


def _sources(vehicle: VehicleGrade, limits: Limits, language: Language) -> list[str]:
    """Return the sources of the limits used, one line per method."""
    used = [
        m
        for m in limits.methods
        if any(m in grade.bands for a in vehicle.axles for grade in a.grades)
    ]
    lines, said = [], set[str]()
    for method in used:
        others = [*limits.conditions.values(), *limits.differences.values()]
        using = [limits.methods[method], *(limit for limit in others if method in limit.methods)]
        texts = [text for limit in using if (text := limit.citation(language)) not in said]
        said |= {text for text in texts if text.startswith("jounce")}
        lines.append(f"{METHODS[method].name}: {shorten('; '.join(dict.fromkeys(texts)), 600)}.")
    return lines


def _foot(limits: Limits, about: Mapping[str, str], software: str, words: Mapping[str, str]) -> str:
    parts = [
        software,
        f"{words['limits']}: {shorten(limits.label, 80)}, {shorten(limits.date, 40)}",
    ]
    if about.get("record"):
        parts.append(f"{words['record']}: {shorten(about['record'], 140)}")
    return " · ".join(part for part in parts if part)
