"""Test estimates with records of known values in every sign, datum and sampling: counts for a page and a test."""

from __future__ import annotations

import itertools
import re
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import foreign_records
import numpy as np
from foreign_records import Record

import jounce as jn
from jounce.campaign.characterise import read_force_deflection
from jounce.core.errors import JounceError
from jounce.identify.damper import fit_damper
from jounce.identify.decay import fit_decay
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.free_response import DecayParameters, decay_response
from jounce.identify.motion import MOTIONS, QUANTITY_OF_UNIT
from jounce.identify.stiffness import fit_stiffness
from jounce.recordings import read_recording
from jounce.recordings.formats import TableFormat

Outcome = tuple[bool, bool]
"""Whether the estimate is right, and whether a warning or problem that speaks of its cause is beside it."""
SIGNS = list(itertools.product((1, -1), (1, -1)))


def _is_loud(findings: object, about: str = "") -> bool:
    """Whether a warning or problem names the cause; other findings may also accompany right numbers."""
    return any(finding.severity != "note" and about in finding.message for finding in findings)  # type: ignore[attr-defined]


def _close(found: float, truth: float, share: float = 0.02) -> bool:
    return abs(found - truth) <= share * max(abs(truth), 1e-12)


def dampers() -> Iterator[Outcome]:
    """Asymmetric and symmetric dampers with and without gas force, stroke and force of any sign, nothing stated."""
    for bump, rebound, gas, rate, (stroke, force), has_velocity in itertools.product(
        (500.0, 1500.0), (2000.0, 1500.0, 800.0), (60.0, 0.0), (200.0, 1000.0), SIGNS, (True, False)
    ):
        t = np.arange(0.0, 4.0, 1.0 / rate)
        x, v = 0.02 * np.sin(2 * np.pi * t), 0.04 * np.pi * np.cos(2 * np.pi * t)
        f = (
            np.where(v > 0.0, bump, rebound) * v
            + gas
            + np.random.default_rng(1).normal(0.0, 3.0, len(t))
        )
        result = fit_damper(
            stroke * x, stroke * v if has_velocity else None, force * f, t, law="bilinear"
        )
        found = result.parameters
        right = _close(found["bump_coefficient"].value, bump) and _close(
            found["rebound_coefficient"].value, rebound
        )
        yield right, _is_loud(result.findings, "_positive")


def springs() -> Iterator[Outcome]:
    """Springs with and without preload, stroke and force of any sign, nothing stated."""
    way = np.concatenate([np.linspace(0.0, 0.03, 80), np.linspace(0.03, 0.0, 80)])
    for preload, (stroke, force) in itertools.product((0.0, 300.0), SIGNS):
        result = fit_stiffness(
            [ForceDeflectionTrial(stroke * way, force * (preload + 22.7e3 * way))], intercept="keep"
        )
        assert result.intercept is not None
        yield (
            _close(result.stiffness.value, 22.7e3) and abs(result.intercept.value - preload) < 1.0,
            _is_loud(result.findings),
        )


def decays() -> Iterator[Outcome]:
    """Viscous damping, friction and drag; displacement, velocity and acceleration; any sign and sampling."""
    mass, omega = 16.0, 33.9
    for (ratio, friction, drag), kind, sign, rate in itertools.product(
        ((0.03, 0.0, 0.0), (0.03, 4e-4, 0.0), (0.03, 0.0, 3.0), (0.03, 2e-4, 3.0)),
        ("displacement", "velocity", "acceleration"),
        (1, -1),
        (200.0, 1000.0),
    ):
        t = np.arange(0.0, 2.5, 1.0 / rate)
        truth = DecayParameters(omega, ratio, friction, 0.1, 0.2, 0.02, drag)
        signal = sign * decay_response(t, truth, kind)  # type: ignore[arg-type]
        result = fit_decay(t, signal, mass=mass, quantity=kind)  # type: ignore[arg-type]
        force = friction * mass * omega**2
        found_drag = 0.0 if result.quadratic_drag is None else result.quadratic_drag.value
        right = (
            _close(result.damping_ratio.value, ratio)
            and abs(result.coulomb_force.value - force) < 0.02 * force + 0.01
            and _close(found_drag, mass * drag)
        )
        yield right, _is_loud(result.findings)


