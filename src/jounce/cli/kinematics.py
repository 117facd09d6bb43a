"""``jounce kinematics`` and ``jounce adjust``: a suspension swept over travel, rack or roll, and its adjustments."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    ANGLE,
    AsJson,
    Changes,
    Force,
    ReportFile,
    RigName,
    bare_numbers,
    changes,
    check_outputs,
    chosen_rig,
    optional_quantity,
    write_report,
)
from jounce.cli.reply import DONE, REFUSED, Reply, progress, show_findings, show_written, table, tell
from jounce.core.errors import DescriptionError
from jounce.core.findings import not_drawn
from jounce.core.typed import bare_number, pairs

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from numpy.typing import NDArray
    from rich.console import Console

    from jounce.design.adjustments import Effect, Lengths, OverTravel, WheelState
    from jounce.kinematics.sweeps import AxleLayout
    from jounce.parts import Rig
    from jounce.report import Page


_SHOWN = 7


def kinematics(
    rig: RigName,
    travel: Annotated[
        str | None, typer.Option(help='Wheel travel, bump positive: "-80 mm:80 mm:4 mm", or a single value.')
    ] = None,
    rack: Annotated[
        str | None, typer.Option(help='Rack travel, positive to the left: "-20 mm:20 mm:5 mm", or a single value.')
    ] = None,
    roll: Annotated[
        str | None, typer.Option(help='Instead of --travel: body roll over an axle, "-4 deg:4 deg:1 deg".')
    ] = None,
    axle: Annotated[
        bool, typer.Option("--axle", help="With --rack only: both wheels of an axle, and Ackermann percentage.")
    ] = False,
    right: Annotated[
        str | None,
        typer.Option(metavar="RIG", help="The right corner of an axle that is no mirror image of the left one."),
    ] = None,
    left_travel: Annotated[
        str | None, typer.Option(help="Travel of the left wheel of an axle, pose by pose; --right-travel likewise.")
    ] = None,
    right_travel: Annotated[str | None, typer.Option(help="Travel of the right wheel, pose by pose.")] = None,
    heave: Annotated[
        str | None,
        typer.Option(help="Rise of the body above the road, pose by pose, together with --roll and --pitch."),
    ] = None,
    pitch: Annotated[str | None, typer.Option(help="Pitch of the body, nose down positive, pose by pose.")] = None,
    handwheel: Annotated[
        str | None,
        typer.Option(help='Angle of the handwheel, to the left positive, in place of --rack: "-90 deg:90 deg:15 deg".'),
    ] = None,
    poses: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv",
            help="Poses one by one, as a table or a log has them: columns travel and rack, or for an axle any of "
            "left_travel, right_travel, heave, roll, pitch, rack, handwheel, each with its unit in the header.",
        ),
    ] = None,
    vehicle: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help='Layout for anti-dive, anti-lift and anti-squat: axle=front, wheelbase="2.7 m", '
            'centre_of_mass_height="550 mm", brake_share=0.6. Repeat it.',
        ),
    ] = None,
    points: Annotated[
        bool, typer.Option("--points", help="With --travel or --rack: include the positions of all hardpoints.")
    ] = False,
    set_: Changes = None,
    out: Annotated[Path | None, typer.Option(help="Write the sweep: SWEEP.nc or SWEEP.csv.")] = None,
    figure: Annotated[Path | None, typer.Option(metavar="DIR", help="Plot every quantity into this folder.")] = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Sweep a suspension and list its kinematic quantities: camber, toe, roll centre, wheel rate and more.

    Example: jounce kinematics reference-double-wishbone --travel "-80 mm:80 mm:4 mm" --out sweep.nc
    """
    from jounce.kinematics.sweeps import SWEEP_FILES

    if out is not None:
        SWEEP_FILES.check(out, force=force)
    check_outputs(folder=figure, report=report, force=force)
    with progress() as say:
        say("loading")
        chosen = chosen_rig(rig, changes(set_))
        say("sweeping")
        both = {"left_travel": left_travel, "right_travel": right_travel, "heave": heave, "pitch": pitch}
        both |= {"handwheel": handwheel}
        if poses is not None:
            beside = {"--travel": travel, "--rack": rack, "--roll": roll}
            beside |= {f"--{name.replace('_', '-')}": value for name, value in both.items()}
            _refuse_beside({"--axle": axle, **{option: value is not None for option, value in beside.items()}})
            other = None if right is None else chosen_rig(right, {})
            sweep = _sweep_poses(chosen, other, poses, _vehicle(vehicle), points=points)
        elif right is not None or any(value is not None for value in both.values()):
            _refuse_beside({"--travel": travel is not None, "--axle": axle, "--points": points})
            other = None if right is None else chosen_rig(right, {})
            sweep = _sweep_both(chosen, other, {**both, "roll": roll, "rack": rack}, _vehicle(vehicle))
        else:
            sweep = _sweep(chosen, travel, rack, roll, _vehicle(vehicle), axle=axle, points=points)
        if out is not None:
            SWEEP_FILES.write(sweep, out, force=force)
        missing = []
        if figure is not None:
            say("drawing")
            try:
                from jounce.plots.kinematics import write_kinematics

                write_kinematics(sweep, figure, force=force)
            except Exception as error:  # noqa: BLE001 - whatever it is, the sweep is told
                missing, figure = [not_drawn(str(figure), error)], None
        page_file, undrawn = write_report(lambda: _page(rig, chosen, sweep), report, force=force)
    stopped = str(sweep.attrs["stopped"])
    if stopped:
        tell(f"{stopped}. The poses before that are kept.")
    elif sweep.attrs.get("findings"):
        tell(str(sweep.attrs["findings"]))
    written = [str(path) for path in (out, figure, page_file) if path is not None]
    exit_code = REFUSED if stopped else DONE
    return Reply(
        plain_sweep(sweep),
        lambda console: draw_sweep(console, f"Kinematics of {rig}", sweep, written),
        as_json,
        exit_code,
        [*missing, *undrawn],
    )


