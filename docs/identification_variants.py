"""Estimates tried on records of known truths in every sign, datum and sampling: counts for a page and a test."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

import jounce as jn
from jounce.identify.damper import fit_damper
from jounce.identify.decay import DecayParameters, decay_response, fit_decay
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.stiffness import fit_stiffness

Outcome = tuple[bool, bool]
"""Whether the estimate is right, and whether a warning or problem that speaks of its cause is beside it."""
SIGNS = list(itertools.product((1, -1), (1, -1)))


def _is_loud(findings: object, about: str = "") -> bool:
    """Whether a warning or problem is among them that names the cause: others stand beside right numbers, too."""
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
        f = np.where(v > 0.0, bump, rebound) * v + gas + np.random.default_rng(1).normal(0.0, 3.0, len(t))
        result = fit_damper(stroke * x, stroke * v if has_velocity else None, force * f, t, law="bilinear")
        found = result.parameters
        right = _close(found["bump_coefficient"].value, bump) and _close(found["rebound_coefficient"].value, rebound)
        yield right, _is_loud(result.findings, "_positive")


def springs() -> Iterator[Outcome]:
    """Springs with and without preload, stroke and force of any sign, nothing stated."""
    way = np.concatenate([np.linspace(0.0, 0.03, 80), np.linspace(0.03, 0.0, 80)])
    for preload, (stroke, force) in itertools.product((0.0, 300.0), SIGNS):
        result = fit_stiffness([ForceDeflectionTrial(stroke * way, force * (preload + 22.7e3 * way))], intercept="keep")
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
    """Heights, deflections and forces zeroed at rest, undeformed or anywhere, as they are or turned, in an update."""
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
        right = all(_close(one.value, values[path], 1e-3) for path, one in update.parameters.items())
        yield right, _is_loud(update.findings, "sign is turned")


SUBJECTS: dict[str, Callable[[], Iterator[Outcome]]] = {
    "dampers: signs, gas force, sampling, with and without velocity": dampers,
    "springs: signs, preload": springs,
    "free decays: damping, friction, drag, quantity, sign, sampling": decays,
    "updates: datum and sign of each channel": datums,
}


def counts(subject: str) -> tuple[int, int, int, int]:
    """Variants tried, right, wrong but flagged, silently wrong."""
    outcomes = list(SUBJECTS[subject]())
    right = sum(is_right for is_right, _ in outcomes)
    flagged = sum(is_loud and not is_right for is_right, is_loud in outcomes)
    return len(outcomes), right, flagged, len(outcomes) - right - flagged


def write_table(folder: Path) -> None:
    """Write the table of all subjects as a page to include."""
    lines = ["| recorded | variants tried | right | wrong, flagged | silently wrong |", "|---|---|---|---|---|"]
    lines += [f"| {subject} | {' | '.join(map(str, counts(subject)))} |" for subject in SUBJECTS]
    folder.mkdir(exist_ok=True)
    (folder / "identification-variants.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
