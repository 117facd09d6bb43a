"""The shipped campaign, measured once for all tests: recordings of 1 s, all obstacles passed by then, to save time."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.campaign import run_campaign
from jounce.campaign.result import CampaignResult
from jounce.core.writing import write_files
from jounce.papers.virtual_bench import (
    BenchPlan,
    campaign_texts,
    measurement_texts,
    shipped_truth,
    truth_text,
)


@pytest.fixture(scope="session")
def shipped_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Descriptions, measurements, and the truth behind them."""
    folder = tmp_path_factory.mktemp("shipped")
    plan = BenchPlan(duration=1.0)
    truth = {"truth.toml": truth_text(plan, shipped_truth())}
    write_files(folder, {**campaign_texts(), **measurement_texts(plan), **truth})
    return folder


@pytest.fixture(scope="session")
def quick_look(shipped_folder: Path) -> tuple[CampaignResult, list[str]]:
    """Its quick look, and what was said meanwhile."""
    said: list[str] = []
    return run_campaign(shipped_folder / "quick-look.toml", progress=said.append), said