def _page(rig: str, chosen: Rig, sweep: xr.Dataset) -> Page:
    from jounce.report import recordings_page

    name = Path(rig).stem
    return recordings_page({name: sweep}, title=f"Kinematics of {name}", subtitle="Kinematic sweep", rig=chosen)


def _sweep(
    rig: Rig,
    travel: str | None,
    rack: str | None,
    roll: str | None,
    vehicle: AxleLayout | None,
    *,
    axle: bool,
    points: bool,
) -> xr.Dataset:
    from jounce.kinematics import sweep_rack, sweep_travel
    from jounce.kinematics.sweeps import text_range

    steered = None if rack is None else text_range(rack, "m", "--rack")
    if roll is not None or axle:
        if points:
            raise DescriptionError("a sweep of an axle has no hardpoints", where="--points", hint="Leave it out.")
        return _sweep_axle(rig, travel, steered, roll, vehicle)
    if travel is None:
        if steered is None:
            example = '--travel "-80 mm:80 mm:4 mm", --rack or --roll'
            raise DescriptionError("nothing to sweep", where="jounce kinematics", allowed=example)
        return sweep_rack(rig, steered, vehicle=vehicle, points=points)
    lifted = text_range(travel, "m", "--travel")
    if steered is not None and len(steered) > 1 and len(lifted) == 1:
        return sweep_rack(rig, steered, float(lifted[0]), vehicle=vehicle, points=points)
    pair = steered if steered is None or len(steered) > 1 else float(steered[0])
    return sweep_travel(rig, lifted, pair, vehicle=vehicle, points=points)


def _refuse_beside(given: dict[str, bool]) -> None:
    """Refuse options that poses one by one do not take."""
    for option, there in given.items():
        if there:
            hint = "Of an axle use --left-travel and --right-travel." if option == "--travel" else "Leave it out."
            raise DescriptionError("poses one by one do not take it", where=option, hint=hint)


_OF_WHEEL = {"travel": "m", "rack": "m"}
_OF_AXLE = {
    "left_travel": "m",
    "right_travel": "m",
    "heave": "m",
    "roll": "rad",
    "pitch": "rad",
    "rack": "m",
    "handwheel": "rad",
}


def _sweep_poses(rig: Rig, right: Rig | None, file: Path, vehicle: AxleLayout | None, *, points: bool) -> xr.Dataset:
    """Sweep the poses of a file, of a wheel or of an axle."""
    from jounce.core.columns import read_columns_csv
    from jounce.kinematics import sweep_axle, sweep_path

    found = read_columns_csv(file)
    names = set(found.names)
    of_axle = right is not None or bool(names & (_OF_AXLE.keys() - _OF_WHEEL.keys()))
    units = _OF_AXLE if of_axle else _OF_WHEEL
    if not names & units.keys() or (of_axle and "travel" in names):
        allowed = f"columns {', '.join(_OF_WHEEL)} of a wheel, or {', '.join(_OF_AXLE)} of an axle"
        raise DescriptionError(
            "no poses of a wheel or of an axle", where=str(file), found=", ".join(found.names), allowed=allowed
        )
    values = {name: found[name].in_si(unit) for name, unit in units.items() if name in names}
    if of_axle:
        _refuse_beside({"--points": points})
        return sweep_axle(rig, right=right, vehicle=vehicle, **values)
    lifted, steered = (values.get(name, 0.0) for name in _OF_WHEEL)
    return sweep_path(rig, lifted, steered, vehicle=vehicle, points=points)


