"""A driven mechanism that reaches a singular configuration: the run stops there and says when and in which pose."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

LEVEL = (0.0, 1.0, 0.0)


def driven_four_bar():
    """Four bars whose driven crank cannot turn all the way round: at its limit coupler and rocker lie on one line."""
    mechanism = jn.mechanics.Mechanism()
    crank = mechanism.body("crank", 1.0, (0.5, 0.0, 0.0), (0.1, 0.1, 0.1))
    coupler = mechanism.body("coupler", 1.0, (1.0, 0.0, 0.5), (0.1, 0.1, 0.1))
    rocker = mechanism.body("rocker", 1.0, (2.0, 0.0, 0.5), (0.1, 0.1, 0.1))
    angle = mechanism.revolute("crank", mechanism.ground, crank, (0.0, 0.0, 0.0), LEVEL)
    mechanism.revolute("joint", crank, coupler, (1.0, 0.0, 0.0), LEVEL)
    mechanism.revolute("rocker", mechanism.ground, rocker, (2.0, 0.0, 0.0), LEVEL)
    mechanism.point_on_line(
        "pin", coupler, rocker, at=(1.5, 0.0, 0.7), axis=LEVEL, point=(1.5, 0.0, 0.7)
    )
    mechanism.motion("motor", angle, mechanism.track("drive"))
    mechanism.watch_energy()
    return mechanism


def limit_angle():
    """Crank angle (rad) at which coupler (0.5, 0.7) and rocker (-0.5, 0.7) are stretched, by the law of cosines."""
    reach = 2.0 * np.hypot(0.5, 0.7)
    return np.arccos((1.0 + 4.0 - reach**2) / 4.0)


@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_lock_up_is_reported_with_time_and_pose(speed):
    with pytest.raises(jn.SimulationError, match="singular configuration") as caught:
        jn.simulate_mechanism(
            driven_four_bar(), 5.0, motions={"drive": jn.mechanics.constant_rate(speed)}
        )
    found = str(caught.value)
    assert "crank.angle" in found
    assert float(found.split("stopped after ")[1].split(" s:", maxsplit=1)[0]) == pytest.approx(
        limit_angle(), abs=0.01
    )


def test_what_was_computed_before_is_kept():
    run = jn.simulate_mechanism(
        driven_four_bar(), 5.0, motions={"drive": jn.mechanics.constant_rate(1.0)}, check=False
    )
    assert run.attrs["status"] == "locked_up"
    assert float(run["time"][-1]) == pytest.approx(limit_angle(), abs=0.01)
    assert float(run["constraint.residual"].max()) < 1e-9