def datums() -> Iterator[Outcome]:
    """Heights, deflections and forces zeroed at rest, undeformed or anywhere, with either sign, in an update."""
    rig = jn.load("kart-quarter-car")
    truth = rig.with_changes({"strut.spring.rate": "21.5 N/mm", "strut.damper.coefficient": 120.0})
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.6 m")
    trial = jn.Trial(road=road, speed="1.95 m/s", duration="1 s")
    run = jn.simulate(truth, trial, tolerance=1e-8)
    free = {"strut.spring.rate": "20 %", "strut.damper.coefficient": [50.0, 300.0]}
    channels = ("sprung.z", "unsprung.z", "strut.deflection", "tyre.force", "sprung.az")
    for name, zero, sign in itertools.product(channels, ("rest", 0.0, 0.7), (1, -1)):
        offset = float(run[name][0]) if zero == "rest" else float(zero)
        measured = run[[name]].map(lambda signal: sign * (signal - offset))  # noqa: B023 - used at once
        update = jn.update_model([jn.FitTrial("one", rig, trial, measured)], free)
        values = truth.parameters()
        right = all(
            _close(one.value, values[path], 1e-3) for path, one in update.parameters.items()
        )
        yield right, _is_loud(update.findings, "sign is reversed")


def _fit_damper(file: Path, **choice: Any) -> tuple[dict[str, Any], list[Any]]:
    run, notes = read_recording(file)
    signals = (
        run["displacement"].to_numpy(),
        None,
        run["force"].to_numpy(),
        run["time"].to_numpy(),
    )
    result = fit_damper(*signals, law="bilinear", **choice)
    return result.parameters, [*notes, *result.findings]


def _fit_spring(file: Path, **choice: Any) -> tuple[dict[str, Any], list[Any]]:
    trials, notes = read_force_deflection([file], TableFormat(), motions=tuple(MOTIONS.values()))
    result = fit_stiffness(trials, **choice)
    return {"stiffness": result.stiffness}, [*notes, *result.findings]


def _fit_decay(file: Path, channel: str, **choice: Any) -> tuple[dict[str, Any], list[Any]]:
    run, notes = read_recording(file)
    quantity = QUANTITY_OF_UNIT[run[channel].attrs["units"]]
    result = fit_decay(run["time"].to_numpy(), run[channel].to_numpy(), quantity=quantity, **choice)
    found = {
        "damping_coefficient": result.damping_coefficient,
        "coulomb_force": result.coulomb_force,
    }
    return found, [*notes, *result.findings]


def judged(record: Record, fit: Callable[..., tuple[dict[str, Any], list[Any]]]) -> str:
    """Whether a fit of the file is right (within its interval or 3 %), reported with its cause, refused, or wrong.

    A sound record with a warning is a false alarm, a wrong number from a record as sound as the truth is hidden.
    """
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "record.csv"
        file.write_text(record.text(), encoding="utf-8")
        try:
            found, findings = fit(file, **dict(record.choice))
        except JounceError:
            return "refused"
    loud = [
        one.message
        for one in findings
        if one.severity != "note" and "only one trial" not in one.message
    ]
    slack = dict(record.slack)
    if all(
        _close(found[name].value, value, 0.03)
        or found[name].has(value)
        or abs(found[name].value - value) < slack.get(name, 0.0)
        for name, value in record.truth.items()
    ):
        return "false alarm" if loud and not record.about else "right"
    if record.about == foreign_records.HIDDEN:
        return "hidden"
    return (
        "told" if record.about and any(re.search(record.about, text) for text in loud) else "silent"
    )


def files(records: Callable[[], Iterator[Record]], fit: Callable[..., Any]) -> Iterator[Outcome]:
    """Files made without jounce; refusals and false alarms count as such."""
    for record in records():
        verdict = judged(record, fit)
        yield verdict == "right", verdict in ("told", "refused")


FILES: dict[str, tuple[Callable[[], Iterator[Record]], Callable[..., Any]]] = {
    "files of dampers: sign, datum, unit, rate, steps, filter, dropouts, drift, exchange": (
        foreign_records.dampers,
        _fit_damper,
    ),
    "files of springs: sign, both sides, datum, slip, steps, dropouts, drift, exchange": (
        foreign_records.springs,
        _fit_spring,
    ),
}
SUBJECTS: dict[str, Callable[[], Iterator[Outcome]]] = {
    "dampers: signs, gas force, sampling, with and without velocity": dampers,
    "springs: signs, preload": springs,
    "free decays: damping, friction, drag, quantity, sign, sampling": decays,
    "updates: datum and sign of each channel": datums,
    **{subject: partial(files, *how) for subject, how in FILES.items()},
}


def counts(subject: str) -> tuple[int, int, int, int]:
    """Variants tried, right, wrong but flagged, silently wrong."""
    outcomes = list(SUBJECTS[subject]())
    right = sum(is_right for is_right, _ in outcomes)
    flagged = sum(is_loud and not is_right for is_right, is_loud in outcomes)
    return len(outcomes), right, flagged, len(outcomes) - right - flagged


def write_table(folder: Path) -> None:
    """Write the table of all subjects as a page to include."""
    lines = [
        "| recorded | variants tried | right | wrong, flagged | silently wrong |",
        "|---|---|---|---|---|",
    ]
    lines += [f"| {subject} | {' | '.join(map(str, counts(subject)))} |" for subject in SUBJECTS]
    folder.mkdir(exist_ok=True)
    (folder / "identification-variants.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
