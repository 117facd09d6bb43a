"""Results of campaigns side by side: objectives, updated parameters with their intervals, and verdicts."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

from jounce.core.display import display_unit
from jounce.core.errors import DescriptionError
from jounce.core.numbers import number
from jounce.core.shown import Shown
from jounce.core.tables import TextTable

SCHEMA = "jounce.results/1"
_LARGEST = 100_000_000  # bytes of a file of results
_DIGITS = 4


@dataclass(frozen=True)
class ComparedResult:
    """One quantity of several campaigns.

    Attributes
    ----------
    name : str
        Update and quantity, such as ``strategy 1: strut.spring.rate``.
    unit : str
        SI unit of the values; ``%`` for shares, empty for counts.
    values : tuple of float or None
        Value of each campaign in ``unit``; None where a campaign has none.
    intervals : tuple of (tuple of float) or None
        95 % interval of each value, in ``unit``; None without an interval.
    """

    name: str
    unit: str
    values: tuple[float | None, ...]
    intervals: tuple[tuple[float, float] | None, ...]

    def cells(self) -> tuple[tuple[str, ...], str]:
        """Write values and intervals in their display unit; and that unit."""
        present = [abs(value) for value in self.values if value is not None]
        factor, unit = 1.0, self.unit
        if unit not in ("", "%"):
            shown = display_unit(unit, max(present, default=0.0))
            factor, unit = shown.factor, shown.name
        texts = []
        for value, interval in zip(self.values, self.intervals, strict=True):
            is_count = self.unit == "" and value is not None
            text = f"{value:g}" if is_count else number(value and value * factor, _DIGITS)
            if interval is not None:
                low, high = (number(end * factor, _DIGITS) for end in interval)
                text += f" ({low} … {high})"
            texts.append(text)
        return tuple(texts), unit


@dataclass(frozen=True)
class ComparedResults(Shown):
    """Results of several campaigns, quantity by quantity.

    Attributes
    ----------
    names : tuple of str
        Names of the results.
    rows : tuple of ComparedResult
        Objective and parameters of each update, then what the trials show.
    """

    names: tuple[str, ...]
    rows: tuple[ComparedResult, ...]

    def __str__(self) -> str:
        return str(self.table())

    def table(self) -> TextTable:
        """Return a table with a column per campaign, in display units."""
        cells = ((row.name, row.cells()) for row in self.rows)
        rows = [(name, *values, unit) for name, (values, unit) in cells]
        return TextTable("Results", ("quantity", *self.names, "unit"), rows)

    def to_dict(self) -> dict[str, Any]:
        """Return names and rows as plain data; numbers in SI units."""
        rows = [
            {
                "name": row.name,
                "unit": row.unit,
                "values": list(row.values),
                "intervals": [interval and list(interval) for interval in row.intervals],
            }
            for row in self.rows
        ]
        return {"names": list(self.names), "rows": rows}


def compare_results(results: Mapping[str, Path | str | Mapping[str, Any]]) -> ComparedResults:
    """List what campaigns found, side by side: objectives, updated parameters, and how well trials are predicted.

    Parameters
    ----------
    results : mapping of str to Path, str or mapping
        Two or more results by name: files ``results.json`` of campaigns, or their content as `CampaignResult.to_dict`
        returns it.

    Returns
    -------
    ComparedResults
        Updates of one name share their rows. Objectives are of each campaign's own kind (its weights and trials), so
        they are comparable only between campaigns that have these in common.

    Raises
    ------
    DescriptionError
        For fewer than two results, and a file that contains none.

    Examples
    --------
    >>> import jounce as jn
    >>> rate = {"value": 22e3, "interval": [21e3, 23e3], "unit": "N/m"}
    >>> update = {"name": "all", "objective_after": 0.2, "parameters": {"strut.spring.rate": rate}}
    >>> first = {"schema": "jounce.results/1", "updates": [update], "trials": []}
    >>> second = {"schema": "jounce.results/1", "updates": [], "trials": []}
    >>> print(jn.compare_results({"first": first, "second": second}))
    Results
    quantity                                first  second  unit
    ──────────────────────  ─────────────────────  ──────  ────
    all: objective                         0.2000       –
    all: strut.spring.rate  22.00 (21.00 … 23.00)       –  N/mm
    """
    if len(results) < 2:
        raise DescriptionError(
            "there is nothing to compare",
            where="results",
            found=len(results),
            allowed="at least two results of campaigns",
        )
    read = {name: _checked(name, given) for name, given in results.items()}
    rows = []
    for name in dict.fromkeys(name for quantities in read.values() for name in quantities):
        found = [quantities.get(name) for quantities in read.values()]
        unit = next(one[0] for one in found if one is not None)
        values = tuple(None if one is None else one[1] for one in found)
        rows.append(
            ComparedResult(
                name, unit, values, tuple(None if one is None else one[2] for one in found)
            )
        )
    return ComparedResults(tuple(read), tuple(rows))


_Quantity = tuple[str, float, tuple[float, float] | None]


def _checked(name: str, given: Path | str | Mapping[str, Any]) -> dict[str, _Quantity]:
    """Return the quantities of results, or refuse what contains none."""
    where = str(given) if isinstance(given, Path | str) else name
    try:
        content = _read(given) if isinstance(given, Path | str) else given
        if content.get("schema") == SCHEMA:
            return dict(_quantities(content))
    except OSError as error:
        raise DescriptionError("no such file", where=where, hint=error.strerror or "") from None
    except (ValueError, TypeError, AttributeError, LookupError):
        pass  # another kind of file, or a damaged one
    raise DescriptionError(
        "not the results of a campaign",
        where=where,
        allowed="the file results.json that a run writes",
    )


def _read(file: Path | str) -> Any:
    with Path(file).open("rb") as stream:
        return json.loads(stream.read(_LARGEST))


def _quantities(results: Mapping[str, Any]) -> Iterator[tuple[str, _Quantity]]:
    """Yield name, unit, value and interval of everything that is compared."""
    for update in results.get("updates", ()):
        own = update["name"]
        for key, unit, words in (
            ("objective_after", "1", "objective"),
            ("reduction_percent", "%", "reduction of the objective"),
        ):
            if isinstance(update.get(key), float):
                yield f"{own}: {words}", (unit, update[key], None)
        for name, estimate in update.get("parameters", {}).items():
            interval = estimate.get("interval")
            ends = (float(interval[0]), float(interval[1])) if interval else None
            yield f"{own}: {name}", (estimate["unit"], float(estimate["value"]), ends)
    trials = [trial for trial in results.get("trials", ()) if trial.get("channels")]
    if not trials:
        return
    yield "trials", ("", float(len(trials)), None)
    holding = sum(trial.get("verdict") == "holds" for trial in trials)
    yield "trials that validate the model", ("", float(holding), None)
    for channel in dict.fromkeys(name for trial in trials for name in trial["channels"]):
        measured = [trial["channels"][channel] for trial in trials if channel in trial["channels"]]
        for key, unit, words in (("nrmse", "%", "median NRMSE"), ("r2", "1", "median R²")):
            values = [one[key] for one in measured if isinstance(one.get(key), float)]
            if values:
                share = 100.0 if unit == "%" else 1.0
                yield f"{words}, {channel}", (unit, share * median(values), None)
