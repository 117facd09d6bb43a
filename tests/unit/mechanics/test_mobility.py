"""Degrees of freedom of linkages: counted, named, and not taken for free where the next millimetre stops them."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

X, Y, Z, ORIGIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
BALL = (0.1, 0.1, 0.1)


def axle(rods):
    """A rigid axle on rods along the car, and a Panhard rod."""
    linkage = jn.mechanics.Mechanism()
    body = linkage.body("axle", 80.0, (0.0, 0.0, 0.3), (10.0, 2.0, 10.0))
    linkage.free("axle", body)
    for i, (chassis, on_axle) in enumerate(rods):
        linkage.rod(f"rod {i}", linkage.ground, body, at=chassis, second_at=on_axle)
    linkage.rod("Panhard", linkage.ground, body, at=(-0.1, 0.5, 0.3), second_at=(-0.1, -0.5, 0.3))
    for y in (-0.4, 0.4):
        top, bottom = (0.0, y, 0.7), (0.0, y, 0.35)
        linkage.spring_damper(
            f"spring {y:+g}", linkage.ground, body, top, bottom, stiffness=20e3, damping=1500.0
        )
    linkage.watch_body(body)
    return linkage


def converging():
    return axle(
        [
            (start, end)
            for side in (-1.0, 1.0)
            for start, end in (
                ((0.5, 0.5 * side, 0.25), (0.0, 0.55 * side, 0.2)),
                ((0.4, 0.5 * side, 0.45), (0.0, 0.2 * side, 0.42)),
            )
        ]
    )


def parallel(upper=0.3):
    ends = [(0.5, 0.2), (-0.5, 0.2), (upper, 0.42), (-0.3, 0.42)]
    return axle([((0.5, y, z), (0.0, y, z)) for y, z in ends])


def test_four_rods_and_a_panhard_rod_leave_one_freedom_which_a_run_names():
    """By hand: the rods of each side meet, seen from the side, at x = 8.8 m, z = 1.08 m."""
    run = jn.simulate_mechanism(converging(), 0.1, output_step=0.05)
    assert run.attrs["degrees_of_freedom"] == 1
    (said,) = run.attrs["findings"]
    text = "the joints allow 1: axle turns about the line through (8.8, 0, 1.08) m along (0, 1, 0)"
    assert said == f"note: degrees of freedom: {text}"
    lower, upper = (0.05 / 0.5), (0.03 / 0.4)  # slopes of the rods
    x = (0.42 - 0.2) / (lower - upper)
    assert (x, 0.2 + lower * x) == (pytest.approx(8.8), pytest.approx(1.08))


def test_a_redundant_rod_does_not_hide_the_second_freedom():
    found = parallel().mobility()
    assert (found.degrees_of_freedom, found.count) == (2, 1)
    assert {str(motion) for motion in found.motions} == {
        "axle turns about the line through (0, 0, 0.3) m along (1, 0, 0)",
        "axle slides along (0, 0, 1)",
    }
    assert all(motion.is_loaded for motion in found.motions)
    assert found.redundant == (("rod 0", "rod 1", "rod 2", "rod 3"),)
    run = jn.simulate_mechanism(parallel(), 0.1, redundant="remove", output_step=0.05)
    assert any(text.startswith("note: degrees of freedom: redundant equations, removed: rod") for text in
               run.attrs["findings"])  # fmt: skip
    assert run.attrs["degrees_of_freedom"] == 2


def test_a_motion_that_the_next_millimetre_stops_is_not_called_free():
    """Rods through points that lie on no common circle let the axle roll by nothing but rounding."""
    with pytest.raises(jn.AssemblyError, match="singular configuration"):
        parallel(upper=0.4).mobility()


@pytest.mark.parametrize("what", ["mobility", "refuse", "remove"])
def test_a_link_at_its_dead_point_holds_the_crank_and_is_not_left_out(what):
    """Crank and rod on one line through both bearings: the crank cannot turn at all, and no equation is superfluous."""
    mechanism = jn.mechanics.Mechanism()
    crank = mechanism.body("crank", 1.0, (0.0, 0.0, 0.3), BALL)
    mechanism.revolute("bearing", mechanism.ground, crank, at=ORIGIN, axis=Y)
    mechanism.rod("rod", mechanism.ground, crank, at=(0.0, 0.0, -0.5), second_at=(0.0, 0.0, 0.3))
    mechanism.watch_body(crank)
    with pytest.raises(jn.AssemblyError, match="rod: the mechanism is in a singular configuration"):
        mechanism.mobility() if what == "mobility" else jn.simulate_mechanism(
            mechanism, 0.1, redundant=what
        )


def test_a_rod_that_spins_about_its_own_line_feels_no_force():
    mechanism = jn.mechanics.Mechanism()
    crank = mechanism.body("crank", 1.0, (0.05, 0.0, 0.0), BALL)
    rod = mechanism.body("rod", 1.0, (0.2, 0.0, 0.0), (0.002, 0.01, 0.012))
    piston = mechanism.body("piston", 1.0, (0.3, 0.0, 0.0), BALL)
    mechanism.revolute("main", mechanism.ground, crank, at=ORIGIN, axis=Y)
    mechanism.prismatic("bore", mechanism.ground, piston, axis=X, at=(0.3, 0.0, 0.0))
    mechanism.spherical("pin", crank, rod, at=(0.1, 0.0, 0.0))
    mechanism.spherical("gudgeon", rod, piston, at=(0.3, 0.0, 0.0))
    found = mechanism.mobility(start={"main.angle": 0.3})
    assert found.degrees_of_freedom == found.count == 2
    turning, spinning = found.motions
    assert turning.is_loaded
    assert set(turning.moving) == {"crank", "rod", "piston"}
    assert (spinning.body, spinning.moving, spinning.is_loaded) == ("rod", ("rod",), False)
    pin = 0.1 * np.array([np.cos(0.3), 0.0, -np.sin(0.3)])
    along = np.array([pin[0] + np.sqrt(0.04 - pin[2] ** 2), 0.0, 0.0]) - pin
    np.testing.assert_allclose(np.cross(spinning.axis, along), 0.0, atol=1e-9)
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(mechanism, 0.05, start={"main.angle": 0.3}, output_step=0.05)
    assert "no force acts along 1 of 2: rod turns about" in run.attrs["findings"][-1]


@pytest.mark.parametrize(
    ("joint", "freedom", "text"),
    [
        (lambda m, b: m.free("f", b), 6, "body slides along (0, 0, 1)"),
        (
            lambda m, b: m.spherical("f", m.ground, b, at=ORIGIN),
            3,
            "body turns about the line through (0, 0, 0) m",
        ),
        (
            lambda m, b: m.screw("f", m.ground, b, at=ORIGIN, axis=Y, pitch=0.1),
            1,
            "along (0, 1, 0) and slides 0.0159 m/rad along it",
        ),
    ],
)
def test_a_single_body_has_the_freedoms_of_its_joint(joint, freedom, text):
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("body", 1.0, (0.0, 0.0, -0.3), BALL)
    joint(mechanism, body)
    found = mechanism.mobility()
    assert found.degrees_of_freedom == found.count == freedom
    assert text in str(found)
    unfelt = {6: 5, 3: 1, 1: 0}[freedom]  # all but the fall; the turn about the upright; none
    assert sum(not motion.is_loaded for motion in found.motions) == unfelt


def test_sarrus_linkage_slides_though_grubler_counts_none():
    """Two pairs of plates on hinges across each other: the count says 0, the geometry 1, straight up."""
    mechanism = jn.mechanics.Mechanism()
    top = mechanism.body("top", 100.0, (0.0, 0.0, 1.0), BALL)
    for name, along, axis in (("a", np.array(X), Y), ("b", np.array(Y), X)):
        lower = mechanism.body(f"lower {name}", 1.0, 0.6 * along + (0.0, 0.0, 0.25), BALL)
        upper = mechanism.body(f"upper {name}", 1.0, 0.6 * along + (0.0, 0.0, 0.75), BALL)
        mechanism.revolute(f"{name}0", mechanism.ground, lower, at=0.5 * along, axis=axis)
        mechanism.revolute(f"{name}1", lower, upper, at=0.7 * along + (0.0, 0.0, 0.5), axis=axis)
        mechanism.revolute(f"{name}2", upper, top, at=0.5 * along + (0.0, 0.0, 1.0), axis=axis)
    found = mechanism.mobility()
    assert (found.degrees_of_freedom, found.count, len(found.redundant)) == (1, 0, 1)
    assert str(found.motions[0]) in ("top slides along (0, 0, 1)", "top slides along (0, 0, -1)")


def test_a_structure_that_cannot_move_says_so():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bracket", 1.0, (0.0, 0.0, 0.3), BALL)
    mechanism.revolute("pin", mechanism.ground, body, at=ORIGIN, axis=Y)
    mechanism.rod("stay", mechanism.ground, body, at=(1.0, 0.0, 0.3), second_at=(0.0, 0.0, 0.3))
    mechanism.watch_body(body)
    assert mechanism.mobility().degrees_of_freedom == 0
    (said,) = jn.simulate_mechanism(mechanism, 0.1, output_step=0.05).attrs["findings"]
    assert said.startswith("warning: degrees of freedom: the joints allow no motion")


@pytest.mark.parametrize(
    ("scale", "text"),
    [(1e3, "millimetres given as metres?"), (1e-3, "metres given as millimetres?"), (1.0, None)],
)
def test_millimetres_taken_for_metres_are_asked_about(scale, text):
    mechanism = jn.mechanics.Mechanism()
    bob = mechanism.body("bob", 1.0, (0.3 * scale, 0.0, 0.0), BALL)
    mechanism.revolute("pivot", mechanism.ground, bob, at=(0.0, 0.0, 0.1 * scale), axis=Y)
    mechanism.watch_body(bob)
    found = [
        one for one in jn.simulate_mechanism(mechanism, 0.01).attrs["findings"] if "points" in one
    ]
    assert [text in one for one in found] == [True] * (text is not None)


def test_freedoms_are_counted_once_for_a_start():
    """That took seven milliseconds of each short run; a run from another start, or with other numbers, counts again."""
    linkage = converging()
    first = jn.simulate_mechanism(linkage, 0.1, output_step=0.05)
    freedoms = linkage.freedoms(linkage.model())
    assert linkage.freedoms(linkage.model()) is freedoms
    given = (
        np.zeros(len(linkage.model().states)),
        np.zeros(0),
        np.array(list(linkage.values.values())),
    )
    given[0][: len(linkage.model().start)] = linkage.model().start
    assert freedoms.at(*given) is freedoms.at(*given)
    other = jn.simulate_mechanism(
        linkage, 0.1, output_step=0.05, values={"rod 0.at[2]": 0.26, "rod 2.at[2]": 0.26}
    )
    assert other.attrs["degrees_of_freedom"] == first.attrs["degrees_of_freedom"] == 1
    assert other.attrs["findings"] != first.attrs["findings"]
