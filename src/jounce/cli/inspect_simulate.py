"""``jounce inspect simulate``: what a tester would say about a rig or one axle of a vehicle."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.inspect_evaluate import draw_axle
from jounce.cli.options import AsJson, Changes, Force, changes, positive_quantity, quantity
from jounce.cli.outputs import check_outputs
from jounce.cli.reply import Reply, progress
from jounce.cli.rigs import warn_of
from jounce.cli.tables import show_findings, show_written, table
from jounce.core.errors import DescriptionError, OutputError

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.inspection.grading import GradedInspection
    from jounce.parts.testers import Tester

_OF_TESTER = "tester."
_SIDES, _BOTH, _AXLES = ("left", "right"), "both", ("front", "rear")
_ROWS = (
    ("adhesion", "adhesion", "1"),
    ("phase_angle_min_deg", "least phase angle", "deg"),
    ("phase_frequency_hz", "  at", "Hz"),
    ("relative_force_amplitude", "relative force amplitude", "1"),
    ("tyre_rigidity", "tyre rigidity", "N/m"),
    ("theta_rig", "Theta on the tester", "1"),
    ("theta_road", "Theta on the road", "1"),
    ("boge_amplitude", "BOGE amplitude", "m"),
    ("lift_off", "tyre leaves the plate", ""),
)


def simulate(
    rig: Annotated[str, typer.Argument(metavar="RIG", help="A rig or vehicle file, or a name of `jounce library`.")],
    method: Annotated[
        str | None, typer.Option(help="eusama, egea, theta or boge; by default that of the tester.")
    ] = None,
    tester: Annotated[
        str | None, typer.Option(help="A tester file, or the name of a shipped one; by default that of the method.")
    ] = None,
    steady: Annotated[bool, typer.Option("--steady", help="Steady states in place of a run-down.")] = False,
    stroke: Annotated[str | None, typer.Option(help='Stroke of the exciter, peak to peak: "6 mm".')] = None,
    sweep_rate: Annotated[str | None, typer.Option(help='How fast the run-down is: "2.5 Hz/s".')] = None,
    wear: Annotated[
        str | None, typer.Option(help="Share of the damping that is lost: one number, or FIRST:LAST:STEP.")
    ] = None,
    wheel: Annotated[
        str,
        typer.Option(help="left or right: the plate, and of an axle the wheel; both: one wheel of it after the other."),
    ] = "left",
    axle: Annotated[str, typer.Option(help="front or rear: which axle of a vehicle.")] = "front",
    noise: Annotated[
        str, typer.Option(help='Standard deviation of the noise of the force, of the static load: "1 %".')
    ] = "0",
    seed: Annotated[int, typer.Option(min=0, help="Of the noise.")] = 0,
    set_: Changes = None,
    record: Annotated[Path | None, typer.Option(help="Write the record: RECORD.csv or RECORD.nc.")] = None,
    truth: Annotated[bool, typer.Option("--truth", help="With what no tester measures in the record.")] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Simulate the test of a wheel, evaluate the record as a measured one, and grade it.

    --set changes the rig, and with `tester.` before the path the tester: --set tester.plate_mass="25 kg". With --json
    one wheel is one object; both wheels are {wheels: [...], axle: {...}}, as of `inspect evaluate`.

    Example: jounce inspect simulate audi-a6-quarter-car --method egea --wear 0:1:0.1
    """
    _check_words(wheel, axle)
    if record is not None:
        _check_record(record, steady=steady, several=wear is not None and ":" in wear, force=force)
    wanted = changes(set_)
    of_rig = {path: value for path, value in wanted.items() if not path.startswith(_OF_TESTER)}
    of_tester = {path.removeprefix(_OF_TESTER): value for path, value in wanted.items() if path not in of_rig}
    chosen_tester = _tester(method, tester, stroke, sweep_rate, of_tester)
    from jounce.inspection.simulated import simulate_axle, simulate_inspection, sweep_wear
    from jounce.parts import load
    from jounce.parts.variants import worn

    chosen = load(rig).with_changes(of_rig) if of_rig else load(rig)
    warn_of(chosen, rig)
    share = quantity(noise, "1", "--noise")
    wears = sweep_wear(wear) if wear is not None else [0.0]
    about = {"rig": rig, "tester": chosen_tester.name, "method": method or chosen_tester.method, "steady": steady}
    if wheel == _BOTH:
        _check_both(steady=steady, several=len(wears) > 1)
        graded, measured = simulate_axle(
            worn(chosen, wears[0]) if wears[0] else chosen, chosen_tester, method=method,
            axle=axle, noise=share, seed=seed, vehicle=_name(rig),  # type: ignore[arg-type]
        )  # fmt: skip
        if record is not None:
            _write(measured, record, truth=truth, force=force)
        both = {**graded.to_dict(), **about, "record": record and str(record)}
        return Reply(both, lambda out: _draw_both(out, graded, both), as_json)
    runs = []
    with progress() as say:
        for number, lost in enumerate(wears, 1):
            say(f"testing {number} of {len(wears)}" if len(wears) > 1 else "testing")
            found = simulate_inspection(
                worn(chosen, lost) if lost else chosen, chosen_tester, method=method, steady=steady,
                wheel=wheel, axle=axle, noise=share, seed=seed, vehicle=_name(rig),  # type: ignore[arg-type]
            )  # fmt: skip
            runs.append(found)
    if record is not None and runs[0].record is not None:
        _write(runs[0].record, record, truth=truth, force=force)
    tables = [_plain(found.wheel.to_dict(), found.theta_road, found.theta_rig, steady=steady) for found in runs]
    if wear is None or ":" not in wear:
        plain: dict[str, Any] = {**tables[0], **about, "record": record and str(record)}
        return Reply(plain, lambda out: _draw(out, plain, runs[0].wheel.findings), as_json)
    swept = {**about, "wear": wears, "wheels": [{"wear": lost, **one} for lost, one in zip(wears, tables, strict=True)]}
    return Reply(swept, lambda out: _draw_wear(out, swept), as_json)


