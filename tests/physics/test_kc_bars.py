"""Bars and third springs between both wheels on the K&C rig: the work of the pads is the energy of their laws."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq, fsolve
from scipy.spatial.transform import Rotation

import jounce as jn

RIG = "formula-student-front"
ACROSS = np.array([0.0, 1.0, 0.0])
HALF = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_arm_end": [-0.15, 0.12, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
}
T_BAR = {
    "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
    "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
    "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
    "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
}
THIRD = [0.02, 0.21, 0.42]
STIFFNESS, RATE, PRELOAD = 400.0, 30e3, 150.0
REACH = "15 mm"


def bar(kind: str) -> dict:
    return {"anti_roll_bar": {"stiffness": STIFFNESS, "on": "rocker", "kind": kind}}


PARTS = {
    "u": HALF | bar("u"),
    "tilted u": HALF | bar("u") | {"hardpoints.arb_axis": [-0.085, 0.20, 0.362]},
    "z": HALF | bar("z"),
    "t": T_BAR | bar("t"),
    "third spring": {
        "third_spring": {"spring": {"rate": RATE, "preload": PRELOAD}},
        "hardpoints.third_spring_end": THIRD,
    },
}


class Ends:
    """Places of a point on the rocker over wheel travel, of the left side; the right one is the mirror image."""

    def __init__(self, rig: jn.Rig, point: str) -> None:
        sweep = jn.sweep_travel(rig, "-40 mm:40 mm:1 mm", points=True)
        self.over = sweep["wheel_travel"].values
        self.at = np.stack([sweep[f"{point}.{axis}"].values for axis in "xyz"], axis=1)

    def __call__(self, travel: float, side: float) -> np.ndarray:
        place = np.array([np.interp(travel, self.over, column) for column in self.at.T])
        return place * [1.0, side, 1.0]


def turned(axis: np.ndarray, angle: float, place: np.ndarray) -> np.ndarray:
    return Rotation.from_rotvec(angle * axis / np.linalg.norm(axis)).apply(place)


def energy(name: str, rig: jn.Rig, left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Energy of the part, from where its ends are."""
    points = {key: np.array(place) for key, place in rig.hardpoints.given().items()}
    if name == "third spring":
        ends = Ends(rig, "third_spring_end")
        reach = [
            np.linalg.norm(ends(a, 1.0) - ends(b, -1.0)) for a, b in zip(left, right, strict=True)
        ]
        short = 2.0 * THIRD[1] - np.array(reach)
        return PRELOAD * short + 0.5 * RATE * short**2
    ends, pivot = Ends(rig, "arb_link_end"), points["arb_pivot"]
    arm = points["arb_arm_end"] - pivot
    link = np.linalg.norm(points["arb_link_end"] - points["arb_arm_end"])
    if name == "t":
        stem = points["arb_axis"] - pivot

        def missing(state, *where):
            out = []
            for end, side in zip(where, (1.0, -1.0), strict=True):
                tip = turned(stem, state[1], arm * [1.0, side, 1.0])
                out.append(np.linalg.norm(pivot + turned(ACROSS, state[0], tip) - end) - link)
            return out

        state, twist = np.zeros(2), []
        for a, b in zip(left, right, strict=True):
            state = fsolve(missing, state, (ends(a, 1.0), ends(b, -1.0)), xtol=1e-11)
            twist.append(state[1])
        return 0.5 * STIFFNESS * np.array(twist) ** 2
    axis = points.get("arb_axis", pivot + ACROSS) - pivot

    def angle(travel: float) -> float:
        def gap(phi: float) -> float:
            return np.linalg.norm(pivot + turned(axis, phi, arm) - ends(travel, 1.0)) - link

        return brentq(gap, -0.6, 0.6, xtol=1e-14)

    both = [np.array([angle(z) for z in travel]) for travel in (left, right)]
    sign = 1.0 if name == "z" else -1.0  # about an axis to the left, the mirror image turns alike
    return 0.5 * STIFFNESS * (both[0] + sign * both[1]) ** 2


@pytest.mark.parametrize("test", ["bounce", "roll"])
@pytest.mark.parametrize("name", PARTS)
def test_work_of_the_pads_is_the_energy_of_the_part(name: str, test: str) -> None:
    plain = jn.load(RIG)
    rig = plain.with_changes(PARTS[name])
    to = REACH if test == "bounce" else "1.2 deg"
    run = jn.kc_test(rig, test, to=to, points=161).isel(sample=slice(0, 41))
    alone = jn.kc_test(plain, "bounce", to="25 mm", points=401).isel(sample=slice(100, 301))
    work = 0.0
    travels = []
    for side in ("left", "right"):
        height = run[f"{side}.contact_point_z"].values
        own = alone[f"{side}.contact_point_z"].values[::-1]
        without = np.interp(height, own, alone[f"{side}.vertical_force"].values[::-1])
        more = run[f"{side}.vertical_force"].values - without
        steps = 0.5 * (more[1:] + more[:-1]) * np.diff(height)
        work = work + np.append(0.0, np.cumsum(steps))
        travels.append(run[f"{side}.wheel_centre_z"].values)
    stored = energy(name, rig, *travels)
    expected = stored - stored[0]
    slack = 5.0 if name == "tilted u" else 1.0  # exact for small angles
    assert work == pytest.approx(expected, abs=2e-3 * slack * np.abs(expected).max() + 2e-4)
    works = {"u": "roll", "tilted u": "roll", "t": "roll", "z": "bounce", "third spring": "bounce"}
    if works[name] == test:
        assert np.abs(expected).max() > 0.1
    elif name != "third spring":
        assert np.abs(expected).max() < 1e-3 + 0.02 * (name == "z")


def test_a_leaning_bar_is_noted() -> None:
    rig = jn.load(RIG).with_changes(PARTS["tilted u"] | {"hardpoints.arb_axis": [-0.12, 0.2, 0.33]})
    said = jn.kc_test(rig, "roll", points=5).attrs["findings"]
    assert any("lean by" in text for text in said)
    upright = jn.load(RIG).with_changes(PARTS["u"])
    said = jn.kc_test(upright, "roll", points=5).attrs["findings"]
    assert not any("lean by" in text for text in said)


@pytest.mark.parametrize(
    ("name", "test", "path"),
    [
        ("t", "roll", "anti_roll_bar.stiffness"),
        ("t", "roll", "hardpoints.arb_axis[0]"),
        ("z", "bounce", "hardpoints.arb_arm_end[2]"),
        ("third spring", "bounce", "third_spring.spring.rate"),
    ],
)
def test_slopes_are_exact(name: str, test: str, path: str) -> None:
    rig = jn.load(RIG).with_changes(PARTS[name])
    quantity = "left.vertical_force"
    exact = jn.kc_sensitivities(rig, test, [path], quantities=[quantity], points=9, to=0.015)
    value = rig.parameters()[path]
    step = 1e-5 if "hardpoints" in path else 1e-4 * value
    ends = [
        jn.kc_test(rig.with_changes({path: value + s * step}), test, points=9, to=0.015)[quantity]
        for s in (1.0, -1.0)
    ]
    want = (ends[0].values - ends[1].values) / (2.0 * step)
    assert np.abs(want).max() > 0.0
    found = exact["sensitivity"].sel(quantity=quantity, parameter=path).values
    assert found == pytest.approx(want, abs=2e-4 * np.abs(want).max())
