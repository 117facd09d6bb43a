"""A first look at the records of a campaign, in its report and in its results."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.analysis.modes import oscillating
from jounce.campaign.characterise import Characterisation
from jounce.campaign.first_look import FirstLook, first_look
from jounce.campaign.result import CampaignResult
from jounce.report.chart import Chart
from jounce.report.first_look import records
from jounce.report.page import PageTable, Paragraph, blocks_in

TRUE_RIG = {"strut.damper.coefficient": 165.0, "tyre.stiffness": 125000.0}
"""What the recordings were made with; there is no dry friction."""


def test_modes_of_the_trials_are_those_of_the_rig_behind_them(result: CampaignResult) -> None:
    rig = result.rig.with_changes(TRUE_RIG)
    truth = oscillating(np.linalg.eigvals(jn.linearise(rig).A))
    found = [mode for mode in result.look.modes if mode.trials]
    assert [mode.trials for mode in found] == [(1, 2, 3)] * 2
    for mode, (frequency, ratio) in zip(found, truth, strict=True):
        assert mode.frequency.value == pytest.approx(frequency, rel=0.03)
        assert mode.damping_ratio.value == pytest.approx(ratio, rel=0.15)
        assert mode.readings_frequency == pytest.approx(mode.model_frequency, rel=0.03)


def test_each_decay_has_its_mode(result: CampaignResult) -> None:
    decays = [mode for mode in result.look.modes if mode.decay]
    assert [mode.decay for mode in decays] == ["decay 1", "decay 2"]
    for mode in decays:
        assert mode.frequency.value == pytest.approx(32.0 / (2.0 * np.pi), rel=0.02)
        assert mode.model_frequency is not None


def test_the_model_is_analysed_like_the_record(result: CampaignResult) -> None:
    (spectra,) = result.look.spectra
    assert spectra.trials == (1, 2, 3)
    assert spectra.transfer is not None
    assert spectra.model_transfer is not None
    seen = (spectra.transfer.frequency > 3.0) & (spectra.transfer.frequency < 12.0)
    assert np.allclose(spectra.transfer.gain[seen], spectra.model_transfer.gain[seen], rtol=0.25)
    assert spectra.transfer.averages == 3.0


def test_statistics_are_those_of_the_records(result: CampaignResult) -> None:
    assert [trial.number for trial in result.look.statistics] == [1, 2, 3]
    record, _ = jn.read_recording(result.folder / "2.csv")
    row = next(row for row in result.look.statistics[1].channels if row.channel == "unsprung.az")
    assert row.maximum == pytest.approx(float(record["unsprung.az"].max()), rel=1e-9)
    assert set(result.look.statistics[1].clipped.values()) == {0.0}


def test_clipping_is_a_share(result: CampaignResult) -> None:
    record, _ = jn.read_recording(result.folder / "2.csv")
    limit = 0.3 * float(abs(record["sprung.az"]).max())
    cut = record.assign(
        {
            "sprung.az": record["sprung.az"]
            .clip(-limit, limit)
            .assign_attrs(record["sprung.az"].attrs)
        }
    )
    look = first_look(result.campaign, result.characterisation, result.start, {2: cut}, ())
    assert 0.01 < look.statistics[0].clipped["sprung.az"] < 0.9
    table = list(blocks_in(records(look).blocks))[-1]
    assert isinstance(table, PageTable)
    assert any("at its limits" in str(row) for row in table.rows)


def test_one_trial_has_spectra_without_coherence(result: CampaignResult) -> None:
    look = first_look(result.campaign, result.characterisation, result.start, {}, result.trials[:1])
    (spectra,) = look.spectra
    assert spectra.transfer is None
    charts = [block for block in blocks_in(records(look).blocks) if isinstance(block, Chart)]
    assert [len(chart.panels) for chart in charts] == [2]


def test_the_report_has_few_pictures_of_it(result: CampaignResult) -> None:
    blocks = list(blocks_in(records(result.look).blocks))
    assert [len(block.panels) for block in blocks if isinstance(block, Chart)] == [4]
    captions = [block.caption for block in blocks if isinstance(block, PageTable)]
    assert captions == [
        "Modes of the records and of the model",
        "Statistics of the channels",
    ]


def test_records_that_cannot_be_analysed_are_left_out(result: CampaignResult) -> None:
    record, _ = jn.read_recording(result.folder / "2.csv")
    gaps = record.assign({"sprung.az": record["sprung.az"].where(record["time"] > 0.5)})
    look = first_look(result.campaign, Characterisation(), result.start, {2: gaps}, ())
    assert look == FirstLook()
    assert isinstance(records(look).blocks[0], Paragraph)


def test_results_hold_modes_and_statistics(result: CampaignResult) -> None:
    plain = result.to_dict()["records"]
    assert set(plain) == {"statistics", "modes"}
    assert plain["modes"][0]["frequency"]["value"] > 1.0
