"""The parts of an update that need no simulation: what is told apart, starts that end elsewhere, bounds, priors."""

from __future__ import annotations

import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.core.segments import CIRCLE, Segments
from jounce.identify import update
from jounce.identify.datum import QuietStart, _quiet_start, start_findings
from jounce.identify.extended_rig import ONSET_VELOCITY, ExtendedRig, RideExtent, own_doubt
from jounce.identify.fit_problem import FreeParameter, _weight, check_free, free_parameters
from jounce.identify.search import Optimum, SearchOutcome
from jounce.identify.update import UpdatedParameter, bounds_and_priors, identifiability
from jounce.simulation.compiled import compile_rig

RIG = jn.load("kart-quarter-car")
RATE, MASS = "strut.spring.rate", "sprung.mass"


def test_what_the_data_cannot_tell_apart() -> None:
    base = np.linalg.qr(np.random.default_rng(3).normal(size=(60, 3)))[0]
    for likeness, told in ((0.979, 0), (0.981, 1)):
        alike = likeness * base[:, 0] + np.sqrt(1.0 - likeness**2) * base[:, 1]
        found = identifiability(
            np.column_stack((base[:, 0], 3.0 * alike, 2.0 * base[:, 2])), ("a", "b", "c")
        )
        assert [finding.place for finding in found.findings] == ["b"] * told
        assert found.correlation[1][0] == pytest.approx(-likeness, rel=1e-9)
        assert found.correlation[2][0] == pytest.approx(0.0, abs=1e-9)
        assert found.sensitivity == pytest.approx(np.array([1.0, 3.0, 2.0]) / np.sqrt(60.0))
        assert found.rank == 3
        assert found.condition == pytest.approx(
            np.linalg.cond(np.column_stack((base[:, 0], 3.0 * alike, 2.0 * base[:, 2])))
        )
    silent = identifiability(np.column_stack((base[:, 0], np.zeros(60))), ("a", "b"))
    assert (silent.rank, silent.condition) == (1, float("inf"))
    assert [(finding.place, finding.value) for finding in silent.findings] == [("b", 0.0)]
    assert identifiability(np.zeros((60, 2)), ("a", "b")).rank == 0
    for size, rank in ((1.05e-6, 2), (0.95e-6, 1)):  # of the largest
        weak = identifiability(base[:, :2] * (1.0, size), ("a", "b"))
        assert (weak.rank, [finding.place for finding in weak.findings]) == (
            rank,
            ["b"] * (2 - rank),
        )


def test_strong_correlations_and_masses_that_move_far_are_told_from_their_limits_on() -> None:
    for value, told in ((0.89, 0), (-0.89, 0), (0.91, 1), (-0.91, 1)):
        found = update._correlated_pairs(("a", "b"), np.array([[1.0, value], [value, 1.0]]))
        assert [(finding.place, finding.value) for finding in found] == [("b", value)] * told
    weighed = SimpleNamespace(is_estimated=lambda path: path.startswith("guessed"))
    for share, told in ((1.049, 0), (0.951, 0), (1.051, 1), (0.949, 1)):
        for path, initial, is_told in (
            (MASS, 16.0, told),
            ("guessed.mass", 16.0, 0),
            (RATE, 16.0, 0),
            (MASS, 0.0, 0),
        ):
            moved = UpdatedParameter(
                **dict.fromkeys(UpdatedParameter.__dataclass_fields__)
                | {"value": share * 16.0, "initial": initial}
            )
            found = update._far_masses(weighed, {path: moved})
            assert [finding.value for finding in found] == [pytest.approx(share - 1.0)] * is_told


