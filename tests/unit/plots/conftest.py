"""Results made by hand, so that what is drawn can be compared with what was given."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.campaign.description import TrialEntry
from jounce.campaign.trial_result import ChannelComparison, Signals, TrialComparison, TrialResult
from jounce.identify.update import Identifiability, UpdatedParameter, UpdateResult


def comparison(rating: float, grade: str, verdict: str, nrmse: float = 0.2) -> TrialComparison:
    channel = ChannelComparison(nrmse, 1.0 - nrmse**2, -0.03, rating, grade, 0.001, 12.0)
    return TrialComparison({"sprung.az": channel}, verdict, 10.0)


def trial_result(
    number: int, use: str, speed: float, pitch: float | None = None, nrmse: float = 0.2
) -> TrialResult:
    time = np.arange(0.0, 1.0, 1e-3)
    measured = np.where((time > 0.2) & (time < 0.6), np.sin(40.0 * (time - 0.2)), 0.0)
    entry = TrialEntry(number=number, speed=speed, road="A", recording=f"{number}.csv", use=use)
    return TrialResult(
        entry,
        pitch,
        comparison(0.5, "poor", "does not hold", 2.0 * nrmse),
        comparison(0.9, "good", "holds", nrmse),
        {"sprung.az": Signals(time, measured, 0.7 * measured)},
        {"sprung.az": Signals(time, measured, 0.9 * measured)},
    )


@pytest.fixture
def trials() -> tuple[TrialResult, ...]:
    lost = TrialResult(
        TrialEntry(number=4, speed=2.0, road="A", recording="4.csv"), None, None, None, {}, {}
    )
    return (
        trial_result(1, "fit", 1.95),
        trial_result(2, "hold-out", 2.86, nrmse=0.4),
        trial_result(3, "hold-out", 2.0, 0.15),
        lost,
    )


@pytest.fixture
def update_result() -> UpdateResult:
    parameters = {
        "strut.spring.rate": UpdatedParameter(
            20000.0, 21000.0, 100.0, (20804.0, 21196.0), 18000.0, 22000.0, False, "N/m"
        ),
        "tyre.stiffness": UpdatedParameter(100e3, 110e3, None, None, 90e3, 110e3, True, "N/m"),
    }
    known = Identifiability(
        tuple(parameters), (1.0, 0.5), (2.0, 1.0), 2, 2.0, ((1.0, -0.4), (-0.4, 1.0)), ()
    )
    correlation = ((1.0, 0.0), (0.0, 0.0))
    return UpdateResult(
        "strategy 2", "bfgs", 200.0, 50.0, 75.0, 5, 9, parameters, correlation, {}, known
    )
