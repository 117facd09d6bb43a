"""Updates to K&C sheets: exact sheets, few readings, what cannot be told, and refusals."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError, FitError

RIG = jn.load("generic-mcpherson")
HEIGHT = "hardpoints.tie_rod_inner[2]"


def bounce(rig: jn.Rig, points: int = 21) -> xr.Dataset:
    return jn.kc_test(rig, "bounce", points=points)


def test_an_exact_sheet_gives_its_numbers() -> None:
    truth = RIG.with_changes({HEIGHT: RIG.parameters()[HEIGHT] + 0.003, "strut.spring.rate": 400e3})
    free = {HEIGHT: "5 mm", "strut.spring.rate": "20 %"}
    fit = jn.update_kc(RIG, bounce(truth), free)
    assert not fit.undetermined
    for path, estimate in fit.parameters.items():
        assert estimate.value == pytest.approx(truth.parameters()[path], rel=2e-3)
        assert estimate.has(truth.parameters()[path])
        assert fit.rig.parameters()[path] == estimate.value
    toe = next(curve for curve in fit.curves if curve["quantity"] == "left.toe")
    assert toe["after"] < 0.05 * toe["before"]
    assert f"{HEIGHT} " in str(fit)


def test_ten_rows_of_dial_gauges_are_enough() -> None:
    truth = RIG.with_changes({HEIGHT: RIG.parameters()[HEIGHT] + 0.003})
    whole = bounce(truth)
    order = np.argsort(whole["input"].values)[::2]
    toe = whole["left.toe"].values[order] + np.random.default_rng(3).normal(0.0, 2e-4, order.size)
    rows = xr.Dataset(
        {"left.toe": ("sample", toe, {"units": "rad"})},
        {"input": ("sample", whole["input"].values[order], {"units": "m"})},
        {"test": "bounce"},
    )
    fit = jn.update_kc(RIG, rows, {HEIGHT: "6 mm"}, noise={"toe": "0.012 deg"})
    estimate = fit.parameters[HEIGHT]
    assert estimate.has(truth.parameters()[HEIGHT])
    assert estimate.interval[1] - estimate.interval[0] < 6e-3


def test_what_the_test_cannot_tell_gets_no_number() -> None:
    free = {HEIGHT: "5 mm", "hardpoints.wheel_centre[0]": "5 mm"}
    fit = jn.update_kc(RIG, bounce(RIG), free, quantities=["toe"])
    assert fit.undetermined == ("hardpoints.wheel_centre[0]",)
    assert "hardpoints.wheel_centre[0]" not in fit.parameters
    assert (
        fit.rig.parameters()["hardpoints.wheel_centre[0]"]
        == RIG.parameters()["hardpoints.wheel_centre[0]"]
    )
    codes = {item.code: item.place for item in fit.findings}
    assert codes["identify.kc_undetermined"] == "hardpoints.wheel_centre[0]"


def test_totals_tell_static_camber() -> None:
    truth = RIG.with_changes({"wheel.camber": RIG.wheel.camber + np.radians(0.5)})
    free = {"wheel.camber": "2 deg"}
    fit = jn.update_kc(RIG, bounce(truth), free, quantities=["camber"], totals=["camber"])
    assert fit.parameters["wheel.camber"].has(truth.wheel.camber)


@pytest.mark.parametrize(
    ("free", "options", "message"),
    [
        ({}, {}, "no free parameters"),
        ({"sprung.mass": "10 %"}, {}, "unknown parameter"),
        ({HEIGHT: ["1 m", "2 m"]}, {}, "invalid bounds"),
        ({HEIGHT: "5 mm"}, {"quantities": ["toes"]}, "not measured"),
        ({HEIGHT: "5 mm"}, {"noise": {"toe": "3 N"}}, "noise: toe"),
    ],
)
def test_wrong_input_is_refused(free: dict, options: dict, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        jn.update_kc(RIG, bounce(RIG, 5), free, **options)


def test_a_sheet_without_known_quantities_is_refused() -> None:
    with pytest.raises(FitError, match="no measured quantity"):
        jn.update_kc(
            RIG,
            bounce(RIG, 5)[["left.lateral_force"]].assign_attrs(test="bounce"),
            {HEIGHT: "5 mm"},
        )