def test_how_a_search_ended_is_told() -> None:
    def optimum(objective: float, place: float, converged: bool = True) -> Optimum:
        return Optimum(np.array([0.0, place]), objective, 1, 1, converged)

    assert update._stall("u", optimum(1.0, 0.0), 1.0) == []
    (finding,) = update._stall("u", optimum(0.5, 0.0, converged=False), 1.0)
    assert (finding.severity, finding.value) == ("warning", 0.5)
    assert update._stall("u", optimum(0.0, 0.0, converged=False), 0.0)[0].value == 0.0
    for objective in (1.0, 1.1):
        with pytest.raises(jn.FitError, match="u: the optimiser stalled at the start values"):
            update._stall("u", optimum(objective, 0.0, converged=False), 1.0)


def test_other_minima_are_told_and_how_near_they_come() -> None:
    rig = jn.load("kart-quarter-car")
    problem = SimpleNamespace(
        free=(
            FreeParameter(RATE, 22.7e3, 20e3, 26e3),
            FreeParameter("tyre.stiffness", 130e3, 120e3, 140e3),
        ),
        trials=[SimpleNamespace(source=SimpleNamespace(rig=rig))],
    )

    def optimum(objective: float, place: float) -> Optimum:
        return Optimum(np.array([0.0, place]), objective, 1, 1, converged=True)

    best = optimum(1.0, 0.2)
    assert update._other_minima("u", problem, SearchOutcome(best, (), 4, is_confirmed=True)) == []
    (finding,) = update._other_minima("u", problem, SearchOutcome(best, (), 8, is_confirmed=False))
    assert (finding.severity, "none of the 7 other start points" in finding.message) == (
        "warning",
        True,
    )
    for objective, severity, told in (
        (1.4, "warning", "only 1.4 times"),
        (1.6, "note", "1.6 times the residual"),
    ):
        (finding,) = update._other_minima(
            "u", problem, SearchOutcome(best, (optimum(objective, -0.5),), 4, is_confirmed=True)
        )
        assert finding.severity == severity
        assert "with tyre.stiffness 1.25e+05 N/m" in finding.message
        assert RATE not in finding.message
        assert told in finding.message


def test_start_values_that_differ_between_trials_are_told() -> None:
    free = (FreeParameter("a", 2.0, 1.0, 3.0), FreeParameter("b", 2.0, 1.0, 3.0))
    trials = [
        SimpleNamespace(factors=np.array(each)) for each in ((1.0, 1.0), (1.0, 1.5), (1.0, 0.75))
    ]
    (finding,) = update._common_factors(SimpleNamespace(free=free, trials=trials))
    assert (finding.place, finding.value) == ("b", 2.0)


def test_relative_and_absolute_bounds() -> None:
    rate = RIG.parameters()[RATE]
    for given, lower, upper in (
        ("10 %", 0.9 * rate, 1.1 * rate),
        (0.1, 0.9 * rate, 1.1 * rate),
        (["10 N/mm", "40 N/mm"], 1e4, 4e4),
        ([rate, "40 N/mm"], rate, 4e4),
    ):
        (found,) = free_parameters(RIG, {RATE: given}, where="u")
        assert (found.initial, found.lower, found.upper) == pytest.approx(
            (rate, lower, upper), rel=1e-12
        )
    (cold,) = free_parameters(
        RIG.with_changes({"strut.spring.preload": "-10 N"}), {"strut.spring.preload": "10 %"}
    )
    assert (cold.lower, cold.upper) == pytest.approx((-11.0, -9.0))


@pytest.mark.parametrize(
    ("free", "message"),
    [
        ({}, "u: no free parameter"),
        ({"strut.spring.rat": "10 %"}, "u: strut.spring.rat: .*Did you mean 'strut.spring.rate'"),
        ({RATE: "0 %"}, "u: strut.spring.rate: the range must be above zero; found '0 %'"),
        ({RATE: -0.1}, "the range must be above zero"),
        ({RATE: ["1 N/mm"]}, "invalid pair of bounds"),
        ({RATE: 3 + 4j}, "invalid pair of bounds"),
        ({RATE: ["20 N/mm", "20 N/mm"]}, "the lower bound must be below the upper"),
        (
            {RATE: ["40 N/mm", "50 N/mm"]},
            "the bounds exclude the start value.*allowed: 40000 to 50000",
        ),
        ({RATE: ["1 N/mm", "2 N/mm"]}, "the bounds exclude the start value"),
        (
            {"strut.spring.preload": "10 %"},
            "strut.spring.preload: a relative range needs a nonzero start value",
        ),
    ],
)
def test_bounds_that_are_none(free: dict[str, object], message: str) -> None:
    with pytest.raises(jn.JounceError, match=message):
        free_parameters(RIG.with_changes({"strut.spring.preload": 0.0}), free, where="u")


