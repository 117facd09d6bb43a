"""``jounce fit``: stiffness, decays and damper laws from measured files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    LENGTH,
    AsJson,
    Columns,
    Database,
    FigureFile,
    Force,
    ForceSign,
    ReportFile,
    Resample,
    SampleTime,
    StrokeSign,
    Variable,
    check_outputs,
    columns,
    files,
    optional_positive,
    optional_quantity,
    reading,
    write_picture,
    write_report,
)
from jounce.cli.reply import Reply, progress, show_written
from jounce.core.errors import DescriptionError, OutputError, RecordingError, nearest, unknown
from jounce.core.typed import pairs, positive_quantity, quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import xarray as xr
    from matplotlib.figure import Figure
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.identify.damper import DamperCurve
    from jounce.identify.decay import CombinedDecay, DecayResult
    from jounce.identify.motion import MeasuredMotion, Quantity
    from jounce.identify.stiffness import StiffnessResult
    from jounce.report import Page


app = typer.Typer(no_args_is_help=True, help="Find stiffness, damping and damper laws from measurements.")


def _decay_estimates(motion: MeasuredMotion) -> tuple[tuple[str, str, str], ...]:
    """Names of the numbers of a decay: as they are told, as the result has them, and their units."""
    return (
        ("damping_ratio", "damping_ratio", "1"),
        ("damping_coefficient", "damping_coefficient", motion.damping),
        (f"coulomb_{motion.force_word}", "coulomb_force", motion.force),
        ("quadratic_drag", "quadratic_drag", motion.drag),
        ("natural_frequency_hz", "natural_frequency_hz", "Hz"),
        ("equilibrium", "equilibrium", motion.deflection),
        ("stiffness", "stiffness", motion.stiffness),
    )


@app.command("stiffness")
def stiffness(
    measured: Annotated[
        list[str],
        typer.Argument(metavar="FILES", help="Trials: columns displacement and force, or angle and torque."),
    ],
    law: Annotated[str, typer.Option(help="linear, polynomial, power or monotone-spline.")] = "linear",
    degree: Annotated[int, typer.Option(min=1, max=9, help="Degree of the polynomial.")] = 3,
    discard_below: Annotated[
        str | None, typer.Option(help='Ignore smaller deflections, e.g. "2 mm", or angles.')
    ] = None,
    intercept: Annotated[
        str,
        typer.Option(
            help="Intercept of the line: drop (F = k x), shift (F = k (x - x0)) or keep (F = k x + b, a preload)."
        ),
    ] = "drop",
    branch: Annotated[str, typer.Option(help="loading, unloading or both.")] = "loading",
    load: Annotated[
        str | None,
        typer.Option(help='Static load of the part, e.g. "206 N", or torque: checks that the fit covers it.'),
    ] = None,
    rig: Annotated[str | None, typer.Option(help="A rig that takes the rate over: name or file.")] = None,
    part: Annotated[
        str | None, typer.Option(help="Which rate of the rig it is.", show_default="strut.spring.rate")
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write the rig with the rate, RIG.toml.")] = None,
    stroke_positive: StrokeSign = None,
    force_positive: ForceSign = None,
    columns_: Columns = None,
    variable: Variable = "",
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Fit the stiffness of a spring, a tyre or a part that is twisted to repeated trials.

    Stroke and force are positive in compression, unless the options or the record say otherwise. Files with the columns
    angle and torque give a rate in N m/rad.

    Example: jounce fit stiffness tyre_031_*.csv --discard-below "2 mm" --intercept drop --load "206 N"
    """
    from jounce.campaign.characterise import read_force_deflection
    from jounce.core.serialise import to_plain
    from jounce.identify.motion import MOTIONS
    from jounce.identify.signs import sign_of
    from jounce.identify.stiffness import fit_stiffness
    from jounce.recordings.formats import TableFormat

    check_outputs(rig=out, figure=figure, report=report, force=force)
    if (rig is None) != (out is None):
        raise OutputError("a rate is written from one rig into another file", where="--rig", allowed="--rig and --out")
    if part is not None and rig is None:
        raise OutputError("a part of no rig", where="--part", found=part, allowed="--part with --rig and --out")
    sign_of(stroke_positive, "stroke", where="--stroke-positive")
    sign_of(force_positive, "force", where="--force-positive")
    found = files(measured, "FILES")
    told = TableFormat(columns=columns(columns_) or {}, variable=variable)
    trials, notes = read_force_deflection(found, told, stroke_positive, force_positive, tuple(MOTIONS.values()))  # type: ignore[arg-type]
    motion = MOTIONS[trials[0].motion]
    discard = 0.0
    if discard_below is not None:
        most = LENGTH if motion.name == "translation" else None
        discard = quantity(discard_below, motion.deflection, "--discard-below", most=most)
    result = fit_stiffness(
        trials,
        law=law,  # type: ignore[arg-type]
        degree=degree,
        discard_below=discard,
        intercept=intercept,  # type: ignore[arg-type]
        branch=branch,  # type: ignore[arg-type]
        operating_force=optional_quantity(load, motion.force, "--load"),
    )
    findings = (*notes, *result.findings)
    title = _title(found)
    if rig is not None and out is not None:
        _write_rate(result, rig, part or "strut.spring.rate", f"{result.law} law of {title}", out, force=force)

    def picture() -> Figure:
        from jounce.plots import stiffness_fit

        return stiffness_fit(result, trials)

    def page() -> Page:
        from jounce.report import stiffness_page

        return stiffness_page(result, trials, findings, title=title)

    written, missing = _written(picture, page, title, figure, report, force=force)
    written["out"] = out and str(out)
    plain = {"files": [str(file) for file in found], **to_plain(result), "findings": to_plain(findings), **written}
    return _reply(plain, page, as_json=as_json, missing=missing)


