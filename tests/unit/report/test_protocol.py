"""Test protocols: what stands on the page, in both languages, whatever the texts are; the files beside each other."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from jounce.core.display import local_units
from jounce.core.errors import DescriptionError, OutputError
from jounce.core.findings import Finding
from jounce.inspection.grading import VehicleGrade, grade, grade_vehicle
from jounce.inspection.quarter_car import LinearQuarterCar, force_response, steady_state
from jounce.inspection.result import Inspection, WheelCurves, WheelResult
from jounce.report import protocol
from jounce.report.protocol import (
    protocol_content,
    protocol_html,
    protocol_pdf,
    protocol_png,
    shorten,
    write_protocol,
)
from jounce.testers.plates import phase_angle

FACTS = {"vehicle": "Audi A6", "plate_number": "M-ÄÖ 12", "date": "2026-11-21", "tester": "lane 2"}


def wheel(side: str, damping: float = 1300.0) -> WheelResult:
    corner = LinearQuarterCar(330.0, 36.0, 22e3, damping, 210e3)
    steady = steady_state(corner)
    frequency = np.linspace(25.0, 4.0, 60)
    response = force_response(corner, frequency)
    force = 3e-3 * np.abs(response)
    load = corner.static_load
    curves = WheelCurves(
        26.0 - frequency,
        frequency,
        load - force,
        load + force,
        np.degrees(phase_angle(response)),
        np.full(60, 3e-3),
    )
    return WheelResult(
        side,
        static_load=load,
        adhesion=steady.adhesion,
        phase_angle_min_deg=steady.phase_angle_min_deg,
        phase_frequency_hz=steady.phase_frequency_hz,
        relative_force_amplitude=steady.relative_force_amplitude,
        tyre_rigidity=steady.tyre_rigidity,
        theta_rig=0.17,
        theta_road=0.17,
        uncertainty={"adhesion": 0.0021, "phase_angle_min_deg": 0.34},
        corner=corner,
        curves=curves,
    )


def axle(name: str, *wheels: WheelResult, **facts: str) -> Inspection:
    shown = wheels or (wheel("left"), wheel("right"))
    return Inspection(
        shown, {"axle": name} if name else {}, {**FACTS, **facts}, ("eusama", "egea", "theta")
    )


def vehicle(*inspections: Inspection) -> VehicleGrade:
    return grade_vehicle([grade(one, deciding=["egea"]) for one in inspections])


@pytest.fixture
def sound() -> VehicleGrade:
    return vehicle(axle("front"), axle("rear"))


@pytest.fixture(scope="module")
def worn() -> VehicleGrade:
    return vehicle(axle("front", wheel("left"), wheel("right", 300.0)), axle("rear"))


@pytest.fixture
def record() -> xr.Dataset:
    time = np.arange(4000) / 1000.0
    force = 3590.0 + 500.0 * np.sin(60.0 * time)
    names = ("left.plate.force", "right.plate.force")
    return xr.Dataset(dict.fromkeys(names, ("time", force)), coords={"time": time})


def viewer_in(page: str) -> dict[str, Any]:
    data = re.search(r'id="jounce-data">(.*?)</script>', page)
    assert data is not None
    (viewer,) = json.loads(data[1])["viewers"]
    assert isinstance(viewer, dict)
    return viewer


def test_the_viewer_speaks_the_language_of_its_page(
    sound: VehicleGrade, record: xr.Dataset
) -> None:
    records = {"front": record}
    german = viewer_in(protocol_html(sound, records=records, language="de"))
    assert german["x"] == {"words": "Zeit", "unit": "s"}
    assert [role["label"] for role in german["roles"]] == ["Links", "Rechts"]
    (axle,) = german["scenes"]
    assert axle["label"] == "Vorderachse"
    panes = {pane["name"]: pane["words"] for pane in axle["panes"]}
    assert panes == {
        "Plattenkraft": "Plattenkraft",
        "Δ Plattenkraft": "Δ Plattenkraft: Rechts − Links",
    }
    english = viewer_in(protocol_html(sound, records=records))
    assert english["x"]["words"] == "time"
    panes = {pane["name"]: pane["words"] for pane in english["scenes"][0]["panes"]}
    assert panes == {"plate force": "plate force", "Δ plate force": "Δ plate force: Right − Left"}


def test_units_are_those_of_the_test_methods(sound: VehicleGrade, record: xr.Dataset) -> None:
    usual = protocol_html(sound, records={"front": record})
    with local_units("imperial"):
        page = protocol_html(sound, records={"front": record})
    said = " Units are those of the test methods (EUSAMA, EGEA), whatever display units are chosen."
    assert said not in usual
    assert page.replace(said, "") == usual


class Text(HTMLParser):
    """Visible text and tags of a page."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.tags: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, _attrs: object) -> None:
        self.tags.append(tag)

    def handle_data(self, data: str) -> None:
        self.texts.append(data)

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.texts).split())