def test_no_free_parameter_here_may_be_some_elsewhere() -> None:
    check_free(RIG, {}, more=1)
    check_free(RIG.with_changes({"strut.spring.preload": 0.0}), {"strut.spring.preload": "10 %"})
    with pytest.raises(jn.FitError, match="no free parameter"):
        check_free(RIG, {})


def test_bounds_with_a_prior() -> None:
    given = {"bounds": "10 %", "prior": ["22 N/mm", "300 N/m"]}
    assert bounds_and_priors(RIG, {RATE: given, MASS: "5 %"}, "u") == (
        {RATE: "10 %", MASS: "5 %"},
        {RATE: (pytest.approx(22e3), pytest.approx(300.0))},
    )
    assert bounds_and_priors(RIG, {"elsewhere": given}, "u") == ({"elsewhere": "10 %"}, {})
    for bad, message in (
        ({"bounds": "10 %"}, "invalid bounds for a parameter with a prior"),
        (given | {"more": 1}, "invalid bounds for a parameter with a prior"),
        (given | {"prior": ["22 N/mm"]}, "invalid bounds for a parameter with a prior"),
        (given | {"prior": 3.0}, "invalid bounds for a parameter with a prior"),
        (given | {"prior": ["22 N/mm", 0.0]}, "invalid standard deviation; found 0"),
    ):
        with pytest.raises(jn.FitError, match=f"u: {re.escape(RATE)}: {message}"):
            bounds_and_priors(RIG, {RATE: bad}, "u")


def test_weights_of_channels() -> None:
    values = np.array([1.0, 3.0, 1.0, 3.0])
    assert _weight("printed", "a", values) == 1.0
    assert _weight("normalised", "a", values) == pytest.approx(
        0.5
    )  # over the deviation, and over the root of four
    assert _weight({"a": 9.0}, "a", values) == 3.0
    assert _weight({"a": 9.0}, "b", values) == 0.0
    with pytest.raises(jn.FitError, match="a: the channel is constant and cannot be normalised"):
        _weight("normalised", "a", np.ones(4))
    with pytest.raises(jn.FitError, match="unknown weighting; found 'normal'"):
        _weight("normal", "a", values)


@pytest.mark.parametrize(
    ("recorded", "doubt", "static", "zero", "datum"),
    [
        (
            None,
            0.0,
            0.019,
            0.0,
            "undeformed",
        ),  # in motion: a static value of 2 % of the range does no harm
        (None, 0.0, 0.021, 0.0, "free offset"),
        (None, 0.01, 0.059, 0.0, "undeformed"),  # 4 standard errors of the quiet start beside
        (None, 0.01, 0.061, 0.0, "free offset"),
        (0.0119, 0.0, 0.01, 0.0, "undeformed"),  # hardly loaded: within 0.2 % of the range
        (0.0121, 0.0, 0.01, 0.0, "free offset"),
        (0.0519, 0.01, 0.01, 0.0, "undeformed"),
        (0.0521, 0.01, 0.01, 0.0, "free offset"),
        (0.119, 0.0, 1.0, 0.0, "rest"),  # loaded: within 2 % of the range and 10 % of the load
        (-0.119, 0.0, 1.0, 0.0, "rest"),
        (0.121, 0.0, 1.0, 0.0, "free offset"),
        (0.319, 0.0, 1.0, 0.2, "free offset"),
        (0.299, 0.0, 1.0, 0.2, "rest"),
        (0.631, 0.0, 1.0, 0.0, "undeformed"),  # a load may be off by 35 %
        (1.369, 0.0, 1.0, 0.0, "undeformed"),
        (0.629, 0.0, 1.0, 0.0, "free offset"),
    ],
)
def test_where_a_quiet_start_says_the_zero_lies(
    recorded: float | None, doubt: float, static: float, zero: float, datum: str
) -> None:
    start = QuietStart(recorded, doubt, static, zero, reach=1.0)
    assert start.datum() == datum
    assert start.matters(start.datum()) == (
        abs(static - zero) > 0.02 + 4.0 * doubt or datum != "undeformed"
    )
    assert not QuietStart(recorded, doubt, static, zero, 1.0, is_stated=True).matters("rest")


