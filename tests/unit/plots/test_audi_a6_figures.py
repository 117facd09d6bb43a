"""Figures of paper 2's cases show what the studies hold."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.display import local_units
from jounce.core.errors import RecordingError
from jounce.papers.audi_a6 import AudiCase, run_audi_a6
from jounce.papers.audi_a6_exciter import EccentricExciter, run_eccentric_exciter
from jounce.plots.audi_a6 import (
    case_curve,
    case_overview,
    exciter_spring,
    exciter_torque_curve,
    start_up_transient,
)
from jounce.report import PageTable
from jounce.report.papers import audi_case_page


@pytest.fixture(scope="module")
def case() -> AudiCase:
    return run_audi_a6("case-b")


@pytest.fixture(scope="module")
def exciter() -> EccentricExciter:
    return run_eccentric_exciter()


@pytest.mark.parametrize(
    ("channel", "output"), [("bounce.displacement", "z"), ("pitch.angle", "theta")]
)
def test_one_line_for_each_variant_in_thousandths(case, channel, output):
    figure = case_curve(case, channel)
    assert len(figure.axes) == 2
    for axes, runs in zip(figure.axes, (case.runs[:3], case.runs[3:]), strict=True):
        for run in runs:
            line = next(line for line in axes.lines if line.get_label() == run.variant)
            extremes = [window.max for window in run.outputs[output]]
            assert np.max(line.get_ydata()) == pytest.approx(1e3 * max(extremes), rel=1e-4)


def test_overview_has_a_row_for_each_signal(case):
    figure = case_overview(case, case.runs[0].moment)
    assert len(figure.axes) == 7
    assert figure.axes[-1].get_ylabel() == "moment\n[N·m]"
    assert min(figure.axes[-1].lines[0].get_ydata()) == -100.0


def test_unknown_channel_and_moment(case):
    with pytest.raises(RecordingError, match=r"pitch\.angle,"):
        case_curve(case, "pitch.angel")
    with pytest.raises(RecordingError, match="-100"):
        case_overview(case, 5.0)


def test_start_up(case):
    line = start_up_transient(case).axes[0].lines[0]
    assert line.get_ydata()[0] == pytest.approx(-120.0, abs=1e-9)
    assert line.get_ydata()[-1] == pytest.approx(-163.9, abs=0.1)


def test_exciter(exciter):
    plate, length, _ = exciter_spring(exciter, 2.0).axes
    assert max(plate.lines[0].get_ydata()) == pytest.approx(3.0, rel=1e-6)
    assert [line.get_ydata()[0] for line in length.lines[:3]] == pytest.approx(
        [341.0] * 3, abs=1e-9
    )
    torque = exciter_torque_curve(exciter).axes[0]
    assert {line.get_label() for line in torque.lines[:3]} == {"summed", "series", "two-mass"}


def test_figures_of_the_cases_follow_the_chosen_units(case, exciter):
    sizes = {
        "bounce.displacement": ("bounce\n[in]", 1.0 / 25.4),
        "front.force": ("front force\n[lbf]", 1e3 / 4.4482216),
    }
    for channel, (label, size) in sizes.items():
        usual = case_curve(case, channel).axes[0].lines[0].get_ydata()
        with local_units("imperial"):
            axes = case_curve(case, channel).axes[0]
        assert axes.get_ylabel() == label
        np.testing.assert_allclose(axes.lines[0].get_ydata(), np.asarray(usual) * size, rtol=1e-6)
    with local_units("imperial"):
        labels = [
            axes.get_ylabel()
            for axes in (*exciter_spring(exciter).axes, *exciter_torque_curve(exciter).axes)
        ]
        page = audi_case_page(case)
    assert labels == [
        "plate\n[in]", "spring length\n[in]", "spring force\n[lbf]", "drive torque\n[lbf·ft]", "force on plate\n[lbf]",
    ]  # fmt: skip
    tables = [block for block in page.blocks() if isinstance(block, PageTable)]
    extremes = next(
        table for table in tables if table.caption.startswith("Extremes with a pitch moment")
    )
    assert extremes.header[1] == "z min [in]"
    window = next(run for run in case.runs).outputs["z"][0]
    cell = extremes.rows[0][1]
    assert float(str(cell).replace("−", "-")) == pytest.approx(window.min / 0.0254, abs=5.1e-4)
