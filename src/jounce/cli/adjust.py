"""``jounce adjust``: the adjustments of the double-wishbone prototype."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force, RigName, bare_number, pairs
from jounce.cli.reply import Reply
from jounce.cli.rigs import chosen_rig
from jounce.cli.tables import show_findings, show_written, table
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.design.adjustment_effects import Effect, Lengths, WheelState
    from jounce.parts import DoubleWishbone

_FACTORS = {"m": (1e3, "mm"), "rad": (57.29577951308232, "deg"), "rad/m": (0.05729577951308232, "deg/mm")}


def adjust(
    rig: RigName,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="SETTING=VALUE", help='Make a setting: upper_arm_length="10 mm". Repeat it.'),
    ] = None,
    camber: Annotated[
        str | None, typer.Option(help='Find the arm length for this camber, top outward: "-2 deg".')
    ] = None,
    toe: Annotated[str | None, typer.Option(help='Find the tie rod for this toe, toe-in: "0.5 deg".')] = None,
    out: Annotated[Path | None, typer.Option(help="Write the adjusted rig, comments kept: RIG.toml.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Say what the prototype's adjustments do to a double wishbone, make them, or find the lengths for camber and toe.

    Example: jounce adjust kart-double-wishbone --camber "-2 deg" --toe "0.5 deg" --out cambered.toml
    """
    from jounce.core.serialise import check_writable, write_atomically
    from jounce.design.adjustment_effects import adjust_report, lengths_for

    given = {name: bare_number(value) for name, value in pairs(set_, "--set", 'upper_arm_length="10 mm"').items()}
    if out is not None:
        check_writable(out, force=force)
    chosen, lengths = chosen_rig(rig, {}), None
    if camber is not None or toe is not None:
        _refuse_both(given)
        wished = (None if value is None else bare_number(value) for value in (camber, toe))
        lengths = lengths_for(chosen, *wished)
        given |= lengths.settings()
    if out is not None and not given:
        raise DescriptionError("nothing is adjusted", where="--out", allowed="--set, --camber or --toe beside it")
    report = adjust_report(chosen, given, effects=not given)
    if out is not None:
        write_atomically(out, _text(rig, report.rig), force=force)
    plain = _plain(rig, report, lengths, out)
    return Reply(plain, lambda console: _draw(console, plain, report, lengths), as_json)


def _refuse_both(given: dict[str, Any]) -> None:
    """Lengths that are looked for cannot be given, too."""
    for name in ("lower_arm_length", "upper_arm_length", "tie_rod_length"):
        if name in given:
            raise DescriptionError(
                "a length that is looked for is given",
                where=f"--set {name}",
                hint="Leave it out, or --camber and --toe.",
            )


def _text(name: str, rig: DoubleWishbone) -> str:
    """The rig's file with the new values."""
    from jounce.campaign.rig_text import updated_text
    from jounce.parts import rig_path

    return updated_text(rig_path(name).read_text(encoding="utf-8"), rig)


def _plain(rig: str, report: Any, lengths: Lengths | None, out: Path | None) -> dict[str, Any]:
    from jounce.core.serialise import to_plain
    from jounce.design.adjustments import SETTINGS

    sources = {name: {"text": item.text, "source": item.source} for name, item in SETTINGS.items()}
    return {
        "rig": rig,
        "settings": report.settings,
        "lengths": to_plain(lengths),
        "before": to_plain(report.before),
        "after": to_plain(report.after),
        "effects": [{**to_plain(effect), **sources[effect.setting]} for effect in report.effects],
        "findings": to_plain(list(report.findings)),
        "out": None if out is None else str(out),
    }


def _draw(console: Console, plain: dict[str, Any], report: Any, lengths: Lengths | None) -> None:
    findings: tuple[Finding, ...] = report.findings
    if plain["settings"]:
        made = ", ".join(f"{name} {_shown(name, value)}" for name, value in plain["settings"].items())
        title = f"{plain['rig']} with {made}"
        console.print(
            table(title, ("quantity", "unit", "before", "after"), _states(report.before, report.after), text=(0, 1))
        )
    else:
        console.print(table(plain["rig"], ("quantity", "unit", "as it is"), _states(report.before), text=(0, 1)))
        _draw_effects(console, report.effects)
    if lengths is not None:
        console.print(f"reached: camber {_degrees(lengths.camber)}, toe {_degrees(lengths.toe)}")
    show_findings(console, findings)
    show_written(console, plain)


def _states(*states: WheelState) -> list[tuple[object, ...]]:
    from jounce.design.adjustment_effects import QUANTITIES

    rows = []
    for name, unit in QUANTITIES.items():
        factor, people = _FACTORS.get(unit, (1.0, unit))
        values = [getattr(state, name) for state in states]
        rows.append((name.replace("_", " "), people, *(None if value is None else value * factor for value in values)))
    return rows


def _draw_effects(console: Console, effects: tuple[Effect, ...]) -> None:
    """One table: what each setting changes from the lowest to the highest value of its range, and per mm, deg or N."""
    from jounce.design.adjustment_effects import QUANTITIES

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
    console.print(table("What each setting does: at both ends of its range, and per unit", header, rows))


def _scaled(values: list[float | None], factors: list[float]) -> list[float | None]:
    return [None if value is None else value * factor for value, factor in zip(values, factors, strict=True)]


def _shown(name: str, value: float) -> str:
    from jounce.design.adjustments import SETTINGS, shown

    return shown(value, SETTINGS[name].unit)


def _degrees(value: float) -> str:
    from jounce.design.adjustments import shown

    return shown(value, "rad")