def test_what_quiet_starts_tell() -> None:
    rest = QuietStart(0.0, 0.0, 1.0, 0.0, 1.0, likeness=-0.59)
    turned = QuietStart(0.7, 0.0, 1.0, 0.0, 1.0, likeness=-0.61)
    free = QuietStart(0.4, 0.0, 1.0, 0.0, 1.0)
    starts = {f"trial {i}": {"a": rest, "b": turned} for i in range(4)} | {"last": {"c": free}}
    found = {
        (finding.place, finding.severity): finding.message for finding in start_findings(starts)
    }
    assert set(found) == {("b", "warning"), ("a", "note"), ("b", "note"), ("c", "warning")}
    assert (
        'datum "rest" taken from the start of trial 0, trial 1, trial 2, trial 3: zero at rest;'
        in found["a", "note"]
    )
    assert (
        "is inverted relative to the model in trial 0, trial 1, trial 2, trial 3 (correlation -0.61)"
        in found["b", "warning"]
    )
    assert "not zeroed at rest and does not share the zero of the model" in found["c", "warning"]
    many = start_findings({f"trial {i}": {"a": rest} for i in range(5)})
    assert "taken from the start of 5 trials:" in many[0].message


@pytest.mark.parametrize("track", ["waves", "pieces"])
def test_tracks_are_made_higher_and_later(track: str) -> None:
    time = np.linspace(0.01, 1.49, 30)
    given = jn.mechanics.interpolated([0.0, 0.5, 1.0, 1.5], [0.0, 1.0, -1.0, 2.0])
    if track == "waves":
        kind = jn.mechanics.harmonic(1.0, 1.0).kind[0]
        tables = np.random.default_rng(2).normal(size=(len(given.kind), 4)) * (1.0, 1.0, 7.0, 1.0)
        given = replace(given, kind=np.full(len(given.kind), kind), coefficients=tables)
    value, rate = given.evaluate(time)
    assert np.ptp(value) > 1.0
    for factor in (1.0, 1.3):
        higher = given.times(factor).evaluate(time)
        np.testing.assert_allclose(higher, (factor * value, factor * rate), rtol=1e-12, atol=1e-12)
    circle = Segments(np.array([0.0, 2.0]), np.array([CIRCLE]), np.array([[0.1, 1.5, 0.7, -1.0]]))
    np.testing.assert_allclose(
        circle.times(1.3).evaluate(time), 1.3 * np.array(circle.evaluate(time)), rtol=1e-12
    )
    later = given.stretch_to(2.0 + 1.6 * given.edges).evaluate(2.0 + 1.6 * time)
    np.testing.assert_allclose(later, (value, rate / 1.6), rtol=1e-9, atol=1e-9)


