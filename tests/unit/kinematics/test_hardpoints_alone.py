"""Hardpoints and the wheel's radius are enough to sweep; nothing that takes masses, springs or tyres exists then."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.exchange.points import write_hardpoints
from jounce.kinematics import CATALOGUE
from jounce.parts import Corner, library, rig_findings
from jounce.parts.files import rig_from_table, rig_text
from jounce.parts.importers import import_hardpoints
from jounce.parts.variants import with_strut_angle

OF_FORCES = {
    "spring_force",
    "stop_force",
    "damper_force",
    "wheel_force",
    "wheel_rate",
    "wheel_rate_spring",
    "wheel_rate_contact",
    "wheel_rate_contact_spring",
    "wheel_damping_coefficient",
    "tyre_deflection",
    "ride_rate",
    "tyre_stiffness",
}


def points_of(name: str, folder: Path, further: str = "") -> Path:
    """A file with only the tables of hardpoints and wheel of a shipped rig, and its push rod's foot."""
    whole = jn.load(name)
    assert name in library()
    lines = ['schema = "jounce.rig/1"', f'model = "{whole.model}"', "# only points", "[hardpoints]"]
    lines += [f"{point} = {list(place)}" for point, place in whole.hardpoints.given().items()]
    lines += [
        "[wheel]",
        f"radius = {whole.wheel.radius}",
        f"camber = {whole.wheel.camber}",
        f"toe = {whole.wheel.toe}",
    ]
    file = folder / "points.toml"
    file.write_text("\n".join([*lines, further]), encoding="utf-8")
    return file


@pytest.mark.parametrize(
    "name",
    [
        "reference-double-wishbone",
        "formula-student-front",
        "generic-mcpherson",
        "semi-trailing-arm",
    ],
)
def test_rows_of_geometry_are_those_of_the_whole_rig(name: str, tmp_path: Path) -> None:
    whole = jn.load(name)
    on = f'[strut]\non = "{whole.strut.on}"\n'
    if hasattr(whole.strut, "pushrod_on"):
        on += f'pushrod_on = "{whole.strut.pushrod_on}"\n'
    rig = jn.load(points_of(name, tmp_path, on))
    assert set(rig.without) == {"bodies", "spring", "damper", "tyre"}
    found, expected = (jn.sweep_travel(one, [-0.02, 0.0, 0.02]) for one in (rig, whole))
    assert set(expected.data_vars) - set(found.data_vars) == OF_FORCES & set(expected.data_vars)
    for row in found.data_vars:
        assert found[row].to_numpy() == pytest.approx(expected[row].to_numpy(), abs=1e-12), row


def test_a_spring_without_masses_has_its_wheel_rate(tmp_path: Path) -> None:
    further = '[strut]\non = "rocker"\nspring = {rate = "35 N/mm", preload = "1047 N"}\n'
    rig, whole = (
        jn.load(points_of("formula-student-front", tmp_path, further)),
        jn.load("formula-student-front"),
    )
    assert rig.without == ("bodies", "damper", "tyre")
    found, expected = (
        jn.sweep_travel(one, [-0.01, 0.0, 0.01])["wheel_rate_spring"] for one in (rig, whole)
    )
    assert found.to_numpy() == pytest.approx(expected.to_numpy(), rel=1e-12)


def test_axles_and_designs_of_hardpoints_alone(tmp_path: Path) -> None:
    rig = jn.load(points_of("formula-student-front", tmp_path))
    rolled = jn.sweep_roll(rig, "-2 deg:2 deg:1 deg")
    assert np.isfinite(rolled["roll_centre_height"]).all()
    assert "roll_moment" not in rolled
    target = {"quantity": "bump_steer", "value": "0 deg/m", "tolerance": "0.1 deg/m"}
    assert jn.design_kinematics(rig, {"hardpoints.tie_rod_inner[2]": "15 mm"}, [target]).met
    assert rig_findings(rig) == []


