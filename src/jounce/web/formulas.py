"""Computed channels of a layout: each is computed once for each recording, in a process of its own, and stored."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from jounce.analysis.layouts import TIME, Formula
from jounce.core.errors import JounceError
from jounce.core.phrases import german_of
from jounce.core.units import unit_factor
from jounce.web.levels import Levels, write_channel


def stems_of(formulas: Sequence[Formula]) -> list[str]:
    """Return the names of the files that store the results; they change with what a formula uses of those above."""
    from jounce.analysis.formula_text import channels_in

    stems: dict[str, str] = {}
    for formula in formulas:
        try:
            above = [stems[name] for name in channels_in(formula.formula, list(stems))]
        except JounceError:
            above = []
        text = json.dumps([formula.formula, formula.unit, above])
        stems[formula.name] = f"f-{sha256(text.encode()).hexdigest()[:20]}"
    return list(stems.values())


def is_computed(folder: Path, stem: str) -> bool:
    """Whether a formula was computed or refused."""
    return (folder / f"{stem}.json").is_file()


def with_formulas(
    levels: Levels, formulas: Sequence[Formula]
) -> tuple[Levels, list[dict[str, Any]]]:
    """Return a record with its computed channels, and the state of each formula: problem, unit, and findings."""
    channels, states = list(levels.about["channels"]), []
    for formula, stem in zip(formulas, stems_of(formulas), strict=True):
        state = json.loads((levels.folder / f"{stem}.json").read_text(encoding="utf-8"))
        if any(channel["name"] == formula.name for channel in levels.about["channels"]):
            state = _refused("the recording has a channel of this name")
        states.append({"name": formula.name, **state})
        if state["problem"] is None:
            channels.append({"name": formula.name, "unit": state["unit"], "stem": stem})
    return Levels(levels.folder, {**levels.about, "channels": channels}), states


def write_formulas(asked: Mapping[str, Any]) -> dict[str, int]:
    """Compute the formulas of each record that are not stored yet, and store them with their findings."""
    formulas = [Formula(**formula) for formula in asked["formulas"]]
    records = asked["records"].items()
    return {"computed": sum(_write(Path(folder), path, formulas) for path, folder in records)}


def _write(folder: Path, path: str, formulas: Sequence[Formula]) -> int:
    """Compute the formulas of a record, each with those above it; return how many were not stored."""
    from jounce.analysis.formula import evaluate_formula

    levels = Levels(folder, json.loads((folder / "about.json").read_text(encoding="utf-8")))
    own = unit_factor(levels.about["unit"], "s", where=path)
    time = own * levels.axis_values(TIME, 0, int(levels.about["count"]))
    count = 0
    for k, stem in enumerate(stems_of(formulas)):
        if is_computed(folder, stem):
            continue
        with_above, _ = with_formulas(levels, formulas[:k])

        def channel(name: str, levels: Levels = with_above) -> tuple[Any, str]:
            return np.asarray(levels.samples(name), float), levels.unit(name)

        try:
            result = evaluate_formula(
                formulas[k].formula,
                channel,
                with_above.names,
                time,
                unit=formulas[k].unit,
                where=path,
            )
        except JounceError as error:
            message = error.message()
            state = _refused(str(message), german_of(message))
        else:
            write_channel(folder, stem, result.values)
            notes = [
                {"text": str(found), "german": f"{found.place}: {found.sentence('de')}"}
                for found in result.findings
            ]
            state = {"problem": None, "unit": result.unit, "notes": notes}
        (folder / f"{stem}.json").write_text(json.dumps(state), encoding="utf-8")
        count += 1
    return count


def _refused(text: str, german: str | None = None) -> dict[str, Any]:
    return {
        "problem": {"text": text, "german": german or german_of(text)},
        "unit": "",
        "notes": [],
    }