def _sweep_both(rig: Rig, right: Rig | None, texts: dict[str, str | None], vehicle: AxleLayout | None) -> xr.Dataset:
    """Sweep both wheels of an axle pose by pose."""
    from jounce.kinematics import sweep_axle
    from jounce.kinematics.sweeps import text_range

    units = {"roll": "rad", "pitch": "rad", "handwheel": "rad"}
    values = {
        name: text_range(text, units.get(name, "m"), "--" + name.replace("_", "-"))
        for name, text in texts.items()
        if text is not None
    }
    return sweep_axle(rig, right=right, vehicle=vehicle, **values)


def _sweep_axle(
    rig: Rig, travel: str | None, rack: NDArray[np.float64] | None, roll: str | None, vehicle: AxleLayout | None
) -> xr.Dataset:
    from jounce.kinematics import sweep_roll, sweep_steering
    from jounce.kinematics.sweeps import text_range

    if roll is None:
        if rack is None:
            raise DescriptionError("nothing to sweep", where="--axle", allowed='--rack "-20 mm:20 mm:5 mm", or --roll')
        lifted = 0.0 if travel is None else _one_value(text_range(travel, "m", "--travel"), "--travel", "with --axle")
        return sweep_steering(rig, rack, lifted, vehicle=vehicle)
    if travel is not None:
        raise DescriptionError(
            "a roll sweep sets the wheel travel itself", where="--travel", hint="Leave out --travel or --roll."
        )
    if vehicle is not None:
        raise DescriptionError(
            "a roll sweep has no anti-dive percentages", where="--vehicle", hint="Leave it out, or sweep --travel."
        )
    at = 0.0 if rack is None else _one_value(rack, "--rack", "with --roll")
    return sweep_roll(rig, text_range(roll, "rad", "--roll"), at)


def _one_value(values: NDArray[np.float64], option: str, why: str) -> float:
    if len(values) > 1:
        raise DescriptionError(f"only a single value can be used {why}", where=option, found=f"{len(values)} values")
    return float(values[0])


def _vehicle(texts: list[str] | None) -> AxleLayout | None:
    if not texts:
        return None
    from jounce.kinematics.sweeps import AxleLayout

    given = pairs(texts, "--vehicle", 'wheelbase="2.7 m"')
    return AxleLayout.from_table(bare_numbers(AxleLayout, given, "--vehicle {}".format), where="--vehicle")


def plain_sweep(sweep: xr.Dataset) -> dict[str, Any]:
    """Every quantity with its unit and values in SI; None where there is no finite value."""
    import numpy as np

    names = [*map(str, sweep.coords), *map(str, sweep.data_vars)]
    shape = tuple(sweep.sizes.values())
    found = {}
    for name in names:
        variable = sweep[name]
        values = variable.to_numpy()
        if name in sweep.coords and name not in sweep.dims:
            values = np.broadcast_to(values, shape)
        found[name] = {"units": str(variable.attrs.get("units", "1")), "values": values.tolist()}
    return found


def draw_sweep(out: Console, title: str, sweep: xr.Dataset, written: list[str]) -> None:
    """Some poses of a sweep as a table, a quantity a row."""
    import numpy as np

    from jounce.core.display import display_unit
    from jounce.plots.display import kinematic_value

    along, *others = map(str, sweep.dims)
    shown = sweep.sel(dict.fromkeys(others, 0.0), method="nearest") if others else sweep
    count = shown.sizes[along]
    at = np.unique(np.linspace(0, count - 1, min(count, _SHOWN)).round().astype(int))
    unit = display_unit(str(sweep[along].attrs.get("units", "1")))  # poses are numbered
    rows = []
    for name, variable in shown.data_vars.items():
        values, si = variable.to_numpy(), str(variable.attrs["units"])
        own = display_unit(si, float(np.nanmax(np.abs(values), initial=0.0)))
        shown_values = (kinematic_value(str(name), float(value), si) for value in values[at])
        rows.append([str(name), own.name or "1", *shown_values])
    header = (
        "quantity",
        "unit",
        *(f"{value * unit.factor:.4g} {unit.name}".strip() for value in shown[along].to_numpy()[at]),
    )
    out.print(table(f"{title} over {along.replace('_', ' ')}", header, rows, text=(0, 1)))
    many = "".join(f" at each of {sweep.sizes[name]} values of {name.replace('_', ' ')}" for name in others)
    out.print(f"{count} poses{many}{', shown for the one nearest to 0' if others else ''}")
    for path in written:
        out.print(f"written: {path}")


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
