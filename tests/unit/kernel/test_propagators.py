"""What a step does, by Taylor series and doubling, against SciPy's matrix exponential of the joined system."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from jounce import parts
from jounce.core.segments import POLYNOMIAL, SINE, Segments
from jounce.kernel.methods.rows import padded_length
from jounce.models import build
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import prepare
from jounce.simulation.settings import output_times

RIG = parts.load("kart-quarter-car").with_changes(
    {"tyre.lift_off": False, "tyre.damping_coefficient": 60.0}
)
ROAD = Segments(
    np.array([0.0, 0.03, 0.06, 50.0]),
    np.array([POLYNOMIAL, SINE, POLYNOMIAL]),
    np.array([[0.0, 0.1, 2.0, 30.0], [0.0, 0.01, 80.0, 0.3], [0.0] * 4]),
)


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="quarter car",
    where="scipy.linalg.expm of state and excitation joined",
    tolerance="rounding",
    compares="one exact step of a quarter car",
)
@pytest.mark.parametrize("step", [1e-6, 1e-3, 0.5])
@pytest.mark.parametrize("wave", [0, 1])
def test_a_step(step: float, wave: int) -> None:
    """Wheel hop of 180 rad/s: series converge at once, or after seven doublings."""
    compiled = compile_model(build(RIG))
    p = compiled.parameter_values(RIG.parameters())
    case = prepare(compiled, p, ROAD, output_times(2.0 * step, step))
    assert case.run().status.name == "COMPLETED"
    assert case.exact.blocks.parts == 1
    lay, rows = case.exact.props.layout, case.exact.props.matrix[0]
    zero, still = np.zeros(4), np.zeros(2)
    joined = np.zeros((9, 9))
    joined[:4, :4] = compiled.evaluate("rate_x", zero, still, p, zero[:0])
    joined[:4, 4] = compiled.evaluate("rate", zero, still, p, zero[:0])
    joined[:4, 5:7] = compiled.evaluate("rate_u", zero, still, p, zero[:0])
    joined[[5, 6], [6, 7]] = 1.0
    if wave:
        joined[7, 6] = -(80.0**2)
    else:
        joined[7, 8] = 1.0
    expected = expm(joined * step)[:4].T
    first = lay.forcing + wave * lay.signals
    found = np.vstack(
        [np.eye(4) + rows[:4, :4], rows[lay.drift, :4], rows[first : first + lay.signals, :4]]
    )
    if wave:
        found[-1] = expected[-1]  # sines have three signals
    for image, wanted in zip(found, expected, strict=True):
        assert image == pytest.approx(wanted, rel=0.0, abs=2e-12 * np.max(np.abs(wanted)))


def test_rows_are_whole_vectors() -> None:
    assert [padded_length(count) for count in (1, 4, 5, 8, 14, 16, 17)] == [4, 4, 8, 8, 16, 16, 24]


@pytest.mark.parametrize("count", [2, 3, 4, 5, 100, 193, 194, 195, 402])
def test_runs_of_any_number_of_samples_begin_alike(count: int) -> None:
    """Steps are taken in blocks and by pairs: where they end leaves no mark on the samples; odd distances neither."""
    compiled = compile_model(build(RIG))
    p, times = compiled.parameter_values(RIG.parameters()), output_times(0.5, 1e-3)
    whole = prepare(compiled, p, ROAD, times).run().states
    size = np.max(np.abs(whole), axis=1)[:, None]
    assert (
        np.max(
            np.abs(prepare(compiled, p, ROAD, times[:count]).run().states - whole[:, :count]) / size
        )
        < 1e-12
    )
    some = np.delete(np.arange(len(times)), [7, 8, count + 20])
    assert (
        np.max(np.abs(prepare(compiled, p, ROAD, times[some]).run().states - whole[:, some]) / size)
        < 1e-12
    )