def test_files_of_hardpoints_stay_so(tmp_path: Path) -> None:
    rig = jn.load(points_of("formula-student-front", tmp_path))
    text = rig_text(rig)
    for word in ("bodies", "mass", "tyre", "spring =", "without", "guide"):
        assert word not in text
    (tmp_path / "again.toml").write_text(text, encoding="utf-8")
    assert jn.load(tmp_path / "again.toml") == rig
    moved = rig.with_changes({"hardpoints.tie_rod_inner[2]": "151 mm"})
    kept = jn.save(moved, tmp_path / "kept.toml", like=tmp_path / "points.toml")
    assert "# only points" in kept.read_text(encoding="utf-8")
    assert "bodies" not in kept.read_text(encoding="utf-8")
    assert jn.load(kept) == moved
    assert rig.mirrored().mirrored() == rig
    assert not any(
        path.startswith(("bodies.", "tyre.", "strut.spring")) for path in rig.parameters()
    )


def test_what_takes_forces_is_refused(tmp_path: Path) -> None:
    rig = jn.load(points_of("formula-student-front", tmp_path))
    with pytest.raises(
        jn.DescriptionError, match="cannot be determined from hardpoints alone"
    ) as caught:
        jn.simulate(
            rig,
            jn.Trial(
                road={"kind": "half-sine", "height": 0.01, "length": 0.1, "start": 0.2},
                speed=2.0,
                duration=1.0,
            ),
        )
    assert "[tyre]" in str(caught.value)
    with pytest.raises(jn.DescriptionError):
        jn.lumped_from(rig)
    with pytest.raises(jn.DescriptionError, match="needs all its parts"):
        jn.load("formula-student-car").with_changes({"front.corner": rig.model_dump(by_alias=True)})
    with pytest.raises(jn.DescriptionError, match="unknown parameter"):
        jn.design_kinematics(
            rig,
            {"strut.spring.rate": "1 N/mm"},
            [{"quantity": "camber", "value": 0.0, "tolerance": 0.1}],
        )


def test_some_bodies_are_not_none(tmp_path: Path) -> None:
    body = (
        "[bodies.upright]\nmass = 10.0\ncentre_of_mass = [0.0, 0.59, 0.2]\ninertia = {xx = "
        "0.1, yy = 0.1, zz = 0.1}\n"
    )
    with pytest.raises(jn.DescriptionError, match="lower_arm"):
        jn.load(points_of("formula-student-front", tmp_path, body))
    with pytest.raises(jn.DescriptionError):
        jn.load(points_of("formula-student-front", tmp_path, '[sprung]\nmass = "60 kg"\n'))


# without a strut ------------------------------------------------------------------------------------------------------

TEMPLATES = [
    "reference-double-wishbone",
    "formula-student-front",
    "sedan-multi-link",
    "semi-trailing-arm",
]
OF_STRUTS = {row.name for row in CATALOGUE if row.needs in ("strut", "rack strut", "rocker strut")}
STRUTS = ("strut_", "spring_", "damper_", "arb_", "third_")


def table_of(name: str) -> dict[str, Any]:
    """Table of a shipped rig with the points of its links and its wheel only."""
    whole = jn.load(name)
    points = {
        point: list(at)
        for point, at in whole.hardpoints.given().items()
        if not point.startswith(STRUTS)
    }
    wheel = {"radius": whole.wheel.radius, "camber": whole.wheel.camber, "toe": whole.wheel.toe}
    on = {"pushrod_on": whole.strut.pushrod_on} if "pushrod_outer" in points else {}
    return {
        "schema": "jounce.rig/1",
        "model": whole.model,
        "hardpoints": points,
        "wheel": wheel,
        "strut": on,
    }


def by_hand(name: str, folder: Path) -> Corner:
    table = table_of(name)
    lines = ['schema = "jounce.rig/1"', f'model = "{table["model"]}"']
    for part in ("hardpoints", "wheel", "strut"):
        lines += [f"[{part}]", *(f"{key} = {value!r}" for key, value in table[part].items())]
    file = folder / "points.toml"
    file.write_text("\n".join(lines), encoding="utf-8")
    return jn.load(file)


def in_python(name: str, _: Path) -> Corner:
    return rig_from_table(table_of(name))


def imported(name: str, folder: Path) -> Corner:
    points = table_of(name)["hardpoints"]
    file = folder / "points.csv"
    rows = [f"{point},{','.join(map(str, at))}" for point, at in points.items()]
    file.write_text("\n".join(["name,x [m],y [m],z [m]", *rows]), encoding="utf-8")
    wheel = jn.load(name).wheel
    _, findings, text = import_hardpoints(file, wheel_radius=wheel.radius)
    assert any("the table contains no strut" in finding.message for finding in findings)
    (folder / "rig.toml").write_text(text, encoding="utf-8")
    return jn.load(folder / "rig.toml").with_changes(
        {"wheel.camber": wheel.camber, "wheel.toe": wheel.toe}
    )


