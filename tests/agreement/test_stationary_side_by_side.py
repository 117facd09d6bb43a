"""Stationary responses of many rigs side by side agree with a readable twin that takes one at a time."""

from __future__ import annotations

import numpy as np
import pytest
from stationary_twin import Table, band_variance, slope, white_variance

import jounce as jn
from jounce.core.errors import SimulationError
from jounce.ride import covariance, family
from jounce.ride.covariance import RandomVibration, Signal
from jounce.ride.family import Families, LinearFamily, Matrices
from jounce.ride.surface import Surface, surface
from jounce.simulation.statics import find_equilibrium

SHARES = np.array([1.0, 0.83, 1.21])[:, None]
QUARTER = (
    "audi-a6-quarter-car",
    ("strut.damper.coefficient", "sprung.mass"),
    ("sprung.az", "strut.deflection"),
)
HALF = (
    "audi-a6-half-car-4dof",
    ("front.distance", "front.damping_coefficient"),
    ("body.az", "body.pitch"),
)
FULL = ("audi-a6-full-car", ("front.distance", "front.track"), ("body.az", "body.pitch"))
ROLLING = (*FULL[:2], ("body.az", "body.roll", "rear_left.tyre.force"))
BAND = {"band": (0.05, 0.5)}
CASES = {
    "quarter car, white noise": (QUARTER, {}),
    "quarter car, band": (QUARTER, BAND),
    "half car, white noise": (HALF, {}),
    "half car, band": (HALF, BAND),
    "full car, one noise": (FULL, {"sides": "same"}),
    "full car, coherent sides": (ROLLING, BAND),
}


def _weighted(frequency: np.ndarray) -> np.ndarray:
    return 1.0 / (1.0 + (frequency / 6.0) ** 2)


def _noises(member: LinearFamily, road: Surface) -> list[list[int]]:
    sides = [place.side for place in member.places]
    if road.sides == "same":
        return [list(range(len(sides)))]
    return [
        [i for i, side in enumerate(sides) if side == chosen]
        for chosen in sorted(set(sides), reverse=True)
    ]


def _table(model: Matrices, geometry: np.ndarray, speed: float) -> Table:
    parts = {
        "A": model.A,
        "B0": model.B[0],
        "B1": model.B[1],
        "C": model.C,
        "D0": model.D[0],
        "D1": model.D[1],
    }
    return {**parts, "delays": geometry[:-1] / speed, "track": geometry[-1]}


@pytest.mark.parametrize("way", ["eigenvectors", "without eigenvectors"])
@pytest.mark.parametrize("case", CASES)
def test_variances_and_slopes_of_three_rigs(case, way, monkeypatch) -> None:
    (name, paths, channels), options = CASES[case]
    rig, road = jn.load(name), surface("C", 20.0, **options)
    families = Families(tuple(LinearFamily(rig, paths) for _ in SHARES))
    signals = [Signal(families.first.compiled.output_names.index(channel)) for channel in channels]
    gain = _weighted if options.get("band") and name == QUARTER[0] else None
    signals[0] = Signal(signals[0].output, gain)
    if way != "eigenvectors":
        monkeypatch.setattr(family, "_DEPENDENT", 0.0)
    nodes = []
    whole = covariance.frequencies
    monkeypatch.setattr(
        covariance, "frequencies", lambda *given: nodes.append(whole(*given)) or nodes[-1]
    )
    values = families.start * SHARES
    found = RandomVibration(families, road, tuple(signals)).at(values)
    assert found.absent == {}
    rows = [signal.output for signal in signals]
    for k, member in enumerate(families.members[: 2 if way == "eigenvectors" else 1]):
        model, along = member.at(values[k])
        noises, (width, moved) = (
            _noises(member, road),
            (member.geometry_at(values[k]), member.geometry[1]),
        )

        def variance(table: Table, k: int = k, noises: list[list[int]] = noises) -> np.ndarray:
            if road.band is None:
                return road.intensity * white_variance(table, noises)
            frequency, weights = nodes[0][0][k], nodes[0][1][k]
            gains = np.ones((len(rows), len(frequency)))
            gains[0] = 1.0 if gain is None else gain(frequency) ** 2
            n = frequency / road.speed
            shared = road.root_coherence(n, float(table["track"])) if len(noises) == 2 else None
            return band_variance(
                table, noises, frequency, weights * road.heights(n) / road.speed, gains, shared
            )

        table = _table(model.of_rows(rows), width, road.speed)
        exact = variance(table)
        assert found.variances[k] == pytest.approx(exact, rel=1e-10, abs=1e-10 * exact[0])
        for i, path in enumerate(paths):
            change = _table(along[i].of_rows(rows), moved[i], road.speed)
            steep = slope(variance, table, change, abs(values[k, i]))
            near = (
                1e-8 if path != "front.track" else 1e-6
            )  # the slope of a coherence is a difference of its own
            room = near * np.abs(exact / values[k, i])
            assert np.all(
                np.abs(found.variance_slopes[k, i] - steep) <= near * np.abs(steep) + room
            ), path


