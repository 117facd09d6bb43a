"""Recordings that end early: a shaker needs no obstacle pass, and one bad trial does not take an update with it."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.recordings import write_recording

RIG = jn.load("kart-quarter-car")
TRIAL = """
[[trial]]
number = {number}
{drive}
recording = "{number}.csv"
use = "fit"
duration = "{duration}"
"""


@pytest.fixture
def campaign(tmp_path):
    time = np.linspace(0.0, 1.0, 201)
    height = 2e-3 * np.sin(2 * np.pi * 6.0 * time)
    lines = ["time [s], road.z [m]", *(f"{t}, {z}" for t, z in zip(time, height, strict=True))]
    (tmp_path / "base.csv").write_text("\n".join(lines))
    shaken = jn.Trial(
        excitation=jn.Excitation(time=tuple(time), height=tuple(height)), duration=0.8
    )
    bump = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"),
        speed="1.95 m/s",
        duration="0.8 s",
    )
    truth = RIG.with_changes({"strut.spring.rate": "24 N/mm"})
    for number, trial in ((1, shaken), (2, bump)):
        write_recording(
            jn.simulate(truth, trial, tolerance=1e-8)[["sprung.az"]], tmp_path / f"{number}.csv"
        )

    def written(duration: str):
        text = 'schema = "jounce.campaign/1"\nrig = "kart-quarter-car"\n[roads.A]\nkind = "half-sine"\n'
        text += 'height = "10 mm"\nlength = "60 mm"\nstart = "0.2 m"\n'
        text += TRIAL.format(number=1, drive='excitation = "base.csv"', duration="0.8 s")
        text += TRIAL.format(number=2, drive='speed = "1.95 m/s"\nroad = "A"', duration=duration)
        text += '[[update]]\nname = "k"\nfree = {"strut.spring.rate" = "10 %"}\n'
        (tmp_path / "c.toml").write_text(text)
        return jn.run_campaign(tmp_path / "c.toml")

    return written


def test_a_base_motion_may_go_on_after_the_recording(campaign):
    result = campaign("0.8 s")
    assert result.is_complete
    assert result.strategies[0].update.parameters["strut.spring.rate"].value == pytest.approx(
        24e3, rel=1e-5
    )


def test_a_trial_cut_before_its_obstacle_ends_does_not_take_the_update_with_it(campaign):
    result = campaign("0.11 s")
    assert [finding.place for finding in result.findings if finding.severity == "problem"] == [
        "trial 2"
    ]
    assert result.strategies[0].fitted_on == (1,)
    assert result.strategies[0].update.parameters["strut.spring.rate"].value == pytest.approx(
        24e3, rel=1e-5
    )


def test_what_the_data_do_not_see_has_no_standard_error():
    rig = RIG.with_changes({"strut.bump_stop": {"gap": "50 mm", "rate": "200 N/mm"}})
    trial = jn.Trial(
        road=jn.HalfSine(height="5 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s"
    )
    measured = jn.simulate(rig, trial)[["sprung.az"]]
    free = {"strut.bump_stop.rate": "10 %", "strut.spring.rate": "10 %"}
    result = jn.update_model([jn.FitTrial("one", rig, trial, measured)], free)
    assert result.parameters["strut.bump_stop.rate"].standard_error is None
    assert result.parameters["strut.bump_stop.rate"].interval is None
    assert result.parameters["strut.spring.rate"].standard_error is not None
