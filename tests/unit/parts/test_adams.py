"""A subsystem of Adams Car, made up from a shipped rig with the frames of its parts turned, gives that rig again."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts.importers import import_adams

DATABASE = Path(__file__).parents[2] / "files" / "adams_car" / "made_up.cdb"
SUB = Path("subsystems.tbl") / "front.sub"
RIG = jn.load("sedan-double-wishbone")


@pytest.fixture
def changed(tmp_path):
    """The database with some text of the subsystem, or of another file, changed."""

    def change(*pairs, name=SUB):
        folder = tmp_path / "made_up.cdb"
        if not folder.exists():
            shutil.copytree(DATABASE, folder)
        text = (folder / name).read_text()
        for old, new in pairs:
            assert old in text
            text = text.replace(old, new)
        (folder / name).write_text(text)
        return folder / SUB

    return change


def test_points_and_bodies_are_those_of_the_rig() -> None:
    rig, findings, _ = import_adams(DATABASE / SUB, wheel_radius=RIG.wheel.radius)
    assert rig.model == "double-wishbone"
    up = np.array([0.0, 0.0, rig.hardpoints.wheel_centre[2] - RIG.hardpoints.wheel_centre[2]])
    for name, point in RIG.hardpoints.given().items():
        np.testing.assert_allclose(
            getattr(rig.hardpoints, name), np.array(point) + up, rtol=0.0, atol=1e-9
        )
    for name in ("lower_arm", "upper_arm", "upright"):
        found, own = rig.body_masses()[name], RIG.body_masses()[name]
        assert found.mass == pytest.approx(own.mass)
        np.testing.assert_allclose(
            found.centre_of_mass, np.array(own.centre_of_mass) + up, rtol=0.0, atol=1e-9
        )
        size = np.abs(own.inertia.tensor).max()
        np.testing.assert_allclose(
            found.inertia.tensor, own.inertia.tensor, rtol=0.0, atol=2e-6 * size
        )
    assert (rig.wheel.camber, rig.wheel.toe) == (
        pytest.approx(np.radians(-0.5)),
        pytest.approx(np.radians(0.2)),
    )
    assert "wheel.radius" not in rig.estimated
    assert {"bodies.wheel.mass", "tyre.stiffness", "sprung.mass", "strut.on"} <= set(rig.estimated)
    said = " ".join(finding.message for finding in findings)
    assert "subframe_front" in said
    assert "subframe (25 kg)" in said
    assert "so their joints are rigid: lca_front" in said


def test_property_files_in_their_units_and_signs(changed) -> None:
    """Installed at 250 mm, with 330 mm free: 80 mm at 60 N/mm. Rebound is positive in Adams, bump is here."""
    rig, _, _ = import_adams(DATABASE / SUB)
    assert rig.strut.spring.rate == pytest.approx(60e3)
    assert rig.strut.spring.free_length - rig.hardpoints.length("strut") == pytest.approx(
        0.08, abs=1e-8
    )
    assert rig.strut.damper.velocity == pytest.approx((-1.0, -0.1, 0.0, 0.1, 1.0))
    assert rig.strut.damper.force == pytest.approx((-2500.0, -800.0, 0.0, 400.0, 1200.0))
    stop = rig.strut.bump_stop
    assert (stop.gap, stop.rate, stop.progression) == pytest.approx((0.04, 50e3, 1e8))
    file = changed(("'mm'", "'meter'"), name=Path("springs.tbl/ride.spr"))
    changed(
        ("330.0", "0.33"),
        ("-100.0 ", "-0.1 "),
        ("50.0 ", "0.05 "),
        ("\n100.0 ", "\n0.1 "),
        name=Path("springs.tbl/ride.spr"),
    )
    assert import_adams(file)[0].strut.spring.rate == pytest.approx(60e3)
    changed(("-6000.0", "-9000.0"), name=Path("springs.tbl/ride.spr"))
    changed(("'installed_length'", "'preload'"), ("250.0\n[DAMPER", "4200.0\n[DAMPER"))
    spring = import_adams(file)[0].strut.spring
    assert spring.curve.kind == "table"
    assert spring.free_length - rig.hardpoints.length("strut") == pytest.approx(0.07, abs=1e-8)


def test_a_spring_in_xml(changed, tmp_path) -> None:
    file = changed(("ride.spr", "ride.xml"))
    rows = "\n".join(f"{x} {60.0 * x}" for x in (-100, 0, 100))
    (tmp_path / "made_up.cdb" / "springs.tbl" / "ride.xml").write_text(
        '<afc xmlns="http://a/:vfc" xmlns:afc="http://a/:afc"><afc:Units><afc:UnitSetting name="force" '
        'current="newton"/><afc:UnitSetting name="length" current="mm"/></afc:Units><SpringProperties freeLength="330">'
        f"<Spline><![CDATA[{rows}]]></Spline></SpringProperties></afc>"
    )
    assert import_adams(file)[0].strut.spring == import_adams(DATABASE / SUB)[0].strut.spring


def test_what_is_not_there_is_estimated_and_named(changed) -> None:
    file = changed(
        ("springs.tbl", "other.tbl"),
        ("dampers.tbl", "../../etc"),
        ("stop.bum", "none.bum"),
        ("'upright'", "'other'"),
    )
    changed(("X,Y,Z location", "somewhere"))
    rig, findings, _ = import_adams(file)
    assert {
        "strut.spring.rate",
        "strut.spring.preload",
        "strut.damper.coefficient",
        "bodies.upright.mass",
    } <= set(rig.estimated)
    assert rig.strut.bump_stop is None
    assert rig.bodies.lower_arm.mass == pytest.approx(RIG.bodies.lower_arm.mass)
    assert "bodies.lower_arm.inertia" in rig.estimated
    said = " ".join(f"{finding.place}: {finding.message}" for finding in findings)
    assert "strut.spring: the property file" in said
    assert "bodies.upright: not in the file: 8 kg is assumed" in said
    assert rig.sprung.mass == pytest.approx(350.0, rel=0.5)


def test_a_part_without_inertia_is_estimated(changed) -> None:
    rig, findings, _ = import_adams(changed(("IXX", "LXX"), ("IYY", "LYY"), ("IZZ", "LZZ")))
    assert "bodies.lower_arm.inertia" in rig.estimated
    assert any("IXX, IYY and IZZ are not in the file" in finding.message for finding in findings)


@pytest.mark.parametrize(
    ("pairs", "what"),
    [
        ([("'suspension'", "'steering'")], "the subsystem is not a suspension.*'steering'"),
        ([("[UNITS]", "[NO_UNITS]")], r"the block \[UNITS\] is missing"),
        ([("'mm'", "'furlong'")], "no unit for LENGTH; found 'furlong'.*inch"),
        ([("'mm'", "'inch'")], r"an implausible half track width.*20\.27 m"),
        ([("-797.9", "797.9")], "left and right are swapped: y points to the right"),
        (
            [("'lca_front       ", "'lca_frunt       ")],
            "points of a double-wishbone are missing.*lower_arm_front",
        ),
        ([("'subframe_front  ", "'lca_front       ")], "lower_arm_front is given twice"),
        ([("-200  -420  163.066", "-200  -420")], "not a hardpoint"),
        (
            [("MASS                     =  1.397", "MASS                     =  heavy")],
            "not a number; found 'heavy'",
        ),
        ([("MASS                     =  1.397", "MASS                     =  0.0")], "no mass"),
        ([("[HARDPOINT]", "[HARDPOINTS]")], "the file contains no hardpoints"),
    ],
)
def test_mistakes_are_said(changed, pairs, what) -> None:
    with pytest.raises(DescriptionError, match=what):
        import_adams(changed(*pairs))


@pytest.mark.parametrize(
    ("name", "pair", "what"),
    [
        (
            "springs.tbl/ride.spr",
            ("50.0   3000.0", "-50.0   3000.0"),
            "the first column does not increase",
        ),
        ("springs.tbl/ride.spr", (" FREE_LENGTH  =  330.0", ""), "FREE_LENGTH is missing"),
        ("dampers.tbl/ride.dpr", ("[CURVE]", "[CURVES]"), r"the block \[CURVE\] is missing"),
        ("bumpstops.tbl/stop.bum", ("40   8400", "40   -8400"), "a stop without force|rate"),
    ],
)
def test_mistakes_in_property_files(changed, name, pair, what) -> None:
    if pair[1].endswith("-8400"):
        file = changed(
            ("40   8400", "40   -8400"),
            ("30   4200", "30   -1"),
            ("20   1800", "20   -1"),
            ("10   600", "10   -1"),
            name=Path(name),
        )
    else:
        file = changed(pair, name=Path(name))
    with pytest.raises(DescriptionError, match=what):
        import_adams(file)


BUSHING = """[MDI_HEADER]
 FILE_TYPE = 'bus'
