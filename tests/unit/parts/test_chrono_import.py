"""Suspensions of Project Chrono as rigs: every number where it belongs, every assumption said, bad files refused."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.parts import DoubleWishbone, FiveLink, McPherson, rig_from_table
from jounce.parts.importers import import_chrono, shipped_corner
from jounce.parts.leverage import (
    motion_ratio,
    spring_force,
    static_spring_force,
    static_tyre_deflection,
)

FILES = Path(__file__).parents[2] / "files" / "chrono"
FILE_NAMES = sorted(file.stem for file in FILES.glob("*.json") if "Single" not in file.stem)
READ_BY_EYE = pytest.mark.source(
    kind="published",
    of="files of other makers",
    key="project-chrono",
    where="what its files of suspensions print, read by eye",
    tolerance="the digits of the files",
)


def read(name: str, **options: Any) -> Any:
    return import_chrono(FILES / f"{name}.json", **options)


def table_of(name: str) -> dict[str, Any]:
    text = (FILES / f"{name}.json").read_text(encoding="utf-8")
    return json.loads("\n".join(line.partition("//")[0] for line in text.splitlines()))


def changed(tmp_path: Path, name: str, change: Callable[[dict[str, Any]], object]) -> Path:
    table = table_of(name)
    change(table)
    file = tmp_path / "changed.json"
    file.write_text(json.dumps(table), encoding="utf-8")
    return file


@pytest.mark.parametrize("name", FILE_NAMES)
def test_every_file_becomes_a_rig_that_stands_on_the_road(name: str):
    rig, findings, text = read(name)
    assert rig_from_table(tomllib.loads(text)) == rig
    assert rig.side == "left"
    assert rig.undeformed_radius - rig.hardpoints.wheel_centre[2] == pytest.approx(
        static_tyre_deflection(rig), abs=1e-6
    )
    below = [point[2] for point in rig.hardpoints.given().values()]
    assert min(below) > 0.0
    assert all(finding.place.startswith(str(FILES / name)) for finding in findings)
    known = rig.parameters()
    assert set(rig.estimated) <= {*known, *(path.rpartition(".")[0] for path in known)}


@pytest.mark.parametrize(
    ("name", "kind"), [("MacPhersonStrut", McPherson), ("Sedan_MultiLink", FiveLink)]
)
def test_templates_are_models(name: str, kind: type):
    assert isinstance(read(name)[0], kind)
    assert isinstance(read("audi_DoubleWishbone")[0], DoubleWishbone)


@READ_BY_EYE
def test_points_are_those_of_the_file_moved_up():
    rig, _, _ = read("audi_DoubleWishbone", wheel_radius=0.344)
    file = table_of("audi_DoubleWishbone")
    up = rig.hardpoints.wheel_centre[2] - file["Spindle"]["COM"][2]
    moved = np.array([0.0, 0.0, up])
    for name, (section, key) in {
        "lower_ball_joint": ("Lower Control Arm", "Location Upright"),
        "upper_arm_rear": ("Upper Control Arm", "Location Chassis Back"),
        "tie_rod_outer": ("Tierod", "Location Upright"),
        "strut_top": ("Spring", "Location Chassis"),
    }.items():
        assert getattr(rig.hardpoints, name) == pytest.approx(
            np.array(file[section][key]) + moved, abs=1e-9
        )
    assert rig.hardpoints.damper_top is None, "spring and damper share their ends"
    assert rig.bodies.upper_arm.centre_of_mass == pytest.approx(
        np.array([-0.1083, 0.5972, 0.1063]) + moved, abs=1e-9
    )


@READ_BY_EYE
def test_other_ends_of_a_damper_are_kept():
    points = read("HMMWV_DoubleWishboneFront")[0].hardpoints
    assert points.damper_bottom is None
    assert np.subtract(points.damper_top, points.strut_top) == pytest.approx(
        [0.0, -0.012, 0.126], abs=1e-9
    )


@READ_BY_EYE
def test_inertia_of_an_arm_is_turned_from_its_own_axes():
    """Chrono's arm has x along its axis: the moment about that axis is the file's first one, and traces stay."""
    rig, _, _ = read("Sedan_DoubleWishbone")
    for name, moments in (
        ("lower_arm", [0.0151, 0.0207, 0.0355]),
        ("upper_arm", [0.00591, 0.00190, 0.00769]),
    ):
        axis = np.subtract(
            getattr(rig.hardpoints, f"{name}_front"), getattr(rig.hardpoints, f"{name}_rear")
        )
        axis = axis / np.linalg.norm(axis)
        tensor = getattr(rig.bodies, name).inertia.tensor
        assert axis @ tensor @ axis == pytest.approx(moments[0], rel=1e-5)
        assert np.linalg.eigvalsh(tensor) == pytest.approx(sorted(moments), rel=1e-4)
    assert rig.bodies.upright.inertia.tensor == pytest.approx(np.diag([0.0138, 0.0146, 0.00283]))


def test_inertia_in_vehicle_axes_is_kept(tmp_path: Path):
    file = changed(
        tmp_path,
        "Sedan_DoubleWishbone",
        lambda table: table.update({"Vehicle-Frame Inertia": True}),
    )
    rig, findings, _ = import_chrono(file)
    assert rig.bodies.lower_arm.inertia.tensor == pytest.approx(np.diag([0.0151, 0.0207, 0.0355]))
    assert any("vehicle axes, as the file states" in finding.message for finding in findings)


def test_products_of_inertia_are_tensor_elements(tmp_path: Path):
    file = changed(
        tmp_path,
        "Sedan_DoubleWishbone",
        lambda table: table["Upright"].update({"Products of Inertia": [0.001, -0.0005, 0.0002]}),
    )
    inertia = import_chrono(file)[0].bodies.upright.inertia
    assert (inertia.xy, inertia.xz, inertia.yz) == pytest.approx((0.001, -0.0005, 0.0002))


@READ_BY_EYE
def test_inertia_of_links_has_z_along_the_link():
    rig, _, _ = read("Sedan_MultiLink")
    for name, moments in (
        ("link_3", [0.0543, 0.0541, 0.000279]),
        ("link_4", [0.0762, 0.527, 0.567]),
    ):
        along = np.subtract(
            getattr(rig.hardpoints, f"{name}_outer"), getattr(rig.hardpoints, f"{name}_inner")
        )
        along = along / np.linalg.norm(along)
        tensor = getattr(rig.bodies, name).inertia.tensor
        assert along @ tensor @ along == pytest.approx(moments[2], rel=1e-4)
        assert np.trace(tensor) == pytest.approx(sum(moments), rel=1e-5)


def test_an_impossible_inertia_is_cut_and_told():
    rig, findings, _ = read("HMMWV_DoubleWishboneFront_mapShock")
    told = {
        finding.place.rpartition(": ")[2]: finding
        for finding in findings
        if "principal moments" in finding.message
    }
    assert set(told) == {"Lower Control Arm", "Upper Control Arm", "Tierod"}
    assert told["Tierod"].value == pytest.approx(0.1)
    assert rig.bodies.lower_arm.inertia.principal_moments == pytest.approx(
        [0.4, 0.4, 0.8], rel=1e-4
    )
    assert {"bodies.lower_arm.inertia", "bodies.tie_rod.inertia"} <= set(rig.estimated)


def test_the_upper_arm_of_a_multi_link_moves_with_the_upright():
    rig, findings, _ = read("Sedan_MultiLink")
    assert rig.hardpoints.link_1_outer == rig.hardpoints.link_2_outer
    (told,) = [finding for finding in findings if "links 1 and 2" in finding.message]
    assert rig.bodies.upright.mass == pytest.approx(3.201 + told.value)
    # its centre lies a bit over a third of the way out: mass * (inertia / mass + distance^2) / length^2, by hand
    axis = np.array([0.060, 0.397, 0.082]) - np.array([-0.157, 0.358, 0.062])
    axis /= np.linalg.norm(axis)
    out = np.linalg.norm(
        np.cross(axis, np.array([0.056, 0.714, 0.151]) - np.array([0.060, 0.397, 0.082]))
    )
    away = np.linalg.norm(
        np.cross(axis, np.array([-0.014, 0.490, 0.098]) - np.array([0.060, 0.397, 0.082]))
    )
    assert told.value == pytest.approx((0.0237 + 4.744 * away**2) / out**2, rel=1e-6)
    assert rig.strut.on == "link_4"
    assert {"link_3", "link_4"} <= set(rig.body_masses())
    assert "link_1" not in rig.body_masses()


def test_linear_and_curved_springs():
    linear, curved = read("DoubleWishbone")[0], read("DoubleWishboneCurve")[0]
    assert linear.strut.spring.rate == pytest.approx(369149.0)
    assert linear.strut.spring.free_length == pytest.approx(0.339)
    curve = curved.strut.spring.curve
    assert (curve.deflection[0], curve.deflection[-1]) == pytest.approx((-0.1, 0.1))
    assert (curve.force[0], curve.force[-1]) == pytest.approx((-36915.0, 36915.0))
    length = linear.hardpoints.length("spring")
    assert spring_force(linear) == pytest.approx(369149.0 * (0.339 - length))
    assert spring_force(curved) == pytest.approx(369150.0 * (0.339 - length), rel=1e-9)


@READ_BY_EYE
def test_a_curve_that_pushes_at_its_free_length():
    """The file has -3848 N at no lengthening: it pushes there, and pulls from 53 mm of lengthening on."""
    curve = read("Polaris_Front_DoubleWishbone")[0].strut.spring.curve
    points = dict(zip(curve.deflection, curve.force, strict=True))
    assert points[0.0] == pytest.approx(3848.384815)
    assert (curve.deflection[0], curve.force[0]) == pytest.approx((-0.053433408, -3700.370014))
    assert (curve.deflection[-1], curve.force[-1]) == pytest.approx((0.099233471, 14801.48006))


def test_preload_shifts_the_force(tmp_path: Path):
    linear = changed(
        tmp_path, "DoubleWishbone", lambda table: table["Spring"].update({"Preload": 1000.0})
    )
    assert spring_force(import_chrono(linear)[0]) == pytest.approx(
        spring_force(read("DoubleWishbone")[0]) + 1000.0
    )
    curved = changed(
        tmp_path, "DoubleWishboneCurve", lambda table: table["Spring"].update({"Preload": 1000.0})
    )
    assert spring_force(import_chrono(curved)[0]) == pytest.approx(
        spring_force(read("DoubleWishboneCurve")[0]) + 1000.0
    )


@READ_BY_EYE
def test_dampers_change_both_signs():
    assert read("audi_DoubleWishbone")[0].strut.damper.coefficient == 10000.0
    table = read("Polaris_Front_DoubleWishbone")[0].strut.damper
    points = dict(zip(table.velocity, table.force, strict=True))
    assert points[0.33] == pytest.approx(262.0), (
        "-262 N at -0.33 m/s of lengthening is compression in bump"
    )
    assert points[-0.33] == pytest.approx(-2875.0)


@READ_BY_EYE
def test_damper_maps_are_turned_over():
    damper = read("HMMWV_DoubleWishboneFront_mapShock")[0].strut.damper
    assert damper.velocity == pytest.approx((-0.666667, -0.333333, 0.0, 0.333333, 0.666667))
    assert (len(damper.length), len(damper.force), len(damper.force[0])) == (15, 15, 5)
    middle = damper.length.index(pytest.approx(0.361899))
    assert damper.force[middle] == pytest.approx((-14973.3, -7486.67, 0.0, 4173.85, 8347.71))
    corner = shipped_corner()
    assert corner.damper.coefficients_at(0.361899)[0] == pytest.approx(4173.85 / 0.333333, rel=1e-6)


def test_maps_over_lengthening_and_degressive_dampers(tmp_path: Path):
    file = changed(
        tmp_path,
        "HMMWV_DoubleWishboneFront_mapShock",
        lambda table: table["Shock"].update({"Free Length": 0.1}),
    )
    assert import_chrono(file)[0].strut.damper.length[0] == pytest.approx(0.373304)
    shares = {"Degressivity Compression": 3.0, "Degressivity Expansion": 1.0}
    file = changed(tmp_path, "audi_DoubleWishbone", lambda table: table["Shock"].update(shares))
    rig, findings, _ = import_chrono(file)
    points = dict(zip(rig.strut.damper.velocity, rig.strut.damper.force, strict=True))
    assert (points[1.0], points[-1.0]) == pytest.approx((10000.0 / 4.0, -10000.0 / 2.0))
    assert any("degressive damper" in finding.message for finding in findings)


def test_stops_begin_at_the_lengths_of_the_file():
    rig, findings, _ = read("HMMWV_DoubleWishboneFront_mapShock")
    length = rig.hardpoints.length("spring")
    assert length - rig.strut.bump_stop.gap == pytest.approx(0.15)
    assert length + rig.strut.rebound_stop.gap == pytest.approx(0.3)
    assert any("Minimum Length" in finding.place for finding in findings)
    # Chrono's points for every vehicle (ADAMS/Car's example): depth in mm to N
    law = {
        2.0: 200.0,
        6.0: 600.0,
        10.0: 1000.0,
        20.0: 2500.0,
        30.0: 4500.0,
        40.0: 7500.0,
        50.0: 12500.0,
    }
    for depth, force in law.items():
        found = (
            rig.strut.bump_stop.rate * 1e-3 * depth
            + rig.strut.bump_stop.progression * (1e-3 * depth) ** 3
        )
        assert found == pytest.approx(force, rel=0.08), depth
    assert read("audi_DoubleWishbone")[0].strut.bump_stop is None


def test_sprung_mass_is_what_the_spring_carries():
    rig, findings, _ = read("van_DoubleWishboneFront")
    assert spring_force(rig) == pytest.approx(static_spring_force(rig), rel=1e-5)
    assert "sprung.mass" in rig.estimated
    assert any(finding.value == pytest.approx(rig.sprung.mass, rel=1e-5) for finding in findings)
    rig, findings, _ = read("MacPhersonStrut")
    assert rig.sprung.mass == 350.0
    assert any(
        "carries nothing in the design position: 350 kg is assumed" in finding.message
        for finding in findings
    )


def test_given_values_are_not_estimated():
    rig, _, _ = read(
        "van_DoubleWishboneFront",
        wheel_radius=0.376,
        wheel_mass=31.8,
        tyre_stiffness=175e3,
        sprung_mass=627.2,
    )
    assert (rig.wheel.radius, rig.tyre.stiffness, rig.sprung.mass) == pytest.approx(
        (0.376, 175e3, 627.2)
    )
    assert rig.bodies.wheel.mass == pytest.approx(14.705 + 31.8)
    assert not {"wheel.radius", "tyre.stiffness", "sprung.mass", "bodies.wheel.mass"} & set(
        rig.estimated
    )
    with pytest.raises(DescriptionError, match=r"wheel\.radius: out of range; found -1"):
        read("van_DoubleWishboneFront", wheel_radius=-1)


def test_camber_and_toe_are_read(tmp_path: Path):
    file = changed(
        tmp_path,
        "audi_DoubleWishbone",
        lambda t: t.update({"Camber Angle (deg)": -1.5, "Toe Angle (deg)": 0.2}),
    )
    wheel = import_chrono(file)[0].wheel
    assert (wheel.camber, wheel.toe) == pytest.approx((np.radians(-1.5), np.radians(0.2)))


def test_what_is_not_read_is_told(tmp_path: Path):
    def add(table: dict[str, Any]) -> None:
        table["Antiroll Bar"] = {"Stiffness": 1.0}
        table["Lower Control Arm"]["Bushing Data"] = {"Stiffness Linear": 7e7}

    findings = import_chrono(changed(tmp_path, "audi_DoubleWishbone", add))[1]
    told = [str(finding) for finding in findings if finding.severity == "warning"]
    assert any("Antiroll Bar: this section is not read" in text for text in told)
    assert any("Lower Control Arm: Bushing Data: bushings are not read" in text for text in told)


def test_mcpherson_slides_along_the_spring():
    rig, _, _ = read("MacPhersonStrut")
    assert rig.bodies.strut.mass == 5.0
    middle = (np.array(rig.hardpoints.strut_top) + np.array(rig.hardpoints.strut_bottom)) / 2.0
    assert rig.bodies.strut.centre_of_mass == pytest.approx(middle, abs=1e-8)
    assert 0.85 < motion_ratio(rig) < 1.0


BAD: list[tuple[str, Callable[[dict[str, Any]], object], str]] = [
    (
        "audi_DoubleWishbone",
        lambda t: t.update(Template="SolidAxle"),
        "cannot be read; found 'SolidAxle'.*MultiLink",
    ),
    (
        "audi_DoubleWishbone",
        lambda t: t.update(Template="TMeasyTire", Type="Tire"),
        r"cannot be read \(Tire\)",
    ),
    ("audi_DoubleWishbone", lambda t: t.pop("Spring"), "the key 'Spring' is missing"),
    (
        "audi_DoubleWishbone",
        lambda t: t["Shock"].pop("Damping Coefficient"),
        "Shock: the key 'Damping Coefficient' is m",
    ),
    (
        "audi_DoubleWishbone",
        lambda t: t["Spring"].pop("Free Length"),
        "Spring: the key 'Free Length' is missing",
    ),
    ("audi_DoubleWishbone", lambda t: t["Upright"].update(Mass=0), "Upright: Mass: out of range"),
    (
        "audi_DoubleWishbone",
        lambda t: t["Upright"].update({"Moments of Inertia": [1.0, 1.0, -1.0]}),
        "not above 0",
    ),
    (
        "audi_DoubleWishbone",
        lambda t: t["Spindle"].update(COM=[0.0, -0.8, 0.0]),
        "wheel_centre: not on the left side",
    ),
    (
        "audi_DoubleWishbone",
        lambda t: t["Lower Control Arm"].update({"Location Upright": [0.2, 0.42, -0.27]}),
        "Lower Control Arm: two points coincide, or three are collinear",
    ),
    (
        "audi_DoubleWishbone",
        lambda t: t["Tierod"].update({"Location Upright": [-0.2, 0.42, -0.12]}),
        "tie_rod_outer: coincides",
    ),
    (
        "DoubleWishboneCurve",
        lambda t: t["Spring"]["Spring Curve Data"].reverse(),
        "Curve Data: fewer than two ascending",
    ),
    (
        "DoubleWishboneCurve",
        lambda t: t["Shock"].update({"Damping Curve Data": [[0.0, 1.0]]}),
        "two ascending values",
    ),
    (
        "van_DoubleWishboneFront",
        lambda t: t["Spring"].update({"Minimum Length": 0.4}),
        "Minimum Length: fewer than two",
    ),
    (
        "Sedan_MultiLink",
        lambda t: t["Trailing Link"].pop("Location Chassis"),
        "Trailing Link: the key 'Location Chassis'",
    ),
    (
        "audi_DoubleWishbone",
        lambda t: t.update({"Camber Angle (deg)": "a"}),
        "Camber Angle .deg.: not a regular list",
    ),
]


@pytest.mark.parametrize(
    ("name", "change", "message"), BAD, ids=[f"{bad[0]} {bad[2][:30]}" for bad in BAD]
)
def test_bad_files_are_refused_with_their_place(
    tmp_path: Path, name: str, change: Callable[..., Any], message: str
):
    with pytest.raises(DescriptionError, match=message) as caught:
        import_chrono(changed(tmp_path, name, change))
    assert "changed.json" in str(caught.value)


def test_a_single_wishbone_says_what_can_be_read():
    with pytest.raises(
        DescriptionError,
        match="'SingleWishbone'; allowed: the template DoubleWishbone, MacPhersonStrut, ",
    ):
        read("Gator_SingleWishboneFront")


@pytest.mark.parametrize("name", ["a\x7fb", "a\x00b", "a\ud800b", 'a"\nb', "a\u202e\x85b"])
def test_names_of_any_characters_are_kept_in_the_rig_file(tmp_path: Path, name: str):
    file = changed(
        tmp_path, "HMMWV_DoubleWishboneFront_mapShock", lambda table: table.update(Name=name)
    )
    rig, _, text = import_chrono(file)
    assert rig.source is not None
    assert name.replace("\ud800", "\ufffd") in rig.source
    assert tomllib.loads(text)["source"] == rig.source
    assert not {"\x7f", "\x00", "\u202e"} & set(text)
    text.encode()
