"""``jounce export``: equations and hardpoints, and what is refused; FMUs have tests of their own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.parts.importers import import_hardpoints


@pytest.mark.parametrize(
    ("suffix", "begin"),
    [(".tex", "% quarter-car"), (".py", '"""quarter-car'), (".c", "/* quarter-car")],
)
def test_equations(cli, tmp_path: Path, suffix: str, begin: str) -> None:
    outcome = cli("export", "equations", "kart-quarter-car", "--out", f"kart{suffix}")
    assert outcome.exit_code == 0, outcome.err
    assert (tmp_path / f"kart{suffix}").read_text().startswith(begin)
    assert "speeds: sprung.vz, unsprung.vz" in outcome.out
    assert cli("export", "equations", "kart-quarter-car", "--out", f"kart{suffix}").exit_code == 2


def test_equations_as_a_function_of_casadi(cli, tmp_path: Path) -> None:
    import casadi as ca

    plain = cli("export", "equations", "kart-quarter-car", "--out", "kart.casadi", "--json").json
    assert plain["numbers"]["sprung.mass"] == 16.0
    found = ca.Function.load(str(tmp_path / "kart.casadi"))
    assert found.name_out() == ["M", "Q", "G", "gamma", "dq", "dz"]
    refused = cli("export", "equations", "kart-quarter-car", "--out", "kart.docx")
    assert (refused.exit_code, ".tex, .py, .c, .casadi" in refused.err) == (2, True)


@pytest.mark.parametrize(
    "name", ["formula-student-front", "generic-mcpherson", "sedan-multi-link", "semi-trailing-arm"]
)
def test_hardpoints_come_back(cli, tmp_path: Path, name: str) -> None:
    outcome = cli("export", "hardpoints", name, "--out", "points.csv")
    assert outcome.exit_code == 0
    rig = jn.load(name)
    found, _, _ = import_hardpoints(tmp_path / "points.csv", model=rig.model)
    for point, place in rig.hardpoints.given().items():
        assert getattr(found.hardpoints, point) == pytest.approx(place, abs=1e-9)


def test_a_drawing_for_cad(cli, tmp_path: Path) -> None:
    assert cli("export", "hardpoints", "kart-double-wishbone", "--out", "kart.dxf").exit_code == 0
    lines = (tmp_path / "kart.dxf").read_text().splitlines()
    pairs = list(zip(map(int, lines[::2]), lines[1::2], strict=True))
    rig = jn.load("kart-double-wishbone").hardpoints
    kinds = [value for code, value in pairs if code == 0]
    assert kinds.count("POINT") == kinds.count("TEXT") == len(rig.given())
    assert kinds.count("LINE") == len(type(rig).rods) + 1
    assert (kinds[0], kinds[-1]) == ("SECTION", "EOF")
    at = pairs.index((1, "wheel_centre"))
    place = [float(value) for code, value in pairs[at - 6 : at] if code in (10, 20, 30)]
    assert place == pytest.approx([1e3 * value for value in rig.wheel_centre])


def test_a_lumped_rig_has_no_hardpoints(cli) -> None:
    refused = cli("export", "hardpoints", "kart-quarter-car", "--out", "points.csv")
    assert (refused.exit_code, "the rig has no hardpoints" in refused.err) == (2, True)


@pytest.mark.parametrize("suffix", [".crg", ".csv"])
def test_roads_come_back(cli, tmp_path: Path, suffix: str) -> None:
    outcome = cli(
        "export", "road", "iso:C", "--length", "20 m", "--step", "0.05 m", "--out", f"road{suffix}"
    )
    assert outcome.exit_code == 0, outcome.err
    assert "401 points over 20 m" in outcome.out
    own, found = jn.load_road("iso:C", length=20.0), jn.load_road(tmp_path / f"road{suffix}")
    at = np.arange(401) * 0.05
    np.testing.assert_allclose(
        found.height_at(at[:-1]), own.height_at(at[:-1]), rtol=0.0, atol=1e-9
    )


def test_what_is_lost_between_points_is_said(tmp_path: Path) -> None:
    """Half a sine of 10 mm and 0.2 m: half way between points 0.1 m apart it is sin 45 degrees high, the line 5 mm."""
    made = jn.write_road(jn.HalfSine(height=0.01, length=0.2), tmp_path / "bump.crg", step=0.1)
    assert made.findings[0].value == pytest.approx(0.01 * (np.sin(np.pi / 4) - 0.5))
    assert not jn.write_road(jn.Flat(), tmp_path / "flat.crg", length=5.0).findings


def test_roads_that_cannot_be_written(cli) -> None:
    for words, message in (
        (("iso:C", "--out", "road.toml"), ".crg, .csv"),
        (("iso:C", "--out", "road.crg", "--step", "0 m"), "above 0"),
        (("iso:C", "--out", "road.crg", "--step", "1 um"), "invalid number of points"),
        (("nothing.toml", "--out", "road.crg"), "no such file"),
    ):
        refused = cli("export", "road", *words)
        assert (refused.exit_code, message in refused.err) == (2, True), refused.err
    rough = jn.Iso8608(class_="C", length="10 m")
    with pytest.raises(jn.JounceError, match="the road is not known over this distance"):
        jn.write_road(rough, "road.crg", length=20.0)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("sldemo-half-car", "--tester", "eusama"), "cannot be placed on a tester"),
        (("kart-quarter-car", "--tester", "eusema"), "eusama"),
        (("kart-quarter-car", "--axle", "rear"), "--axle with --tester"),
        (("audi-a6-full-car", "--tester", "eusama", "--axle", "middle"), "front, rear"),
        (
            ("audi-a6-quarter-car", "--tester", "eusama", "--control", "skyhook"),
            "is not controlled",
        ),
    ],
)
def test_rigs_that_are_not_written_on_a_tester(cli, tmp_path: Path, words, message) -> None:
    refused = cli("export", "fmu", *words, "--sources-only", "--out", "a.fmu")
    assert (refused.exit_code, message in refused.err) == (2, True), refused.err
    assert not (tmp_path / "a.fmu").exists()


def test_a_model_of_mujoco_comes_back(cli, tmp_path: Path) -> None:
    assert cli("export", "mjcf", "kart-double-wishbone", "--out", "kart.xml").exit_code == 0
    outcome = cli("import", "mjcf", "kart.xml", "--out", "kart.toml")
    assert outcome.exit_code == 0, outcome.err
    assert jn.load(tmp_path / "kart.toml").model == "double-wishbone"
