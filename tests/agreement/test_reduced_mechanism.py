"""A corner run by its one internal coordinate is the corner run as a mechanism.

The two form their equations in different ways: the mechanism with all coordinates, loops and their forces, projected
after every step; the reduced corner from masses and levers that were sampled over travel. The mechanism is run at a
tolerance a thousand times tighter.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.kernel.poses import Walk, space_for, walk_poses
from jounce.simulation import reduced as module
from jounce.simulation.reduced import DEGREES, reduction_of
from jounce.variants import many as many_runs

pytestmark = pytest.mark.usefixtures("optimised")

KART = jn.load("kart-double-wishbone")
BESIDE_STRUT = {  # torsion bar, third spring and damper, Z-bar: both wheels move alike
    "torsion_bar": {"stiffness": 60.0, "preload": 3.0, "on": "lower_arm"},
    "third_spring": {
        "spring": {"rate": 2e3, "preload": 10.0},
        "damper": {"coefficient": 40.0},
        "on": "lower_arm",
    },
    "anti_roll_bar": {"stiffness": 8.0, "on": "lower_arm", "kind": "z"},
    "hardpoints.third_spring_end": [0.0, 0.12, 0.125],
    "hardpoints.arb_pivot": [-0.1, 0.1, 0.12],
    "hardpoints.arb_arm_end": [-0.02, 0.12, 0.12],
    "hardpoints.arb_link_end": [0.0, 0.2, 0.06],
}
ALL_AT_ONCE = {
    **BESIDE_STRUT,
    "tyre.law": "radial",
    "tyre.damping_coefficient": 20.0,
    "steering.rack_travel": "4 mm",
    "strut.bump_stop": {"gap": "6 mm", "rate": "50 N/mm", "progression": 1e8},
    "strut.rebound_stop": {"gap": "8 mm", "rate": "50 N/mm"},
    "strut.friction": {"force": 8.0, "regularisation_velocity": 0.01},
    "guide_friction": {"force": 4.0, "regularisation_velocity": 0.01},
}
TOLERANCE = 1e-5
SEED = 20261123


def bump(height: float = 0.012, speed: float = 2.0, duration: float = 0.6) -> jn.Trial:
    return jn.Trial(
        road=jn.HalfSine(height=height, length=0.06, start=0.1), speed=speed, duration=duration
    )


def errors(reduced, full) -> dict[str, float]:
    """Largest difference of every channel over the range it sweeps, where it moves at all."""
    assert list(reduced) == list(full)
    ranges = {name: float(np.ptp(full[name].values)) for name in full}
    return {
        name: float(np.max(np.abs(reduced[name].values - full[name].values))) / size
        for name, size in ranges.items()
        if size > 1e-9
    }


def compare(rig: jn.Rig, trial: jn.Trial) -> tuple[bool, float]:
    """Whether a run is reduced, and how far body and wheel are off, as shares of the tolerance."""
    reduced = jn.simulate(rig, trial, tolerance=TOLERANCE)
    if not reduced.attrs["method"].startswith("reduced"):
        return False, 0.0
    full = jn.simulate(rig, trial, tolerance=1e-3 * TOLERANCE, method="explicit")
    found = errors(reduced, full)
    assert {"reduced explicit", "reduced implicit"} & {reduced.attrs["method"]}
    return True, max(
        found[name] for name in ("sprung.z", "unsprung.z") if name in found
    ) / TOLERANCE


def random_case(
    random: np.random.Generator, rig: jn.Rig, *, alike: bool = False
) -> tuple[jn.Rig, jn.Trial]:
    """Other hardpoints, masses and rates, with or without stops and lift-off, over an obstacle or a rough road.

    Those that are ``alike`` all have stops and may lift off, so that one model is compiled for them.
    """
    numbers = rig.parameters()
    changes: dict[str, object] = {}
    for path, value in numbers.items():
        if path.startswith("hardpoints.") and not path.startswith(
            ("hardpoints.wheel", "hardpoints.contact")
        ):
            changes[path] = value + 0.004 * random.uniform(-1.0, 1.0)
        elif path.endswith(".mass") or path in ("strut.spring.rate", "tyre.stiffness"):
            changes[path] = value * random.uniform(0.85, 1.15)
    changes["tyre.lift_off"] = bool(random.random() < 0.7) or alike
    if random.random() < 0.5 or alike:
        gap, rate = random.uniform(0.002, 0.02, 2), 5.0 * numbers.get("strut.spring.rate", 3e4)
        changes["strut.bump_stop"] = {"gap": float(gap[0]), "rate": rate, "progression": 1e7}
        changes["strut.rebound_stop"] = {"gap": float(gap[1]), "rate": rate}
    size = max(numbers.get("tyre.undeformed_radius", 0.25), 0.12) / 0.3
    if random.random() < 0.7:
        height, length = size * random.uniform(0.005, 0.05), size * random.uniform(0.1, 1.0)
        road = jn.HalfSine(height=height, length=length, start=0.1)
        return rig.with_changes(changes), jn.Trial(
            road=road, speed=random.uniform(1.0, 12.0), duration=0.8
        )
    road = jn.Iso8608(
        **{"class": str(random.choice(list("ABCD")))},
        length="30 m",
        seed=int(random.integers(1000)),
    )
    return rig.with_changes(changes), jn.Trial(
        road=road, speed=random.uniform(4.0, 20.0), duration=0.8
    )


def test_random_corners_agree_within_the_tolerance():
    random = np.random.default_rng(SEED)
    found = [compare(*random_case(random, KART, alike=True)) for _ in range(15)]
    assert sum(reduced for reduced, _ in found) >= 12
    assert max(share for _, share in found) < 1.0


@pytest.mark.slow
def test_five_hundred_random_corners_agree_within_the_tolerance():
    """Every shipped suspension; cases that cannot stand, or leave the road, are no cases."""
    random = np.random.default_rng(SEED)
    names = [
        "kart-double-wishbone",
        "reference-double-wishbone",
        "generic-mcpherson",
        "sedan-multi-link",
        "semi-trailing-arm",
        "formula-student-front",
        "suv-front",
        "audi-double-wishbone",
    ]
    rigs, found = [jn.load(name) for name in names], []
    while len(found) < 500:
        rig, trial = random_case(random, rigs[len(found) % len(rigs)])
        try:
            found.append(compare(rig, trial))
        except jn.JounceError:
            continue
    assert sum(reduced for reduced, _ in found) >= 400
    assert max(share for _, share in found) < 1.0


@pytest.fixture(scope="module")
def everything():
    return KART.with_changes(ALL_AT_ONCE)


def test_every_force_and_every_channel_is_that_of_the_mechanism(everything):
    trial = bump()
    reduced = jn.simulate(everything, trial, tolerance=1e-6)
    full = jn.simulate(everything, trial, tolerance=1e-9, method="explicit")
    assert reduced.attrs["method"].startswith("reduced")
    assert full.attrs["method"] == "explicit"
    assert reduced.attrs["events"] >= 10
    assert {"third_spring.force", "torsion_bar.torque", "anti_roll_bar.torque"} <= set(reduced)
    assert {name: reduced[name].attrs for name in reduced} == {
        name: full[name].attrs for name in full
    }
    found = errors(reduced, full)
    assert len(found) == len(full.data_vars)  # everything moves
    assert (
        max(found[name] for name in ("sprung.z", "unsprung.z", "strut.deflection", "wheel.steer"))
        < 1e-6
    )
    assert max(found.values()) < 1e-4  # accelerations and forces, with steep friction


def test_a_body_that_is_held_leaves_one_coordinate():
    held = KART.with_changes({"guide": "fixed", "sprung": None})
    reduced, full = (
        jn.simulate(held, bump(), method=method, tolerance=1e-7) for method in ("auto", "explicit")
    )
    assert reduced.attrs["method"] == "reduced explicit"
    assert "sprung.z" not in reduced
    assert max(errors(reduced, full).values()) < 1e-5


def test_the_bound_of_a_table_holds_between_its_points():
    """Lengths and masses at other poses than those sampled differ by less than the bound says."""
    reduction = reduction_of(KART)
    assert reduction is not None
    values = KART.parameters()
    p = np.array([values[path] for path in reduction.parameters])
    others = np.sort(np.random.default_rng(SEED).uniform(-0.04, 0.04, 23))
    targets = np.array([[travel, 0.0] for travel in others])
    address, start = reduction.native.address, reduction.start
    before = np.full(len(others), -1, dtype=np.int64)
    walk = Walk(address["pose"], address["output"], p, start, np.zeros(2), targets, before)
    exact, work = space_for(walk, len(reduction.names))
    walk_poses(walk, exact, work)
    bounds = []
    for degree in DEGREES:
        table = reduction.table(p, 0.0, -0.04, 0.04, degree)
        rows = table.numbers[3:].reshape(len(reduction.names) - 1, degree + 1)
        x = (others - table.numbers[0]) / table.numbers[1]
        for name, row, wanted in zip(reduction.names[1:], rows, exact.outputs[1:], strict=True):
            size = (
                np.ptp(wanted) if "." in name else np.abs(row[0])
            )  # a length or an angle, or a mass
            bound = table.error * (
                100.0 if name.startswith("wheel.") else 1.0
            )  # what nothing feels may be less exact
            assert np.max(np.abs(np.polyval(row[::-1], x) - wanted)) <= bound * size + 1e-15
        bounds.append(table.error)
    assert bounds[1] < bounds[0] < 1e-8
    assert reduction.table(p, 0.0, -0.06, 0.06, DEGREES[0]).error > 10.0 * bounds[0]
    assert (
        reduction.table(p, 0.0, -0.3, 0.3, DEGREES[0]) is None
    )  # no wheel of a kart travels that far


def test_a_wheel_that_travels_far_gets_a_wider_table_or_the_mechanism():
    soft = KART.with_changes(
        {"strut.spring.rate": 4e3, "strut.spring.preload": None, "strut.damper.coefficient": 20.0}
    )
    trial = bump(height=0.03, speed=3.0)
    run = jn.simulate(soft, trial)
    full = jn.simulate(soft, trial, method="explicit", tolerance=1e-8)
    travel = (full["unsprung.z"] - full["sprung.z"]).values
    assert np.ptp(travel) > 0.03
    assert max(errors(run, full)[name] for name in ("sprung.z", "unsprung.z")) < 1e-5


@pytest.mark.parametrize(
    "options",
    [
        {"method": "explicit"},
        {"detail": True},
        {"offset": {"sprung.distance": 0.001}},
        {"tolerance": 1e-12},
    ],
    ids=["asked for", "detail", "from an offset", "tight tolerance"],
)
def test_the_mechanism_runs_where_one_coordinate_does_not_do(options):
    run = jn.simulate(KART, bump(duration=0.05), **options)
    assert run.attrs["method"] == "explicit"


def test_a_wheel_that_leaves_the_table_between_samples_is_run_by_the_mechanism():
    """It travels 140 mm, and is at rest again when the next sample is taken."""
    stiff, trial = (
        KART.with_changes({"strut.damper.coefficient": 300.0}),
        bump(height=0.1, speed=4.0, duration=2.0),
    )
    fine, coarse = (jn.simulate(stiff, trial, output_step=step) for step in (1e-3, 1.0))
    assert np.ptp((fine["unsprung.z"] - fine["sprung.z"]).values) > 0.13
    assert np.ptp((coarse["unsprung.z"] - coarse["sprung.z"]).values) < 0.01
    assert fine.attrs["method"] == coarse.attrs["method"] == "explicit"


def test_what_no_road_allows_is_said_by_the_mechanism():
    with pytest.raises(jn.JounceError, match="equilibrium"):
        jn.simulate(KART.with_changes({"strut.spring.rate": 1.0}), bump())


# many variants --------------------------------------------------------------------------------------------------------


def spread(random: np.random.Generator, count: int) -> dict[str, np.ndarray]:
    """Hardpoints, a mass and rates of a kart on stops."""
    numbers = STOPPED.parameters()
    ball = numbers["hardpoints.upper_ball_joint[2]"]
    return {
        "hardpoints.upper_ball_joint[2]": ball + random.uniform(-0.003, 0.003, count),
        "bodies.upright.mass": numbers["bodies.upright.mass"] * random.uniform(0.9, 1.1, count),
        "strut.spring.rate": numbers["strut.spring.rate"] * random.uniform(0.9, 1.1, count),
        "strut.bump_stop.gap": random.uniform(0.004, 0.02, count),
    }


STOPPED = KART.with_changes(
    {"strut.bump_stop": {"gap": "6 mm", "rate": "50 N/mm", "progression": 1e8}}
)
RANGE = 0.0199  # m, which half of their wheels leave
WORDS = ("rms sprung.az", "max tyre.force", "range strut.deflection", "min wheel.camber")


def test_variants_step_side_by_side_as_they_run_alone():
    """Nineteen, so that a block is not full; events of all of them fall into each other's steps."""
    changes, trial = spread(np.random.default_rng(SEED), 19), bump(duration=2.5)
    words = (*WORDS, "Wk sprung.az")
    many = jn.simulate_many(STOPPED, trial, changes, metrics=words, outputs="sprung.z")
    assert many.attrs["side_by_side"] == 19
    assert not any(many["reason"].values)
    for i in (0, 7, 18):
        rig = STOPPED.with_changes({path: float(values[i]) for path, values in changes.items()})
        one = jn.simulate_many(
            rig, trial, {"sprung.mass": [rig.parameters()["sprung.mass"]]}, metrics=words
        )
        assert one.attrs["side_by_side"] == 0
        for word in words:
            assert float(many[word][i]) == pytest.approx(float(one[word][0]), rel=1e-6)
        full = jn.simulate(rig, trial, method="explicit", tolerance=1e-8)["sprung.z"].values
        assert np.max(np.abs(many["sprung.z"].values[i] - full)) < 1e-5 * np.ptp(full)


