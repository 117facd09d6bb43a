from __future__ import annotations

import json
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.parts.importers import read_chrono_corner

SHIPPED = (
    Path(str(resources.files("jounce.parts")))
    / "library"
    / "hmmwv"
    / "HMMWV_DoubleWishboneFront_mapShock.json"
)


def changed(tmp_path: Path, change: Callable[[dict[str, Any]], object]) -> Path:
    table = json.loads(SHIPPED.read_text(encoding="utf-8"))
    change(table)
    file = tmp_path / "corner.json"
    file.write_text(json.dumps(table), encoding="utf-8")
    return file


@pytest.mark.source(
    kind="published",
    of="files of other makers",
    key="project-chrono",
    where="what its file of the HMMWV's front suspension prints, read by eye",
    tolerance="the digits of the file",
    compares="points, masses and damper of a corner",
)
def test_values_are_those_of_the_file():
    corner = read_chrono_corner(SHIPPED)
    assert corner.name == "HMMWV DoubleWishbone Front"
    assert corner.points["lower_ball_joint"].tolist() == [-0.036, 0.787, -0.118]
    assert corner.points["wheel_centre"].tolist() == [-0.040, 0.910, -0.026]
    assert (corner.parts["lower_arm"].mass, corner.tie_rod_mass) == (23.965, 6.0)
    assert (corner.spring_rate, corner.spring_free_length) == (167062.0, 0.339)
    assert corner.damper.force.shape == (5, 15)
    # the row of -0.333333 m/s holds -4173.85 N at mid stroke, that of 0.333333 m/s 7486.67 N
    assert corner.damper.coefficients_at(0.37) == pytest.approx(
        (4173.85 / 0.333333, 7486.67 / 0.333333), rel=1e-6
    )
    # near the ends of the stroke it is harder in rebound, as in the file: 20022.8 N
    assert corner.damper.coefficients_at(0.28)[1] == pytest.approx(20022.8 / 0.333333, rel=1e-6)


def test_comments_are_allowed_as_chrono_allows_them(tmp_path: Path):
    text = SHIPPED.read_text(encoding="utf-8").replace(
        '"Name":', '// of "a" vehicle\n  /* front\n axle */ "Name":'
    )
    file = tmp_path / "corner.json"
    file.write_text(
        text.replace("HMMWV DoubleWishbone Front", "http://x /* y */"), encoding="utf-8"
    )
    assert read_chrono_corner(file).name == "http://x /* y */"


BAD: list[tuple[Callable[[dict[str, Any]], object], str]] = [
    (
        lambda t: t.update(Template="MacPhersonStrut"),
        "cannot be read.*MacPhersonStrut.*DoubleWishbone",
    ),
    (lambda t: t.pop("Spring"), "'Spring' is missing"),
    (
        lambda t: t["Spring"].pop("Spring Coefficient"),
        "Spring: the key 'Spring Coefficient' is missing",
    ),
    (
        lambda t: t["Spring"].update({"Spring Coefficient": -1.0}),
        "Spring Coefficient: out of range; found -1",
    ),
    (lambda t: t["Spring"].update({"Minimum Length": 0.4}), "lengths contradict"),
    (
        lambda t: t["Spindle"].update(COM=[1.0, 2.0]),
        "Spindle: COM: unexpected numbers.*3 finite numbers",
    ),
    (lambda t: t["Spindle"].update(COM=[1.0, 2.0, "a"]), "Spindle: COM: not a regular list"),
    (
        lambda t: t["Spindle"].update(COM=[1.0, 2.0, float("nan")]),
        "Spindle: COM: unexpected numbers",
    ),
    (lambda t: t["Spindle"].update(Mass=True), "Spindle: Mass: unexpected numbers"),
    (lambda t: t["Shock"].pop("Map Data"), "'Map Data' is missing"),
    (lambda t: t["Shock"]["Map Data"][1].pop(), "Map Data: not a regular list"),
    (lambda t: t["Shock"]["Deformation"].pop(), r"Map Data: unexpected numbers.*n x 15 finite"),
    (lambda t: t["Shock"]["Deformation"].reverse(), "Deformation: fewer than two ascending"),
    (
        lambda t: [row.__setitem__(0, row[0] + 2.0) for row in t["Shock"]["Map Data"]],
        "do not span zero",
    ),
]


@pytest.mark.parametrize(("change", "message"), BAD)
def test_wrong_values_are_refused_with_their_place(tmp_path: Path, change: Callable, message: str):
    with pytest.raises(DescriptionError, match=message):
        read_chrono_corner(changed(tmp_path, change))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b'{\n "Name": "x",\n}', "line 3.*|not valid JSON"),
        (b"", "not valid JSON"),
        (b"[1, 2]", "not a description"),
        (b"\xff\xfe\x00", "not a text file"),
    ],
)
def test_other_files_are_refused(tmp_path: Path, content: bytes, message: str):
    file = tmp_path / "corner.json"
    file.write_bytes(content)
    with pytest.raises(DescriptionError, match=message):
        read_chrono_corner(file)
    with pytest.raises(DescriptionError, match="no such file"):
        read_chrono_corner(tmp_path / "missing.json")


def test_both_elements_stand_on_the_lower_arm():
    corner = read_chrono_corner(SHIPPED)
    assert corner.distance("spring_bottom", "damper_bottom") == 0.0
    assert np.isclose(corner.distance("spring_top", "spring_bottom"), 0.246321, atol=1e-6)
