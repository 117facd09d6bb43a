"""A simulator without a line of jounce moves as jounce does where their laws are the same, and counts what updates say.

The count of 200 benches is made by hand: see ``foreign_counts.py``.
"""

import ast
import json
import sys
from pathlib import Path

import foreign_benches
import foreign_counts
import numpy as np
import pytest
from foreign_benches import Chain, Pass, Ride, Rig, Road

import jounce as jn

FRICTION = Rig(bump=120.0, rebound=200.0, guide=6.0, strut=4.0, onset=2e-3)


def as_described(rig):
    """The same rig in jounce's words."""
    return jn.load("kart-quarter-car").with_changes({
        "strut.spring.rate": rig.rate,
        "strut.damper": {"bump_coefficient": rig.bump, "rebound_coefficient": rig.rebound},
        "strut.friction": {"force": rig.strut, "regularisation_velocity": rig.onset},
        "guide.friction": {"force": rig.guide, "regularisation_velocity": rig.onset},
        "tyre.stiffness": rig.stiffness,
        "tyre.damping_coefficient": rig.tyre_damping,
    })  # fmt: skip


def test_the_simulator_imports_nothing_of_jounce():
    tree = ast.parse(Path(foreign_benches.__file__).read_text(encoding="utf-8"))
    imported = {
        name.split(".")[0]
        for node in ast.walk(tree)
        if isinstance(node, ast.Import | ast.ImportFrom)
        for name in (
            [node.module] if isinstance(node, ast.ImportFrom) else [one.name for one in node.names]
        )
    }
    assert "numpy" in imported
    assert imported - {"numpy"} <= sys.stdlib_module_names


@pytest.mark.parametrize("rig", [Rig(), FRICTION], ids=["linear", "friction"])
def test_equal_laws_move_equally(rig):
    passes = [Pass(Road(shape), 2.86) for shape in ("half-sine", "versine", "trapezoid")]
    passes.append(Pass(Road(count=3), 1.97))
    motions = foreign_benches.ridden([Ride(rig, one) for one in passes], duration=0.35)
    for one, motion in zip(passes, motions, strict=True):
        trial = jn.Trial(road=foreign_counts.road_of(one.road), speed=one.speed, duration=0.35)
        run = jn.simulate(as_described(rig), trial, tolerance=1e-8)
        rest = run.isel(time=0)
        pairs = [(run[name], motion.recorded[name]) for name in ("sprung.az", "unsprung.az")]
        zeroed = ("strut.deflection", "sprung.z")
        pairs += [(run[name] - rest[name], motion.recorded[name]) for name in zeroed]
        pairs += [(run["strut.force"], motion.strut_force), (run["tyre.force"], motion.tyre_force)]
        for theirs, ours in pairs:
            assert np.max(np.abs(theirs.to_numpy() - ours)) < 5e-4 * np.max(np.abs(ours)), (
                one,
                theirs.name,
            )


def test_sensors_and_delays_are_those_of_closed_forms():
    """A filter of first and one of second order at a corner: of a slow signal, its value before their delay at rest."""
    corner, late = 200.0, 3e-3
    delays = {1: 1.0 / (2.0 * np.pi * corner), 2: np.sqrt(2.0) / (2.0 * np.pi * corner)}
    driven = Pass(Road("versine", length=0.09), 1.95)
    rides = [Ride(Rig(), driven)]
    rides += [
        Ride(Rig(), driven, {"sprung.z": Chain(1.02, corner, order)}, {"sprung.z": late})
        for order in delays
    ]
    plain, *filtered = (
        motion.recorded["sprung.z"] for motion in foreign_benches.ridden(rides, duration=0.35)
    )
    at = np.arange(len(plain)) / foreign_benches.RATE
    for delay, record in zip(delays.values(), filtered, strict=True):
        expected = 1.02 * np.interp(at - late - delay, at, plain, left=0.0)
        assert np.max(np.abs(record - expected)) < 3e-3 * np.max(np.abs(plain))


def test_the_belt_loses_its_share_over_the_first_obstacles():
    driven = Pass(Road(), 2.0, slowing=0.02, over=0.06)
    time = np.linspace(0.0, 1.0, 100_001)
    x, v = foreign_benches.travelled(driven, time)
    assert np.max(np.abs(np.gradient(x, time) - v)) < 1e-4
    assert v[0] == 2.0
    assert v[-1] == pytest.approx(1.96, abs=1e-12)
    assert v[np.searchsorted(x, 0.26)] == pytest.approx(1.96, abs=1e-5)
    assert v[np.searchsorted(x, 0.20) - 1] == 2.0