def test_variants_whose_wheels_leave_their_tables_go_on_side_by_side_over_wider_ones(monkeypatch):
    changes, trial = spread(np.random.default_rng(SEED), 40), bump()
    usual = jn.simulate_many(STOPPED, trial, changes, metrics=WORDS, outputs="sprung.z")
    held, real = [], many_runs._TrialGroup._step_through

    def step_through(*arguments):
        found = real(*arguments)
        held.append(int(found.held.sum()))
        return found

    monkeypatch.setattr(many_runs._TrialGroup, "_step_through", step_through)
    monkeypatch.setattr(module, "first_range", lambda _: RANGE)
    many = jn.simulate_many(STOPPED, trial, changes, metrics=WORDS, outputs="sprung.z")
    assert len(held) == 2
    assert 0 < held[0] <= 24  # whose wheels travel less; the others are 16 or more
    assert sum(held) == many.attrs["side_by_side"] == 40
    assert not any(many["reason"].values)
    for word in WORDS:
        assert many[word].values == pytest.approx(usual[word].values, rel=1e-6)
    rig = STOPPED.with_changes({path: float(values[3]) for path, values in changes.items()})
    full = jn.simulate(rig, trial, method="explicit", tolerance=1e-8)["sprung.z"].values
    assert np.max(np.abs(many["sprung.z"].values[3] - full)) < 1e-5 * np.ptp(full)


