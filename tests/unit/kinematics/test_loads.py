from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RIG = jn.load("reference-double-wishbone")


def test_arms_share_the_force_along_their_axis() -> None:
    load = jn.ContactLoad(longitudinal_force="-2 kN", vertical_force="3 kN")
    found = jn.pickup_loads(RIG, load, [-0.02, 0.0, 0.02])
    for arm in ("lower", "upper"):
        front, rear = (
            np.array(getattr(RIG.hardpoints, f"{arm}_arm_{end}")) for end in ("front", "rear")
        )
        axis = (front - rear) / np.linalg.norm(front - rear)
        along = [
            sum(
                axis[k] * found[f"{arm}_arm_{end}.f{name}"].to_numpy()
                for k, name in enumerate("xyz")
            )
            for end in ("front", "rear")
        ]
        assert along[0] == pytest.approx(along[1], abs=1e-8)


def test_forces_of_a_rod_lie_along_it() -> None:
    found = jn.pickup_loads(RIG, jn.ContactLoad(lateral_force=1000.0, aligning_torque=50.0))
    rod = np.array(RIG.hardpoints.tie_rod_outer) - np.array(RIG.hardpoints.tie_rod_inner)
    rod /= np.linalg.norm(rod)
    for end in ("inner", "outer"):
        force = np.array([float(found[f"tie_rod_{end}.f{axis}"][0]) for axis in "xyz"])
        assert np.linalg.norm(np.cross(force, rod)) < 1e-9
        assert force @ rod == pytest.approx(
            float(found["tie_rod.axial_force"][0])
        )  # the wheel pulls it outward: tension


def test_where_the_longitudinal_force_acts_matters() -> None:
    """A brake on the wheel loads the tie rod and arms with its moment, a shaft does not."""
    brake = jn.pickup_loads(RIG, jn.ContactLoad(longitudinal_force=-1000.0))
    shaft = jn.pickup_loads(RIG, jn.ContactLoad(longitudinal_force=-1000.0, through="wheel_centre"))
    assert float(brake["upper_ball_joint.fx"][0]) > 0.0 > float(shaft["upper_ball_joint.fx"][0])
    swept = jn.sweep_travel(RIG, 0.0)
    work = float(shaft["spring.force"][0] * swept["motion_ratio"][0])
    assert work == pytest.approx(
        -1000.0 * float(swept["wheel_centre_longitudinal_slope"][0]), rel=1e-9
    )


def test_a_strut_on_the_upright_is_on_the_spring_line() -> None:
    rig = jn.load("generic-mcpherson")
    found = jn.pickup_loads(rig, jn.ContactLoad(vertical_force=4000.0, lateral_force=-1500.0))
    assert set(found.attrs) >= {"model", "status"}
    assert float(found["spring.force"][0]) > 0.0
    assert found["spring.force"].attrs["units"] == "N"


def test_unreachable_travel_is_left_out() -> None:
    found = jn.pickup_loads(RIG, jn.ContactLoad(vertical_force=1.0), [0.0, 0.2, 0.4])
    assert found["wheel_travel"].to_numpy() == pytest.approx([0.0, 0.2])
    assert found.attrs["status"] == "end_of_travel"
    with pytest.raises(jn.SimulationError, match="no pose"):
        jn.pickup_loads(RIG, jn.ContactLoad(vertical_force=1.0), [0.4])


def test_unknown_loads_are_refused() -> None:
    with pytest.raises(jn.DescriptionError, match="unknown key"):
        jn.ContactLoad(vertical="4 kN")  # type: ignore[call-arg]
    with pytest.raises(jn.DescriptionError, match="wrong unit"):
        jn.ContactLoad(vertical_force="4 kg")
