"""``jounce fit damper``: a damper law from measured motion and force."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Columns, columns
from jounce.cli.reply import Reply
from jounce.cli.tables import estimates, show_findings
from jounce.core.errors import RecordingError

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.identify.damper import DamperResult


def damper(
    record: Annotated[
        Path,
        typer.Argument(metavar="FILE", help="Columns time, displacement, force and, if there is one, velocity."),
    ],
    law: Annotated[str, typer.Option(help="linear, bilinear, polynomial, tanh-hysteretic or bouc-wen.")] = "linear",
    degree: Annotated[int, typer.Option(help="Degree of the polynomial.")] = 3,
    odd: Annotated[bool, typer.Option("--odd", help="Polynomial with odd powers only.")] = False,
    friction: Annotated[bool, typer.Option("--friction", help="Add dry friction to a law of velocity.")] = False,
    velocity_from: Annotated[
        str, typer.Option(help="recorded, or displacement: its derivative, though a velocity was recorded.")
    ] = "recorded",
    columns_: Columns = None,
    variable: Annotated[str, typer.Option(help="Matrix of a .mat file or group of a .tdms file to read.")] = "",
    sample_time: Annotated[str | None, typer.Option(help='Constant step of a file without time, e.g. "10 ms".')] = None,
    as_json: AsJson = False,
) -> Reply:
    """Fit a damper law to a record of imposed motion and force.

    Example: jounce fit damper record.csv --law bouc-wen
    """
    from jounce.core.serialise import to_plain
    from jounce.identify.damper import fit_damper
    from jounce.recordings import read_recording

    data, notes = read_recording(record, columns=columns(columns_), sample_time=sample_time, variable=variable)
    signals = {name: data[name].to_numpy() for name in ("displacement", "velocity", "force") if name in data}
    for name in ("displacement", "force"):
        if name not in signals:
            found = ", ".join(str(channel) for channel in data.data_vars)
            hint = f"Say where it is: --columns {name}='COLUMN [unit]'."
            raise RecordingError(f"no column {name!r}", where=str(record), found=found, hint=hint)
    choice: dict[str, Any] = {
        "law": law,
        "degree": degree,
        "odd": odd,
        "friction": friction,
        "velocity_from": velocity_from,
    }
    result = fit_damper(
        signals["displacement"],
        signals.get("velocity"),
        signals["force"],
        data["time"].to_numpy(),
        name=record.name,
        **choice,
    )
    findings = (*notes, *result.findings)
    plain = {"file": str(record), **to_plain(result), "findings": to_plain(findings)}
    return Reply(plain, lambda out: _draw(out, result, findings), as_json)


def _draw(out: Console, result: DamperResult, findings: tuple[Finding, ...]) -> None:
    rows = [(name.replace("_", " "), found, result.units[name]) for name, found in result.parameters.items()]
    out.print(
        estimates(f"{result.law} law, {result.samples} samples of {result.cycles:g} cycles, R2 = {result.r2:.4f}", rows)
    )
    out.print(
        f"misfit {100.0 * result.nrmse:.3g} % of the range of the force, {result.rms_residual:.4g} N; "
        f"work per cycle {result.energy_per_cycle:.4g} J, by the law {result.fitted_energy_per_cycle:.4g} J"
    )
    out.print(f"for a rig file:\n  [strut]\n  damper = {_toml(result.damper)}", soft_wrap=True)
    if result.friction is not None:
        out.print(f"  friction = {_toml(result.friction)}", soft_wrap=True)
    show_findings(out, findings)


def _toml(table: dict[str, Any]) -> str:
    """Write a table on one line as a rig file takes it."""
    import tomlkit

    inline = tomlkit.inline_table()
    inline.update({key: float(f"{value:.6g}") if isinstance(value, float) else value for key, value in table.items()})
    return inline.as_string()