def test_neither_threads_nor_variants_that_fail_change_the_others():
    changes, trial = spread(np.random.default_rng(SEED + 1), 24), bump(duration=0.3)
    sound = jn.simulate_many(STOPPED, trial, changes, metrics=WORDS[:3], threads=1)
    assert sound.identical(jn.simulate_many(STOPPED, trial, changes, metrics=WORDS[:3], threads=2))
    changes["strut.spring.rate"][3] = 1.0  # stands on its stop
    changes["strut.spring.rate"][5] = 4e6  # too fast for the steps of the others
    changes["hardpoints.upper_ball_joint[2]"][12] += 0.05  # locks up in bump
    others = jn.simulate_many(STOPPED, trial, changes, metrics=WORDS[:3])
    assert others.attrs["side_by_side"] < 24
    kept = [i for i in range(24) if i not in (3, 5, 12)]
    for word in WORDS[:3]:
        assert others[word].values[kept] == pytest.approx(sound[word].values[kept], rel=1e-6)
    for i in (3, 5, 12):  # as it runs, or says why not, by itself
        alone = {path: values[i : i + 1] for path, values in changes.items()}
        one = jn.simulate_many(STOPPED, trial, alone, metrics=WORDS[:3])
        assert str(one["reason"].values[0]) == str(others["reason"].values[i])
        assert others[WORDS[0]].values[i] == pytest.approx(
            one[WORDS[0]].values[0], rel=1e-6, nan_ok=True
        )


