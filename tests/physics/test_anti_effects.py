"""Anti-dive, anti-lift, anti-squat against what joints in balance ask of the springs; dive, lift, squat per g."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.constants import GRAVITY

LONG, HIGH, MASS = 2.6, 0.5, 1400.0
PULL = 1000.0  # N on the wheel


@pytest.mark.parametrize(
    ("axle", "where", "layout", "name", "way"),
    [
        ("front", "contact_point", {"brakes": "outboard"}, "anti_dive", -1.0),
        ("front", "wheel_centre", {"brakes": "inboard"}, "anti_dive", -1.0),
        ("front", "wheel_centre", {"drive": "shaft", "drive_share": 0.4}, "anti_lift", 1.0),
        ("front", "contact_point", {"drive": "hub", "drive_share": 1.0}, "anti_lift", 1.0),
        ("rear", "wheel_centre", {"brakes": "inboard"}, "anti_lift", -1.0),
        ("rear", "wheel_centre", {}, "anti_squat", 1.0),
        ("rear", "contact_point", {"drive": "hub", "drive_share": 0.7}, "anti_squat", 1.0),
    ],
)
def test_the_geometry_takes_what_the_springs_are_spared(
    axle: str, where: str, layout, name: str, way: float
) -> None:
    """The wheel pulls the car and its load changes by the transfer: the spring's force changes by the rest."""
    rig = jn.load("reference-double-wishbone")
    car = jn.AxleLayout(
        axle=axle, wheelbase=LONG, centre_of_mass_height=HIGH, brake_share=0.6, **layout
    )
    swept = jn.sweep_travel(rig, 0.01, vehicle=car)
    share = {"anti_dive": 0.6, "anti_squat": car.driven}.get(
        name, 0.6 if axle == "rear" else car.driven
    )
    transfer = PULL / share * HIGH / LONG  # N of load that all of the force moves
    front = 1.0 if axle == "front" else -1.0
    pulled = jn.ContactLoad(
        longitudinal_force=way * PULL, vertical_force=3000.0 - front * way * transfer, through=where
    )
    forces = [
        float(jn.pickup_loads(rig, load, 0.01)["spring.force"][0])
        for load in (jn.ContactLoad(vertical_force=3000.0), pulled)
    ]
    spared = 1.0 - (forces[1] - forces[0]) * float(swept["motion_ratio_contact"][0]) / (
        -front * way * transfer
    )
    assert float(swept[name][0]) == pytest.approx(spared, rel=1e-9)
    assert set(car.effects) & {"anti_dive", "anti_lift", "anti_squat"} == {
        n for n in swept.data_vars if n.startswith("anti_")
    }


def test_a_front_axle_that_is_not_driven_only_dives() -> None:
    car = {"axle": "front", "wheelbase": LONG, "centre_of_mass_height": HIGH, "brake_share": 0.6}
    assert jn.AxleLayout(**car).effects == ("anti_dive",)
    assert jn.AxleLayout(**{**car, "axle": "rear"}).effects == ("anti_lift", "anti_squat")
    assert jn.AxleLayout(**{**car, "axle": "rear", "drive_share": 0.0}).effects == ("anti_lift",)
    with pytest.raises(jn.DescriptionError):
        jn.AxleLayout(**car, drive="chain")
    for wrong, text in (
        ({"wheelbase": 2600.0}, "at most 30 m"),
        ({"brake_share": 60.0}, r"at least 0, at most 1\.$"),
    ):
        with pytest.raises(jn.DescriptionError, match=text):
            jn.AxleLayout(**{**car, **wrong})


@pytest.mark.parametrize("axle", ["front", "rear"])
def test_moves_of_the_body_are_those_of_springs_and_tyres_under_the_transfer(axle: str) -> None:
    rig = jn.load("reference-double-wishbone")
    car = {"axle": axle, "wheelbase": LONG, "centre_of_mass_height": HIGH, "brake_share": 0.6}
    assert "dive_per_g" not in jn.sweep_travel(rig, 0.0, vehicle=jn.AxleLayout(**car))
    found = jn.sweep_travel(rig, 0.0, vehicle=jn.AxleLayout(**car, mass=MASS))
    transfer = 0.5 * MASS * GRAVITY * HIGH / LONG
    names = {"front": ("dive_per_g", "anti_dive"), "rear": ("lift_per_g", "anti_lift")}[axle]
    # travel of the contact patch under what is left of a small transfer, from the wheel force by virtual work
    step = 1e-5
    near = jn.sweep_travel(rig, step * np.array([-1.0, 1.0]))
    lift = (near["motion_ratio"] / near["motion_ratio_contact"]).to_numpy()
    force = near["wheel_force"].to_numpy() / lift
    rate = float(np.diff(force)[0]) / (2.0 * step * lift.mean())
    tyre = float(found["tyre_stiffness"][0])
    wanted = transfer * (1.0 - float(found[names[1]][0])) / rate + transfer / tyre
    assert float(found[names[0]][0]) == pytest.approx(wanted, rel=1e-6)
    driven = {"front": "lift_per_g", "rear": "squat_per_g"}[axle]
    share = 0.0 if axle == "front" else float(found["anti_squat"][0])
    assert float(found[driven][0]) == pytest.approx(
        transfer * (1.0 - share) / rate + transfer / tyre, rel=1e-6
    )
    third = {
        "third_spring": {"spring": {"rate": 40e3, "preload": 3e3}, "on": "lower_arm"},
        "hardpoints.third_spring_end": [0.0, 0.4, 0.3],
    }
    stiff = rig.with_changes(third)
    both = jn.sweep_travel(stiff, 0.0, vehicle=jn.AxleLayout(**car, mass=MASS))
    near = jn.sweep_travel(stiff, step * np.array([-1.0, 1.0]))
    rate = float(np.diff(near["heave_force"].to_numpy() / lift)[0]) / (2.0 * step * lift.mean())
    wanted = transfer * (1.0 - float(found[names[1]][0])) / rate + transfer / tyre
    assert float(both[names[0]][0]) == pytest.approx(wanted, rel=1e-6)
