"""Trials whose rig was adjusted as the prototype is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.characterise import Knowledge
from jounce.campaign.description import TrialEntry, load_campaign
from jounce.campaign.run import rig_of
from jounce.core.errors import DescriptionError


def entry(**given) -> TrialEntry:
    return TrialEntry.from_table(
        {"number": 1, "speed": "2 m/s", "road": "A", "recording": "a.csv", **given}, where="trial"
    )


def test_an_arm_is_made_longer_in_one_trial_alone() -> None:
    knowledge = Knowledge(jn.load("kart-double-wishbone"))
    plain, longer = (
        rig_of(entry(adjustments=one), knowledge) for one in ({}, {"upper_arm_length": "20 mm"})
    )
    assert plain == knowledge.rig
    assert float(np.degrees(longer.wheel.camber - plain.wheel.camber)) == pytest.approx(
        5.0, abs=0.5
    )  # the paper's 5 deg


def test_adjustments_that_the_rig_lacks_are_refused(tmp_path: Path) -> None:
    file = jn.new_campaign(tmp_path / "mine")
    text = file.read_text(encoding="utf-8").replace(
        'recording = "trials/01.csv"',
        'recording = "trials/01.csv"\nadjustments = {upper_arm_length = "20 mm"}',
    )
    file.write_text(text, encoding="utf-8")
    assert load_campaign(file)[0].trial[0].adjustments == {"upper_arm_length": "20 mm"}
    with pytest.raises(DescriptionError, match=r"trial\[0\].adjustments \(number 1\)"):
        jn.run_campaign(file)