# --- content --------------------------------------------------------------------------------------------------------


def test_both_wheels_of_both_axles_with_value_uncertainty_band_and_verdict(
    worn: VehicleGrade,
) -> None:
    content = protocol_content(worn, FACTS)
    assert [one["title"] for one in content["axles"]] == ["Front axle", "Rear axle"]
    front = content["axles"][0]
    assert [one["text"] for one in front["wheels"]] == ["pass", "fail"]
    row = next(row for row in front["rows"] if row["label"].startswith("Least phase angle"))
    left, right, difference, passes = row["cells"]
    assert row["decides"] is True
    steady = steady_state(LinearQuarterCar(330.0, 36.0, 22e3, 1300.0, 210e3))
    assert left["text"] == f"{steady.phase_angle_min_deg:.1f}°"
    assert (
        left["half"] == f"± 0.4° at {steady.phase_frequency_hz:.1f} Hz"
    )  # behind its value, rounded up
    assert (left["band"], left["tone"]) == ("sufficient", "green")
    assert (right["band"], right["tone"]) == ("too small", "red")
    assert difference["band"] == "too large"
    assert passes["text"] == "from 35°"
    assert content["verdict"] == {"text": "fail", "tone": "red"}
    assert content["reasons"][0]["place"] == "Front right"
    assert "is too small (below 35°): fail" in content["reasons"][0]["text"]


def test_german_words_and_commas(worn: VehicleGrade) -> None:
    content = protocol_content(worn, FACTS, language="de")
    assert content["title"] == "Prüfprotokoll Stoßdämpfer"
    assert content["verdict"]["text"] == "nicht bestanden"
    row = next(row for row in content["axles"][0]["rows"] if "Bodenhaftung" in row["label"])
    assert re.fullmatch(r"\d+,\d %", row["cells"][0]["text"])
    assert row["cells"][0]["half"] == "± 0,3 %"
    assert content["reasons"][0]["place"] == "Vorn rechts"
    assert content["head"][2] == {"label": "Datum", "text": "21.11.2026"}


@pytest.mark.parametrize(
    ("language", "words"), [("en", "Simulated, not measured"), ("de", "Simuliert, nicht gemessen")]
)
def test_simulated_records_say_so_across_the_page(worn: VehicleGrade, language, words) -> None:
    assert 'class="across"' not in protocol_html(worn, language=language, about=FACTS)
    (axle, *others) = worn.axles
    facts = {**axle.inspection.facts, "simulated": "jounce, seed 0"}
    simulated = replace(
        worn, axles=(replace(axle, inspection=replace(axle.inspection, facts=facts)), *others)
    )
    page = protocol_html(simulated, language=language, about=FACTS)
    assert f'<p class="across" aria-hidden="true">{words}</p>' in page
    assert protocol_content(simulated, FACTS)["simulated"]
    assert len(protocol_png(simulated, language=language, about=FACTS)) == 1
    assert protocol_png(simulated, language=language)[0] != protocol_png(worn, language=language)[0]


def test_both_languages_have_the_same_words() -> None:
    from jounce.report.protocol import words_in

    assert set(words_in("en")) == set(words_in("de"))


def test_a_sound_car_says_so(sound: VehicleGrade) -> None:
    content = protocol_content(sound, FACTS)
    assert content["verdict"]["tone"] == "green"
    assert [one["text"] for one in content["reasons"]] == [
        "All deciding values are within their limits."
    ]
    assert content["more"] == ""


def test_reasons_that_do_not_fit_are_counted(worn: VehicleGrade) -> None:
    every = protocol_content(worn, FACTS)
    few = protocol_content(worn, FACTS, most=2)
    total = len(every["reasons"]) + len(every["remarks"])
    assert total > 2
    assert few["reasons"] == every["reasons"][:2]
    assert few["more"] == f"… and {total - 2} more, see the data file beside this report."


