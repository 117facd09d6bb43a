"""From a laboratory's raw folder to the values behind it, in two steps; the laboratory shares no code with jounce."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
import raw_laboratory as laboratory

import jounce as jn
from jounce.campaign import CampaignResult, FolderCampaign
from jounce.campaign.run import Runner, prepared_campaign
from jounce.core.errors import JounceError
from jounce.report.campaign import curves
from jounce.report.page import Details


@pytest.fixture(scope="module")
def lab() -> laboratory.Laboratory:
    return laboratory.drawn(3)


@pytest.fixture(scope="module")
def folder(lab: laboratory.Laboratory, tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("raw")
    laboratory.write(lab, place)
    laboratory.write_book(lab, place)
    return place


@pytest.fixture(scope="module")
def made(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> FolderCampaign:
    return jn.campaign_from_folder(tmp_path_factory.mktemp("made") / "campaign", folder)


@pytest.fixture(scope="module")
def result(made: FolderCampaign) -> CampaignResult:
    return jn.run_campaign(made.campaign)


@pytest.fixture(scope="module")
def runner(made: FolderCampaign) -> Runner:
    return prepared_campaign(made.campaign, lambda _text: None)[0]


def test_every_file_is_recognised(made: FolderCampaign) -> None:
    kinds = {
        kind: sorted(item.file.name for item in made.files if item.kind == kind)
        for kind in {i.kind for i in made.files}
    }
    assert {kind: len(names) for kind, names in kinds.items()} == {
        "trial": 16, "spring": 5, "tyre": 6, "decay": 2, "calibration": 2, "settings": 1, "table of trials": 1,
    }  # fmt: skip
    assert sorted(item.number for item in made.files if item.kind == "trial") == list(range(1, 17))
    assert not [item.doubt for item in made.files if item.doubt]


def test_all_passages_are_found_and_timed(lab: laboratory.Laboratory, runner: Runner) -> None:
    assert sorted(runner.loaded) == list(range(1, 17))
    for number, item in runner.loaded.items():
        true = laboratory.passages(lab, number - 1)
        found = np.array(item.facts.passages.times)
        late = np.array([time - true[np.argmin(np.abs(true - time))] for time in found])
        assert abs(len(found) - len(true)) <= 1, number  # one at an end may lie half outside
        assert np.ptp(late) < 2e-4, number
        assert np.max(np.abs(late)) < 3e-3, number
        mean = (len(true) - 1) * lab.belt.loop / (true[-1] - true[0])
        assert item.facts.speed == pytest.approx(mean, rel=1e-3)
        slip = 1.0 - item.facts.speed / item.facts.pulses
        assert slip == pytest.approx(lab.belt.slip, abs=3e-3)


def test_the_intervals_hold_what_is_true(
    lab: laboratory.Laboratory, result: CampaignResult
) -> None:
    assert result.is_complete, [str(item) for item in result.findings if item.severity == "problem"]
    truth = laboratory.truths(lab)
    parameters = result.strategies[0].update.discrepancy.parameters
    assert set(parameters) == set(truth)
    for path, found in parameters.items():
        assert found.interval[0] <= truth[path] <= found.interval[1], path
        if path == "tyre.damping_coefficient":  # little beside the damper's share at the wheel
            continue
        assert found.identified, path
        assert (
            found.interval[1] - found.interval[0]
            < (0.5 if "friction" in path else 0.2) * truth[path]
        ), path


def test_the_model_holds_in_all_trials(result: CampaignResult) -> None:
    assert [trial.entry.number for trial in result.trials if trial.after is None] == []
    assert {trial.after.verdict for trial in result.trials} == {"holds"}


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda place: (place / "settings.toml").unlink(), "no settings of the laboratory"),
        (lambda place: (place / "table.csv").unlink(), "no table of trials"),
        (
            lambda place: [file.unlink() for file in place.glob("P*.csv")],
            "no record of a trial was found",
        ),
        (
            lambda place: (place / "settings.toml").write_text(
                (place / "settings.toml").read_text().replace("100 mV/g", "100")
            ),
            "a sensitivity with its units is required",
        ),
        (
            lambda place: (place / "settings.toml").write_text(
                (place / "settings.toml").read_text().replace('unsprung_mass = "5 kg"\n', "")
            ),
            "sprung_mass and unsprung_mass are missing",
        ),
    ],
)
def test_what_is_missing_is_said(folder: Path, tmp_path: Path, change, what: str) -> None:
    place = tmp_path / "raw"
    shutil.copytree(folder, place)
    change(place)
    with pytest.raises(JounceError, match=what):
        jn.campaign_from_folder(tmp_path / "campaign", place)
    assert not (tmp_path / "campaign").exists()


def test_other_files_go_on_without_one(folder: Path, tmp_path: Path) -> None:
    place = tmp_path / "raw"
    shutil.copytree(folder, place)
    next(place.glob("*_05.csv")).unlink()
    next(place.glob("tyre_025_1.csv")).rename(place / "tyre_1.csv")
    (place / "notes.docx").write_bytes(b"PK")
    (place / "empty.csv").write_text("", encoding="utf-8")
    (place / "cal_laser.csv").write_text(
        "displacement [mm],ch3 [V]\n10,1.4\n10,1.5\n", encoding="utf-8"
    )
    made = jn.campaign_from_folder(tmp_path / "campaign", place)
    codes = {
        item.code.removeprefix("campaign."): item.place
        for item in made.findings
        if item.code != "campaign.file_left_out"
    }
    assert codes["no_record"] == "trial 5"
    assert codes["tyre_without_pressure"] == "tyre_1.csv"
    assert codes["stated_sensitivity_used"] == "cal_laser.csv"
    left_out = {item.place for item in made.findings if item.code == "campaign.file_left_out"}
    assert left_out == {"notes.docx", "empty.csv"}


def copy_with_trials(folder: Path, place: Path, numbers: tuple[int, ...]) -> Path:
    """Copy a laboratory's folder with the records of some trials only."""
    shutil.copytree(folder, place)
    for file in place.glob("P*.csv"):
        if int(file.stem[-2:]) not in numbers:
            file.unlink()
    return place


