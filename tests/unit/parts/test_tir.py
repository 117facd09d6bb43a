"""Tyre property files: real ones, units, pressures, curves, and what is wrong with them."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.core.errors import DescriptionError
from jounce.parts import load
from jounce.parts.elements import Tyre
from jounce.parts.importers import read_tir, tyre_from_tir

FILES = Path(__file__).parents[2] / "files" / "tyre_tir"
SMALL = """[UNITS]
LENGTH = 'mm'
FORCE = 'newton'
TIME = 'second'
PRESSURE = 'bar'
[MODEL]
PROPERTY_FILE_FORMAT = 'MF61'
[DIMENSION]
UNLOADED_RADIUS = 320.5  $ a comment with = and '
[VERTICAL]
VERTICAL_STIFFNESS = 210  ! N/mm
VERTICAL_DAMPING = 0.08
FNOMIN = 4000
"""


def small(folder: Path, *changes: tuple[str, str], more: str = "") -> Path:
    text = SMALL
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    file = folder / "small.tir"
    file.write_text(text + more)
    return file


@pytest.mark.source(
    kind="published",
    of="files of other makers",
    key="project-chrono",
    where="what its five tyre property files print, read by eye",
    tolerance="the digits of the files",
    compares="stiffness, damping and radius of tyre files",
)
@pytest.mark.parametrize(
    ("name", "stiffness", "damping", "radius", "load"),
    [  # read off the files by eye; LCZ of the generic one is 0.4419
        ("CityBus_Pac02Tire", 1e6, 5000.0, 0.548, 35000.0),
        ("Generic_Pac02Tire", 0.4419e6, 500.0, 0.4699, 35000.0),
        ("audi_Pac02Tire", 280835.2941, 2000.0, 0.344, 4850.0),
        ("mf_185_80R14", 1.75e5, 50.0, 0.376, 3800.0),
        ("suv_Pac02Tire", 248315.625, 500.0, 0.409, 4000.0),
    ],
)
def test_real_files(name, stiffness, damping, radius, load) -> None:
    tyre = read_tir(FILES / f"{name}.tir")
    assert (tyre.stiffness, tyre.damping_coefficient, tyre.radius) == pytest.approx(
        (stiffness, damping, radius)
    )
    assert (tyre.nominal_load, tyre.file_format, tyre.findings) == (load, "PAC2002", ())
    table = tyre_from_tir(FILES / f"{name}.tir")
    assert table == {
        "stiffness": tyre.stiffness,
        "damping_coefficient": damping,
        "undeformed_radius": radius,
    }
    table.pop("undeformed_radius")
    assert Tyre(**table).stiffness == pytest.approx(stiffness)


def test_every_real_file_is_tested() -> None:
    assert len(list(FILES.glob("*.tir"))) == 5


def test_units_of_the_file_count(tmp_path) -> None:
    tyre = read_tir(small(tmp_path))
    assert tyre.radius == pytest.approx(0.3205, rel=1e-12)
    assert tyre.stiffness == pytest.approx(210e3, rel=1e-12)
    assert tyre.damping_coefficient == pytest.approx(80.0, rel=1e-12)
    assert (tyre.nominal_load, tyre.file_format, tyre.name) == (4000.0, "MF61", "small")
    inches = read_tir(
        small(tmp_path, ("'mm'", "'inch'"), ("'newton'", "'pound_force'"), ("320.5", "12.6"))
    )
    assert inches.radius == pytest.approx(0.32004, rel=1e-12)
    assert inches.stiffness == pytest.approx(210 * 4.4482216152605 / 0.0254, rel=1e-12)
    kilo = read_tir(
        small(
            tmp_path, ("'newton'", "'kilo_newton'"), ("210 ", "0.21"), ("'second'", "'millisecond'")
        )
    )
    assert kilo.stiffness == pytest.approx(210e3, rel=1e-12)
    assert kilo.damping_coefficient == pytest.approx(0.08 * 1e6 * 1e-3, rel=1e-12)


def test_a_wrong_unit_is_noticed_by_its_values(tmp_path) -> None:
    wrong = read_tir(small(tmp_path, ("'mm'", "'meter'")))  # mm and N/mm in a file that declares m
    assert [finding.message.split(";")[0] for finding in wrong.findings] == [
        "the stiffness 210 N/m is unusual for a tyre",
        "the radius 320.5 m is unusual for a tyre",
    ]


def test_stiffness_rises_with_the_pressure() -> None:
    tyre = read_tir(FILES / "CityBus_Pac02Tire.tir")
    assert (tyre.pressure, tyre.nominal_pressure) == (800e3, 800e3)
    assert tyre.stiffness_at() == tyre.stiffness_at(800e3) == tyre.stiffness
    with pytest.raises(
        DescriptionError,
        match=r"does not state how .* pressure; found '700000 Pa'; allowed: 800000 Pa",
    ):
        tyre.stiffness_at(700e3)
    with pytest.raises(DescriptionError, match="files with PFZ1"):
        read_tir(FILES / "audi_Pac02Tire.tir").stiffness_at(2e5)


def test_pressures_under_all_their_names(tmp_path) -> None:
    modern = "PFZ1 = 0.7\n[OPERATING_CONDITIONS]\nINFLPRES = 2.5\nNOMPRES = 2.0\n"
    tyre = read_tir(small(tmp_path, more=modern))
    assert (tyre.pressure, tyre.nominal_pressure) == pytest.approx((2.5e5, 2e5))
    assert tyre.stiffness_at() == pytest.approx(210e3 * (1 + 0.7 * 0.25), rel=1e-12)
    assert tyre.stiffness_at(1.8e5) == pytest.approx(210e3 * (1 - 0.07), rel=1e-12)
    assert tyre_from_tir(tmp_path / "small.tir", pressure=1.8e5)["stiffness"] == pytest.approx(
        210e3 * 0.93
    )
    for pressure, says in [
        (0.0, "invalid inflation pressure"),
        (float("nan"), "invalid inflation pressure"),
    ]:
        with pytest.raises(DescriptionError, match=says):
            tyre.stiffness_at(pressure)
    steep = read_tir(small(tmp_path, more=modern.replace("0.7", "4.0")))
    with pytest.raises(
        DescriptionError,
        match="the stiffness is not positive at this pressure; found '100000 Pa'; allowed: above 150000 Pa",
    ):
        steep.stiffness_at(1e5)
    with pytest.raises(DescriptionError, match="the unit for PRESSURE is missing"):
        read_tir(small(tmp_path, ("PRESSURE = 'bar'\n", ""), more=modern))


def test_a_measured_tyre_at_three_pressures(tmp_path) -> None:
    # 335/65R22.5, measured: 4.0652e5, 5.6519e5, 6.4452e5 N/m at 40, 60, 70 psi. The line of PFZ1 through the first
    # two gives the third.
    slope = (5.6519 / 4.0652 - 1.0) / (5.6519 / 4.0652) * 60.0 / 20.0
    file = small(
        tmp_path,
        ("'mm'", "'meter'"),
        ("'bar'", "'psi'"),
        ("= 210 ", "= 5.6519e5 "),
        ("320.5", "0.503"),
        ("0.08", "0"),
        more=f"PFZ1 = {slope:.10f}\n[OPERATING_CONDITIONS]\nINFLPRES = 60\nNOMPRES = 60\n",
    )
    tyre = read_tir(file)
    psi = 6894.757293168
    assert tyre.stiffness_at(40 * psi) == pytest.approx(4.0652e5, rel=1e-6)
    assert tyre.stiffness_at(60 * psi) == pytest.approx(5.6519e5, rel=1e-6)
    assert tyre.stiffness_at(70 * psi) == pytest.approx(6.4452e5, rel=2e-4)
    assert tyre.stiffness_at() == pytest.approx(5.6519e5, rel=1e-9)


def test_a_measured_curve(tmp_path) -> None:
    table = "[DEFLECTION_LOAD_CURVE]\n{pen fz}\n0 0.0\n10 1800.0 $ mm N\n 20.0  4100.0\n"
    tyre = tyre_from_tir(small(tmp_path, more=table))
    assert tyre["curve"]["deflection"] == pytest.approx([0.0, 0.01, 0.02])
    assert tyre["curve"]["force"] == pytest.approx([0.0, 1800.0, 4100.0])
    tyre.pop("undeformed_radius")
    assert Tyre(**tyre).curve is not None
    for row, says in [
        ("5 2000", "the curve does not increase; found '5 2000'"),
        ("30", "a pair of numbers is required"),
        ("x 1", "not a number"),
    ]:
        with pytest.raises(DescriptionError, match=rf"line 19: \[DEFLECTION_LOAD_CURVE\]: {says}"):
            read_tir(small(tmp_path, more=f"{table}{row}\n"))
    with pytest.raises(DescriptionError, match="the curve has one point"):
        read_tir(small(tmp_path, more="[DEFLECTION_LOAD_CURVE]\n0 0\n"))


def test_a_load_that_rises_with_the_square_of_the_deflection(tmp_path) -> None:
    tyre = tyre_from_tir(small(tmp_path, more="Q_FZ2 = 15\n"))
    first, second = tyre["curve"]["coefficients"]
    # at the nominal load the tangent is the stiffness
    deflection = (-first + (first**2 + 4 * second * 4000.0) ** 0.5) / (2 * second)
    assert first + 2 * second * deflection == pytest.approx(210e3, rel=1e-9)
    with pytest.raises(DescriptionError, match="Q_FZ2 is too large"):
        tyre_from_tir(small(tmp_path, more="Q_FZ2 = 500\n"))


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ([("[UNITS]\n", "[UNIT]\n")], r"small\.tir: the section \[UNITS\] is missing"),
        ([("LENGTH = 'mm'\n", "")], "the unit for LENGTH is missing"),
        (
            [("'mm'", "'parsec'")],
            r"line 2: unknown unit for LENGTH; found 'parsec'; allowed: meter, millimeter",
        ),
        (
            [("'newton'", "'newtonn'")],
            "unknown unit for FORCE; found 'newtonn'.*Did you mean 'newton'",
        ),
        (
            [("VERTICAL_STIFFNESS", "VERTICAL_STIFNESS")],
            "VERTICAL_STIFFNESS is missing.*'VERTICAL_STIFNESS'",
        ),
        (
            [("UNLOADED_RADIUS", "RADIUS")],
            r"UNLOADED_RADIUS is missing; allowed: UNLOADED_RADIUS in \[DIMENSION\]",
        ),
        ([("= 210 ", "= soft ")], r"line 11: VERTICAL_STIFFNESS: not a number; found 'soft'"),
        ([("= 210 ", "= 2,1 ")], "not a number; found '2,1'. Write a decimal point"),
        ([("= 210 ", "= nan ")], "not a finite number"),
        (
            [("= 210 ", "= -210 ")],
            r"line 11: VERTICAL_STIFFNESS: out of range; found '-210'; allowed: above 0",
        ),
        ([("= 0.08", "= -1")], "VERTICAL_DAMPING: out of range; found '-1'; allowed: at least 0"),
        (
            [("FNOMIN = 4000", "VERTICAL_STIFFNESS = 3")],
            r"line 13: VERTICAL_STIFFNESS is given twice in \[VERTICAL\]",
        ),
    ],
)
def test_refuses(tmp_path, changes, says) -> None:
    with pytest.raises(DescriptionError, match=says) as caught:
        read_tir(small(tmp_path, *changes))
    assert "\n" not in str(caught.value)


def test_refuses_what_is_no_tyre_file(tmp_path) -> None:
    with pytest.raises(DescriptionError, match=r"none\.tir: no such file"):
        read_tir(tmp_path / "none.tir")
    for content, says in [
        (b"", "not a tyre property file"),
        (b"x,y\n1,2\n", "not a tyre property file"),
        (b"\x00\x01MATLAB", "not a text file"),
    ]:
        (tmp_path / "bad.tir").write_bytes(content)
        with pytest.raises(DescriptionError, match=says):
            read_tir(tmp_path / "bad.tir")


def test_spellings_that_other_programs_write(tmp_path) -> None:
    text = SMALL.replace("\n", "\r\n").replace("= 210  ", "=2.1D+02").replace("'mm'", "'MM'")
    (tmp_path / "other.tir").write_bytes(
        text.replace("[VERTICAL]", "[ vertical ]").encode("cp1252")
    )
    assert read_tir(tmp_path / "other.tir").stiffness == pytest.approx(210e3)


def test_bottoming_curves_are_read_and_named_as_dropped(tmp_path: Path) -> None:
    text = (
        "[UNITS]\nLENGTH = 'mm'\nFORCE = 'newton'\nTIME = 'second'\n[DIMENSION]\nUNLOADED_RADIUS = 300\n"
        "[VERTICAL]\nVERTICAL_STIFFNESS = 200\nBOTTOMING_RADIUS = 210\n"
        "[BOTTOMING_CURVE]\n{pen fz}\n0 0\n5 4000\n10 20000\n"
    )
    file = tmp_path / "rim.tir"
    file.write_text(text)
    tyre = read_tir(file)
    assert (tyre.bottoming_penetration, tyre.bottoming_load) == (
        (0.0, 0.005, 0.01),
        (0.0, 4000.0, 20000.0),
    )
    assert tyre.bottoming_radius == pytest.approx(0.21)
    (finding,) = tyre.findings
    assert (finding.severity, finding.value) == ("note", pytest.approx(0.09))
    assert "the rim hits the road from a deflection of 0.09 m on" in finding.message
    assert tyre.tyre()["stiffness"] == pytest.approx(2e5)
    curve = tyre.tyre(rim=True)["curve"]  # the rim's force adds to the tyre's from 90 mm on
    assert curve["deflection"] == pytest.approx([0.0, 0.09, 0.095, 0.1])
    assert curve["force"] == pytest.approx([0.0, 18000.0, 19000.0 + 4000.0, 20000.0 + 20000.0])
    rig = load("sedan-double-wishbone").with_changes({"tyre": tyre.tyre(rim=True)})
    assert rig.tyre.stiffness is None
    file.write_text(
        text.replace(
            "[BOTTOMING_CURVE]\n{pen fz}\n0 0\n5 4000\n10 20000\n", "BOTTOM_STIFF = 2000\n"
        )
    )
    stiff = read_tir(file).tyre(rim=True)["curve"]
    assert stiff["force"] == pytest.approx([0.0, 18000.0, 0.099 * 2e5 + 0.009 * 2e6])
    file.write_text(text.replace("BOTTOMING_RADIUS = 210\n", ""))
    assert "this force never acts" in read_tir(file).findings[0].message
    file.write_text(text.replace("5 4000", "5 -4000"))
    with pytest.raises(
        DescriptionError, match=r"line 13: \[BOTTOMING_CURVE\]: the curve does not increase"
    ):
        read_tir(file)
