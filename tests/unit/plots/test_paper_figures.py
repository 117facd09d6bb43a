"""The quarter-car prototype paper's figures from a campaign: what they show is what the campaign holds."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.papers.table2 import table2
from jounce.papers.virtual_bench import BenchPlan, campaign_texts, make_measurements
from jounce.plots.paper_figures import adjusted_and_not, paper_figures, update_on_every_trial


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    """Strategies 1 and 2 of the shipped quick look on trials 1 and 4."""
    folder = tmp_path_factory.mktemp("paper")
    rows = tuple(row for row in table2() if row.number in (1, 4))
    make_measurements(
        folder, BenchPlan(trials=rows, spring_trials=2, tyre_trials=1, decays=1, duration=0.8)
    )
    texts = campaign_texts()
    (folder / "quarter-car.toml").write_text(texts["quarter-car.toml"], encoding="utf-8")
    head, *trials = texts["quick-look.toml"].split("[[trial]]")
    updates = trials[-1][trials[-1].index("# --- updating") :]
    short = (
        "[[trial]]".join([head, trials[0], trials[3]])
        + updates[: updates.index('[[update]]\nname = "strategy 3"')]
    )
    (folder / "short.toml").write_text(short, encoding="utf-8")
    return jn.run_campaign(folder / "short.toml")


def test_there_is_a_figure_for_all_that_was_done(result):
    figures = paper_figures(result)
    assert list(figures) == ["figure-4a", "figure-4b", "figure-6", "figure-8", "figure-9"]
    for name in ("figure-4a", "figure-4b"):
        (axes,) = figures[name].axes
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("deflection [mm]", "force [N]")
    (axes,) = figures["figure-4b"].axes
    linear = result.characterisation.tyre["0.31 MPa"]
    low = 1e3 * linear.fitted_range[0]
    assert low == pytest.approx(
        2.0, abs=0.06
    )  # the first point of this trial above the 2 mm that are discarded
    assert [line.get_label() for line in axes.get_lines()] == [
        "experiment, 1 trial",
        f"linear fit, loading, from {low:.3g} mm: {1e-3 * linear.stiffness.value:.1f} N/mm",
        "polynomial fit, loading, all deflections",
    ]
    assert [line.get_xdata()[0] for line in axes.get_lines()[1:]] == pytest.approx(
        [low, 0.0], abs=1e-9
    )
    assert [axes.get_title("left") for axes in figures["figure-6"].axes] == [
        "(a) single obstacle",
        "(b) a series of 5 obstacles",
    ]
    assert [axes.get_title("left") for axes in figures["figure-9"].axes] == [
        "(a) trial 1, strategy 2: sprung.az",
        "(b) trial 1, strategy 2: unsprung.az",
    ]
    assert figures["figure-8"].axes[-1].get_xlabel() == "time [s]"


def test_curves_are_experiment_and_both_simulations(result):
    strategy = result.strategies[1]
    trial = strategy.trial(1)
    for axes, name in zip(
        adjusted_and_not(strategy, trial).axes, ("sprung.az", "unsprung.az"), strict=True
    ):
        drawn = {line.get_label(): line.get_ydata() for line in axes.get_lines()}
        np.testing.assert_array_equal(drawn["experiment"], trial.signals[name].measured)
        np.testing.assert_array_equal(
            drawn["simulation, not adjusted"], trial.signals_before[name].simulated
        )
        np.testing.assert_array_equal(drawn["simulation, adjusted"], trial.signals[name].simulated)
        pair = [one.channels[name].r2 for one in (trial.before, trial.after)]
        assert axes.get_title("right") == f"R² {pair[0]:.3f} → {pair[1]:.3f}"


def test_an_update_is_drawn_on_every_trial_with_the_fitted_ones_marked(result):
    figure = update_on_every_trial(result.strategies[0])
    titles = [axes.get_title("left") for axes in figure.axes]
    assert titles == [
        f"{trial}: {name} [m/s²]"
        for trial in ("1, fitted", "4")
        for name in ("sprung.az", "unsprung.az")
    ]


def test_the_measured_points_are_those_that_were_fitted(result):
    bench = result.characterisation
    assert {place: len(trials) for place, trials in bench.loaded.items()} == {
        "bench.spring": 2,
        'bench.tyre."0.31 MPa"': 1,
        'bench.tyre."0.25 MPa"': 1,
    }
    (axes,) = paper_figures(result)["figure-4a"].axes
    assert sum(line.get_marker() == "." for line in axes.get_lines()) == 2
