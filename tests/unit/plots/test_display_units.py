"""Figures and pages in imperial units: what is drawn is the same, its numbers and labels follow."""

from __future__ import annotations

from contextlib import suppress

import numpy as np
import pytest

import jounce as jn
from jounce.core.display import (
    SYSTEMS,
    current_units,
    display_unit,
    display_unit_for,
    local_units,
    size,
)
from jounce.core.errors import DescriptionError
from jounce.core.units import conversion_factor
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.plots.display import estimate_text, setting_text
from jounce.report.bench_charts import road_panels, stiffness_panels

SIZES = {  # what one SI unit is, by the definitions of inch, foot, pound and pound-force (NIST SP 811, appendix B)
    "m": 1.0 / 0.0254, "m/s": 1.0 / 0.0254, "m/s^2": 1.0 / 0.3048, "kg": 1.0 / 0.45359237, "N": 1.0 / 4.4482216152605,
    "Pa": 1.450377377e-4, "N/m": 5.710147e-3, "N*s/m": 5.710147e-3, "N*m": 0.7375621, "J": 0.7375621, "W": 1.341022e-3,
    "kg*m^2": 23.73036, "rad/m": np.degrees(0.0254),
}  # fmt: skip
IN = 1.0 / 0.0254


@pytest.fixture
def imperial():
    with local_units("imperial"):
        yield


@pytest.mark.parametrize("si", SIZES)
def test_sizes(si: str, imperial: None) -> None:
    assert display_unit(si).factor == pytest.approx(SIZES[si], rel=1e-6)


def test_every_unit_is_what_the_library_of_units_says() -> None:
    """The name of each unit, read as a user writes it, has the size with which values are shown."""
    from jounce.core.display import _LARGE, _UNITS

    for system in SYSTEMS:
        large = {si: unit for si, (_, unit) in _LARGE[system].items()}
        for si, unit in [*_UNITS[system].items(), *large.items()]:
            if unit.name and si != "m/km":
                assert unit.factor * conversion_factor(unit.name, si) == pytest.approx(
                    1.0, rel=1e-9
                ), unit


def test_units_by_size_and_by_words(imperial: None) -> None:
    assert display_unit("m/s", 3.9).name == "in/s"
    assert display_unit("m/s", 4.0).name == "mph"
    assert display_unit("m", -10.0).name == "ft"
    assert display_unit("N", 1e6).name == "lbf"
    assert display_unit_for("m/s", "speed") == display_unit("m/s", 10.0)
    assert display_unit_for("kN").factor == pytest.approx(224.8089, rel=1e-6)
    assert display_unit_for("in").factor == pytest.approx(
        1.0, rel=1e-12
    )  # what is converted already
    assert display_unit_for("psi").factor == pytest.approx(1.0, rel=1e-12)
    assert size(0.31, "MPa") == "44.96 psi"
    assert setting_text(1.95, "m/s", "speed") == "4.362 mph"
    for unit in ("s", "Hz", "%", "g", "°", "no unit", "SI"):
        assert display_unit_for(unit).name == unit
        assert display_unit_for(unit).factor == 1.0


def test_a_block_and_a_choice_end_where_they_should() -> None:
    assert current_units() == "metric"
    with suppress(ZeroDivisionError), local_units("imperial"):
        assert current_units() == "imperial"
        raise ZeroDivisionError
    assert current_units() == "metric"
    with pytest.raises(
        DescriptionError, match=r"unknown system of units 'imperal'; .*Did you mean 'imperial'"
    ):
        jn.use_units("imperal")
    assert current_units() == "metric"
    assert size(0.31, "MPa") == "0.31 MPa"


def lines(figure) -> list[tuple[str, str, np.ndarray, np.ndarray]]:
    return [
        (axes.get_xlabel(), axes.get_ylabel(), *np.asarray(line.get_data(), dtype=float))
        for axes in figure.axes
        for line in axes.get_lines()
    ]


BUMP = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")


def drawn() -> dict[str, list]:
    x = np.linspace(0.0, 0.015, 31)
    trials = [ForceDeflectionTrial(x, k * x, f"spring {k}") for k in (22700.0, 22760.0)]
    fit = jn.fit_stiffness(trials)
    road = [(p.x_label, p.y_label, p.series[0].x, p.series[0].y) for p in road_panels({"a": BUMP})]
    bench = [
        (p.x_label, p.y_label, s.x, s.y)
        for p in stiffness_panels(fit, trials, "")[:1]
        for s in p.series
    ]
    return {
        "road": lines(jn.plots.road_profile(BUMP)),
        "stiffness": lines(jn.plots.stiffness_fit(fit, trials))[:3],
        "road in a report": road,
        "stiffness in a report": bench,
    }


LABELS = {
    "road": ("distance [in]", "height [in]", IN, IN / 1e3),
    "stiffness": ("deflection [in]", "force [lbf]", IN / 1e3, SIZES["N"]),
    "road in a report": ("distance [in]", "height [in]", IN, IN / 1e3),
    "stiffness in a report": ("deflection [in]", "force [lbf]", IN / 1e3, SIZES["N"]),
}


def test_curves_have_the_units_of_their_labels() -> None:
    before = drawn()
    with local_units("imperial"):
        after = drawn()
    for name, (across, up, x_size, y_size) in LABELS.items():
        for (_, _, x, y), (x_label, y_label, *found) in zip(before[name], after[name], strict=True):
            assert (x_label, y_label) == (across, up), name
            np.testing.assert_allclose(found[0], np.asarray(x) * x_size, rtol=1e-9, atol=1e-12)
            np.testing.assert_allclose(found[1], np.asarray(y) * y_size, rtol=1e-6, atol=1e-12)


def test_texts_of_estimates(imperial: None) -> None:
    from jounce.identify.estimate import Estimate

    text = estimate_text(Estimate(22731.4, 12.3, (22705.0, 22757.0)), "N/m")
    assert text == "129.800 lbf/in (95 %: 129.649 to 129.946)"


def test_a_mechanism_has_its_places_in_inches() -> None:
    rig = jn.load("kart-double-wishbone")

    def ticks() -> list[tuple[str, list[tuple[float, str]]]]:
        figure = jn.plots.mechanism(rig)
        found = []
        for axes in figure.axes[:3]:
            axis = axes.xaxis
            places = [
                place
                for place in axis.get_majorticklocs()
                if axes.get_xlim()[0] <= place <= axes.get_xlim()[1]
            ]
            found.append(
                (
                    axes.get_xlabel(),
                    [(place, axis.get_major_formatter()(place, 0)) for place in places],
                )
            )
        return found

    with local_units("imperial"):
        inches = ticks()
    for (metric, _), (label, places) in zip(ticks(), inches, strict=True):
        assert label == metric.replace("[mm]", "[in]")
        assert 2 <= len(places) <= 8
        for place, text in places:
            assert abs(float(text.replace("−", "-"))) == pytest.approx(abs(place) / 25.4, abs=1e-9)
