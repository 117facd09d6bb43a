"""Test sheets: expected results and information of planned trials, with space for notes."""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import numpy as np

from jounce.campaign.belt import with_recurrence
from jounce.campaign.from_folder import quarter_car_text
from jounce.campaign.laboratory import Laboratory, TrialRow, load_laboratory, read_trials
from jounce.core.errors import DescriptionError
from jounce.core.operation import File, Switch, operation
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.identify.belt_loops import running_trial
from jounce.parts import Rig, load
from jounce.parts.files import rig_from_table
from jounce.parts.variants import with_strut_angle
from jounce.roads import ROADS, Road, Train, Trial
from jounce.simulation import modes
from jounce.simulation.derivatives import sensitivities

CHANNELS = {"sprung.az": 0.2, "unsprung.az": 1.0}
"""Predicted channels, and the noise (m/s^2) of a typical accelerometer, as on the virtual bench."""
TAUGHT = (
    "strut.spring.rate",
    "strut.damper.bump_coefficient",
    "strut.damper.rebound_coefficient",
    "strut.damper.coefficient",
    "tyre.stiffness",
    "guide.friction.force",
)
"""Parameters of a quarter car that trials can determine."""
_STEP, _AFTER = 1e-3, 1.0  # s; of the prediction, and behind a single obstacle


@dataclass(frozen=True)
class SheetTrial(Shown):
    """One trial of a test sheet.

    Attributes
    ----------
    number : int
        Trial number in the table.
    speed, angle, pressure, pitch : float or None
        Settings: m/s, rad, Pa, and the pitch of the obstacles of a train, m.
    obstacles : int
        Number of obstacles on the belt.
    returns : float or None
        Time (s) after which the obstacle returns.
    peaks : dict
        Expected maximum absolute value by channel, SI.
    teaches : dict
        Relative standard error (1) by parameter, due to noise alone and with all other parameters known.
    """

    number: int
    speed: float | None
    angle: float | None
    pressure: float | None
    pitch: float | None
    obstacles: int
    returns: float | None
    peaks: dict[str, float]
    teaches: dict[str, float]


@dataclass(frozen=True)
class TestSheet(Plain):
    """A test sheet with trials in the order that needs the least set-up work.

    Attributes
    ----------
    title : str
        Title of the laboratory.
    trials : tuple of SheetTrial
        Trials in running order.
    frequencies : tuple of float
        Expected natural frequencies of the rig, Hz.
    masses : tuple of float
        Sprung and unsprung mass, kg.
    channels : tuple of (str, str, str)
        Column of the card, measured channel and sensitivity.
    for_students : bool
        Whether the sheet has space for predictions and conclusions.
    """

    __test__ = False  # no test of pytest

    title: str
    trials: tuple[SheetTrial, ...]
    frequencies: tuple[float, ...]
    masses: tuple[float, ...]
    channels: tuple[tuple[str, str, str], ...]
    for_students: bool


