"""``jounce kinematics`` and ``jounce adjust``: a suspension swept over travel, rack or roll, and its adjustments."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    ANGLE,
    AsJson,
    Force,
    RigName,
    chosen_rig,
    optional_quantity,
)
from jounce.cli.reply import Reply, progress, show_findings, show_written, table
from jounce.core.errors import DescriptionError
from jounce.core.typed import bare_number, pairs

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.design.adjustments import Effect, Lengths, OverTravel, WheelState


_FACTORS = {"m": (1e3, "mm"), "rad": (57.29577951308232, "deg"), "rad/m": (0.05729577951308232, "deg/mm")}


def adjust(
    rig: RigName,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="SETTING=VALUE", help='Adjust a setting: upper_arm_length="10 mm". Repeat it.'),
    ] = None,
    camber: Annotated[
        str | None,
        typer.Option(help='Find the length of an arm or link for this camber, top outward positive: "-2 deg".'),
    ] = None,
    toe: Annotated[
        str | None, typer.Option(help='Find the tie-rod length for this toe, toe-in positive: "0.5 deg".')
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write the adjusted rig, with its comments: RIG.toml.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Show the effect of the prototype's adjustments, apply them, or find the lengths for a camber and a toe.

    Example: jounce adjust kart-double-wishbone --camber "-2 deg" --toe "0.5 deg" --out cambered.toml
    """
    from jounce.core.serialise import to_plain
    from jounce.core.writing import check_writable, write_atomically
    from jounce.design.adjustments import SETTINGS, adjust_report, lengths_for
    from jounce.parts import rig_path
    from jounce.parts.files import updated_text

    given = {name: bare_number(value) for name, value in pairs(set_, "--set", 'upper_arm_length="10 mm"').items()}
    if out is not None:
        check_writable(out, what="rigs", suffixes=(".toml",), force=force)
    chosen, lengths = chosen_rig(rig, {}), None
    if camber is not None or toe is not None:
        wished = ((camber, "--camber"), (toe, "--toe"))
        lengths = lengths_for(chosen, *(optional_quantity(text, "rad", name, most=ANGLE) for text, name in wished))
        for name in given:
            if name == "camber_plate" or (name.endswith("_length") and name != "pushrod_length"):
                hint = "Leave it out, or --camber and --toe."
                raise DescriptionError("a length to be found is also given", where=f"--set {name}", hint=hint)
        given |= lengths.settings()
    if out is not None and not given:
        raise DescriptionError("nothing to adjust", where="--out", allowed="--set, --camber or --toe beside it")
    with progress() as say:
        say("sweeping")
        report = adjust_report(chosen, given, effects=not given)
    if out is not None:
        write_atomically(out, updated_text(rig_path(rig).read_text(encoding="utf-8"), report.rig), force=force)
    sources = {name: {"text": item.text, "source": item.source} for name, item in SETTINGS.items()}
    plain = {
        "rig": rig,
        "settings": report.settings,
        "lengths": to_plain(lengths),
        "before": to_plain(report.before),
        "after": to_plain(report.after),
        "over_travel": to_plain(report.over_travel),
        "effects": [{**to_plain(effect), **sources[effect.setting]} for effect in report.effects],
        "findings": to_plain(list(report.findings)),
        "out": None if out is None else str(out),
    }
    return Reply(plain, lambda console: _draw_adjusted(console, plain, report, lengths), as_json)


def _draw_adjusted(console: Console, plain: dict[str, Any], report: Any, lengths: Lengths | None) -> None:
    from jounce.design.adjustments import SETTINGS, shown

    if plain["settings"]:
        made = ", ".join(f"{name} {shown(value, SETTINGS[name].unit)}" for name, value in plain["settings"].items())
        rows = _states(report.before, report.after)
        console.print(table(f"{plain['rig']} with {made}", ("quantity", "unit", "before", "after"), rows, text=(0, 1)))
    else:
        console.print(table(plain["rig"], ("quantity", "unit", "present"), _states(report.before), text=(0, 1)))
        _draw_effects(console, report.effects)
    _draw_over_travel(console, report.over_travel, changed=bool(plain["settings"]))
    if lengths is not None:
        console.print(f"reached: camber {shown(lengths.camber, 'rad')}, toe {shown(lengths.toe, 'rad')}")
    show_findings(console, report.findings)
    show_written(console, plain)


def _seen(value: float | None, unit: str, factor: float) -> float | None:
    """A value (SI) for people: nothing in place of what rounding leaves of it."""
    from jounce.plots.display import SMALLEST

    return None if value is None else 0.0 if abs(value) < SMALLEST.get(unit, 0.0) else value * factor


def _draw_over_travel(console: Console, found: OverTravel, *, changed: bool) -> None:
    """Quantities over travel, each before and after."""
    from jounce.core.display import display_unit
    from jounce.design.adjustments import OVER_TRAVEL

    rows = []
    for name in found.before:
        factor, people = _FACTORS.get(unit := OVER_TRAVEL[name], (1.0, unit))
        for when, values in (("before", found.before), ("after", found.after))[: 2 if changed else 1]:
            label = (name.replace("_", " "), people) if when == "before" else ("", "")
            cells = (_seen(value, unit, factor) for value in values[name])
            rows.append((*label, *((when,) if changed else ()), *cells))
    along = display_unit("m")
    places = (f"{travel * along.factor:.4g} {along.name}" for travel in found.travel)
    header = ("quantity", "unit", *(("",) if changed else ()), *places)
    console.print(table("Over wheel travel, bump positive", header, rows, text=(0, 1, 2) if changed else (0, 1)))


def _states(*states: WheelState) -> list[tuple[object, ...]]:
    from jounce.design.adjustments import QUANTITIES

    rows: list[tuple[object, ...]] = []
    for name, unit in QUANTITIES.items():
        factor, people = _FACTORS.get(unit, (1.0, unit))
        values = (getattr(state, name) for state in states)
        rows.append((name.replace("_", " "), people, *(_seen(value, unit, factor) for value in values)))
    return rows


def _draw_effects(console: Console, effects: tuple[Effect, ...]) -> None:
    """One table: what each setting changes from the lowest to the highest value of its range, and per mm, deg or N."""
    from jounce.design.adjustments import QUANTITIES

    units = {name: _FACTORS.get(unit, (1.0, unit)) for name, unit in QUANTITIES.items()}
    rows: list[tuple[object, ...]] = []
    for effect in effects:
        factor, people = _FACTORS.get(effect.unit, (1.0, effect.unit))
        rows.append((effect.setting, *([""] * len(QUANTITIES))))
        for value, state in ((effect.lowest, effect.at_lowest), (effect.highest, effect.at_highest)):
            values = [getattr(state, name, None) for name in QUANTITIES]
            rows.append((f"    {value * factor:.4g} {people}", *_scaled(values, [units[n][0] for n in QUANTITIES])))
        slopes = [effect.per_unit[name] for name in QUANTITIES]
        rows.append((f"    per {people}", *_scaled(slopes, [units[n][0] / factor for n in QUANTITIES])))
    header = ("setting", *(f"{name.replace('_', ' ')} {units[name][1]}" for name in QUANTITIES))
    console.print(table("Effect of each setting: at both ends of its range, and per unit", header, rows))


def _scaled(values: list[float | None], factors: list[float]) -> list[float | None]:
    return [None if value is None else value * factor for value, factor in zip(values, factors, strict=True)]


def _shown(name: str, value: float) -> str:
    from jounce.design.adjustments import SETTINGS, shown

    return shown(value, SETTINGS[name].unit)