def exchange(place: Path, *numbers: int) -> None:
    """Let the records of two trials change their names."""
    first, second = (next(place.glob(f"*_{number:02d}.csv")) for number in numbers)
    first.rename(place / "swap")
    second.rename(first)
    (place / "swap").rename(second)


def test_exchanged_trials_are_named(folder: Path, tmp_path: Path) -> None:
    place = copy_with_trials(folder, tmp_path / "raw", (1, 2, 3))
    exchange(place, 1, 2)
    made = jn.campaign_from_folder(tmp_path / "campaign", place)
    runner, _, _ = prepared_campaign(made.campaign, lambda _text: None)
    (named,) = [item for item in runner.findings if item.code == "campaign.trials_exchanged"]
    assert named.place == "trials 1 and 2"


@pytest.fixture(scope="module")
def spoiled(
    lab: laboratory.Laboratory, folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> CampaignResult:
    """Three trials: one whose record holds noise only, one cut to less than a loop, one as it was."""
    place = copy_with_trials(folder, tmp_path_factory.mktemp("spoiled") / "raw", (1, 2, 3))
    records = {number: next(place.glob(f"*_{number:02d}.csv")) for number in (1, 2)}
    first, second = laboratory.passages(lab, 1)[:2]
    texts = {number: records[number].read_text(encoding="utf-8") for number in (1, 2)}
    records[1].write_text(_noise(texts[1]), encoding="utf-8")
    records[2].write_text(_short(texts[2], second + 0.6 * (second - first)), encoding="utf-8")
    made = jn.campaign_from_folder(place.parent / "campaign", place)
    return jn.run_campaign(made.campaign)


def _noise(text: str) -> str:
    """The record with its accelerations (the first two channels) shuffled, so that nothing of a passage is left."""
    header, *rows = text.splitlines()
    cells = [row.split(",") for row in rows]
    mixed = np.random.default_rng(1).permutation(len(cells))
    shuffled = [[own[0], *cells[i][1:3], *own[3:]] for own, i in zip(cells, mixed, strict=True)]
    return "\n".join([header, *map(",".join, shuffled)])


def _short(text: str, until: float) -> str:
    """The record up to an instant, s."""
    header, *rows = text.splitlines()
    return "\n".join([header, *(row for row in rows if float(row.split(",")[0]) < until)])


def test_an_obstacle_that_never_comes_is_drawn(spoiled: CampaignResult) -> None:
    (left_out,) = [item for item in spoiled.findings if item.code == "campaign.trial_left_out"]
    assert left_out.place == "trial 1"
    assert "the obstacle is not found in the record" in left_out.message
    sought = spoiled.sought[1]
    assert sought.likeness < 0.5
    assert (
        set(sought.record.data_vars)
        == set(sought.response.data_vars)
        == {"sprung.az", "unsprung.az"}
    )
    assert float(sought.response["time"][0]) < float(sought.record["time"][-1])
    drawn = [block for block in curves(spoiled).blocks if isinstance(block, Details)]
    (chart,) = [
        block for item in drawn for block in item.blocks if getattr(block, "name", "") == "sought-1"
    ]
    assert [panel.series[1].label for panel in chart.panels] == ["looked for", "looked for"]


def test_a_record_of_less_than_a_loop_is_compared_on_a_running_belt(
    spoiled: CampaignResult,
) -> None:
    (noted,) = [item for item in spoiled.findings if item.code == "campaign.no_whole_loop"]
    assert noted.place.startswith("trial 2")
    short = next(trial for trial in spoiled.trials if trial.entry.number == 2)
    assert min(channel.r2 for channel in short.after.channels.values()) > 0.97


def test_trials_of_one_speed_that_were_exchanged_are_named_by_their_obstacles(
    folder: Path, tmp_path: Path
) -> None:
    place = copy_with_trials(folder, tmp_path / "raw", (1, 2, 3, 14, 16))
    exchange(place, 14, 16)
    made = jn.campaign_from_folder(tmp_path / "campaign", place)
    result = jn.run_campaign(made.campaign)
    (named,) = [item for item in result.findings if "exchanged" in item.code]
    assert (named.code, named.place) == ("campaign.better_exchanged", "trials 14 and 16")
    assert min(named.numbers["first"], named.numbers["second"]) > 0.9


def test_a_belt_that_nobody_measured_is_measured_by_its_pulses(
    lab: laboratory.Laboratory, folder: Path, tmp_path: Path
) -> None:
    place = copy_with_trials(folder, tmp_path / "raw", (1, 2, 3))
    settings = place / "settings.toml"
    text = settings.read_text(encoding="utf-8")
    assert 'length = "1.97 m", ' in text
    settings.write_text(text.replace('length = "1.97 m", ', ""), encoding="utf-8")
    made = jn.campaign_from_folder(tmp_path / "campaign", place)
    runner, _, _ = prepared_campaign(made.campaign, lambda _text: None)
    (found,) = [item for item in runner.findings if item.code == "campaign.belt_length_found"]
    assert found.value == pytest.approx(
        1.97 / (1.0 - lab.belt.slip), rel=3e-3
    )  # by pulses: slip counts in it
    assert all(item.trial.road.recurrence == found.value for item in runner.loaded.values())
