"""Descriptions of cars on solid axles and twist beams: names, parts that are missing, and what runs leave out."""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts import SolidAxle, load, rig_findings, rig_from_table

BODY = {"mass": 1500.0, "pitch_inertia": 2500.0, "roll_inertia": 600.0, "height": 0.6}


def car(**rear: object) -> jn.Rig:
    table = {
        "schema": "jounce.vehicle/1",
        "model": "full-car-3d",
        "body": BODY,
        "front": {"distance": 1.4, "corner": "sedan-double-wishbone"},
        "rear": {"distance": 1.4, **rear},
    }
    return rig_from_table(table)


def test_an_axle_is_named_like_a_corner() -> None:
    rig = car(axle="van-rear-axle")
    assert isinstance(rig.rear.axle, SolidAxle)
    assert rig.rear.part == "axle"
    assert rig.front.part == "corner"
    assert rig.parameters()["rear.axle.bodies.axle.mass"] == 150.0
    assert rig.with_changes(
        {"rear.axle.wheel.radius": "350 mm"}
    ).rear.axle.wheel.radius == pytest.approx(0.35)
    assert jn.kc_test(rig, "bounce", on="rear", points=5).attrs["model"] == "solid-axle"


def test_a_car_on_an_axle_is_written_and_read_again(tmp_path) -> None:
    van = load("van-full-car-3d")
    file = jn.save(van, tmp_path / "van.toml")
    assert load(file) == van


@pytest.mark.parametrize(
    ("rear", "message"),
    [
        ({"axle": "solid-axle"}, "axle of a car needs all its parts.*bodies, tyre"),
        ({"axle": "sedan-multi-link"}, "not a solid axle or twist beam.*five-link"),
        ({"corner": "van-rear-axle"}, "not a 3-D corner.*solid-axle"),
        ({"axle": "van-rear-axel"}, "no axle of that name.*van-rear-axle"),
        ({"axle": 3}, "not a solid axle or twist beam"),
        ({}, "give exactly one of corner, axle"),
        ({"axle": "van-rear-axle", "corner": "sedan-multi-link"}, "exactly one of corner, axle"),
    ],
)
def test_impossible_cars_are_refused(rear: dict[str, object], message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        car(**rear)


def test_a_lever_without_a_watt_linkage_is_refused() -> None:
    body = {"mass": 1.0, "centre_of_mass": [0.0, 0.0, 0.3], "inertia": {"xx": 1, "yy": 1, "zz": 1}}
    with pytest.raises(DescriptionError, match="mass of its lever belong together"):
        load("van-rear-axle").with_changes({"bodies.watt_lever": body})


def test_bushings_that_runs_leave_out_are_reported() -> None:
    soft = {"stiffness": [1e7, 1e7, 1e7]}
    changes = {"rear.axle.bushings": {"lower_link_axle": soft, "lower_link_body": soft}}
    rig = load("van-full-car-3d").with_changes(changes)
    (found,) = (item for item in rig_findings(rig) if item.code == "parts.kc_only")
    assert "lower_link_axle" in str(found)
    assert "lower_link_body" not in str(found)
    assert not [
        item for item in rig_findings(load("van-full-car-3d")) if item.code == "parts.kc_only"
    ]