def test_doubts_are_shares_or_in_the_unit_of_what_is_doubted() -> None:
    mass = RIG.parameters()[MASS]
    assert own_doubt(RIG, MASS, "2 %", "doubt") == pytest.approx(0.02)
    assert own_doubt(RIG, MASS, 0.03, "doubt") == 0.03
    assert own_doubt(RIG, MASS, "400 g", "doubt") == pytest.approx(0.4 / mass)
    cold = RIG.with_changes({"strut.spring.preload": "-20 N"})
    assert own_doubt(cold, "strut.spring.preload", "5 N", "doubt") == pytest.approx(0.25)
    assert (
        own_doubt(
            RIG.with_changes({"strut.spring.preload": 0.0}), "strut.spring.preload", "5 N", "doubt"
        )
        == 0.0
    )
    with pytest.raises(
        jn.DescriptionError, match=r"doubt: sprung\.mass: a negative uncertainty; found '-2 %'"
    ):
        own_doubt(RIG, MASS, "-2 %", "doubt")
    with pytest.raises(jn.DescriptionError, match=r"doubt: sprung\.mas: unknown parameter"):
        own_doubt(RIG, "sprung.mas", "2 %", "doubt")


def test_a_doubted_curve_has_the_stiffness_of_the_rig_where_it_rests() -> None:
    used = compile_rig(RIG).facts.parameters
    rest = {"strut.spring": 0.007, "tyre": 0.0015}
    richer = ExtendedRig(
        RIG, [], jn.Doubt(), RideExtent(rest["strut.spring"], rest["tyre"], 1.0), used
    )
    p, xi = RIG.parameters(), np.linspace(-1.0, 1.5, len(richer.nuisances))
    for part, rate in (("strut.spring", p[RATE]), ("tyre", p["tyre.stiffness"])):
        x, h = rest[part], 1e-6
        force = richer.elastic_force(part, p, xi, np.array([x - h, x, x + h, 0.0]))
        assert force[3] == 0.0
        assert (force[2] - force[0]) / (2.0 * h) == pytest.approx(rate, rel=1e-6)
        places = richer._curved.get(part)
        if places is None:
            assert force[1] == pytest.approx(rate * x)
            continue
        bends = [richer.nuisances[i].mean + richer.nuisances[i].deviation * xi[i] for i in places]
        first, second = (
            rate * bends[0] / (2.0 * x),
            rate * bends[1] / (3.0 * x**2) if len(bends) > 1 else 0.0,
        )
        coefficients = richer.curve(part, p, xi, places)
        assert coefficients[1:] == pytest.approx([first, second][: len(bends)])
        assert force[1] == pytest.approx(sum(one * x**k for k, one in enumerate(coefficients, 1)))
    assert richer._curved


def test_the_quiet_start_is_what_lies_before_the_model_moves() -> None:
    time = np.arange(1000) * 1e-3
    simulated = -0.01 + 0.02 * np.where(time > 0.3, np.sin(40.0 * (time - 0.3)), 0.0)
    measured = np.where(
        time < 0.29, 0.003 + 1e-4 * (-1.0) ** np.arange(1000), simulated
    )  # it may be early by 20 ms
    start = _quiet_start(SimpleNamespace(measured=measured, bias=0.5), time, simulated, -0.01)
    assert start.recorded == pytest.approx(0.003, abs=1e-6)
    assert (start.static, start.zero, start.reach) == (-0.01, 0.5, pytest.approx(np.ptp(measured)))
    assert start.doubt == pytest.approx(1e-4 / np.sqrt(281.0), rel=0.02)
    early = _quiet_start(
        SimpleNamespace(measured=measured[295:], bias=0.0), time[295:], simulated[295:], -0.01
    )
    assert early.recorded == pytest.approx(-0.01)  # less than 20 ms: all that there is
    moving = _quiet_start(
        SimpleNamespace(measured=measured[400:], bias=0.0), time[400:], simulated[400:], -0.01
    )
    assert (moving.recorded, moving.doubt) == (None, 0.0)


