"""Tables of hardpoints in the manners of several programs: one rig, and one message for each mistake."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts.importers import import_hardpoints

RIG = jn.load("formula-student-front")
POINTS = {name: np.array(point) for name, point in RIG.hardpoints.given().items()}
LOTUS = {
    "lower_arm_front": "Lower wishbone front pivot", "lower_arm_rear": "Lower wishbone rear pivot",
    "lower_ball_joint": "Lower wishbone outer ball joint", "upper_arm_front": "Upper wishbone front pivot",
    "upper_arm_rear": "Upper wishbone rear pivot", "upper_ball_joint": "Upper wishbone outer ball joint",
    "tie_rod_inner": "Inner track rod ball joint", "tie_rod_outer": "Outer track rod ball joint",
    "wheel_centre": "Wheel centre point", "pushrod_outer": "Push rod wishbone end",
    "pushrod_inner": "Push rod rocker end", "rocker_pivot": "Rocker axis 1st point",
    "rocker_axis": "Rocker axis 2nd point", "strut_bottom": "Damper to rocker point",
    "strut_top": "Damper to body point",
}  # fmt: skip
OPTIMUM = {
    "lower_arm_front": "CHAS_LowFor", "lower_arm_rear": "CHAS_LowAft", "lower_ball_joint": "UPRI_LowPnt",
    "upper_arm_front": "CHAS_UppFor", "upper_arm_rear": "CHAS_UppAft", "upper_ball_joint": "UPRI_UppPnt",
    "tie_rod_inner": "CHAS_TiePnt", "tie_rod_outer": "UPRI_TiePnt", "wheel_centre": "Wheel Center",
    "pushrod_outer": "NSMA_PPAttPnt", "pushrod_inner": "ROCK_RodPnt", "rocker_pivot": "CHAS_RocPiv",
    "rocker_axis": "CHAS_RocAxi", "strut_bottom": "ROCK_CoiPnt", "strut_top": "CHAS_AttPnt",
}  # fmt: skip


def rows(form="{name},{x},{y},{z}", names=None, turn=(1, 1, 1), scale=1e3, **changes) -> list[str]:
    found = []
    for number, (name, point) in enumerate(POINTS.items(), 1):
        if name in changes and changes[name] is None:
            continue
        x, y, z = scale * np.array(changes.get(name, point)) * turn
        found.append(form.format(name=(names or {}).get(name, name), x=x, y=y, z=z, number=number))
    return found


def read(tmp_path, lines, name="points.csv", **options):
    file = tmp_path / name
    file.write_text("\n".join(lines), encoding="utf-8")
    return import_hardpoints(file, **options)


LOTUS_4 = "{x:12.3f} {y:12.3f} {z:12.3f}  POINT ( {number} ) = {name}"
LOTUS_5 = "{x:.3f}\t{y:.3f}\t{z:.3f}\tPOINT:{number} {name}"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (["name,x [mm],y [mm],z [mm]", *rows()], ""),
        (
            ["name;x;y;z;what", *(line + ";by hand" for line in rows("{name};{x};{y};{z}"))],
            "states no unit: mm",
        ),
        ([line.replace(".", ",") for line in rows("{name}; {x}; {y}; {z}")], "states no unit: mm"),
        (["units: m", *rows("{name} {x} {y} {z}", scale=1.0)], ""),
        (
            ["# Shark", "TYPE 1 Double wishbone", *rows(LOTUS_4, LOTUS, turn=(-1, 1, 1))],
            "x points rearward",
        ),
        (rows(LOTUS_5, LOTUS, turn=(-1, -1, 1)), "they are mirrored"),
        (
            ["Name,X (in),Y (in),Z (in)", *rows("{name}_L,{x},{y},{z}", OPTIMUM, scale=1 / 0.0254)],
            "",
        ),
        (rows("  {name}: [{x}, {y}, {z}]"), "states no unit: mm"),
        (rows('  "{name}": {{"x": {x}, "y": {y}, "z": {z}}},'), "states no unit: mm"),
        (
            rows(
                "{name},{x},{y},{z}",
                {name: name.replace("_", " ").title().replace(" ", "") for name in POINTS},
            ),
            "mm",
        ),
    ],
)
def test_every_manner_of_writing_gives_the_rig(tmp_path, lines, told) -> None:
    rig, findings, text = read(tmp_path, lines)
    assert rig.model == "double-wishbone"
    for name, point in POINTS.items():
        np.testing.assert_allclose(getattr(rig.hardpoints, name), point, rtol=0.0, atol=2e-9)
    assert rig.without == ("bodies", "spring", "damper", "tyre")
    assert rig.wheel.radius == pytest.approx(0.226)
    assert list(rig.estimated) == ["wheel.radius", "strut.pushrod_on"]
    said = " ".join(finding.message for finding in findings)
    assert told in said
    assert "wheel radius" in said
    (tmp_path / "rig.toml").write_text(text, encoding="utf-8")
    again = jn.load(tmp_path / "rig.toml")
    assert again.hardpoints == rig.hardpoints


def test_the_kinematics_are_those_of_the_rig(tmp_path) -> None:
    sweeps = [jn.sweep_travel(rig, [-0.01, 0.01]) for rig in (read(tmp_path, rows())[0], RIG)]
    changes = [float(np.diff(sweep["camber"].values)[0]) for sweep in sweeps]
    assert abs(changes[1]) > 1e-3
    assert changes[0] == pytest.approx(changes[1], abs=1e-8)


def test_an_excel_sheet(tmp_path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append(["Front axle"])
    sheet.append([None, "Point", "X [mm]", "Y [mm]", "Z [mm]"])
    for name, point in POINTS.items():
        sheet.append([None, OPTIMUM[name], *(1e3 * value for value in point)])
    book.save(tmp_path / "points.xlsx")
    rig, _, _ = import_hardpoints(tmp_path / "points.xlsx")
    np.testing.assert_allclose(rig.hardpoints.strut_top, POINTS["strut_top"], atol=1e-9)
    (tmp_path / "points.xlsx").write_bytes(b"PK nothing")
    with pytest.raises(DescriptionError, match="not an Excel file"):
        import_hardpoints(tmp_path / "points.xlsx")


def test_axes_sides_axles_and_names(tmp_path) -> None:
    lines = [f"{name};{1e3 * y};{1e3 * x};{1e3 * z}" for name, (x, y, z) in POINTS.items()]
    rig, _, _ = read(tmp_path, lines, axes="y,x,z")
    np.testing.assert_allclose(rig.hardpoints.tie_rod_outer, POINTS["tie_rod_outer"], atol=1e-12)
    both = rows("hpl_{name},{x},{y},{z}") + rows(
        "hpr_{name},{x},{y},{z}", turn=(1, -1, 1), strut_top=(0.0, 0.02, 0.4)
    )
    assert read(tmp_path, both)[0].hardpoints.strut_top[2] == pytest.approx(0.428)
    assert read(tmp_path, both, side="right")[0].hardpoints.strut_top == pytest.approx(
        (0.0, 0.02, 0.4)
    )
    axles = rows("{name} FL,{x},{y},{z}") + rows(
        "{name} RL,{x},{y},{z}", strut_top=(0.0, 0.02, 0.4)
    )
    with pytest.raises(DescriptionError, match=r"two axles.*--axle front or --axle rear"):
        read(tmp_path, axles)
    assert read(tmp_path, axles, axle="rear")[0].hardpoints.strut_top[2] == pytest.approx(0.4)
    column = ["side,point,x [mm],y [mm],z [mm]", *rows("L,{name},{x},{y},{z}")]
    column += rows("R,{name},{x},{y},{z}", turn=(1, -1, 1), strut_top=(0.0, 0.02, 0.4))
    assert read(tmp_path, column)[0].hardpoints.strut_top[2] == pytest.approx(0.428)
    assert read(tmp_path, column, side="right")[0].hardpoints.strut_top == pytest.approx(
        (0.0, 0.02, 0.4)
    )
    with pytest.raises(
        DescriptionError,
        match=r"given twice.*Distinguish the sides of the car by a column with left and right",
    ):
        read(tmp_path, rows() + rows(turn=(1, -1, 1)))
    own = rows(names={"wheel_centre": "Hub"})
    with pytest.raises(
        DescriptionError,
        match=r"points of a double-wishbone are missing.*these points and wheel_centre.*--name",
    ):
        read(tmp_path, own)
    assert read(tmp_path, own, names={"hub": "wheel_centre"})[0].model == "double-wishbone"


def test_the_road_is_found(tmp_path) -> None:
    low = [0.0, 0.0, -0.3]
    moved = {name: point + low for name, point in POINTS.items()}
    lines = rows(**moved)
    with pytest.raises(
        DescriptionError, match=r"the height of the road is not in the table.*--wheel-radius"
    ):
        read(tmp_path, lines)
    rig, findings, _ = read(tmp_path, lines, wheel_radius=0.23)
    assert rig.hardpoints.wheel_centre[2] == pytest.approx(0.23)
    assert rig.hardpoints.strut_top[2] == pytest.approx(0.428 + 0.004)
    assert "all points are moved" in findings[1].message
    rig, _, _ = read(tmp_path, [*lines, "Contact patch,0,610,-290"])
    assert rig.wheel.radius == pytest.approx(0.216)
    assert rig.hardpoints.strut_top[2] == pytest.approx(0.418)


@pytest.mark.parametrize(
    ("lines", "options", "what"),
    [
        (["hello"], {}, "the file contains no points"),
        (
            ["name,x [mm],y [mm],z [mm]", *rows(scale=1 / 0.0254)],
            {},
            r"half track.*Is the table in inch or cm\?",
        ),
        (rows(scale=100.0), {}, "file does not state the unit.*may be in inch or cm"),
        (rows(scale=1 / 0.0254), {}, "file does not state the unit.*may be in inch"),
        (rows(), {"unit": "kg"}, "wrong unit"),
        (["name,x [mm],y [m],z [mm]", *rows()], {}, "columns in different units"),
        (["unit: furlong", *rows()], {}, "unknown unit 'furlong'"),
        (
            [*rows(), "LCA front,1,2,3"],
            {},
            r"lower_arm_front is given twice.*'LCA front' at \[1\.0, 2\.0, 3\.0\]",
        ),
        (
            rows(strut_top=None),
            {},
            "points of a double-wishbone are missing.*these points and strut_top",
        ),
        (rows(names=dict.fromkeys(POINTS, "P")), {}, "given twice|no suspension has these points"),
        ([*rows(), "a,1,2,3,4"], {}, "more than three numbers"),
        (
            [*rows(strut_top=None), "strut_top,1,2,three"],
            {},
            "strut_top: a hardpoint without three.*'strut_top, 1, 2",
        ),
        (
            [*rows(), "UCA front L,5,13,"],
            {},
            "UCA front L: a hardpoint without three coordinates.*name and three",
        ),
        (rows(), {"axes": "x,y"}, "three axes are required"),
        (rows(), {"axes": "-x,y,z"}, "the arm's front lies behind its rear.*Reverse x"),
        (rows(), {"model": "five-links"}, "unknown suspension 'five-links'.*five-link"),
        (rows(), {"model": "five-link"}, "points of a five-link are missing"),
        (rows(), {"names": {"a": "wheel_centre"}}, "unknown name 'a'"),
        (rows(), {"names": {"wheel_centre": "hub"}}, "unknown hardpoint 'hub'"),
        (rows(), {"wheel_radius": -1.0}, "out of range"),
        (
            rows("{name} L,{x},{y},{z}")
            + rows("{name} R,{x},{y},{z}", lower_ball_joint=(0.0, 0.5, 0.1)),
            {},
            "left and right points are on the same side",
        ),
        (rows(tie_rod_inner=(0.065, -0.225, 0.148)), {}, "not on the same side of the car"),
        (rows(tie_rod_inner=POINTS["lower_arm_front"]), {}, "coincides with"),
    ],
)
def test_mistakes_are_said(tmp_path, lines, options, what) -> None:
    with pytest.raises(DescriptionError, match=what):
        read(tmp_path, lines, **options)


HEAD = "name,x,y,z"
INCH = 1.0 / 0.0254


@pytest.mark.parametrize(
    "lines",
    [
        [HEAD, ",[in],[in],[in]", *rows(scale=INCH)],
        ["name,x_in,y_in,z_in", *rows(scale=INCH)],
        ["# units: inch", "# name,x,y,z", *rows(scale=INCH)],
        [HEAD, *rows(), "# wheel_centre,9,9,9"],
    ],
    ids=["row of units", "units in names", "units behind #", "a point behind #"],
)
def test_units_and_comments_as_tables_have_them(tmp_path, lines) -> None:
    found, _, _ = read(tmp_path, lines)
    for name, point in POINTS.items():
        assert getattr(found.hardpoints, name) == pytest.approx(point, abs=1e-9)


def test_unicode_text_of_a_spreadsheet(tmp_path) -> None:
    file = tmp_path / "points.txt"
    file.write_text(
        "\r\n".join([HEAD.replace(",", "\t"), *rows("{name}\t{x}\t{y}\t{z}")]), encoding="utf-16"
    )
    found, _, _ = import_hardpoints(file)
    for name, point in POINTS.items():
        assert getattr(found.hardpoints, name) == pytest.approx(point, abs=1e-9)


def test_decimal_commas_between_commas_are_no_further_columns(tmp_path) -> None:
    """150,5,220,0,118,0 under name, x, y, z was x = 150, y = 5, z = 220."""
    lines = [HEAD, *rows("{name},{x:.1f},{y:.1f},{z:.1f}")]
    lines[1:] = [line.replace(".", ",") for line in lines[1:]]
    with pytest.raises(
        DescriptionError,
        match=r"line 2: a row has more numbers than the table has columns.*allowed: 4 cells.*semicolons",
    ):
        read(tmp_path, lines)


def test_two_units_are_refused(tmp_path) -> None:
    with pytest.raises(DescriptionError, match="line 2: two units; found 'inch after mm'"):
        read(tmp_path, ["units: mm", "name,x [in],y [in],z [in]", *rows()])


def test_a_strut_is_known_by_its_everyday_names_and_what_it_lacks_is_said(tmp_path):
    rig = jn.load("generic-mcpherson")
    names = {
        "lower_ball_joint": "Ball joint",
        "strut_top": "Strut top mount",
        "strut_bottom": "Strut lower mount",
    }
    points = {name: 1e3 * np.array(place) for name, place in rig.hardpoints.given().items()}
    lines = [f"{names.get(name, name)},{x},{y},{z}" for name, (x, y, z) in points.items()]
    found, _, _ = read(tmp_path, ["name,x [mm],y [mm],z [mm]", *lines])
    assert found.model == "mcpherson"
    for name in names:
        assert np.allclose(getattr(found.hardpoints, name), getattr(rig.hardpoints, name))
    few = [line for line in lines if line.startswith(("Ball joint", "Strut top", "strut"))]
    with pytest.raises(
        DescriptionError, match=r"nearest is a mcpherson, of which .*tie_rod_outer are missing"
    ):
        read(tmp_path, ["name,x [mm],y [mm],z [mm]", *few], name="few.csv")
