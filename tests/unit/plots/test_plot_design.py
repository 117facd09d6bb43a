"""Pictures of designs show the numbers of the results they are given."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import jounce as jn
from jounce.design.optimise import Optimisation, optimise
from jounce.design.pareto import ParetoFront, pareto
from jounce.plots import figure_of
from jounce.plots.design import optimisation, pareto_front

FREE = {
    "front.spring_rate": "±30 %",
    "front.damping_coefficient": (500.0, 8000.0),
    "rear.damping_coefficient": (500.0, 8000.0),
}


@pytest.fixture(scope="module")
def front() -> ParetoFront:
    return pareto(jn.load("audi-a6-half-car-4dof"), FREE, "C", "20 m/s", points=6)


@pytest.fixture(scope="module")
def best() -> Optimisation:
    vehicle = jn.load("audi-a6-half-car-4dof")
    return optimise(
        vehicle, FREE, "body.az", {"strut.deflection": "11 mm"}, road="C", speed="20 m/s"
    )


def test_front_shows_designs_travel_and_numbers(front):
    figure = pareto_front(front)
    main, _, springs, dampers = figure.axes
    points = main.collections[0]
    assert np.asarray(points.get_offsets()) == pytest.approx(
        np.column_stack([front.comfort, front.holding])
    )
    assert np.asarray(points.get_array()) == pytest.approx(1e3 * front.travel)
    assert springs.get_ylabel() == "N/mm"
    assert springs.lines[0].get_ydata() == pytest.approx(1e-3 * front.numbers["front.spring_rate"])
    assert [line.get_label() for line in dampers.lines] == [
        "front.damping_coefficient",
        "rear.damping_coefficient",
    ]
    assert [text.get_text() for text in main.texts] == ["for comfort", "for road holding"]
    assert len(main.collections) == 1 + len(front.marks)
    assert main.get_xlabel() == ("comfort: sprung.az, unweighted r.m.s. of front and rear [m/s²]")


def test_a_front_of_two_metrics_shows_neither_twice(front):
    pair = replace(
        front,
        metrics={**front.metrics, "travel": front.metrics["comfort"]},
        words={**front.words, "travel": front.words["comfort"]},
        travel=front.comfort,
    )
    main, *numbers = pareto_front(pair).axes
    assert len(numbers) == 2  # springs and dampers: no colours need a bar
    assert np.asarray(main.collections[0].get_offsets()) == pytest.approx(
        np.column_stack([front.comfort, front.holding])
    )
    assert (front.roles, pair.roles) == (("comfort", "holding", "travel"), ("comfort", "holding"))
    assert str(pair).count("sprung.az, unweighted r.m.s. of front and rear [m/s^2]") == 1
    named = replace(
        pair,
        metrics={
            "comfort": "a: p95 sprung.az",
            "holding": "b: sprung.az",
            "travel": "b: sprung.az",
        },
    )
    assert str(named).startswith("From a: p95 sprung.az to b: sprung.az on ")


def test_optimisation_shows_numbers_in_their_bounds_and_limits(best):
    left, right = optimisation(best).axes
    assert [label.get_text() for label in left.get_yticklabels()] == list(FREE)
    shown = [line.get_xdata()[0] for line in left.lines if line.get_marker() == "o"]
    assert shown == pytest.approx(
        [100 * (n.value - n.lower) / (n.upper - n.lower) for n in best.numbers]
    )
    widths = [patch.get_width() for patch in right.patches]
    assert widths[0] == pytest.approx(100 * best.after["body.az"] / best.before["body.az"])
    assert widths[1:] == pytest.approx([100 * c.value / c.start for c in best.constraints])
    texts = [text.get_text() for text in right.texts]
    assert [("at its limit" in text) for text in texts[1:]] == [
        c.is_active for c in best.constraints
    ]


def test_both_are_drawn_by_the_one_verb(front, best):
    assert len(figure_of(front).axes) == 4
    assert len(figure_of(best).axes) == 2