def test_the_mechanism_runs_each_variant_where_it_is_asked_for():
    rates = {"strut.spring.rate": np.linspace(2e4, 2.4e4, 16)}
    given = (KART, bump(duration=0.1), rates)
    many = [
        jn.simulate_many(*given, metrics=WORDS[0], method=method) for method in ("auto", "explicit")
    ]
    assert [runs.attrs["side_by_side"] for runs in many] == [16, 0]
    assert many[0][WORDS[0]].values == pytest.approx(many[1][WORDS[0]].values, rel=1e-6)


def test_mechanisms_step_side_by_side_as_they_run_alone(monkeypatch):
    """Each lane is held on its own loops; what finds no rest or is too fast for the others runs by itself."""
    monkeypatch.setattr("jounce.variants.stepped.LEAST_WITH_LOOPS", 64)
    changes, trial = spread(np.random.default_rng(SEED + 2), 66), bump(duration=0.3)
    changes["strut.spring.rate"][3] = 1.0
    changes["strut.spring.rate"][5] = 4e6
    changes["hardpoints.upper_ball_joint[2]"][12] += 0.05
    many = jn.simulate_many(
        STOPPED, trial, changes, metrics=WORDS, outputs="sprung.z", method="explicit"
    )
    assert many.attrs["side_by_side"] == 64
    reduced = jn.simulate_many(STOPPED, trial, changes, metrics=WORDS)
    kept = [i for i in range(66) if i not in (3, 5, 12)]
    for word in WORDS:
        assert many[word].values[kept] == pytest.approx(reduced[word].values[kept], rel=1e-5)
    for i in (0, 3, 5, 12, 65):
        alone = {path: values[i : i + 1] for path, values in changes.items()}
        one = jn.simulate_many(
            STOPPED, trial, alone, metrics=WORDS, outputs="sprung.z", method="explicit"
        )
        assert one.attrs["side_by_side"] == 0
        assert str(one["reason"].values[0]) == str(many["reason"].values[i])
        for word in WORDS:
            assert many[word].values[i] == pytest.approx(one[word].values[0], rel=1e-6, nan_ok=True)
        assert many["sprung.z"].values[i] == pytest.approx(
            one["sprung.z"].values[0], abs=1e-9, nan_ok=True
        )


def test_one_lane_whose_wheel_flips_over_leaves_the_others_there(monkeypatch):
    monkeypatch.setattr("jounce.variants.stepped.LEAST_WITH_LOOPS", 64)
    dampers = np.full(64, 3000.0)
    dampers[10] = 100.0
    high = bump(height=0.15, speed=4.0, duration=0.1)
    many = jn.simulate_many(
        KART, high, {"strut.damper.coefficient": dampers}, metrics=WORDS[:2], method="explicit"
    )
    assert many.attrs["side_by_side"] == 63
    assert "flipped" in str(many["reason"].values[10])
    assert np.flatnonzero(many["reason"].values != "").tolist() == [10]
    assert np.ptp(np.delete(many[WORDS[1]].values, 10)) < 1e-6 * float(many[WORDS[1]].values[0])
