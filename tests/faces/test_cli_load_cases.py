"""``jounce load-cases`` through its entry point."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

import jounce as jn
from jounce.core.display import local_units
from jounce.plots import number
from jounce.plots.mechanisms.load_cases import load_case

RIG = "formula-student-front"
CAR = {"axle": "front", "mass": "280 kg", "wheelbase": "1.55 m", "centre_of_mass_height": "300 mm"}
SHARES = {"weight_share": 0.48, "brake_share": 0.65}
NAMES = ("longitudinal", "lateral", "vertical")
GIVEN = [part for key, value in {**CAR, **SHARES}.items() for part in ("--car", f"{key}={value}")]


def test_forces_are_those_of_python_in_table_file_json_and_picture(cli, tmp_path) -> None:
    case = [
        "--case",
        "braking 1.2 g: longitudinal=-1.2",
        "--case",
        "both: longitudinal=-0.7, lateral=0.9",
    ]
    out, folder = tmp_path / "cases.csv", tmp_path / "cases"
    outcome = cli(
        "load-cases", RIG, *GIVEN, *case, "--out", str(out), "--report", "cases.html", "--json"
    )
    assert outcome.exit_code == 0, outcome.err
    found = outcome.json
    assert found["cases"] == ["braking 1.2 g", "both"]
    cases = {
        "braking 1.2 g": {"longitudinal": -1.2},
        "both": {"longitudinal": -0.7, "lateral": 0.9},
    }
    wanted = jn.load_cases(jn.load(RIG), jn.LoadedAxle(**CAR, **SHARES), cases)
    for name in ("tie_rod.axial_force", "upper_ball_joint.fy", "wheel_travel"):
        assert found["forces"][name]["values"] == wanted[name].to_numpy().tolist()
    page = Path("cases.html").read_text(encoding="utf-8")
    force = float(
        np.linalg.norm([wanted[f"upper_ball_joint.f{axis}"].to_numpy()[1, 0] for axis in "xyz"])
    )
    assert number(force) in page
    assert page.count("<svg") == 2
    rows = list(csv.DictReader(out.read_text(encoding="utf-8").splitlines()))
    assert [(row["case"], row["wheel"]) for row in rows][:3] == [
        ("braking 1.2 g", "left"), ("braking 1.2 g", "right"), ("both", "left")
    ]  # fmt: skip
    assert float(rows[3]["spring.force [N]"]) == wanted["spring.force"].to_numpy()[1, 1]
    drawn = cli("load-cases", RIG, *GIVEN, *case[:2], "--figure", str(folder))
    assert f"written: {folder}" in drawn.out.replace("\n", "")
    assert [file.name for file in folder.iterdir()] == ["braking-1.2-g.png"]
    assert (folder / "braking-1.2-g.png").stat().st_size > 50_000
    again = cli("load-cases", RIG, *GIVEN, *case, "--out", str(out))
    assert again.exit_code == 2
    assert "exists" in again.err


def test_usual_cases_are_shown_and_what_the_spring_cannot_carry_is_told(cli) -> None:
    outcome = cli("load-cases", RIG, *GIVEN)
    assert outcome.exit_code == 0
    for text in (
        "static",
        "cornering 1 g",
        "Magnitudes of forces at hardpoints",
        "cannot carry the load within 100 mm",
    ):
        assert text in outcome.out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--case", "braking"], "invalid load case"),
        (["--case", "a: lateral=fast"], "lateral"),
        (["--case", "a: sideways=1"], "sideways"),
        (["--case", "a: lateral=1", "--case", "a: lateral=2"], "given twice"),
        (["--car", "colour=red"], "colour"),
        (["--out", "cases.xlsx"], ".csv"),
    ],
)
def test_bad_cases_are_refused(cli, arguments, message: str) -> None:
    outcome = cli("load-cases", RIG, *GIVEN, *arguments)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_a_lumped_rig_has_no_joints(cli) -> None:
    outcome = cli("load-cases", "kart-quarter-car", *GIVEN)
    assert outcome.exit_code == 2
    assert "lumped" in outcome.err


def test_numbers_of_forces_stand_beside_each_other_and_follow_the_units() -> None:
    rig = jn.load(RIG)
    found = jn.load_cases(
        rig, jn.LoadedAxle(**CAR, **SHARES), {"both": {"longitudinal": -0.7, "lateral": 0.7}}
    )
    figure = load_case(rig, found, "both")
    FigureCanvasAgg(figure).draw()
    sizes = []
    for axes in figure.axes:
        told = [text for text in axes.texts if text.get_text()]
        sizes.append(sorted(float(text.get_text()) for text in told))
        boxes = [text.get_window_extent() for text in told]
        assert len(boxes) > 8
        for k, one in enumerate(boxes):
            assert not any(one.overlaps(other) for other in boxes[k + 1 :])
    assert sizes[0] == sizes[1]
    largest = float(np.sqrt(sum(found[f"{name}_force"].to_numpy() ** 2 for name in NAMES)).max())
    assert f"{1e-3 * largest:.2f}" in [text.get_text() for text in figure.axes[0].texts]
    with local_units("imperial"):
        figure = load_case(rig, found, "both")
    assert [axes.get_ylabel() for axes in figure.axes] == ["z [in]", "x [in]"]
    assert f"{largest / 4.4482216:.0f}" in [text.get_text() for text in figure.axes[0].texts]
    inches = float(found["wheel_travel"].sel(case="both", wheel="left")) / 0.0254
    assert any(
        f"numbers: lbf; wheel travel: left {inches:+.2f} in" in text.get_text()
        for text in figure.texts
    )