@operation(
    "campaign sheet",
    offers=("report",),
    page="jounce.report.laboratory:sheet_page",
    title="{result.title}",
    doing="predicting trials",
    example="jounce campaign sheet settings.toml --report sheet.pdf",
)
def plan_test(
    settings: Annotated[Path | str, File("Settings of the laboratory.", "SETTINGS.toml")],
    *,
    students: Annotated[
        bool, Switch("Add space to predict, measure and compare, for a laboratory exercise.")
    ] = False,
) -> TestSheet:
    """Predict the planned trials of a laboratory, and prepare a sheet for notes.

    Parameters
    ----------
    settings : path
        Settings of the laboratory (schema ``jounce.laboratory/1``) that name the table of trials.
    students : bool
        Add space for predictions, measurements and conclusions.

    Returns
    -------
    TestSheet
        Trials in the order that needs the least set-up work, with expected peaks and information.

    Raises
    ------
    DescriptionError
        If the settings are invalid or have no table of trials.

    Examples
    --------
    >>> plan_test("nowhere.toml")   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: nowhere.toml: ...
    """
    file = Path(settings)
    laboratory = load_laboratory(file)
    if not laboratory.trials:
        raise DescriptionError(
            "the settings name no table of trials",
            where=f"{file}: trials",
            allowed='trials = "table.csv"',
        )
    rows = read_trials(file.parent / laboratory.trials)
    rig = _rig_of(laboratory, rows, file)
    ordered = sorted(
        rows,
        key=lambda row: (
            -(row.pressure or 0.0),
            -(row.angle or 0.0),
            row.pitch or 0.0,
            row.speed or 0.0,
        ),
    )
    values = rig.parameters()
    channels = tuple(
        (column, channel.measures, str(channel.sensitivity))
        for column, channel in laboratory.channels.items()
    )
    return TestSheet(
        laboratory.title,
        tuple(_predict(rig, laboratory, row) for row in ordered),
        tuple(mode.frequency_hz for mode in modes(rig) if mode.frequency_hz > 0.0),
        tuple(values[path] for path in ("sprung.mass", "unsprung.mass") if path in values),
        channels,
        students,
    )


def _rig_of(laboratory: Laboratory, rows: list[TrialRow], file: Path) -> Rig:
    if laboratory.rig:
        local = file.parent / laboratory.rig
        return load(local if local.is_file() else laboratory.rig)
    angle = next((row.angle for row in rows if row.angle is not None), 0.0)
    text = quarter_car_text(
        f"{laboratory.sprung_mass:g} kg", f"{laboratory.unsprung_mass:g} kg", angle
    )
    return rig_from_table(tomllib.loads(text), where=str(file))


def _predict(rig: Rig, laboratory: Laboratory, row: TrialRow) -> SheetTrial:
    """Predict peaks and information of one trial on a running belt."""
    rig = rig if row.angle is None else with_strut_angle(rig, row.angle)
    road = _road_of(laboratory, row)
    peaks: dict[str, float] = {}
    teaches: dict[str, float] = {}
    returns = None
    if row.speed is not None:
        if road.recurrence is not None:
            trial, begin = running_trial(rig, road, row.speed)
            returns = road.recurrence / row.speed
        else:
            trial, begin = (
                Trial(road=road, speed=row.speed, duration=road.end() / row.speed + _AFTER),
                0.0,
            )
        values = rig.parameters()
        paths = [path for path in TAUGHT if values.get(path)]
        slopes = sensitivities(rig, trial, paths, output_step=_STEP)
        peaks = _peaks(rig, trial, begin)
        time = slopes["time"].to_numpy()
        for path in paths:
            information = sum(
                float(
                    np.sum(
                        (slopes[name].sel(parameter=path).to_numpy()[time >= begin] / noise) ** 2
                    )
                )
                for name, noise in CHANNELS.items()
            )
            if information > 0.0:
                teaches[path] = 1.0 / math.sqrt(information) / abs(values[path])
    return SheetTrial(
        row.number,
        row.speed,
        row.angle,
        row.pressure,
        row.pitch,
        row.count,
        returns,
        peaks,
        teaches,
    )


def _road_of(laboratory: Laboratory, row: TrialRow) -> Road:
    obstacle = laboratory.obstacle
    fields = {"kind": obstacle.shape, "height": obstacle.height, "length": obstacle.length}
    single = ROADS[obstacle.shape].from_table(fields, where="obstacle")
    road = single if row.pitch is None else Train(of=single, count=row.count, pitch=row.pitch)
    return with_recurrence(road, laboratory.belt)


def _peaks(rig: Rig, trial: Trial, begin: float) -> dict[str, float]:
    from jounce.simulation.settings import RunSettings
    from jounce.simulation.solve import solve

    run = solve(rig, trial, RunSettings(_STEP))
    return {
        name: float(np.max(np.abs(run.channels[name][0][run.time >= begin]))) for name in CHANNELS
    }
