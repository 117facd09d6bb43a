"""From the folder of another laboratory, with other habits, to the values behind it."""

from __future__ import annotations

import pytest
import spanish_laboratory as laboratory

import jounce as jn


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> jn.FolderCampaign:
    place = tmp_path_factory.mktemp("spanish")
    laboratory.write(laboratory.Truth(), place / "lab")
    return jn.campaign_from_folder(place / "campaign", place / "lab")


def test_every_file_is_recognised(made: jn.FolderCampaign) -> None:
    kinds = [item.kind for item in made.files]
    assert {kind: kinds.count(kind) for kind in set(kinds)} == {
        "trial": 5, "spring": 3, "tyre": 6, "table of trials": 1, "settings": 1,
    }  # fmt: skip
    assert made.findings == ()


def test_the_intervals_hold_what_is_true_where_the_tyre_damps_four_times_the_start(
    made: jn.FolderCampaign,
) -> None:
    result = jn.run_campaign(made.campaign)
    truth = laboratory.Truth()
    assert result.is_complete, [str(item) for item in result.findings if item.severity == "problem"]
    found = result.strategies[0].update.discrepancy.parameters
    true = {
        "strut.spring.rate": truth.spring, "strut.damper.bump_coefficient": truth.damper,
        "strut.damper.rebound_coefficient": truth.damper, "tyre.stiffness": truth.tyre,
        "tyre.damping_coefficient": truth.tyre_damping,
    }  # fmt: skip
    for path, value in true.items():
        low, high = found[path].interval
        assert low <= value <= high, path
        assert high - low < (1.0 if path == "tyre.damping_coefficient" else 0.3) * value, path
    assert found["tyre.damping_coefficient"].interval[0] > 20.0  # N s/m; the rig begins at 10
    assert {trial.after.verdict for trial in result.trials} == {"holds"}
