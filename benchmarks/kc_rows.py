"""Tests of a K&C laboratory on a double wishbone with bushings at every joint, beside the tests' independent solver."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from timing import Row, processor_time

import jounce as jn

sys.path += [str(Path(__file__).parent.parent / "tests" / name) for name in ("twins", "recovery")]
import kc_rigs  # noqa: E402 - the independent solver of the tests
import kc_tests  # noqa: E402
import test_kc_update as virtual  # noqa: E402 - virtual rigs with noise, friction and a wrong curve
from kc_oracle import Oracle  # noqa: E402

POINTS = 41
_TEST = "lateral-opposed"
_BUSHING = {
    "stiffness": ["8 kN/mm", "6 kN/mm", "3 kN/mm"],
    "rotational_stiffness": ["10 N*m/deg"] * 3,
}
_JOINTS = (
    "lower_arm_front",
    "lower_arm_rear",
    "upper_arm_front",
    "upper_arm_rear",
    "lower_ball_joint",
    "upper_ball_joint",
    "tie_rod_inner",
    "tie_rod_outer",
    "strut_bottom",
    "strut_top",
)


def kc_rows() -> list[Row]:
    """Processor time of all tests and of one; the error is that of toe against the independent solver, of its range."""
    soft = {"bushings": dict.fromkeys(_JOINTS, _BUSHING)}
    rig = jn.load("reference-double-wishbone").with_changes(soft)
    every = jn.kc_tests(rig, points=POINTS)
    own = _least(lambda: jn.kc_tests(rig, points=POINTS))
    single = _least(lambda: jn.kc_test(rig, _TEST, points=POINTS))
    slopes = _least(lambda: jn.kc_sensitivities(rig))
    sheet = _least(lambda: jn.kc_overview(every, jn.kc_centres(rig)))
    table = rig.model_dump(by_alias=True, exclude_none=True)
    axle = kc_tests.Rig(Oracle(kc_rigs.read_axle(table)))
    inputs = every[_TEST]["input"].values
    states = axle.run(_TEST, inputs)
    toe = np.array([float(kc_tests.quantities(state, table)["left.toe"]) for state in states])
    ours = every[_TEST]["left.toe"].values
    error = float(np.max(np.abs((ours - ours[0]) - (toe - toe[0]))) / np.ptp(ours))
    theirs = processor_time(lambda: axle.run(_TEST, inputs))
    problem = f"K&C rig, bushings at every joint, both wheels, {POINTS} points"
    return [
        Row(
            problem,
            f"jounce, all {len(every)} tests",
            own,
            error,
            None,
            "≤ 0.3 s",
            "processor time",
        ),
        Row(
            problem,
            "jounce, slopes of all rows by all hardpoints and stiffnesses",
            slopes,
            None,
            slopes / own,
            "≤ 3 × the tests",
            "processor time",
        ),
        Row(problem, "jounce, overview of all tests", sheet, None, None, "", "processor time"),
        Row(problem, f"jounce, {_TEST}", single, error, 1.0, "", "processor time"),
        Row(problem, f"independent solver (CasADi), {_TEST}", theirs, None, theirs / single),
        _update_row(),
    ]


def _update_row() -> Row:
    """Processor time of an update of 20 coordinates and 12 stiffnesses to a noisy sheet of 14 tests, with friction."""
    sheet, _, _ = virtual.virtual_rig(12)
    free = dict.fromkeys(virtual.POINTS, "3 mm") | dict.fromkeys(virtual.STIFFNESSES, "30 %")
    took = processor_time(lambda: jn.update_kc(virtual.START, sheet, free))
    counts = f"{len(virtual.POINTS)} coordinates, {len(virtual.STIFFNESSES)} stiffnesses"
    problem = f"update to {len(sheet)} measured tests: {counts}"
    return Row(problem, "jounce", took, None, None, "≤ 10 s", "processor time")


def _least(run: object) -> float:
    return min(processor_time(run) for _ in range(7))  # type: ignore[arg-type]


if __name__ == "__main__":
    from timing import markdown

    print(markdown(kc_rows()))