def test_a_wheel_that_is_not_graded_shows_no_bands() -> None:
    unfit = WheelResult(
        "left", adhesion=0.7, findings=(Finding("left", "problem", "the force is clipped."),)
    )
    content = protocol_content(vehicle(axle("front", unfit, wheel("right"))), {})
    assert content["verdict"] == {"text": "not graded", "tone": "grey"}
    row = next(row for row in content["axles"][0]["rows"] if row["label"].startswith("Adhesion"))
    assert row["cells"][0]["band"] == ""
    assert row["cells"][1]["band"] != ""
    assert {"place": "Front left", "text": "The force is clipped.", "tone": "grey"} in content[
        "reasons"
    ]


def test_a_missing_wheel_and_missing_facts_are_shown_as_missing() -> None:
    content = protocol_content(vehicle(axle("", wheel("right"))), {})
    assert content["axles"][0]["wheels"][0] == {"text": "not tested", "tone": "grey"}
    assert {one["text"] for one in content["head"]} == {"–"}


def test_sources_of_the_limits_are_named(sound: VehicleGrade) -> None:
    sources = protocol_content(sound, FACTS)["sources"]
    assert [one.partition(":")[0] for one in sources] == ["EUSAMA", "EGEA", "THETA"]
    assert "absolute criterion" in sources[1]
    assert "relative criterion" in sources[1]


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("a\x00b\r\nc", "a b c"),
        ("\u202eevil", "evil"),
        ("  ", "–"),
        ("x" * 300, "x" * 159 + "…"),
        ("\ud800", "–"),
    ],
)
def test_texts_become_one_short_line(text: str, shown: str) -> None:
    assert shorten(text) == shown


# --- pages ----------------------------------------------------------------------------------------------------------


def test_the_pdf_is_one_page_and_the_same_bytes_every_time(
    worn: VehicleGrade, record: xr.Dataset
) -> None:
    records = {"front": record, "rear": record}
    first = protocol_pdf(worn, records=records)
    assert first.startswith(b"%PDF-")
    assert protocol_pdf(worn, records=records) == first
    assert protocol_pdf(worn, records=records, language="de") != first
    assert b"(D:20261121000000" in first  # the day of the test, not of the printing
    pages = protocol_png(worn, records=records, ppi=30.0)
    assert len(pages) == 1
    assert pages[0].startswith(b"\x89PNG")


def test_german_dates_are_dates(worn: VehicleGrade) -> None:
    assert b"(D:20261121000000" in protocol_pdf(worn, about={"date": "21.11.2026"})


def test_the_comment_says_what_is_simulated() -> None:
    """Synthetic data says so wherever it is shown."""
    car = vehicle(
        axle("front", comment="simulated, seed 0"), axle("rear", comment="simulated, seed 0")
    )
    html = protocol_html(car, language="de")
    assert re.search(r"<dt>Bemerkung</dt><dd>simulated, seed 0</dd>", html)


@pytest.mark.parametrize("date", ["yesterday", "", "2026-13-45"])
def test_a_date_that_is_none_is_no_date(worn: VehicleGrade, date: str) -> None:
    page = protocol_pdf(worn, about={"date": date})
    assert page.startswith(b"%PDF-")
    assert b"CreationDate" not in page


HOSTILE = [
    '#let x = 1; #read("/etc/passwd") #panic("no")',
    '$sum_(i=0)^n$ "quoted" \\ `code` @ref <label> *b* _i_ [a] {b}',
    "// c /* d */ <script>alert(1)</script> & <b> &amp; </style>",
    "\\u{1F600} \x00\x07\x1b[31m \u202e \ufeff \ud800",
    "{{ 7*7 }} {% raw %}",
    "Donaudampfschifffahrtsgesellschaftskapitän" * 30,
    "W" * 2000,
    "ÄÖÜäöüß é ñ ł 漢字 العربية",
]


@pytest.fixture(scope="module")
def drawn(worn: VehicleGrade) -> dict[str, bytes]:
    """The curves of one vehicle, which are the same whatever stands around them."""
    return protocol._figures(worn, None, "en")


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_texts_are_printed_and_not_run(
    worn: VehicleGrade, drawn, monkeypatch, text: str
) -> None:
    monkeypatch.setattr(protocol, "_figures", lambda *_: drawn)
    about = dict.fromkeys((*FACTS, "place", "operator", "record"), text)
    pages = protocol_png(worn, about=about, ppi=20.0)
    assert len(pages) == 1
    archived = protocol_pdf(worn, about={**about, "date": "2026-11-21"})  # PDF/A is stricter
    assert archived.startswith(b"%PDF-")
    page = protocol_html(worn, about=about)
    found = Text(page)
    assert found.tags.count("script") == 1  # the page's own
    assert shorten(text, 64).split("…")[0][:20].strip() in found.text
    assert "alert(1)</script>" not in page