[UNITS]
 LENGTH = '{length}'
 FORCE = '{force}'
 ANGLE = '{angle}'
 MASS = 'kg'
 TIME = 'sec'
[DAMPING]
 FX_DAMPING = {damping}
 TX_DAMPING = 1.0
"""


def bushing(
    *, length="mm", force="newton", angle="deg", size=1.0, push=1.0, turn=1.0, **curves: str
) -> str:
    """A ``.bus``: 1000, 2000 and 4000 N/mm, 100 N mm/deg about x, soft at first about z; in other units by factors."""
    text = BUSHING.format(length=length, force=force, angle=angle, damping=5.0 * push / size)
    for axis, rate in (("FX", 1000.0), ("FY", 2000.0), ("FZ", 4000.0)):
        text += curves.get(
            axis,
            f"[{axis}_CURVE]\n{{x fx}}\n"
            + "".join(f"{x * size} {rate * x * push}\n" for x in (-2.0, 0.0, 2.0)),
        )
    for axis, rate in (("TX", 100.0), ("TY", 0.0)):
        text += f"[{axis}_CURVE]\n" + "".join(
            f"{x * turn} {rate * x * push * size}\n" for x in (-20.0, 0.0, 20.0)
        )
    return (
        text
        + "[TZ_CURVE]\n"
        + "".join(
            f"{x * turn} {y * push * size}\n"
            for x, y in ((-20, -5000), (-10, -500), (10, 500), (20, 5000))
        )
    )


@pytest.mark.parametrize(
    "units",
    [
        {},
        {
            "length": "inch",
            "size": 1.0 / 25.4,
            "force": "pound_force",
            "push": 1.0 / 4.4482216152605,
        },
        {"angle": "radians", "turn": np.pi / 180.0},
    ],
)
def test_bushings_in_their_units(changed, units) -> None:
    before = " PROPERTY_FILE           =  '<made_up>/bush"
    file = changed((before, f" FX_SCALING_FACTOR = 1.5\n T_PRELOAD_X = 100.0\n{before}"))
    (file.parents[1] / "bushings.tbl").mkdir()
    (file.parents[1] / "bushings.tbl" / "soft.bus").write_text(bushing(**units))
    rig, findings, text = import_adams(file)
    found = rig.bushings.lower_arm_front
    assert found.stiffness == pytest.approx((1.5e6, 2e6, 4e6), rel=1e-9)
    turning = 180.0 / np.pi * 1e-3  # N m/rad for N mm/deg
    assert found.rotational_stiffness == pytest.approx(
        (100.0 * turning, 0.0, 50.0 * turning), rel=1e-9
    )
    assert found.damping == pytest.approx((5000.0, 0.0, 0.0), rel=1e-9)
    said = {
        finding.place.rpartition(": ")[2]: finding
        for finding in findings
        if "bushings" in finding.place
    }
    assert any("T_PRELOAD_X" in finding.message for finding in findings)
    assert said
    assert not any("joints are rigid" in finding.message for finding in findings)
    assert "[bushings.lower_arm_front]" in text
    rigid, _, _ = import_adams(file, rigid=True)
    assert rigid.bushings.lower_arm_front is None


@pytest.mark.parametrize(
    ("curve", "message"),
    [
        ("[FX_CURVE]\n1 10\n2 20\n", "does not reach zero"),
        ("[FX_CURVE]\n-1 10\n1 -10\n", "negative stiffness"),
        ("", "FX_CURVE"),
    ],
)
def test_bushings_that_cannot_be(changed, curve, message) -> None:
    file = changed()
    (file.parents[1] / "bushings.tbl").mkdir()
    (file.parents[1] / "bushings.tbl" / "soft.bus").write_text(bushing(FX=curve))
    with pytest.raises(DescriptionError, match=message):
        import_adams(file)


def test_tabs_and_parts_given_twice(changed) -> None:
    """Frames stand in comments, however these are laid out; a part that is there twice was twice as heavy."""
    whole, _, _ = import_adams(DATABASE / SUB)
    tabbed, _, _ = import_adams(changed(("Z location", "Z\tlocation"), ("P vector", "P\tvector")))
    assert tabbed == whole
    file = changed()
    text = file.read_text()
    begin = text.index("[PART_ASSEMBLY]")
    end = text.index("[", begin + 1)
    file.write_text(text[:end] + text[begin:end] + text[end:])
    with pytest.raises(
        DescriptionError, match=r"is given twice; found 'first in .*allowed: each part once"
    ):
        import_adams(file)


def in_inches(text: str) -> str:
    """The subsystem in inches, pounds and radians: every number of it is another one."""
    inch, pound = 25.4, 0.45359237
    for old, new in (("'mm'", "'inch'"), ("'kg'", "'pound_mass'"), ("'deg'", "'radians'")):
        text = text.replace(old, new)

    def keyed(found: re.Match[str]) -> str:
        name, value = found[2], float(found[3])
        for pattern, unit in (
            ("MASS", pound),
            ("I[XYZ]{2}", pound * inch**2),
            ("(PART_LOC|CM_LOC|USER_).*", inch),
        ):
            value = value / unit if re.fullmatch(pattern, name) else value
        return f"{found[1]}{value!r}"

    text = re.sub(r"(?m)^( *(\w+) *= *)(-?\d[\d.E+-]*)$", keyed, text)
    rows = r"(?m)^( '\w+ *' +'(?:left/right|single)' +)(\S+) +(\S+) +(\S+)$"
    text = re.sub(
        rows, lambda row: row[1] + " ".join(repr(float(row[i]) / inch) for i in (2, 3, 4)), text
    )
    text = re.sub(
        r"(?<=location = )(.*)",
        lambda row: ", ".join(repr(float(x) / inch) for x in row[1].split(",")),
        text,
    )
    angle = r"(?m)^( '(?:camber|toe)_angle.*'real' +)(\S+)$"
    return re.sub(angle, lambda row: f"{row[1]}{float(np.radians(float(row[2])))!r}", text)


def test_inches_pounds_and_radians_are_the_same_rig(changed) -> None:
    """Property files keep their own units."""
    whole, _, _ = import_adams(DATABASE / SUB)
    file = changed()
    text = in_inches(file.read_text())
    assert text != file.read_text()
    file.write_text(text)
    found, _, _ = import_adams(file)
    before, after = whole.parameters(), found.parameters()
    assert set(before) == set(after)
    for path, value in after.items():
        assert value == pytest.approx(before[path], rel=1e-5, abs=2e-6), (
            path
        )  # the rig's file has six digits


def test_without_a_strut_it_is_a_rig_for_kinematics(changed) -> None:
    struts = (
        ("'lwr_strut_mount             '", "'nobody_knows_me             '"),
        ("'top_mount", "'top_of_it"),
    )
    rig, findings, text = import_adams(changed(*struts), wheel_radius=RIG.wheel.radius)
    assert rig.lacks == ("strut", "bodies", "spring", "damper", "tyre")
    assert any("contains no strut" in finding.message for finding in findings)
    assert "[bodies" not in text
    found, expected = (
        jn.sweep_travel(one, [-0.03, 0.0, 0.03]) for one in (rig, import_adams(DATABASE / SUB)[0])
    )
    np.testing.assert_allclose(found["toe"], expected["toe"], rtol=0.0, atol=1e-12)
