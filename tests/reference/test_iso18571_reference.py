"""Ratings of another implementation of ISO/TS 18571 on the same signals."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.identify.comparison import iso18571

pytestmark = pytest.mark.source(
    kind="program",
    of="signals and identification",
    key="objective-rating-metrics",
    where="version 1.3, class ISO18571, seven pairs of signals",
    tolerance="all digits: the same formulae in double precision",
)

T = np.arange(1200) / 10e3
DECAY = np.exp(-20.0 * T) * np.sin(2.0 * np.pi * 60.0 * T)
CASES = {
    "scaled and late": (DECAY, 1.15 * np.interp(T - 0.0013, T, DECAY)),
    "early and stretched": (DECAY, np.exp(-26.0 * T) * np.sin(2.0 * np.pi * 57.0 * (T + 0.002))),
    "with a disturbance": (DECAY, 0.9 * DECAY + 0.1 * np.cos(2.0 * np.pi * 900.0 * T)),
    "with an offset": (DECAY, DECAY + 0.2),
    "a pulse against a step": (np.exp(-(((T - 0.05) / 0.01) ** 2)), np.tanh((T - 0.05) / 0.01)),
    "with a clipped copy": (DECAY, np.clip(DECAY, -0.3, 0.3)),
    "odd length, short": (DECAY[:333], 0.8 * DECAY[7:340]),
}

# Computed once with objective-rating-metrics 1.3 (PyPI, MIT licence), class ISO18571 with its defaults, all digits:
# corridor, phase, magnitude, slope, overall. Both compute the same formulae in double precision.
EXPECTED = {
    "scaled and late": (
        0.6791044782593622,
        0.9458333333333333,
        0.9126818156518479,
        0.925,
        0.8283448211007812,
    ),
    "early and stretched": (
        0.7376674054570835,
        0.2708333333333333,
        0.7929046661279924,
        0.7628235213873643,
        0.6603792663525714,
    ),
    "with a disturbance": (
        0.8725726999871897,
        0.30416666666666664,
        0.6217985615027807,
        0.45121783948405425,
        0.6244656935255762,
    ),
    "with an offset": (
        0.39526150285716977,
        1,
        0.40424509836229683,
        0.9999999999999999,
        0.6389536208153273,
    ),
    "a pulse against a step": (
        0.022818007143722372,
        0,
        0,
        0.1839480141171198,
        0.045916805680912914,
    ),
    "with a clipped copy": (
        0.8478600025869052,
        0.30416666666666664,
        0.4419502710344103,
        0.7699759472164268,
        0.6423625780182629,
    ),
    "odd length, short": (
        0.5996489859004893,
        0.8948948948948949,
        0.8561664377136586,
        0.9,
        0.7700718608819065,
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_scores_of_objective_rating_metrics(case: str) -> None:
    reference, compared = CASES[case]
    found = iso18571(reference, compared, 10e3)
    scores = (found.corridor, found.phase, found.magnitude, found.slope, found.rating)
    np.testing.assert_allclose(scores, EXPECTED[case], rtol=0.0, atol=1e-9)
