"""Models of an update beside each other."""

from __future__ import annotations

from pathlib import Path

import pytest

import jounce as jn
from jounce.campaign.model_choice import ModelChoice
from jounce.core.errors import DescriptionError, FitError


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return jn.new_campaign(tmp_path_factory.mktemp("mine") / "mine")


@pytest.fixture(scope="module")
def found(file: Path) -> ModelChoice:
    return jn.compare_campaign_models(file)


def test_each_model_is_judged(found: ModelChoice) -> None:
    assert {row.model for row in found.models} == {
        "one tyre stiffness", "one tyre stiffness, no friction", "cubic tyre", "cubic tyre, no friction",
    }  # fmt: skip
    assert found.models[0].aic == 0.0
    assert min(row.bic for row in found.models) == 0.0
    assert [row.aic for row in found.models] == sorted(row.aic for row in found.models)
    rows = {row.model: row for row in found.models}
    assert (
        rows["one tyre stiffness"].parameters
        == rows["one tyre stiffness, no friction"].parameters + 1
    )
    assert all(row.trials == 2 for row in found.models)


def test_a_model_without_the_friction_of_the_bench_is_not_carried(found: ModelChoice) -> None:
    rows = {row.model: row for row in found.models}
    without, with_it = rows["one tyre stiffness, no friction"], rows["one tyre stiffness"]
    assert without.aic > with_it.aic + 100.0
    assert without.bic > with_it.bic + 100.0
    assert without.fitted < with_it.fitted
    assert without.held_out < with_it.held_out


def test_what_is_not_there_is_refused(file: Path, tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="unknown update 'u'"):
        jn.compare_campaign_models(file, "u")
    text = file.read_text(encoding="utf-8")
    bare = file.parent / "bare.toml"
    bare.write_text(text[: text.index("[[update]]")], encoding="utf-8")
    with pytest.raises(FitError, match="no update"):
        jn.compare_campaign_models(bare)