def exchanged(name: str, folder: Path) -> Corner:
    rig = in_python(name, folder)
    again, _, _ = import_hardpoints(
        write_hardpoints(rig, folder / "again.csv"), wheel_radius=rig.wheel.radius
    )
    assert write_hardpoints(rig, folder / "again.dxf").is_file()
    return again.with_changes({"wheel.camber": rig.wheel.camber, "wheel.toe": rig.wheel.toe})


@pytest.mark.parametrize("name", TEMPLATES)
@pytest.mark.parametrize("way", [by_hand, in_python, imported, exchanged])
def test_points_of_the_links_are_enough_by_every_way_in(
    way: Any, name: str, tmp_path: Path
) -> None:
    whole, rig = jn.load(name), way(name, tmp_path)
    assert rig.lacks == ("strut", "bodies", "spring", "damper", "tyre")
    found, expected = (jn.sweep_travel(one, [-0.02, 0.0, 0.02]) for one in (rig, whole))
    absent = set(expected.data_vars) - set(found.data_vars)
    assert {row for row in absent if not row.startswith("anti_roll_bar")} == (
        OF_FORCES | OF_STRUTS
    ) & set(expected.data_vars)
    for row in found.data_vars:
        assert found[row].to_numpy() == pytest.approx(
            expected[row].to_numpy(), rel=1e-6, abs=1e-9
        ), row
    assert np.isfinite(jn.sweep_roll(rig, "-2 deg:2 deg:1 deg")["roll_centre_height"]).all()
    if "steer_gain" in found:
        assert np.isfinite(jn.sweep_steering(rig, "-10 mm:10 mm:5 mm")["left.steer"]).all()
    assert rig_findings(rig) == []
    assert rig.mirrored().mirrored() == rig
    assert "strut_" not in rig_text(rig)
    assert rig_from_table(rig.model_dump(by_alias=True, exclude_none=True)) == rig


@pytest.mark.parametrize("name", TEMPLATES)
def test_what_needs_a_strut_says_that_it_is_missing(name: str, tmp_path: Path) -> None:
    rig = by_hand(name, tmp_path)
    target = {"value": 0.0, "tolerance": 0.1}
    inner = next(point for point in rig.hardpoints.given() if point.endswith("inner"))
    free = {f"hardpoints.{inner}[2]": "5 mm"}
    car = jn.LoadedAxle(axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48,
                        brake_share=0.65)  # fmt: skip
    asked = {
        "motion_ratio": lambda: jn.design_kinematics(
            rig, free, [{"quantity": "motion_ratio", **target}]
        ),
        "wheel_rate": lambda: jn.design_kinematics(
            rig, free, [{"quantity": "wheel_rate", **target}]
        ),
        "spring_length": lambda: jn.fit_hardpoints(
            rig, {"wheel_travel": [0.0, 0.01, 0.02], "spring_length": [0.3] * 3}, free
        ),
        "how it moves": lambda: jn.modes(rig),
        "what the joints carry": lambda: jn.load_cases(rig, car),
        "the angle of the strut": lambda: with_strut_angle(rig, "20 deg"),
    }
    for what, ask in asked.items():
        with pytest.raises(jn.DescriptionError) as caught:
            ask()
        message = str(caught.value)
        assert f"{what} cannot be determined from hardpoints alone" in message
        assert "hardpoints.strut_bottom and strut_top" in message


def test_a_fit_of_points_needs_no_strut(tmp_path: Path) -> None:
    rig = by_hand("formula-student-front", tmp_path)
    truth = rig.with_changes({"hardpoints.tie_rod_inner[2]": "151 mm"})
    travel = np.linspace(-0.03, 0.03, 13)
    measured = {"wheel_travel": travel, "toe": jn.sweep_travel(truth, travel)["toe"].to_numpy()}
    found = jn.fit_hardpoints(
        rig, measured, {"hardpoints.tie_rod_inner[2]": "10 mm"}, noise={"toe": "0.01 deg"}
    )
    assert found.numbers["hardpoints.tie_rod_inner[2]"].value == pytest.approx(0.151, abs=1e-6)
    assert not found.rig.has_strut