def _plain(wheel: dict[str, Any], road: float | None, on_rig: float | None, *, steady: bool) -> dict[str, Any]:
    return wheel if steady else {**wheel, "truth": {"theta_road": road, "theta_rig": on_rig}}


def _tester(
    method: str | None, tester: str | None, stroke: str | None, sweep_rate: str | None, wanted: dict[str, Any]
) -> Tester:
    """The tester that is asked for, with its changes."""
    from jounce.inspection.simulated import tester_for
    from jounce.parts.testers import load_tester

    if method is None and tester is None:
        raise DescriptionError(
            "which test?", where="--method", allowed="eusama, egea, theta, boge; or --tester with a file or a name"
        )
    if method is not None:
        found = tester_for(method)
    if tester is not None:
        found = load_tester(tester)
    made = dict(wanted)
    if stroke is not None:
        made["stroke"] = positive_quantity(stroke, "m", "--stroke")
    if sweep_rate is not None:
        made["programme.sweep_rate"] = positive_quantity(sweep_rate, "Hz/s", "--sweep-rate")
    return found.with_changes(made) if made else found


def _check_both(*, steady: bool, several: bool) -> None:
    if steady or several:
        what = "steady states are of one wheel" if steady else "a range of wear is of one wheel"
        raise DescriptionError(what, where="--wheel", found=_BOTH, allowed=", ".join(_SIDES))


def _check_words(wheel: str, axle: str) -> None:
    for option, value, allowed in (("--wheel", wheel, (*_SIDES, _BOTH)), ("--axle", axle, _AXLES)):
        if value not in allowed:
            raise DescriptionError("unknown", where=option, found=value, allowed=", ".join(allowed))


def _check_record(record: Path, *, steady: bool, several: bool, force: bool) -> None:
    """Refuse before the work a record that could not be written after it."""
    if steady or several:
        what = "steady states have no record" if steady else "several tests do not go into one record"
        raise OutputError(what, where=f"--record {record}", hint="Leave out --steady, and give one --wear.")
    check_outputs(recording=record, force=force)


def _write(record: Any, file: Path, *, truth: bool, force: bool) -> None:
    from jounce.testers.testing import write_test

    kept = record if truth else record[[name for name in record.data_vars if not str(name).startswith("truth.")]]
    write_test(kept, file, force=force)


def _name(rig: str) -> str:
    return Path(rig).stem if rig.endswith(".toml") else rig


def _draw_both(out: Console, graded: GradedInspection, plain: dict[str, Any]) -> None:
    out.print(f"{plain['rig']} on {plain['tester']}, run-down of both wheels", style="bold")
    draw_axle(out, graded)
    show_written(out, plain)


def _draw(out: Console, plain: dict[str, Any], findings: Any) -> None:
    how = "steady states" if plain["steady"] else "run-down"
    uncertainty = plain["uncertainty"]
    rows = [(text, plain[key], uncertainty.get(key), unit) for key, text, unit in _ROWS if plain.get(key) is not None]
    title = f"{plain['rig']} on {plain['tester']}, {how}: {plain['wheel']} wheel, {plain['static_load']:.0f} N"
    out.print(title, style="bold", soft_wrap=not out.is_terminal)
    out.print(table("", ("value", "", "±", "unit"), rows, text=(0, 3)))
    for name, band in plain["grade"].items():
        out.print(f"{name}: {band}")
    out.print(f"verdict: {plain['verdict']}")
    for reason in plain["reasons"]:
        out.print(f"  {reason}")
    show_findings(out, list(findings))
    show_written(out, plain)


def _draw_wear(out: Console, plain: dict[str, Any]) -> None:
    shown = [row for row in _ROWS if any(wheel.get(row[0]) is not None for wheel in plain["wheels"])]
    header = ("wear", *(f"{text.strip()} [{unit}]" if unit else text for _, text, unit in shown), "verdict")
    rows = [(wheel["wear"], *(wheel.get(key) for key, _, _ in shown), wheel["verdict"]) for wheel in plain["wheels"]]
    how = "steady states" if plain["steady"] else "run-down"
    last = len(header) - 1
    out.print(table(f"{plain['rig']} on {plain['tester']}, {how}, by wear of the damper", header, rows, text=(last,)))