def test_laws_have_the_tangents_and_loads_that_are_told():
    bent = Rig(growth=0.05, cube=2e8, knee=0.3, exponent=0.7)
    lanes = foreign_benches._Lanes([Ride(bent, Pass(Road(), 2.0))])
    near = 1e-7
    slope = (lanes.spring(lanes.sag + near) - lanes.spring(lanes.sag - near)) / (2.0 * near)
    assert slope == pytest.approx(bent.rate, rel=1e-6)
    assert lanes.cos * lanes.spring(lanes.sag) == pytest.approx(bent.sprung * 9.81, rel=1e-9)
    slope = (lanes.tyre(lanes.rest + near, 0.0) - lanes.tyre(lanes.rest - near, 0.0)) / (2.0 * near)
    assert slope == pytest.approx(bent.stiffness, rel=1e-6)
    assert lanes.tyre(lanes.rest, 0.0) == pytest.approx(
        (bent.sprung + bent.unsprung) * 9.81, rel=1e-9
    )
    assert lanes.damper(np.array(1e-6)) == pytest.approx(1e-6 * bent.bump, rel=1e-5)


def test_a_bench_of_the_fitted_laws_has_one_truth():
    rides = [
        Ride(Rig(guide=6.0, bump=120.0, rebound=200.0), Pass(Road(), speed))
        for speed in (1.95, 3.79)
    ]
    bench = foreign_benches.Bench(0, "", rides[0].rig, rides, [], [], (), {}, 0)
    truth = foreign_benches.true_values(bench, foreign_benches.ridden(rides, duration=0.3))
    for component, effective in truth.values():
        assert effective == pytest.approx(component, rel=1e-6)
    assert [round(one) for one, _ in truth.values()] == [22730, 120, 200, 6, 138000]


@pytest.mark.slow
def test_two_benches_are_counted(tmp_path, capsys):
    out = tmp_path / "counts.jsonl"
    foreign_counts.main(["--benches", "0:2", "--out", str(out)])
    lines = foreign_counts.lines_of(out)
    assert [line["seed"] for line in lines] == [0, 1]
    for line in lines:
        assert set(line["parameters"]) == set(foreign_counts.FREE)
        for path, one in line["parameters"].items():
            assert one["identified"] or one["why"]
            if "strut" not in line["kind"]:  # friction that the fitted strut does not have
                assert foreign_counts.is_inside(one, widths=2.0), (line["seed"], path)
    assert "2 benches, 0 refused" in capsys.readouterr().out


def test_a_count_goes_on_where_it_stopped(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(foreign_benches, "run", lambda benches: [[] for _ in benches])
    monkeypatch.setattr(
        foreign_counts, "updated", lambda bench, *_: {"seed": bench.seed, "kind": "", "error": "no"}
    )
    out = tmp_path / "counts.jsonl"
    foreign_counts.main(["--benches", "1:3", "--out", str(out)])
    foreign_counts.main(["--benches", "0:5", "--out", str(out)])
    seeds = [json.loads(text)["seed"] for text in out.read_text().splitlines()]
    assert seeds == [1, 2, 0, 3, 4]
    assert "0 benches, 5 refused" in capsys.readouterr().out


def test_counting_tells_what_is_outside():
    inside = {
        "interval": [0.0, 2.0],
        "component": 0.5,
        "effective": 1.9,
        "value": 1.0,
        "start": 1.0,
        "identified": True,
    }
    outside = {**inside, "effective": 2.4}
    far = {**inside, "component": -0.6}
    line = {
        "seed": 1,
        "kind": "",
        "shape": "",
        "cpu": 1.0,
        "objective": 0.1,
        "findings": [["", "note", ""]],
    }
    paths = list(foreign_counts.FREE)
    parameters = dict(zip(paths, [outside, far, *[inside] * 3], strict=True))
    table = foreign_counts.table([{**line, "parameters": parameters}]).splitlines()
    assert " ".join(table[-2].split()) == "all 60.0 % 80.0 % 80.0 % 100.0 % 2 of 5 1 2 100.0 %"
    assert "1 of these without a warning" in table[-1]
    warned = json.loads(
        json.dumps({**line, "parameters": parameters, "findings": [["", "warning", ""]]})
    )
    assert "0 of these without a warning" in foreign_counts.table([warned])
    assert "(1.40; start 1)" in foreign_counts.outcomes(warned)
