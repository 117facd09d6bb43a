"""The next trial of a campaign: what a campaign states beside its trials, and trials that cannot be set up."""

import pytest

from jounce.campaign import new_campaign
from jounce.campaign.posterior import campaign_next_trials
from jounce.core.errors import FitError


@pytest.fixture
def campaign(tmp_path):
    """The commented campaign, with something known beforehand of its damper."""
    file = new_campaign(tmp_path / "mine")
    bounds, damper = '"50 %"', '"strut.damper.coefficient" = '
    text = file.read_text(encoding="utf-8")
    assert damper + bounds in text
    known = f'{damper}{{bounds = {bounds}, prior = ["180 N*s/m", "20 N*s/m"]}}'
    file.write_text(text.replace(damper + bounds, known), encoding="utf-8")
    return file


def test_a_prior_does_not_count_where_only_noise_does(campaign):
    found = campaign_next_trials(campaign, speeds=["2 m/s"], roads=["A"], noise_only=True, count=1)
    assert found.counted == "noise only"
    assert [one.name for one in found.candidates] == [
        "A at 2 m/s, strut 26 deg"
    ]  # as the rig stands, too: no trial more
    assert 0.0 < found.now["strut.damper.coefficient"] < 5.0  # N s/m, not the 20 of the prior


def test_trials_that_cannot_be_run_are_left_out_with_the_reason(campaign):
    given = {"strut_angles": ["26 deg", "95 deg"], "roads": ["A"], "noise_only": True, "count": 1}
    found = campaign_next_trials(campaign, speeds=["0.05 m/s", "2 m/s"], **given)
    assert [one.name for one in found.candidates] == ["A at 2 m/s, strut 26 deg"]
    told = {finding.place: finding.message for finding in found.findings}
    assert "end after the 1.5 s" in told["A at 0.05 m/s, strut 26 deg"]
    assert "as are 1 more: strut.angle: out of range" in told["A at 0.05 m/s, strut 95 deg"]
    with pytest.raises(FitError, match=r"none of the trials can be run.*drive faster"):
        campaign_next_trials(campaign, speeds=["0.05 m/s"], roads=["A"], noise_only=True)
