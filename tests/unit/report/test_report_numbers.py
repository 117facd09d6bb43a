from __future__ import annotations

import pytest

from jounce.identify.estimate import Estimate
from jounce.plots.display import (
    correlation,
    estimate_cells,
    estimate_text,
    milliseconds,
    percent,
    setting_text,
)


@pytest.mark.parametrize(
    ("found", "cells"),
    [
        (Estimate(22731.4, 123.0, (22490.0, 22972.0)), ("22.73", "0.12", "22.49 to 22.97", "N/mm")),
        (Estimate(22731.4), ("22.73", "–", "–", "N/mm")),
        (None, ("–", "–", "–", "N/mm")),
    ],
)
def test_estimates(found: Estimate | None, cells: tuple[str, ...]) -> None:
    assert estimate_cells(found, "N/m") == cells


def test_estimate_in_a_sentence() -> None:
    assert (
        estimate_text(Estimate(0.1096, 0.002, (0.1057, 0.1135)), "1")
        == "0.1096 (95 %: 0.1057 to 0.1135)"
    )
    assert estimate_text(Estimate(5.0), "N") == "5.000 N"


def test_interval_that_touches_zero() -> None:
    assert estimate_cells(Estimate(1.0, 0.6, (0.0, 2.2)), "N")[2] == "0 to 2.20"


@pytest.mark.parametrize(
    ("share", "text"),
    [(0.0512, "5.1 %"), (-0.9, "−90.0 %"), (-0.0001, "0.0 %"), (float("nan"), "–")],
)
def test_percent(share: float, text: str) -> None:
    assert percent(share) == text


def test_signs_of_nothing() -> None:
    assert [milliseconds(value) for value in (-1e-6, -0.0123, 0.001)] == ["0.0", "−12.3", "1.0"]
    assert [correlation(value) for value in (-0.001, -0.5, 0.25)] == ["0.00", "−0.50", "+0.25"]


def test_settings_as_given() -> None:
    assert [
        setting_text(2.9, "m/s"),
        setting_text(0.15, "m"),
        setting_text(250000.0, "Pa"),
        setting_text(None, "rad"),
    ] == [
        "2.9 m/s",
        "150 mm",
        "0.25 MPa",
        "–",
    ]
