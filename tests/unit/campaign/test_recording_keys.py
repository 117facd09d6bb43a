"""Trials and bench tables say of their files what files do not say themselves: columns, clock, steps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.campaign.characterise import read_force_deflection
from jounce.campaign.description import DecayBench, StiffnessBench, TrialEntry
from jounce.core.errors import DescriptionError

TIME = np.concatenate(
    (np.arange(1500) * 0.001, 1.503 + np.arange(1500) * 0.001)
)  # two samples are missing
WAVE = np.sin(2.0 * np.pi * 1.4 * TIME)


def written(file: Path, header: str, *columns: np.ndarray) -> Path:
    rows = (
        ";".join(f"{value:.9g}".replace(".", ",") for value in row)
        for row in zip(*columns, strict=True)
    )
    file.write_text("\n".join([header, *rows]))
    return file


@pytest.mark.parametrize("kind", [TrialEntry, DecayBench])
def test_irregular_european_files_in_trials_and_decays(tmp_path: Path, kind: type) -> None:
    written(
        tmp_path / "a.csv",
        "Zeit (ms);Beschl (milli-g);Bemerkung",
        TIME * 1e3,
        WAVE * 200.0,
        TIME * 0.0,
    )
    needed = (
        {"number": 1, "road": "bump", "speed": 2.0, "recording": "a.csv"}
        if kind is TrialEntry
        else {"files": ["a.csv"]}
    )
    entry = kind.from_table(
        {**needed, "columns": {"time": "Zeit", "sprung.az": "Beschl"}, "resample": "2 ms"},
        where="campaign.toml",
    )
    run, findings = entry.read(tmp_path / "a.csv", tmp_path)
    np.testing.assert_allclose(np.diff(run["time"]), 0.002, rtol=1e-9)
    expected = 0.2 * 9.80665 * np.sin(2.0 * np.pi * 1.4 * run["time"].to_numpy())
    np.testing.assert_allclose(run["sprung.az"][20:-20], expected[20:-20], rtol=0.0, atol=1e-3)
    said = " ".join(finding.message for finding in findings)
    assert "decimal commas" in said
    assert "the largest gap in the recorded time is 0.004 s" in said
    with pytest.raises(DescriptionError, match=r"campaign\.toml: resample: wrong unit"):
        kind.from_table({**needed, "resample": "2 mm"}, where="campaign.toml")


def test_bench_tables_choose_a_variable(tmp_path: Path) -> None:
    from scipy.io import savemat

    savemat(
        tmp_path / "a.mat",
        {"first": {"displacement": WAVE[:500], "force": 5.0 * WAVE[:500]}, "other": WAVE},
    )
    table = StiffnessBench(
        files=("a.mat",),
        variable="first",
        columns={"displacement": "displacement [mm]", "force": "force [N]"},
    )
    (trial,), _ = read_force_deflection([tmp_path / "a.mat"], table)
    np.testing.assert_allclose(trial.force, 5.0 * WAVE[:500])
    np.testing.assert_allclose(trial.deflection, 1e-3 * WAVE[:500])
