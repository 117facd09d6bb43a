"""The quarter-car prototype paper's central result, and what makes it come out: each cause is changed by itself.

The paper: adjusting the measured tyre curve represents the sprung mass only, adjusting one tyre stiffness both masses.
On the shipped bench the wheel is represented after either, the body after neither; on ``kart-low-friction`` the paper's
order comes out. A mass counts as represented with R2 above 0.95 on the trial that was fitted.
"""

from __future__ import annotations

from functools import cache

import pytest

import jounce as jn
from jounce.papers.table2 import table2
from jounce.papers.virtual_bench import BenchPlan, campaign_texts, make_measurements

REPRESENTED = 0.95
FRICTION = {
    "rig.strut.friction.force": "5 N",
    "rig.guide_friction.force": "9 N",
}  # of the shipped bench
DEGRESSIVE = {
    "rig.strut.damper": {
        "velocity": [-1.2, -0.5, -0.15, 0.0, 0.15, 0.5, 1.2],
        "force": [-190.0, -92.0, -32.0, 0.0, 23.0, 66.0, 136.0],
    }
}


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Strategies 1 to 3 on trials 1, 4 and 6 (0.31 MPa) and 9 (0.25 MPa) of a bench, cached by what was changed."""

    @cache
    def evaluated(
        truth, changed=(), file="campaign.toml", weights="printed", decay="viscous-and-coulomb"
    ):
        folder = tmp_path_factory.mktemp("bench")
        rows = tuple(row for row in table2() if row.number in (1, 4, 6, 9))
        real = jn.load_truth(truth).with_changes(
            {**dict(FRICTION if "friction" in changed else {}), **_more(changed)}
        )
        make_measurements(folder, BenchPlan(trials=rows, duration=1.0), real)
        texts = campaign_texts()
        for name in ("rig.toml", "quarter-car.toml"):
            (folder / name).write_text(texts[name], encoding="utf-8")
        text = texts[file].replace("[bench.decay] ", f'[bench.decay]\nmethod = "{decay}" ')
        head, *trials = text[: text.index("# --- updating")].split("[[trial]]")
        kept = [one for one in trials if any(f"\nnumber = {row.number}\n" in one for row in rows)]
        updates = text[text.index("[[update]]") : text.index("# Beyond the paper")]
        chosen = updates.replace('method = "bfgs"', f'method = "bfgs"\nweights = "{weights}"')
        (folder / "short.toml").write_text(
            "[[trial]]".join([head, *kept]) + chosen, encoding="utf-8"
        )
        return jn.run_campaign(folder / "short.toml")

    return evaluated


def _more(changed):
    more = dict(DEGRESSIVE) if "degressive" in changed else {}
    if "settles less" in changed:
        more |= {"standing_tyre.settling": "0.45 mm", "standing_tyre.settling_force": "50 N"}
    if "even belt" in changed:
        more |= {"belt.speed_drop": 0.0, "belt.speed_error": 0.0}
    return more


def represented(result, strategy, number=None):
    """Body and wheel: whether each is represented after a strategy."""
    found = result.strategies[strategy - 1]
    after = found.trial(number or found.fitted_on[0]).after
    return tuple(after.channels[name].r2 > REPRESENTED for name in ("sprung.az", "unsprung.az"))


@pytest.mark.slow
def test_the_paper_s_order_comes_out_on_a_bench_with_little_friction(run):
    result = run("kart-low-friction")
    assert represented(result, 1) == (
        True,
        False,
    )  # section 8: "only the dynamic performance of the sprung mass"
    assert represented(result, 2) == (True, True)
    assert represented(result, 3) == (True, True)
    first, second, _ = (strategy.update for strategy in result.strategies)
    assert second.objective_after < 0.2 * first.objective_after
    assert second.reduction_percent > first.reduction_percent  # 65.5 and 31.4 % there


@pytest.mark.slow
def test_dry_friction_alone_takes_the_body_away(run):
    result = run("kart-low-friction", ("friction",))
    assert represented(result, 1)[0] is False
    assert represented(result, 2) == (False, True)


@pytest.mark.slow
def test_a_tyre_that_settles_less_is_represented_by_its_curve(run):
    """The measured curve is then right within its 10 %: strategy 1 represents the wheel, too."""
    assert represented(run("kart-low-friction", ("settles less",)), 1) == (True, True)


@pytest.mark.slow
def test_a_degressive_damper_hides_what_the_tyre_curve_lacks(run):
    assert represented(run("kart-low-friction", ("degressive",)), 1) == (True, True)


@pytest.mark.slow
def test_two_masses_in_place_of_the_linkage_lose_the_body(run):
    """The paper's model was a multibody model; a quarter car bends the spring rate to fit the wheel."""
    assert represented(run("kart-low-friction", file="quick-look.toml"), 2) == (False, True)


@pytest.mark.slow
def test_the_shipped_bench_gives_the_opposite_order(run):
    result = run("kart-prototype")
    assert represented(result, 1) == (False, True)
    assert represented(result, 2) == (False, True)
    split = result.strategies[1].objective_by_channel()
    assert split["unsprung.az"][0] > 5.0 * split["sprung.az"][0]  # Eq. 2 as printed is the wheel's


@pytest.mark.slow
def test_weights_help_the_body_and_friction_still_holds_it(run):
    printed, normalised = (
        run("kart-prototype", weights=weights).strategies[0].trial(1).after.channels["sprung.az"].r2
        for weights in ("printed", "normalised")
    )
    assert printed < normalised < REPRESENTED


@pytest.mark.some(2)
@pytest.mark.parametrize("truth", ["kart-prototype", "kart-low-friction"])
def test_closer_trains_are_met_better(run, truth):
    """Section 9: "the adjusted model better represented the situations when this distance was smaller"."""
    found = run(truth).strategies[1]
    misfit = {
        number: sum(channel.nrmse for channel in found.trial(number).after.channels.values())
        for number in (4, 6)
    }
    assert misfit[4] < misfit[6]


@pytest.mark.slow
def test_a_belt_that_keeps_its_speed_meets_wide_trains_as_well(run):
    found = run("kart-prototype", ("even belt",)).strategies[1]
    close, wide = (
        sum(c.nrmse for c in found.trial(number).after.channels.values()) for number in (4, 6)
    )
    assert wide < close


def test_the_tyre_is_softer_under_its_load_than_where_it_was_fitted(run):
    """The static load of 21.8 kg lies at the edge of what the fit discards, and on the paper's line well within it."""
    tyre = run("kart-prototype").characterisation.tyre["0.31 MPa"]
    load = 21.8 * 9.81
    assert load / tyre.stiffness.value < 0.0016 < tyre.fitted_range[0]
    assert tyre.stiffness.value == pytest.approx(138.9e3, rel=1e-3)
    assert tyre.tangent_stiffness.value == pytest.approx(130.0e3, rel=1e-3)


def test_a_decrement_takes_dry_friction_for_damping(run):
    viscous, decrement = run("kart-prototype").characterisation.damping_choices
    assert (viscous.method, decrement.method) == ("viscous-and-coulomb", "logarithmic-decrement")
    assert decrement.seen.value > 1.8 * viscous.seen.value  # of four decays: 225 and 104 N s/m


@pytest.mark.slow
def test_the_paper_s_damping_leaves_the_model_unable_to_follow(run):
    """With the decrement put straight into the model, 10 % of it cannot be taken back far enough."""
    result = run("kart-prototype", decay="logarithmic-decrement")
    assert represented(result, 1) == (False, False)
    assert represented(result, 2) == (False, False)
    assert result.strategies[1].update.parameters["strut.damper.coefficient"].at_bound
