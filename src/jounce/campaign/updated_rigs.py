"""Rig files of a campaign: the described file with measured and fitted values, and the origin of each value."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence

import tomlkit

from jounce.campaign.characterise import TYRE_PATHS, Characterisation
from jounce.campaign.description import Campaign
from jounce.campaign.strategy_result import StrategyResult
from jounce.core.text import in_one_line
from jounce.core.toml_comments import annotate, without_head
from jounce.core.units import to_si
from jounce.parts import Rig, rig_from_table
from jounce.parts.files import updated_text
from jounce.parts.rig import split_path, unit_of

_OF_THE_PART = "Intervals of the part count what the model lacks; a fitted value makes up for it and may lie outside."


def pressures_of(campaign: Campaign) -> dict[str, float | None]:
    """Return the tyre pressures of the trials (Pa) by name; the name is empty for a single or unknown pressure."""
    names = {to_si(name, "Pa"): name for name in campaign.bench.tyre}
    run_at = dict.fromkeys(entry.tyre_pressure for entry in campaign.trial)
    if len(run_at) == 1:
        return {"": None}
    return {"" if p is None else names.get(p, f"{p / 1e6:g} MPa"): p for p in run_at}


def updated_rigs(
    campaign: Campaign, text: str, bench: Characterisation, chain: Sequence[StrategyResult]
) -> dict[str, str]:
    """Return the text of a rig file for each tyre pressure, after the last of several consecutive updates.

    ``text`` is the campaign's rig file. Measured and fitted values get a comment with their 95 % interval; ``source``
    and ``estimated`` are rewritten, and existing comments on changed values are dropped.
    """
    return {
        label: _rig_text(campaign, text, bench, chain, pressure)
        for label, pressure in pressures_of(campaign).items()
    }


def _rig_text(
    campaign: Campaign,
    text: str,
    bench: Characterisation,
    chain: Sequence[StrategyResult],
    pressure: float | None,
) -> str:
    name, known = chain[-1].update.name, chain[-1].knowledge
    described = rig_from_table(tomllib.loads(text))
    rig = known.rig_for(None, pressure, {})
    origins = _origins(campaign, bench, chain, pressure, rig)
    replaced = tuple(origins)
    origin = "synthetic recordings" if campaign.synthetic else "measured and fitted"
    rig = rig.model_copy(
        update={
            "source": f"Campaign {campaign.title!r}, {name} ({origin}); what bears no comment: "
            + (described.source or "no source given"),
            "estimated": tuple(
                entry for entry in described.estimated if not _is_replaced(entry, replaced, rig)
            ),
        }
    )
    document = tomlkit.parse(updated_text(text, rig))
    document["source"] = rig.source
    if rig.estimated != described.estimated:
        document["estimated"] = list(rig.estimated)
    for path, words in origins.items():
        annotate(document, split_path(path), words)
    tyre = "" if pressure is None else f", with the tyre at {pressure / 1e6:g} MPa"
    head = [
        f"The rig after {name} of the campaign {campaign.title!r}{tyre}.",
        "Comments say what was measured and fitted, with 95 % intervals; the rest is as in the campaign's rig file.",
        *(
            [_OF_THE_PART]
            if any(strategy.update.discrepancy is not None for strategy in chain)
            else []
        ),
        *([campaign.synthetic] if campaign.synthetic else []),
    ]
    return (
        "\n".join(f"# {in_one_line(line)}" for line in head)
        + "\n"
        + without_head(tomlkit.dumps(document))
    )


def _is_replaced(name: str, origins: Sequence[str], rig: Rig) -> bool:
    """Whether every number covered by an entry of ``estimated`` was measured or fitted."""
    below = [
        path
        for path in rig.parameters()
        if path == name or path.startswith((f"{name}.", f"{name}["))
    ]
    return bool(below) and all(
        any(path == origin or path.startswith((f"{origin}.", f"{origin}[")) for origin in origins)
        for path in below
    )


def _origins(
    campaign: Campaign,
    bench: Characterisation,
    chain: Sequence[StrategyResult],
    pressure: float | None,
    rig: Rig,
) -> dict[str, str]:
    """Return the origin of values by path: the bench, overridden by each update in sequence."""
    words = dict(_bench_origins(bench, pressure, rig))
    at = {entry.number: entry.tyre_pressure for entry in campaign.trial}
    laws = {entry.name: entry.tyre_law for entry in campaign.update}
    for strategy in chain:
        name, fitted_at = strategy.update.name, [at[number] for number in strategy.fitted_on]
        if laws[name] == "polynomial":
            words = {path: text for path, text in words.items() if not path.startswith(TYRE_PATHS)}
            words["tyre.curve"] = (
                f"measured: cubic through the curve of bench.tyre at {_pressure_text(pressure)}"
            )
        here = strategy.knowledge.rig_for(None, pressure, {}).parameters()
        for path, p in strategy.update.parameters.items():
            of_tyre = path.startswith(TYRE_PATHS)
            if of_tyre and pressure is not None and pressure not in fitted_at:
                continue
            factor = here[path] / p.value if of_tyre and p.value else 1.0
            if p.interval is None:
                interval = "at its bound" if p.at_bound else "no interval"
            else:
                interval = f"95 % {_range(p.interval, factor)}{_unit(rig, path)} (noise only)"
            discrepancy = strategy.update.discrepancy
            if discrepancy is not None:
                law = discrepancy.parameters[path]
                verdict = "" if law.identified else ", not identified with this model"
                interval += (
                    f"; of the part 95 % {_range(law.interval, factor)}{_unit(rig, path)}{verdict}"
                )
            words[path] = f"fitted: {name}; {interval}"
    return words


def _range(interval: tuple[float, float], factor: float) -> str:
    """Format the scaled ends of an interval; 118173 is easier to read than 1.1817e+05."""
    return " to ".join(f"{factor * end:.6g}" for end in interval)


def _bench_origins(
    bench: Characterisation, pressure: float | None, rig: Rig
) -> Iterator[tuple[str, str]]:
    for item in bench.replaced:
        if item.source.startswith("bench.tyre"):
            measured_at = to_si(item.source.split('"')[1], "Pa")
            if pressure is not None and measured_at != pressure:
                continue
        spread = (
            ""
            if item.standard_error is None
            else f" +- {1.96 * item.standard_error:.3g}{_unit(rig, item.path)} (95 %)"
        )
        yield item.path, f"measured: {item.source}{spread}"


def _unit(rig: Rig, path: str) -> str:
    """Return a space and the unit of a parameter; empty for dimensionless values and curves."""
    unit = unit_of(rig, path) if path in rig.parameters() else "1"
    return "" if unit == "1" else f" {unit}"


def _pressure_text(pressure: float | None) -> str:
    return "its pressure" if pressure is None else f"{pressure / 1e6:g} MPa"
