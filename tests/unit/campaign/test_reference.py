"""A campaign's results beside published ones."""

from __future__ import annotations

from pathlib import Path

import pytest

import jounce as jn
from jounce.campaign import CampaignResult
from jounce.campaign.beside_reference import beside_reference
from jounce.campaign.description import load_campaign
from jounce.campaign.reference import Reference
from jounce.core.errors import DescriptionError
from jounce.report.campaign import campaign_summary

TOLD = """
[reference]
source = "A paper"
best_speeds = ["1.95 m/s"]
[[reference.update]]
update = "stiffness, damping and friction"
reduction = "95 %"
iterations = 5
represents = ["sprung.az", "unsprung.az"]
parameters = {"tyre.stiffness" = "200 N/mm", "unsprung.mass" = "5 kg"}
"""


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> CampaignResult:
    file = jn.new_campaign(tmp_path_factory.mktemp("mine") / "mine")
    file.write_text(file.read_text(encoding="utf-8") + TOLD, encoding="utf-8")
    return jn.run_campaign(file)


def test_each_statement_has_a_verdict(result: CampaignResult) -> None:
    rows = {
        row.what.partition(": ")[2] or row.what: row
        for row in beside_reference(result.campaign.reference, result.strategies, result.trials)
    }
    update = result.strategies[0].update
    assert rows["reduction"].ours == f"{update.reduction_percent:.1f} %"
    assert (rows["reduction"].verdict == "reproduced") == (
        abs(update.reduction_percent - 95.0) <= 10.0
    )
    assert rows["iterations"].ours == str(update.iterations)
    assert rows["represents"].verdict == "reproduced"
    assert rows["tyre.stiffness"].verdict == "not reproduced"
    assert rows["unsprung.mass"].verdict == "not comparable"
    assert rows["best speeds"].published == "1.95 m/s"
    (plain,) = [row for row in result.to_dict()["reference"] if row["what"] == "best speeds"]
    assert plain["verdict"] in ("reproduced", "not reproduced")


def test_the_summary_shows_them(result: CampaignResult) -> None:
    titles = [section.title for section in campaign_summary(result).sections]
    assert "Published result" in titles


def test_without_a_reference_nothing_is_said(tmp_path: Path) -> None:
    campaign, _ = load_campaign(jn.new_campaign(tmp_path / "mine"))
    assert campaign.reference is None


def test_an_update_that_is_not_there_is_refused(tmp_path: Path) -> None:
    file = jn.new_campaign(tmp_path / "mine")
    told = TOLD.replace('update = "stiffness, damping and friction"', 'update = "strategy 9"')
    file.write_text(file.read_text(encoding="utf-8") + told, encoding="utf-8")
    with pytest.raises(DescriptionError, match="reference names update 'strategy 9'"):
        load_campaign(file)
    with pytest.raises(DescriptionError):
        Reference.from_table({"source": ""}, where="reference")


def test_the_paper_is_beside_its_prototype() -> None:
    file = Path(jn.__file__).parent / "library" / "campaigns" / "kart-prototype" / "campaign.toml"
    reference = load_campaign(file)[0].reference
    assert [update.reduction for update in reference.update] == [0.314, 0.655, 0.52]
    assert [update.iterations for update in reference.update] == [4, 6, 3]