def test_a_strut_has_both_ends_and_whoever_describes_it_gives_them(tmp_path: Path) -> None:
    rig = by_hand("reference-double-wishbone", tmp_path)
    whole = jn.load("reference-double-wishbone")
    bottom, top = whole.hardpoints.strut_bottom, whole.hardpoints.strut_top
    added = rig.with_changes({"hardpoints.strut_bottom": bottom, "hardpoints.strut_top": top})
    assert "motion_ratio" in jn.sweep_travel(added, [0.0])
    with pytest.raises(jn.DescriptionError, match="strut_bottom is missing; give all of"):
        rig.with_changes({"hardpoints.strut_top": top})
    for changes in (
        {"strut.spring": {"rate": 3e4}},
        {"strut.bump_stop": {"gap": 0.03, "rate": 1e5}},
        {"hardpoints.spring_bottom": bottom, "hardpoints.spring_top": top},
    ):
        with pytest.raises(
            jn.DescriptionError, match=r"hardpoints\.strut_bottom: is missing, as is strut_top"
        ):
            rig.with_changes(changes)
    table = whole.model_dump(by_alias=True, exclude_none=True)
    for end in ("bottom", "top"):
        del table["hardpoints"][f"strut_{end}"]
    with pytest.raises(
        jn.DescriptionError, match=r"found \[bodies\], strut\.spring, strut\.damper"
    ):
        rig_from_table(table)


def test_a_mcpherson_strut_is_one_of_its_links(tmp_path: Path) -> None:
    table = table_of("generic-mcpherson")
    with pytest.raises(jn.DescriptionError, match=r"hardpoints\.strut_bottom"):
        rig_from_table(table)
    file = tmp_path / "points.csv"
    rows = [f"{point},{','.join(map(str, at))}" for point, at in table["hardpoints"].items()]
    file.write_text("\n".join(["name,x [m],y [m],z [m]", *rows]), encoding="utf-8")
    with pytest.raises(jn.DescriptionError, match="these points and strut_bottom, strut_top"):
        import_hardpoints(file)


def test_half_a_strut_in_a_table_is_refused(tmp_path: Path) -> None:
    points = table_of("reference-double-wishbone")["hardpoints"]
    points["strut_top"] = [0.0, 0.5, 0.6]
    file = tmp_path / "points.csv"
    rows = [f"{point},{','.join(map(str, at))}" for point, at in points.items()]
    file.write_text("\n".join(["name,x [m],y [m],z [m]", *rows]), encoding="utf-8")
    with pytest.raises(jn.DescriptionError, match="these points and strut_bottom"):
        import_hardpoints(file)


def test_what_is_added_to_hardpoints_alone_counts() -> None:
    rig = jn.load("reference-double-wishbone")
    table = rig.model_dump(by_alias=True, exclude_none=True)
    points = {key: table[key] for key in ("schema", "model", "hardpoints", "wheel")}
    sprung = rig_from_table(points).with_changes({"strut.spring": {"rate": 3e4, "preload": 1e3}})
    assert "spring" not in sprung.lacks
    expected = jn.sweep_travel(
        rig.with_changes({"strut.spring": {"rate": 3e4, "preload": 1e3}}), [0.0]
    )
    assert jn.sweep_travel(sprung, [0.0])["wheel_rate_spring"].to_numpy() == pytest.approx(
        expected["wheel_rate_spring"].to_numpy()
    )
    with pytest.raises(jn.DescriptionError, match="without"):
        rig_from_table({**points, "without": ["tyre"]})


def test_a_spring_beside_a_torsion_bar_counts_in_a_corner_and_in_a_car() -> None:
    car = jn.load("formula-student-car")
    table = car.model_dump(by_alias=True, exclude_none=True)
    corner = table["front"]["corner"]
    del corner["strut"]["spring"]
    corner["torsion_bar"] = {"stiffness": 300.0, "on": "rocker"}
    wound = type(car).from_table(table)
    assert wound.front.corner.without == ("spring",)
    text = rig_text(wound)
    assert "without" not in text
    assert type(car).from_table(tomllib.loads(text)) == wound
    sprung = wound.with_changes({"front.corner.strut.spring": {"rate": 2e4}}).front.corner
    assert sprung.without == ()
    assert sprung.strut.spring.rate == 2e4
