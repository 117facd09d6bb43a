"""One bad file of a bench campaign is one finding: everything else is evaluated, whatever the file does."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from corpus import recordings

from jounce.campaign import new_campaign, run_campaign
from jounce.cli import main

Damage = Callable[[bytes], bytes]


def lines_of(content: bytes) -> list[str]:
    return content.decode().splitlines()


def with_times(factor: float) -> Damage:
    def damage(content: bytes) -> bytes:
        comment, head, *rows = lines_of(content)
        cells = (row.split(",", 1) for row in rows)
        return "\n".join(
            [comment, head, *(f"{factor * float(time):.10g},{rest}" for time, rest in cells)]
        ).encode()

    return damage


def with_header(old: str, new: str) -> Damage:
    return lambda content: content.replace(old.encode(), new.encode(), 1)


def with_values(number: str) -> Damage:
    def damage(content: bytes) -> bytes:
        comment, head, *rows = lines_of(content)
        return "\n".join(
            [comment, head, *(f"{row.split(',')[0]},{number},{number}" for row in rows)]
        ).encode()

    return damage


DAMAGES: dict[str, Damage] = {
    "empty": lambda _: b"",
    "rubbish": lambda _: np.random.default_rng(1).bytes(2000),
    "cut within a row": lambda content: content[
        : content.rindex(b",", 0, content.index(b"\n", 500))
    ],
    "two rows": lambda content: "\n".join(lines_of(content)[:4]).encode(),
    "seconds that are milliseconds": with_times(1e3),
    "hours": with_times(3.6e6),
    "time that stands still": with_times(0.0),
    "time backwards": with_times(-1.0),
    "a huge time": with_times(1e25),
    "a long header": with_header("unsprung.az", "x" * 200_000),
    "a bomb of a unit": with_header("[m/s^2]", "[m^9**9**9**9]"),
    "a different unit": with_header("[m/s^2]", "[kg]"),
    "huge values": with_values("1e300"),
    "large values": with_values("1e25"),
    "constant": with_values("0"),
    "no numbers": with_values("nan"),
}


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The shipped template, its recordings cut to half a second: the wheel is over the bump by then."""
    file = new_campaign(tmp_path_factory.mktemp("campaign") / "c")
    for trial in (file.parent / "trials").iterdir():
        trial.write_text("\n".join(trial.read_text().splitlines()[:503]) + "\n")
    return file


@pytest.fixture
def damaged(campaign: Path, request: pytest.FixtureRequest) -> Callable[[str, Damage], Path]:
    """Damage one file of the campaign, and put it back afterwards."""

    def damage(name: str, change: Damage) -> Path:
        file = campaign.parent / name
        whole = file.read_bytes()
        request.addfinalizer(lambda: file.write_bytes(whole))
        file.write_bytes(change(whole))
        return file

    return damage


def _used(result) -> set[int]:
    return {trial.entry.number for trial in result.trials if trial.after is not None}


@pytest.mark.parametrize(
    "damage",
    [pytest.param(x, marks=[pytest.mark.slow] if k % 3 else []) for k, x in enumerate(DAMAGES)],
)
@pytest.mark.some(2)
def test_one_bad_trial(campaign: Path, damaged, damage: str) -> None:
    damaged("trials/02.csv", DAMAGES[damage])
    result = run_campaign(campaign)
    problems = [finding for finding in result.findings if finding.severity == "problem"]
    assert any("trial 2" in finding.place for finding in problems)
    assert {1, 4} <= _used(result)
    assert all(len(finding.message) < 4500 for finding in problems)
    assert len(result.strategies) == 1
    assert not any("an unexpected reason" in finding.message for finding in problems)


@pytest.mark.parametrize(
    "damage", ["empty", "rubbish", "cut within a row", "a bomb of a unit", "huge values"]
)
@pytest.mark.parametrize(
    "table",
    ["tyre_031_2", *(pytest.param(x, marks=pytest.mark.slow) for x in ("spring_1", "decay_1"))],
)
@pytest.mark.some(2)
def test_one_bad_bench_file(campaign: Path, damaged, table: str, damage: str) -> None:
    change = DAMAGES[damage] if damage != "a bomb of a unit" else with_header("mm", "m^9**9**9**9")
    damaged(f"bench/{table}.csv", change)
    result = run_campaign(campaign)
    problems = [finding for finding in result.findings if finding.severity == "problem"]
    assert any(finding.place.startswith("bench.") for finding in problems)
    assert _used(result) == {1, 2, 4}
    assert not any("an unexpected reason" in finding.message for finding in problems)


@pytest.mark.parametrize("sample", ["mat5", "mat73", "tdms"])
@pytest.mark.some(3)
def test_a_binary_recording_cut_off(campaign: Path, damaged, sample: str) -> None:
    made = recordings.sample(sample)
    other = campaign.parent / "trials" / made.name
    other.write_bytes(made.content[: len(made.content) // 3])
    text = campaign.read_bytes()
    damaged(
        campaign.name,
        lambda content: content.replace(b"trials/02.csv", f"trials/{made.name}".encode()),
    )
    assert text != campaign.read_bytes()
    result = run_campaign(campaign)
    assert any(
        finding.place == "trial 2" and finding.severity == "problem" for finding in result.findings
    )
    assert _used(result) == {1, 4}


def test_what_nobody_foresaw_is_a_finding_too(
    campaign: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from jounce.recordings import files

    read = files.read_recording

    def fails(file: Path, **told: object):
        if Path(file).name == "02.csv":
            raise ZeroDivisionError("x" * 10_000)
        return read(file, **told)

    monkeypatch.setattr(files, "read_recording", fails)
    result = run_campaign(campaign)
    (problem,) = (finding for finding in result.findings if finding.severity == "problem")
    assert problem.place == "trial 2"
    assert "ZeroDivisionError: xxx" in problem.message
    assert len(problem.message) < 600
    assert _used(result) == {1, 4}


def test_the_command_goes_on_and_says_so(campaign: Path, damaged, tmp_path: Path, capsys) -> None:
    damaged("trials/02.csv", DAMAGES["seconds that are milliseconds"])
    assert main(["campaign", "run", str(campaign), "--out", str(tmp_path / "results")]) == 1
    assert (tmp_path / "results" / "results.json").is_file()
    assert "trial 2" in capsys.readouterr().out
