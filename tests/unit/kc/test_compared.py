"""Simulated beside measured tests: verdicts, places and ranges with closed forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.core.findings import findings_of


def made(
    y: np.ndarray, x: np.ndarray, name: str = "left.toe", unit: str = "rad", **attrs: object
) -> xr.Dataset:
    return xr.Dataset(
        {name: ("sample", y, {"units": unit})},
        {"input": ("sample", x, {"units": "m"})},
        {"test": "bounce", **attrs},
    )


X = np.linspace(-0.05, 0.05, 41)


def test_a_curve_within_its_tolerance_is_within() -> None:
    table = jn.compare_kc(made(-0.1 * X, X), made(-0.105 * X + 0.001, X)).isel(row=0)
    assert str(table["verdict"].values) == "within"
    assert np.isnan(table["leaves_at"])
    assert float(table["difference"]) == pytest.approx(0.005 * 0.05, rel=1e-9)
    assert float(table["offset"]) == pytest.approx(-0.001, rel=1e-9)
    assert float(table["tolerance"]) == pytest.approx(0.1 * 0.0105, rel=1e-9)
    assert float(table["slope_simulated"]) == pytest.approx(-0.1, rel=1e-9)
    assert float(table["slope_measured"]) == pytest.approx(-0.105, rel=1e-9)
    assert (str(table["unit"].values), str(table["slope_unit"].values)) == ("rad", "rad/m")


def test_the_place_where_the_model_leaves_its_tolerance() -> None:
    """The measured curve bends: 4 x^2 reaches 0.0036 at 30 mm."""
    measured = made(-0.1 * X + 4.0 * X**2, X)
    table = jn.compare_kc(made(-0.1 * X, X), measured, {"bounce.toe": 0.0036}).isel(row=0)
    assert str(table["verdict"].values) == "outside"
    assert abs(float(table["leaves_at"])) == pytest.approx(0.030, abs=0.0011)
    assert float(table["difference"]) == pytest.approx(0.01, rel=1e-6)
    assert abs(float(table["difference_at"])) == pytest.approx(0.05)


def test_the_most_specific_tolerance_counts_in_any_form() -> None:
    ours, theirs = made(0.0 * X, X), made(-0.1 * X, X)
    for tolerances, expected in (
        ({"toe": "0.1 deg"}, np.radians(0.1)),
        ({"toe": "0.1 deg", "left.toe": "20 %"}, 0.002),
        ({"left.toe": "20 %", "bounce.left.toe": 0.003}, 0.003),
    ):
        table = jn.compare_kc(ours, theirs, tolerances)
        assert float(table["tolerance"][0]) == pytest.approx(expected)
    with pytest.raises(DescriptionError, match="tolerances: unknown quantity 'tow'"):
        jn.compare_kc(ours, theirs, {"tow": 0.1})
    with pytest.raises(DescriptionError, match="not a tolerance"):
        jn.compare_kc(ours, theirs, {"toe": -0.1})


def test_noise_and_resolution_are_in_the_default_tolerance() -> None:
    measured = made(-0.1 * X, X)
    measured["left.toe"].attrs["noise"] = 1e-3
    assert float(jn.compare_kc(made(-0.1 * X, X), measured)["tolerance"][0]) == pytest.approx(4e-3)
    flat = jn.compare_kc(made(1e-5 * X, X), made(0.0 * X, X)).isel(row=0)
    assert str(flat["verdict"].values) == "within"
    assert float(flat["tolerance"]) == pytest.approx(1.75e-4)


def test_only_the_common_range_is_judged_and_said() -> None:
    short = np.linspace(-0.02, 0.02, 21)
    table = jn.compare_kc(made(-0.1 * short, short), made(-0.1 * X + 200 * X**3, X))
    assert (float(table["low"][0]), float(table["high"][0])) == pytest.approx((-0.02, 0.02))
    assert float(table["difference"][0]) == pytest.approx(200 * 0.02**3, rel=2e-2)
    assert [item.code for item in findings_of(table.attrs)] == ["kc.range_not_covered"]
    apart = jn.compare_kc(made(X, X + 1.0), made(X, X))
    assert apart["verdict"].values.tolist() == ["not judged"]
    assert np.isnan(apart["slope_measured"][0])


def test_tests_and_quantities_of_one_side_are_named() -> None:
    ours = {"bounce": made(X, X), "roll": made(X, X)}
    theirs = {
        "bounce": made(X, X).assign({"left.camber": ("sample", X, {"units": "rad"})}),
        "steer": made(X, X),
    }
    table = jn.compare_kc(ours, theirs)
    assert table["quantity"].values.tolist() == ["left.toe"]
    assert {item.code for item in findings_of(table.attrs)} == {
        "kc.not_simulated", "kc.not_measured", "kc.quantities_not_simulated"}  # fmt: skip
    with pytest.raises(DescriptionError, match="names no test"):
        jn.compare_kc(xr.Dataset(), theirs)


def test_a_rig_that_measures_wheel_travel_is_compared_over_it() -> None:
    """The tyre takes a fifth of the height of the pad: over wheel travel both have the same slope."""
    ours = made(-0.1 * 0.8 * X, X).assign(
        {"left.wheel_centre_z": ("sample", 0.8 * X, {"units": "m"})}
    )
    theirs = made(-0.1 * X, X, input_quantity="wheel_centre_z").assign(
        {"left.wheel_centre_z": ("sample", X, {"units": "m"})}
    )
    table = jn.compare_kc(ours, theirs).set_index(row=("test", "quantity"))
    toe = table.sel(row=("bounce", "left.toe"))
    assert float(toe["slope_simulated"]) == pytest.approx(-0.1, rel=1e-9)
    assert float(toe["high"]) == pytest.approx(0.04)


def test_a_handwheel_angle_is_compared_with_the_model_s_own() -> None:
    angle = xr.DataArray(X * 80.0, dims="sample", attrs={"units": "rad"})
    theirs = made(X, X, input_quantity="handwheel_angle").assign_coords(input=angle)
    with_it = made(X, X).assign(handwheel_angle=angle)
    assert jn.compare_kc(with_it, theirs)["verdict"].values.tolist() == ["within"]
    without = jn.compare_kc(made(X, X), theirs)
    assert without.sizes["row"] == 0
    assert [item.code for item in findings_of(without.attrs)] == ["kc.other_input"]


def test_loops_are_compared_by_their_mean_lines() -> None:
    quarter = np.arange(10) / 10
    x = 0.05 * np.append(
        np.tile(np.concatenate([quarter, 1 - quarter, -quarter, quarter - 1]), 2), 0.0
    )
    rising = np.gradient(x) > 0
    ours, theirs = made(-0.1 * x, x), made(-0.1 * x + np.where(rising, -2e-4, 2e-4), x)
    table = jn.compare_kc(ours, theirs).isel(row=0)
    assert float(table["difference"]) < 2.1e-4
    assert float(table["hysteresis_measured"]) == pytest.approx(4e-4 / 0.01, rel=0.05)
    assert float(table["hysteresis_simulated"]) == pytest.approx(0.0, abs=1e-9)


def as_rig(simulated: dict[str, xr.Dataset], folder: Path) -> list[Path]:
    """Write simulated tests as a rig with SAE J670e axes would, with noise of 0.002 deg and 0.01 mm: synthetic."""
    random = np.random.default_rng(5)
    columns = {"toe": ("Toe", "deg", 1), "camber": ("Camber", "deg", 1), "wheel_centre_x": ("WC X", "mm", 1),
               "wheel_centre_y": ("WC Y", "mm", -1), "wheel_centre_z": ("WC Z", "mm", -1),
               "contact_point_y": ("Contact Patch Y", "mm", -1), "vertical_force": ("Fz", "N", -1),
               "lateral_force": ("Fy", "N", -1)}  # fmt: skip
    scale = {"deg": (np.degrees(1.0), 0.002), "mm": (1e3, 0.01), "N": (1.0, 1.0)}
    files = []
    for test, data in simulated.items():
        table = {}
        for quantity, (heading, unit, sign) in columns.items():
            for wheel in ("left", "right"):
                factor, noise = scale[unit]
                values = sign * factor * data[f"{wheel}.{quantity}"].values
                table[f"{heading} {wheel} [{unit}]"] = values + random.normal(
                    0.0, noise, values.size
                )
        lines = [
            ",".join(table),
            *(",".join(map(repr, map(float, row))) for row in zip(*table.values(), strict=True)),
        ]
        file = folder / f"{test}.csv"
        file.write_text("\n".join(lines) + "\n")
        files.append(file)
    return files


def test_a_simulated_axle_measured_on_a_virtual_rig_agrees_with_itself(tmp_path: Path) -> None:
    """Also with the finding where a hardpoint of the model is wrong."""
    rig = jn.load("formula-student-front")
    tests = ("bounce", "roll", "lateral-in-phase", "lateral-opposed")
    simulated = jn.kc_tests(rig, tests)
    track = simulated["roll"].attrs["track"]
    measured = jn.read_kc(as_rig(simulated, tmp_path), convention="j670e", track=track)
    assert list(measured) == list(tests)
    assert [str(item) for item in measured.findings if item.severity != "note"] == []
    table = jn.compare_kc(simulated, measured)
    wrong = table.where(table["verdict"] != "within", drop=True)
    assert wrong["quantity"].values.tolist() == []
    moved = rig.with_changes(
        {"hardpoints.tie_rod_inner[2]": rig.hardpoints.tie_rod_inner[2] + 0.01}
    )
    table = jn.compare_kc(jn.kc_tests(moved, tests), measured).set_index(row=("test", "quantity"))
    bounce = table.sel(row=("bounce", "left.toe"))
    assert str(bounce["verdict"].values) == "outside"
    assert 0.0 < abs(float(bounce["leaves_at"])) < 0.05
    assert str(table.sel(row=("bounce", "left.camber"))["verdict"].values) == "within"


def both(left: float, right: float) -> xr.Dataset:
    data = made(left * X, X)
    return data.assign({"right.toe": ("sample", right * X, {"units": "rad"})})


@pytest.mark.parametrize(
    ("measured", "code", "names"),
    [
        (both(0.1, 0.02), "opposite_sign", ["left.toe"]),
        (both(0.02, -0.1), "other_wheel", ["toe"]),
        (both(-1e-4, 0.02), "other_unit", ["left.toe"]),
        (both(-0.1 * 180.0 / np.pi, 0.02), "other_unit", ["left.toe"]),
    ],
)
def test_a_usual_mistake_is_named(measured: xr.Dataset, code: str, names: list[str]) -> None:
    allowed = {"toe": "10 %"}
    found = findings_of(jn.compare_kc(both(-0.1, 0.02), measured, allowed).attrs)
    assert [(item.code, list(item.numbers["names"])) for item in found] == [(f"kc.{code}", names)]


def test_a_curve_that_merely_differs_is_no_mistake() -> None:
    assert findings_of(jn.compare_kc(both(-0.1, 0.02), both(-0.15, 0.03)).attrs) == []


@pytest.mark.parametrize("factor", [1e3, 1e-3])
def test_an_input_in_another_unit_is_one_finding(factor: float) -> None:
    table = jn.compare_kc(made(-0.1 * X, X), made(-0.1 * X, factor * X))
    assert [item.code for item in findings_of(table.attrs)] == ["kc.ranges_differ"]
    assert set(table["verdict"].values) == {"not judged"}
