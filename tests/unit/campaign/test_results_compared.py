"""Results of campaigns side by side: parameters with intervals, objectives and verdicts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import jounce as jn
from jounce.core.errors import DescriptionError


def results(rate: float, *, name: str = "all", **more: Any) -> dict[str, Any]:
    spring = {"value": rate, "interval": [rate - 100.0, rate + 100.0], "unit": "N/m"}
    bound = {"value": 5.0, "interval": None, "unit": "N"}
    update = {
        "name": name,
        "objective_after": 1e-5 * rate,
        "reduction_percent": 50.0,
        "parameters": {"strut.spring.rate": spring, "strut.friction.force": bound},
    }
    trials = [
        {"verdict": verdict, "channels": {"sprung.az": {"nrmse": nrmse, "r2": 1.0 - nrmse}}}
        for verdict, nrmse in (("holds", 0.1), ("holds", 0.2), ("holds partly", 0.4))
    ]
    return {"schema": "jounce.results/1", "updates": [update], "trials": trials, **more}


def test_values_intervals_and_medians_stand_side_by_side(tmp_path: Path) -> None:
    file = tmp_path / "results.json"
    file.write_text(json.dumps(results(22_000.0)))
    found = jn.compare_results({"a": file, "b": results(23_000.0)})
    rows = {row.name: row for row in found.rows}
    rate = rows["all: strut.spring.rate"]
    assert rate.values == (22_000.0, 23_000.0)
    assert rate.intervals == ((21_900.0, 22_100.0), (22_900.0, 23_100.0))
    assert rate.cells() == (("22.00 (21.90 … 22.10)", "23.00 (22.90 … 23.10)"), "N/mm")
    assert rows["all: strut.friction.force"].intervals == (None, None)
    assert rows["all: objective"].values == pytest.approx((0.22, 0.23))
    assert rows["median NRMSE, sprung.az"].values == pytest.approx((20.0, 20.0))
    assert rows["trials that validate the model"].cells() == (("2", "2"), "")
    assert "22.00 (21.90 … 22.10)" in str(found)
    assert found.to_dict()["rows"][0]["values"] == pytest.approx([0.22, 0.23])


def test_updates_of_other_names_have_rows_of_their_own() -> None:
    found = jn.compare_results({"a": results(1e4), "b": results(1e4, name="other")})
    (row,) = (row for row in found.rows if row.name == "other: strut.spring.rate")
    assert row.values == (None, 1e4)
    assert row.cells()[0][0] == "–"


@pytest.mark.parametrize(
    "wrong",
    [{}, [], {"schema": "jounce.results/1", "updates": 5}, results(1.0, trials=[{"channels": 3}])],
)
def test_what_is_no_result_is_refused_by_its_name(wrong: Any) -> None:
    with pytest.raises(DescriptionError, match="b: not the results of a campaign"):
        jn.compare_results({"a": results(1e4), "b": wrong})


def test_a_missing_file_and_a_single_result_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="no such file"):
        jn.compare_results({"a": results(1e4), "b": tmp_path / "results.json"})
    with pytest.raises(DescriptionError, match="there is nothing to compare; found 1"):
        jn.compare_results({"a": results(1e4)})
