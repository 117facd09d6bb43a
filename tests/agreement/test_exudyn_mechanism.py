"""A spatial slider-crank with a ball joint and a universal joint: jounce, Exudyn and the twin in absolute coordinates.

Exudyn's trajectory is stored with the script that makes it (``tests/files/exudyn``); where Exudyn is installed, a slow
test runs it again. It is implicit and of second order; extrapolated over three step sizes it agrees with the twin at
1e-13 to 3e-11 (positions), 8e-11 (velocities) and 8e-7 (force in the ball joint).
"""

from __future__ import annotations

import importlib.util
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.source(
    kind="program",
    of="mechanisms in space",
    key="exudyn",
    where="a spatial slider-crank, tests/files/exudyn",
    tolerance="its step size, extrapolated",
)

ROOT = Path(__file__).parents[1]
WIDTH = {
    "ball": 3,
    "ball_velocity": 3,
    "cross": 3,
    "rod": 3,
    "rod_spin": 3,
    "ball_force": 3,
    "spring_length": 1,
}


def loaded(path: Path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


MADE = loaded(ROOT / "files" / "exudyn" / "make_slider_crank.py")
MODEL = MADE.MODEL


@pytest.fixture(scope="module")
def stored():
    with np.load(ROOT / "files" / "exudyn" / "slider_crank.npz") as file:
        return {name: file[name] for name in file}


@pytest.fixture(scope="module")
def run():
    return jn.simulate_mechanism(
        mechanism(), MODEL["duration"], output_step=MODEL["output_step"], tolerance=1e-9
    )


def mechanism():
    made = jn.mechanics.Mechanism(gravity=MODEL["gravity"])
    bodies = {name: made.body(name, *MODEL[name]) for name in ("crank", "rod", "slider")}
    made.revolute(
        "pivot", made.ground, bodies["crank"], at=MODEL["crank_pivot"], axis=MODEL["crank_axis"]
    )
    made.spherical("ball", bodies["crank"], bodies["rod"], at=MODEL["ball"])
    made.prismatic(
        "guide", made.ground, bodies["slider"], axis=MODEL["slider_axis"], at=MODEL["cross"]
    )
    axes = MADE.cross_axes()
    made.universal(
        "cross",
        bodies["slider"],
        bodies["rod"],
        at=MODEL["cross"],
        axis=axes[0],
        second_axis=axes[1],
    )
    law = MODEL["spring"]
    length, _ = made.spring_damper(
        "spring",
        made.ground,
        bodies["slider"],
        MODEL["spring_ground"],
        MODEL["spring_slider"],
        stiffness=law["rate"],
        damping=law["damping"],
        free_length=law["free_length"],
    )
    made.output("spring length", length, "m", "length of the spring")
    made.watch_point("ball place", bodies["crank"], MODEL["ball"])
    made.watch_point("cross place", bodies["slider"], MODEL["cross"])
    made.watch_body(bodies["rod"])
    made.watch_reaction("ball")
    made.watch_reaction("cross")
    made.watch_energy()
    return made


def vector(run, *names: str) -> np.ndarray:
    return np.stack([run[name].values for name in names], axis=1)


def channels(run) -> dict[str, np.ndarray]:
    def three(name: str, letters: str = "xyz", prefix: str = "") -> np.ndarray:
        return vector(run, *(f"{name}.{prefix}{letter}" for letter in letters))

    return {
        "ball": three("ball place"),
        "ball_velocity": three("ball place", prefix="v"),
        "cross": three("cross place"),
        "rod": three("rod"),
        "rod_spin": three("rod", prefix="w"),
        "ball_force": -three("ball", prefix="f"),  # Exudyn's is on the first body, the crank
        "spring_length": vector(run, "spring length"),
    }


def errors(found, expected) -> dict[str, float]:
    return {
        name: float(
            np.abs(found[name] - expected[name]).max() / np.ptp(expected[name], axis=0).max()
        )
        for name in WIDTH
    }


LIMITS = {
    "ball": 1e-10,
    "ball_velocity": 2e-10,
    "cross": 1e-10,
    "rod": 1e-10,
    "rod_spin": 2e-10,
    "ball_force": 2e-6,
    "spring_length": 1e-10,
}


@pytest.mark.no_source
def test_it_moves_far(stored) -> None:
    """The crank's end swings 0.24 m and the slider 0.14 m: nothing linear about it."""
    assert np.ptp(stored["ball"][:, 2]) > 0.2
    assert np.ptp(stored["cross"][:, 1]) > 0.1


def test_jounce_agrees_with_exudyn(run, stored) -> None:
    found = errors(channels(run), stored)
    assert found == {name: pytest.approx(0.0, abs=LIMITS[name]) for name in found}


def twin_run() -> dict[str, np.ndarray]:
    """The same mechanism in absolute coordinates with DOP853 at 1e-13."""
    twin = loaded(ROOT / "twins" / "double_wishbone_twin.py")
    system = twin.System(gravity=MODEL["gravity"])
    crank, rod, slider = (system.body(*MODEL[name]) for name in ("crank", "rod", "slider"))
    system.revolute(0, crank, MODEL["crank_pivot"], MODEL["crank_axis"])
    system.prismatic(0, slider, MODEL["cross"], MODEL["slider_axis"])
    system.together(crank, rod, MODEL["ball"])
    system.together(slider, rod, MODEL["cross"])
    system.perpendicular(slider, rod, *MADE.cross_axes())
    law = MODEL["spring"]
    system.spring(
        0,
        slider,
        MODEL["spring_ground"],
        MODEL["spring_slider"],
        law["rate"],
        law["damping"],
        law["free_length"],
    )
    model, rows = system.arrays(), []
    times = np.arange(round(MODEL["duration"] / MODEL["output_step"]) + 1) * MODEL["output_step"]
    local = system.local(crank, MODEL["ball"]), system.local(slider, MODEL["cross"])

    def observed(y) -> np.ndarray:
        multipliers = twin._accelerations(y, 0.0, *model)[1]
        ball, speed = twin._point(y, 3, crank, local[0])
        cross, _ = twin._point(y, 3, slider, local[1])
        on_crank = (
            -twin._matrix(y[3:7]) @ multipliers[10:13]
        )  # rows 10 to 12 hold the ball, along axes of the crank
        length = twin._spring(y, 3, *(part[0] for part in model[9:12]))[0]
        return np.concatenate([ball, speed, cross, y[7:10], y[30:33], on_crank, [length]])

    y = system.at_design()
    rows.append(observed(y))
    for begin, end in pairwise(times):
        solver = twin.DOP853(
            lambda _, x: twin._rate(x, 0.0, *model),
            begin,
            y,
            end,
            rtol=1e-13,
            atol=1e-15,
            first_step=1e-3,
        )
        while solver.status == "running":
            solver.step()
        y, _ = twin._project(solver.y, *model)
        rows.append(observed(y))
    parts = np.split(np.array(rows), np.cumsum(list(WIDTH.values()))[:-1], axis=1)
    return dict(zip(WIDTH, parts, strict=True))


@pytest.mark.no_source
@pytest.mark.slow
@pytest.mark.no_source
def test_jounce_agrees_with_the_twin() -> None:
    fine = jn.simulate_mechanism(
        mechanism(), MODEL["duration"], output_step=MODEL["output_step"], tolerance=1e-11
    )
    found = errors(channels(fine), twin_run())
    assert max(found.values()) < 1e-12


@pytest.mark.no_source
def test_energy_is_kept(run) -> None:
    """Kinetic energy, weights, spring and what the damper has taken add up to what was there at the start."""
    total = sum(run[name].values for name in run if name.startswith("energy."))
    size = np.ptp(run["energy.kinetic"].values)
    assert size > 1.0
    assert np.abs(total - total[0]).max() < 1e-8 * size
    assert float(run["constraint.residual"].max()) < 1e-12


@pytest.mark.no_source
@pytest.mark.slow
def test_exudyn_gives_what_is_stored(stored) -> None:
    pytest.importorskip("exudyn")
    found, _ = MADE.extrapolated(10)
    limits = {name: 10.0 * limit + 1e-6 for name, limit in LIMITS.items()} | {"ball_force": 1e-4}
    assert {
        name: value for name, value in errors(found, stored).items() if value > limits[name]
    } == {}