def test_hostile_findings_and_labels_are_printed(tmp_path: Path) -> None:
    finding = Finding(
        "left", "warning", '#panic("x") <script>alert(1)</script> $a$ ' + "long" * 200
    )
    inspection = axle(
        "front", replace(wheel("left"), findings=(finding,)), wheel("right"), vehicle=HOSTILE[0]
    )
    files = write_protocol(grade(inspection), tmp_path / "a.pdf")
    assert [file.name for file in files] == ["a.pdf", "a.json"]
    assert json.loads(files[1].read_text(encoding="utf-8"))["about"]["vehicle"] == HOSTILE[0]
    assert (
        Text(protocol_html(grade_vehicle([grade(inspection)]))).tags.count("script") == 1
    )  # the page's own


def test_many_remarks_stay_on_one_page() -> None:
    findings = tuple(
        Finding("left", "warning", f"remark {i}: " + "this weakens the result " * 8)
        for i in range(60)
    )
    crowded = vehicle(
        axle("front", replace(wheel("left", 300.0), findings=findings), wheel("right")),
        axle("rear"),
    )
    assert len(protocol_png(crowded, ppi=20.0)) == 1
    for text in ("Remark 0:", "Remark 59:"):
        assert text in Text(protocol_html(crowded)).text  # a screen has room


def test_no_values_at_all_still_make_a_page() -> None:
    empty = vehicle(Inspection((WheelResult("left"),), methods=("theta",)))
    assert protocol_pdf(empty).startswith(b"%PDF-")
    assert "keine Kurven vorhanden" in protocol_html(empty, language="de")


def test_the_html_needs_nothing_else_and_holds_the_same(
    worn: VehicleGrade, record: xr.Dataset
) -> None:
    page = protocol_html(worn, records={"front": record}, language="de")
    found = Text(page)
    assert found.tags.count("svg") == 2
    assert not re.search(r"(?:src|href)=\"(?!#)", page)
    for text in (
        "Prüfprotokoll",
        "M-ÄÖ 12",
        "Vorderachse",
        "nicht bestanden",
        "zu klein",
        "Unterschrift",
        "35°",
    ):
        assert text in found.text
    identities = re.findall(r'\bid="([^"]+)"', page)
    assert len(identities) == len(set(identities))


def test_unknown_languages_are_refused(worn: VehicleGrade) -> None:
    with pytest.raises(DescriptionError, match="unknown language 'fr'"):
        protocol_pdf(worn, language="fr")  # type: ignore[arg-type]


# --- files ----------------------------------------------------------------------------------------------------------


def test_page_and_values_are_written_beside_each_other(sound: VehicleGrade, tmp_path: Path) -> None:
    files = write_protocol(sound, tmp_path / "car.html", about={"operator": "J. Müller"})
    assert [file.name for file in files] == ["car.html", "car.json"]
    plain = json.loads(files[1].read_text(encoding="utf-8"))
    assert plain["schema"] == "jounce.protocol/1"
    assert plain["about"] == {**FACTS, "operator": "J. Müller"}
    assert plain["verdict"] == "pass"
    assert [len(one["wheels"]) for one in plain["axles"]] == [2, 2]
    assert plain["axles"][0]["limits"]["version"] == "1"


def test_nothing_is_overwritten_without_force(sound: VehicleGrade, tmp_path: Path) -> None:
    for name in ("car.pdf", "car.json"):
        (tmp_path / name).write_text("mine", encoding="utf-8")
        with pytest.raises(OutputError, match="the output already exists"):
            write_protocol(sound, tmp_path / "car.pdf")
        assert (tmp_path / name).read_text(encoding="utf-8") == "mine"
        assert len(list(tmp_path.iterdir())) == 1
        (tmp_path / name).unlink()
    (tmp_path / "car.html").write_text("mine", encoding="utf-8")
    write_protocol(sound, tmp_path / "car.html", force=True)
    assert (tmp_path / "car.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_other_formats_and_missing_folders_are_refused(sound: VehicleGrade, tmp_path: Path) -> None:
    with pytest.raises(
        OutputError, match=r"not written in this format; found '.docx'; allowed: .pdf, .html"
    ):
        write_protocol(sound, tmp_path / "car.docx")
    with pytest.raises(OutputError, match="folder"):
        write_protocol(sound, tmp_path / "none" / "car.pdf")