def test_what_is_doubted_is_as_the_doubts_say() -> None:
    """Each doubt of a lumped rig with its group, mean and standard deviation, and what of it the numbers become."""
    p = RIG.parameters()
    used = compile_rig(RIG).facts.parameters
    richer = ExtendedRig(RIG, [RATE], jn.Doubt(), RideExtent(0.007, 0.0015, 1.0), used)
    load = p[MASS] * p["gravity"]
    knots = np.array([0.03, 0.12, 0.35, 1.0])
    coefficient = p["strut.damper.coefficient"]
    expected = {MASS: ("lumped", 0.0, 0.02), "unsprung.mass": ("estimated", 0.0, 0.03)}
    expected |= {f"damper force at {side * v:+.2g} m/s": ("damper_shape", 0.0, 0.2 * coefficient * v + 2.0)
                 for v in knots for side in (1.0, -1.0)}  # fmt: skip
    for place in ("strut.friction", "guide.friction"):
        expected[f"{place}.force"] = ("friction", 0.0, 0.02 * load)
        expected[f"{place}.regularisation_velocity"] = ("friction_onset", 0.0, np.log(2.0))
    expected |= {
        "strut.spring curvature": ("spring_curvature", 0.0, 0.03),
        "tyre curvature": ("tyre_curvature", 0.01, 0.02),
        "tyre change of curvature": ("tyre_curvature", 0.0, 0.002),
    }
    if "strut.angle" in used:
        expected["strut.angle"] = ("angle", 0.0, 0.0087)
    assert {
        one.name: (one.group, one.mean, pytest.approx(one.deviation)) for one in richer.nuisances
    } == expected
    rubbing = RIG.with_changes({"guide.friction": {"force": 6.0}})
    paths = compile_rig(rubbing).facts.parameters
    guided = ExtendedRig(
        rubbing, ["guide.friction.force"], jn.Doubt(), RideExtent(0.007, 0.0015, 1.0), paths
    )
    place = "guide.friction.presliding"
    assert {
        one.name: (one.unit, one.mean, one.deviation)
        for one in guided.nuisances
        if place in one.name
    } == {
        place: ("1", 0.5, 0.3),
        f"{place}_distance": ("ln", 0.0, pytest.approx(np.log(2.0))),
    }
    assert guided.numbers(rubbing.parameters(), {}, np.zeros(len(guided.nuisances)))[place] == 0.5
    xi = np.zeros(len(richer.nuisances))
    names = [one.name for one in richer.nuisances]
    for name, became in (
        (MASS, p[MASS] * 1.06),
        ("strut.friction.force", 0.06 * load),
        ("guide.friction.regularisation_velocity", 8.0 * ONSET_VELOCITY),
    ):
        moved = xi.copy()
        moved[names.index(name)] = 3.0
        assert richer.plain(p, {}, moved)[name] == pytest.approx(became)
    places, root = richer.damper_covariance_root()
    moving = np.concatenate([-knots[::-1], knots])
    scale = 0.2 * coefficient * np.abs(moving) + 2.0
    assert np.sqrt(np.diag(root @ root.T)) == pytest.approx(scale, rel=1e-6)
    apart = np.sqrt(3.0) * np.abs(
        np.arcsinh(moving[3] / 0.1) - np.arcsinh(moving[5] / 0.1)
    )  # Matern 3/2
    assert (root @ root.T)[3, 5] == pytest.approx(
        (1.0 + apart) * np.exp(-apart) * scale[3] * scale[5]
    )
    moved = xi.copy()
    moved[list(places)] = np.linalg.solve(root, np.arange(1.0, 9.0))
    force = richer.damper_force(p, moved, np.concatenate([moving, [0.0, 2.0, -2.0]]))
    beyond = 8.0 + 1.0 / 0.65, 1.0 - 1.0 / 0.65  # straight on
    bends = np.array([*np.arange(1.0, 9.0), 0.0, beyond[0], beyond[1]])
    assert force == pytest.approx(coefficient * np.concatenate([moving, [0.0, 2.0, -2.0]]) + bends)