def _write_rate(result: StiffnessResult, rig: str, part: str, source: str, out: Path, *, force: bool) -> None:
    """Write a rig with one of its rates measured, and where it comes from above it."""
    from jounce.core.writing import write_atomically
    from jounce.identify.motion import MOTIONS, spoken
    from jounce.parts import load, rig_path
    from jounce.parts.files import changed_text
    from jounce.parts.rig import unit_of

    rate, motion, described = result.stiffness, MOTIONS[result.motion], load(rig)
    if part in described.parameters() and (takes := unit_of(described, part)) != motion.stiffness:
        raise OutputError(
            "the part takes no such rate",
            where="--part",
            found=f"{spoken(motion.stiffness)} for {part}",
            allowed=f"a part in {spoken(motion.stiffness)}; this one is in {spoken(takes)}",
        )
    text = changed_text(rig_path(rig).read_text(encoding="utf-8"), described, {part: rate.value})
    low, high = rate.interval or (rate.value, rate.value)
    unit = spoken(motion.stiffness)
    doubt = f"95 % interval {low:.6g} to {high:.6g} {unit}" if rate.interval else "interval unknown"
    write_atomically(out, f"# {part}: {rate.value:.6g} {unit}, {doubt}; {source}\n{text}", force=force)


@app.command("decay")
def decay(
    measured: Annotated[
        list[str], typer.Argument(metavar="FILE...", help="Recording of a free decay; several are combined.")
    ],
    channel: Annotated[
        str, typer.Option(help="Displacement, velocity or acceleration, e.g. sprung.z, or an angle or its rate.")
    ],
    mass: Annotated[str | None, typer.Option(help='Oscillating mass, e.g. "16 kg".')] = None,
    inertia: Annotated[
        str | None, typer.Option(help='Inertia about the axis of what turns (angle, rate gyro), e.g. "0.8 kg*m^2".')
    ] = None,
    stiffness_: Annotated[
        str | None, typer.Option("--stiffness", help="Known stiffness, compared with that from mass and frequency.")
    ] = None,
    begin: Annotated[str | None, typer.Option("--from", help='Leave out what is before, e.g. "1.2 s".')] = None,
    end: Annotated[str | None, typer.Option("--to", help="Leave out what is after.")] = None,
    drag: Annotated[
        str,
        typer.Option("--quadratic-drag", metavar="auto|yes|no", help="Fit it, too; auto: where the record shows it."),
    ] = "auto",
    stroke_positive: StrokeSign = None,
    columns_: Columns = None,
    variable: Variable = "",
    sample_time: SampleTime = None,
    resample: Resample = None,
    database: Database = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Separate viscous damping, dry friction and quadratic drag in a free decay.

    Of a pendulum or another part that turns, give --inertia in place of --mass: numbers are then in N m, N m s/rad and
    N m/rad. Damping does not depend on the sign of the record; the equilibrium of a deflection is positive in
    compression.

    Example: jounce fit decay decay_1.csv --channel sprung.z --mass "16 kg"
    """
    from jounce.identify.decay import combine_decays, fit_decay
    from jounce.identify.motion import motion_of
    from jounce.identify.signs import check_stroke, compression_positive, sign_of
    from jounce.recordings import read_recording

    sign_of(stroke_positive, "stroke", where="--stroke-positive")
    check_stroke(channel, stroke_positive, where="--stroke-positive")  # type: ignore[arg-type]
    check_outputs(figure=figure, report=report, force=force)
    told = reading(columns_, sample_time, variable, resample, database)
    window = optional_quantity(begin, "s", "--from"), optional_quantity(end, "s", "--to")
    results: list[DecayResult] = []
    notes: list[Finding] = []
    every = files(measured, "FILE")
    if figure is not None and len(every) > 1:
        raise OutputError(
            "one picture shows one decay", where="--figure", found=f"{len(every)} files", hint="See --report."
        )
    records: list[tuple[Any, Any]] = []
    with progress() as say:
        for k, file in enumerate(every, 1):
            say(f"fitting {k} of {len(every)}: {file.name}")
            data, found = read_recording(file, **told)
            notes += found
            data = compression_positive(data, stroke_positive, None)  # type: ignore[arg-type]
            record, kind = _decay_record(data, channel, str(file))
            motion = motion_of(kind)
            moving = _inertia(mass, inertia, motion, channel)
            records.append((data["time"].to_numpy(), record))
            results.append(
                fit_decay(
                    data["time"].to_numpy(),
                    record,
                    **moving,
                    stiffness=optional_positive(stiffness_, motion.stiffness, "--stiffness"),
                    quantity=kind,
                    begin=window[0],
                    end=window[1],
                    quadratic_drag=drag,  # type: ignore[arg-type]
                    name=file.name,
                )
            )
    result = results[0] if len(results) == 1 else combine_decays(results)
    findings = (*notes, *result.findings)
    title = _title(every)

    def picture() -> Figure:
        from jounce.plots import decay_fit

        return decay_fit(results[0], *records[0])

    def page() -> Page:
        from jounce.report import decay_page

        names = [file.name if len({f.name for f in every}) == len(every) else str(file) for file in every]
        decays = {name: (one, *record) for name, one, record in zip(names, results, records, strict=True)}
        return decay_page(result, decays, findings, title=title)

    written, missing = _written(picture, page, title, figure, report, force=force)
    plain = {**_decay_plain(result, measured, channel, findings), **written}
    return _reply(plain, page, as_json=as_json, missing=missing)


def _inertia(mass: str | None, inertia: str | None, motion: MeasuredMotion, channel: str) -> dict[str, float]:
    """What swings: the mass of a motion along a line, the inertia of one about an axis."""
    given = {"mass": mass, "inertia": inertia}
    text = given.pop(motion.inertia_word)
    ((other, wrong),) = given.items()
    unit = motion.inertia
    if text is None or wrong is not None:
        raise DescriptionError(
            f"the {motion.inertia_word} of what swings is needed" if text is None else f"no {other} swings here",
            where=f"--{motion.inertia_word if text is None else other}",
            found=f"{channel} is {'an angle or its rate' if motion.name == 'rotation' else 'a motion along a line'}",
            allowed=f'--{motion.inertia_word} "NUMBER {unit}"',
        )
    return {motion.inertia_word: positive_quantity(text, unit, f"--{motion.inertia_word}")}


def _decay_record(data: xr.Dataset, channel: str, file: str) -> tuple[Any, Quantity]:
    """Samples of the channel, and what motion they are."""
    from jounce.identify.motion import QUANTITY_OF_UNIT

    names = [str(name) for name in data.data_vars]
    if channel not in names:
        raise RecordingError(
            f"no channel {channel!r}",
            where=file,
            found=", ".join(names),
            hint=nearest(channel, names) or "See --columns.",
        )
    unit = data[channel].attrs["units"]
    if unit not in QUANTITY_OF_UNIT:
        raise RecordingError(
            "not a motion",
            where=f"{file}: {channel}",
            found=unit,
            allowed="a displacement, velocity or acceleration, or an angle and its derivatives",
        )
    return data[channel].to_numpy(), QUANTITY_OF_UNIT[unit]


def _decay_plain(
    result: DecayResult | CombinedDecay, measured: list[str], channel: str, findings: tuple[Finding, ...]
) -> dict[str, Any]:
    from jounce.core.serialise import to_plain
    from jounce.identify.motion import MOTIONS

    unknown = {"value": None, "standard_error": None, "interval": None}
    names = _decay_estimates(MOTIONS[result.motion])
    plain = {name: to_plain(getattr(result, own)) or unknown for name, own, _ in names}
    naive = result.logarithmic_decrement
    return {
        "files": list(measured),
        "channel": channel,
        "motion": result.motion,
        **plain,
        "logarithmic_decrement": naive.value,
        "logarithmic_decrement_standard_error": naive.standard_error,
        "equivalent_damping_ratio": result.equivalent_damping_ratio.value,
        "decrements": list(getattr(result, "decrements", ())),
        "cycles": result.cycles,
        "r2": getattr(result, "r2", None),
        "findings": to_plain(findings),
    }


@app.command("damper")
def damper(
    record: Annotated[
        Path,
        typer.Argument(metavar="FILE", help="Record with columns time, displacement, force and optionally velocity."),
    ],
    law: Annotated[
        str, typer.Option(help="linear, bilinear, blow-off, polynomial, tanh-hysteretic or bouc-wen.")
    ] = "linear",
    degree: Annotated[int, typer.Option(min=1, max=9, help="Degree of the polynomial.")] = 3,
    odd: Annotated[bool, typer.Option("--odd", help="Use odd powers only.")] = False,
    friction: Annotated[bool, typer.Option("--friction", help="Add dry friction to a law of velocity.")] = False,
    velocity_from: Annotated[
        str, typer.Option(help="recorded, or displacement to differentiate it even if a velocity was recorded.")
    ] = "recorded",
    stroke_positive: StrokeSign = None,
    force_positive: ForceSign = None,
    columns_: Columns = None,
    variable: Variable = "",
    sample_time: SampleTime = None,
    resample: Resample = None,
    database: Database = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Fit a damper law to a record of imposed motion and force.

    Stroke and force are positive in compression, unless the options say otherwise. What the record itself shows (a
    damper dissipates, gas pushes outwards) is held against that; the fitted law is positive in compression.

    Example: jounce fit damper record.csv --law bouc-wen
    """
    from jounce.core.serialise import to_plain
    from jounce.identify.damper import fit_damper
    from jounce.recordings import read_recording

    check_outputs(figure=figure, report=report, force=force)
    data, notes = read_recording(record, **reading(columns_, sample_time, variable, resample, database))
    signals = {name: data[name].to_numpy() for name in ("displacement", "velocity", "force") if name in data}
    for name in ("displacement", "force"):
        if name not in signals:
            found = ", ".join(str(channel) for channel in data.data_vars)
            hint = f"Name its column: --columns {name}='COLUMN [unit]'."
            raise RecordingError(f"no column {name!r}", where=str(record), found=found, hint=hint)
    choice: dict[str, Any] = {
        "law": law,
        "degree": degree,
        "odd": odd,
        "friction": friction,
        "velocity_from": velocity_from,
        "stroke_positive": stroke_positive,
        "force_positive": force_positive,
    }
    with progress() as say:
        say("fitting")
        result = fit_damper(
            signals["displacement"],
            signals.get("velocity"),
            signals["force"],
            data["time"].to_numpy(),
            name=record.name,
            **choice,
        )
    findings = (*notes, *result.findings)

    def curve() -> DamperCurve:
        from jounce.identify.damper import damper_curve

        measured = (signals["displacement"], signals.get("velocity"), signals["force"], data["time"].to_numpy())
        return damper_curve(result, *measured, velocity_from=velocity_from)  # type: ignore[arg-type]

    def picture() -> Figure:
        from jounce.plots import figure_of

        return figure_of(curve(), law=result.law)

    def page() -> Page:
        from jounce.report import damper_page

        return damper_page(result, curve, findings, title=record.stem)

    written, missing = _written(picture, page, record.stem, figure, report, force=force)
    plain = {"file": str(record), **to_plain(result), "findings": to_plain(findings), **written}
    return _reply(plain, page, as_json=as_json, missing=missing)


def _title(found: Sequence[Path]) -> str:
    """What a picture or a page is of: the file, or the first and the last of several."""
    return found[0].stem if len(found) == 1 else f"{found[0].stem} to {found[-1].stem}"


def _written(
    picture: Callable[[], Figure],
    page: Callable[[], Page],
    title: str,
    figure: Path | None,
    report: Path | None,
    *,
    force: bool,
) -> tuple[dict[str, Any], list[Finding]]:
    """Write what is asked for; what could not be drawn loses no result."""
    drawn, missing = write_picture(picture, figure, title, force=force)
    document, undrawn = write_report(page, report, force=force)
    return {"figure": drawn, "report": document}, [*missing, *undrawn]


def _reply(plain: dict[str, Any], page: Callable[[], Page], *, as_json: bool, missing: Sequence[Finding]) -> Reply:
    """Answer with the page of the result."""

    def draw(out: Console) -> None:
        from jounce.cli.terminal import show_page

        show_page(out, page())
        show_written(out, plain)

    return Reply(plain, draw, as_json, missing=missing)


@app.command("hardpoints")
def hardpoints(
    rig: Annotated[str, typer.Argument(metavar="RIG", help="A corner with hardpoints: name or file.")],
    measured: Annotated[
        Path,
        typer.Argument(
            metavar="POSES.csv", help="Columns wheel_travel [mm], rack_travel [mm], toe [deg], camber [deg] ..."
        ),
    ],
    free: Annotated[
        list[str],
        typer.Option("--free", metavar="POINT=WITHIN", help='hardpoints.tie_rod_inner="15 mm". Repeat it.'),
    ],
    noise: Annotated[
        list[str] | None,
        typer.Option("--noise", metavar="QUANTITY=SIZE", help='Standard deviation: toe="0.02 deg". Repeat it.'),
    ] = None,
    offset: Annotated[
        list[str] | None,
        typer.Option("--offset", metavar="QUANTITY", help="A quantity whose zero is not known. Repeat it."),
    ] = None,
    starts: Annotated[int, typer.Option(min=1, help="Number of searches; the first starts from the rig.")] = 3,
    out: Annotated[Path | None, typer.Option(help="Write the rig with its points updated, RIG.toml.")] = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Update hardpoints until the model gives a table of measured poses, with 95 % intervals.

    Example: jounce fit hardpoints formula-student-front poses.csv --free hardpoints.tie_rod_inner="10 mm" --offset toe
    """
    check_outputs(rig=out, figure=figure, force=force)
    widths = pairs(free, "--free", 'hardpoints.tie_rod_inner="15 mm"')
    sizes = pairs(noise, "--noise", 'toe="0.02 deg"')
    with progress() as say:
        say("loading")
        from jounce.core.columns import read_columns_csv
        from jounce.core.writing import write_atomically
        from jounce.design.measured_poses import fit_hardpoints
        from jounce.kinematics.catalogue import require_parts
        from jounce.kinematics.model import check_corner, kinematic_model
        from jounce.parts import load, rig_path
        from jounce.parts.files import updated_text

        chosen = check_corner(load(rig))
        units = {row.name: row.unit for row in kinematic_model(chosen).rows} | {"wheel_travel": "m", "rack_travel": "m"}
        columns_found = read_columns_csv(measured)
        for name in columns_found.names:
            if name not in units:
                require_parts(chosen, name)
                raise unknown(name, units, what="quantity", where=str(measured))
        poses = {name: columns_found[name].in_si(units[name]) for name in columns_found.names}
        say("searching")
        found = fit_hardpoints(chosen, poses, widths, noise=sizes, offsets=offset or (), starts=starts)
        if out is not None:
            write_atomically(out, updated_text(rig_path(rig).read_text(encoding="utf-8"), found.rig), force=force)
    drawn, missing = write_picture(found, figure, f"{rig} against {measured.name}", force=force)
    plain = {"rig": rig, **found.to_dict(), "out": out and str(out), "figure": drawn}

    def page() -> Page:
        from jounce.report import hardpoints_page

        return hardpoints_page(found, title=f"{rig} against {measured.name}")

    return _reply(plain, page, as_json=as_json, missing=missing)