@pytest.mark.parametrize(
    ("name", "paths"), [QUARTER[:2], FULL[:2], ("kart-quarter-car", ("strut.damper.coefficient",))]
)
def test_linear_models_side_by_side(name, paths) -> None:
    """Matrices are those of the native code about each rig's own equilibrium, slopes those of differences."""
    rig = jn.load(name)
    families = Families(tuple(LinearFamily(rig, paths) for _ in SHARES))
    values = families.start * SHARES
    found = families.at(values)
    compiled = families.first.compiled
    for k, given in enumerate(values):
        p = compiled.parameter_values(
            {**rig.parameters(), **dict(zip(paths, given.tolist(), strict=True))}
        )
        one, along = families._by_differences(p, slopes=True)
        for part in family.PARTS:
            exact, steep = getattr(one, part), getattr(along, part)
            size = np.max(np.abs(exact), initial=1e-9)
            assert getattr(found.model, part)[k] == pytest.approx(
                exact, rel=1e-10, abs=1e-12 * size
            ), part
            for i, value in enumerate(given):
                room = 1e-8 * size / abs(value)
                assert getattr(found.along, part)[k, i] == pytest.approx(
                    steep[i], rel=1e-7, abs=room
                ), (part, i)


def test_slopes_of_a_mechanism_whose_best_free_speeds_change_from_pose_to_pose() -> None:
    """Models on both sides are compared in the same states, whichever would be the best ones there."""
    rig, path = jn.load("kart-double-wishbone"), "hardpoints.lower_ball_joint[1]"
    compiled, value = LinearFamily(rig).compiled, rig.parameters()[path]
    numbers = [
        compiled.parameter_values({**rig.parameters(), path: (1.0 + k * 1e-3) * value})
        for k in (-2, 2)
    ]
    assert (
        len({tuple(find_equilibrium(compiled, p, compiled.inputs(0.0)).free) for p in numbers}) == 2
    )
    slopes = jn.stationary(rig, "C", 20.0, parameters=[path]).slopes[path]
    behind, ahead = (
        jn.stationary(rig.with_changes({path: (1.0 + k * 1e-4) * value}), "C", 20.0)
        for k in (-1, 1)
    )
    for channel in ("sprung.az", "tyre.force"):
        assert slopes[channel] == pytest.approx(
            (ahead[channel] - behind[channel]) / (2e-4 * value), rel=1e-6
        ), channel


def test_rigs_that_differ_are_taken_one_by_one(monkeypatch) -> None:
    """Wheels that follow each other otherwise, or motions that nothing holds, in some of the rigs: nothing is mixed."""
    (name, paths, _), road = HALF, surface("C", 20.0)
    rig = jn.load(name)
    families = Families(tuple(LinearFamily(rig, paths) for _ in SHARES))
    chosen = (Signal(families.first.compiled.output_names.index("body.az")),)
    together = RandomVibration(families, road, chosen).at(families.start * SHARES)
    monkeypatch.setattr(covariance, "sources_of", _only_for_one(covariance.sources_of))
    alone = RandomVibration(families, road, chosen).at(families.start * SHARES)
    monkeypatch.undo()
    monkeypatch.setattr(covariance, "has_neutral", lambda _: True)
    reduced = RandomVibration(families, road, chosen).at(families.start * SHARES)
    for other in (alone, reduced):
        assert other.variances == pytest.approx(together.variances, rel=1e-12)
        assert other.variance_slopes == pytest.approx(together.variance_slopes, rel=1e-10)


def _only_for_one(read):
    return lambda delays, sides, *, same: (
        read(delays, sides, same=same) if len(delays) == 1 else None
    )


def test_one_rig_that_nothing_holds_is_named() -> None:
    rig = jn.load("kart-quarter-car")
    families = Families(tuple(LinearFamily(rig, ("tyre.stiffness",)) for _ in SHARES))
    with pytest.raises(SimulationError, match="no static equilibrium"):
        families.at(families.start * np.array([1.0, 0.0, 1.0])[:, None])
