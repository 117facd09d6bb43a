"""What a damper should do: damping ratios at the wheel over speed, or a law from a fit, a campaign or a design."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Self, TypeAlias

import numpy as np

from jounce.core.columns import name_and_unit
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.files import existing_file, reading
from jounce.core.operation import File, MadeBy, Number
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import positive_si
from jounce.design.lumping import lump
from jounce.parts import Corner, QuarterCar, Rig, as_rig
from jounce.parts.dampers import DamperLaw, MapDamper, SampledPoint, as_damper, damper_laws
from jounce.parts.vehicles import FullCar3D, Vehicle
from jounce.recordings.cells import cells_of_file, si_of_cell

_BEYOND = 20.0  # m/s: further than any wheel moves


@dataclass(frozen=True)
class DampedWheel(Plain):
    """What a damper works on, for damping ratios at the wheel.

    Attributes
    ----------
    motion_ratio : float
        Damper travel over wheel travel [1].
    sprung_mass : float
        Sprung mass on the wheel, kg.
    wheel_rate : float
        Spring rate at the wheel, N/m, without the tyre.
    """

    motion_ratio: Annotated[float, Shows("damper travel over wheel travel", "1")]
    sprung_mass: Annotated[float, Shows("sprung mass", "kg")]
    wheel_rate: Annotated[float, Shows("wheel rate", "N/m")]

    def __post_init__(self) -> None:
        for name, unit in (("motion_ratio", "1"), ("sprung_mass", "kg"), ("wheel_rate", "N/m")):
            value = positive_si(getattr(self, name), unit, where=name)
            object.__setattr__(self, name, value)

    @property
    def critical_coefficient(self) -> float:
        """Critical damping coefficient at the wheel, N s/m: ``2 sqrt(wheel_rate sprung_mass)``."""
        return 2.0 * math.sqrt(self.wheel_rate * self.sprung_mass)

    def ratio(self, velocity: Array, force: Array) -> Array:
        """Return the damping ratio [1] of a linear damper with this force (N) at a damper velocity (m/s)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            coefficient = np.asarray(force) / np.asarray(velocity)
        return np.asarray(coefficient * self.motion_ratio**2 / self.critical_coefficient)


@dataclass(frozen=True)
class WheelDamping(Plain):
    """Damping ratios at the wheel over its speed, as a target for a damper.

    At each speed the ratio is that of a linear damper with the same force. Between speeds, and to rest, the force is
    linear. Beyond the last speed of a side there is no target.

    Attributes
    ----------
    speed : tuple of float
        Wheel speeds against the body, m/s, ascending: bump positive, rebound negative, without zero.
    ratio : tuple of float
        Damping ratio [1] at each speed.

    Examples
    --------
    >>> import jounce as jn
    >>> target = jn.WheelDamping((-0.2, -0.05, 0.05, 0.2), (0.4, 0.8, 0.6, 0.3))
    >>> wheel = jn.DampedWheel(motion_ratio=0.9, sprung_mass=60.0, wheel_rate=24e3)     # critical: 2400 N s/m
    >>> round(float(target.force(0.05 * 0.9, wheel)), 3)                                # 0.6 * 2400 * 0.05 / 0.9
    80.0
    """

    speed: tuple[float, ...]
    ratio: tuple[float, ...]

    def __post_init__(self) -> None:
        speeds = np.asarray(self.speed, dtype=float)
        ratios = np.asarray(self.ratio, dtype=float)
        if speeds.ndim != 1 or speeds.shape != ratios.shape or not len(speeds):
            raise DescriptionError(
                "one damping ratio for each speed is required", where="ratio",
                found=f"{ratios.size}", allowed=f"{speeds.size}",
            )  # fmt: skip
        if not (np.isfinite(speeds).all() and (np.diff(speeds) > 0.0).all() and speeds.all()):
            raise DescriptionError(
                "speeds must ascend, without zero", where="speed",
                found=", ".join(f"{value:g}" for value in speeds), allowed="-0.2, -0.05, 0.05, 0.2",
            )  # fmt: skip
        if not (np.isfinite(ratios).all() and (ratios > 0.0).all()):
            raise DescriptionError(
                "out of range", where="ratio", allowed="above 0",
                found=", ".join(f"{value:g}" for value in ratios),
            )  # fmt: skip

    @classmethod
    def low_and_high(
        cls,
        bump: float,
        rebound: float,
        high_speed_bump: float | None = None,
        high_speed_rebound: float | None = None,
        *,
        knee: float | str = 0.1,
    ) -> Self:
        """Build the target of a digressive damper: damping ratios of its slope below and beyond a knee.

        Parameters
        ----------
        bump, rebound : float
            Damping ratio at low speed [1].
        high_speed_bump, high_speed_rebound : float, optional
            Damping ratio of the slope of the force beyond the knee [1]; by default as at low speed.
        knee : float or str
            Wheel speed of the knee, m/s.

        Examples
        --------
        >>> target = WheelDamping.low_and_high(0.6, 0.8, 0.3, 0.4, knee="0.1 m/s")
        >>> wheel = DampedWheel(1.0, 60.0, 24e3)
        >>> (target.force(0.2, wheel) - target.force(0.1, wheel)).round(9) == 0.3 * 2400.0 * 0.1
        np.True_
        """
        at = positive_si(knee, "m/s", where="knee")
        sides = ((bump, high_speed_bump), (rebound, high_speed_rebound))
        far = [
            ((low if high is None else high) * (_BEYOND - at) + low * at) / _BEYOND
            for low, high in sides
        ]
        return cls((-_BEYOND, -at, at, _BEYOND), (far[1], rebound, bump, far[0]))

    def force(self, velocity: float | Array, wheel: DampedWheel) -> Array:
        """Return the force of the damper (N) at its velocity (m/s, bump positive); NaN beyond the target."""
        speed = np.asarray(self.speed)
        at = np.insert(speed, np.searchsorted(speed, 0.0), 0.0)
        wheel_force = np.insert(
            speed * self.ratio * wheel.critical_coefficient, np.searchsorted(speed, 0.0), 0.0
        )
        force = np.interp(
            np.asarray(velocity) / wheel.motion_ratio, at, wheel_force, left=np.nan, right=np.nan
        )
        return np.asarray(force / wheel.motion_ratio)


AnyDamperTarget: TypeAlias = Annotated[
    "WheelDamping | DamperLaw | Mapping[str, Any] | Rig | str | Path | Any",
    MadeBy(
        "jounce.design.damper_targets:chosen_target",
        "jounce.design.damper_targets:target_in_python",
    ),
]
"""What a damper should do; commands ask for damping ratios or a file."""
_RATIO = "Damping ratio at the wheel, e.g. 0.7 or 70 %"


def chosen_target(
    target: Annotated[
        str | None,
        File(
            "A rig whose damper is the target (of a campaign, a design), or the JSON of `jounce fit damper`.",
            "FILE",
            shipped=("parts",),
        ),
    ] = None,
    ratios: Annotated[
        str | None,
        File(r"Damping ratios at the wheel over its speed: a table with speed \[m/s] and ratio."),
    ] = None,
    bump: Annotated[float | None, Number(f"{_RATIO}: bump at low speed.", "RATIO")] = None,
    rebound: Annotated[float | None, Number(f"{_RATIO}: rebound at low speed.", "RATIO")] = None,
    high_speed_bump: Annotated[
        float | None, Number(f"{_RATIO}: slope in bump beyond the knee.", "RATIO")
    ] = None,
    high_speed_rebound: Annotated[
        float | None, Number(f"{_RATIO}: slope in rebound beyond the knee.", "RATIO")
    ] = None,
    knee: Annotated[
        float | None, Number("Wheel speed of the knee; by default 0.1 m/s.", "SPEED", "m/s")
    ] = None,
) -> WheelDamping | str:
    """Build a target from options: a file, a table of damping ratios, or ratios at low and high speed.

    Raises
    ------
    DescriptionError
        If no target is given, or more than one.
    """
    own = {"bump": bump, "rebound": rebound}
    more = (high_speed_bump, high_speed_rebound, knee)
    are_ratios = any(value is not None for value in (*own.values(), *more))
    if [target is not None, ratios is not None, are_ratios].count(True) != 1:
        raise DescriptionError(
            "a target is required, and only one", where="target",
            allowed="--target, --ratios, or --bump and --rebound",
        )  # fmt: skip
    if target is not None:
        return target
    if ratios is not None:
        return read_damping_ratios(ratios)
    for name, value in own.items():
        if value is None:
            raise DescriptionError(
                Phrase("{name} is required with it", name=f"--{name}"), where="target",
                hint="Give --bump and --rebound.",
            )  # fmt: skip
    assert bump is not None
    assert rebound is not None
    return WheelDamping.low_and_high(
        bump, rebound, high_speed_bump, high_speed_rebound, knee=0.1 if knee is None else knee
    )


def target_in_python(target: str | None = None, **given: Any) -> str:
    """Write the target as Python code.

    >>> target_in_python(bump=0.6, rebound=0.8)
    'jn.WheelDamping.low_and_high(bump=0.6, rebound=0.8)'
    """
    if target is not None:
        return repr(target)
    if given.get("ratios") is not None:
        return f"jn.read_damping_ratios({given['ratios']!r})"
    words = ", ".join(f"{name}={value!r}" for name, value in given.items() if value is not None)
    return f"jn.WheelDamping.low_and_high({words})"


def read_damping_ratios(path: str | Path) -> WheelDamping:
    r"""Read damping ratios at the wheel over its speed from a table, as a target for clicks.

    Parameters
    ----------
    path : str or Path
        Table (CSV, text or workbook) with a column ``speed`` (m/s unless the heading states a unit; bump positive,
        rebound negative) and a column ``ratio`` (1, or % if the heading states it).

    Returns
    -------
    WheelDamping
        The target.

    Raises
    ------
    RecordingError
        If a column is missing or a cell is no number.
    DescriptionError
        If speeds are zero or given twice, or ratios are not positive.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "ratios.csv"
    >>> _ = file.write_text("speed [mm/s],ratio\n-50,0.8\n50,0.6\n")
    >>> read_damping_ratios(file)
    WheelDamping(speed=(-0.05, 0.05), ratio=(0.8, 0.6))
    """
    points = sorted(columns_of_table(path, {"speed": "m/s", "ratio": "1"}))
    return WheelDamping(tuple(speed for speed, _ in points), tuple(value for _, value in points))


def columns_of_table(path: str | Path, wanted: Mapping[str, str]) -> list[tuple[float, ...]]:
    """Read columns of a table by name, in SI units.

    Raises
    ------
    RecordingError
        If a column is missing or a cell is no number.
    """
    file = existing_file(Path(path), RecordingError)
    header, *rows = cells_of_file(file) or [[]]
    headings = [name_and_unit(cell) for cell in header]
    names = [name.strip().lower() for name, _ in headings]
    for name in wanted:
        if names.count(name) != 1:
            raise RecordingError(
                Phrase("one column {name} is required", name=name), where=str(file),
                found=", ".join(header), allowed=", ".join(f"{n} [{u}]" for n, u in wanted.items()),
            )  # fmt: skip
    points = []
    for number, row in enumerate(rows, 2):
        if any(cell.strip() for cell in row):
            values = []
            for name, unit in wanted.items():
                place = names.index(name)
                cell, where = (
                    row[place] if place < len(row) else "",
                    f"{file}, row {number}, {name}",
                )
                values.append(si_of_cell(cell, headings[place][1], unit, where))
            points.append(tuple(values))
    if not points:
        raise RecordingError("the table has no rows", where=str(file))
    return points


def law_and_rig(target: Any, place: str) -> tuple[DamperLaw, Rig | None, str]:
    """Return the damper law of a target, the rig in which it stands if there is one, and its path there.

    Raises
    ------
    DescriptionError
        If there is no damper law, or several and ``place`` does not choose one of them.
    """
    if isinstance(target, str | Path) and Path(target).suffix.lower() == ".json":
        target = _of_fit(Path(target))
    if isinstance(target, str | Path):
        target = as_rig(target)
    target = getattr(target, "rig", target)
    if isinstance(target, Rig):
        path, law = damper_in(target, place)
        return law, target, path
    table = getattr(target, "fit", target)
    table = getattr(table, "damper", table)
    if not isinstance(table, DamperLaw | Mapping):
        raise DescriptionError(
            "no target for a damper", where="target", found=type(target).__name__,
            allowed="damping ratios, a damper law, a rig, or the result of a fit or design",
        )  # fmt: skip
    return as_damper(table, where="target"), None, ""


def _of_fit(file: Path) -> Mapping[str, Any]:
    """Return the damper table of the JSON of a fit."""
    with reading(existing_file(file, DescriptionError), DescriptionError):
        text = file.read_text(encoding="utf-8", errors="replace")
    try:
        answer = json.loads(text)
    except (ValueError, RecursionError):
        answer = None
    table = answer.get("damper", answer) if isinstance(answer, dict) else None
    if not isinstance(table, dict):
        raise DescriptionError(
            "no damper law in this file", where=str(file), allowed="the JSON of `jounce fit damper`"
        )
    return table


def damper_in(rig: Rig, place: str = "") -> tuple[str, DamperLaw]:
    """Return path and law of the damper of a rig; ``place`` is the beginning of its path, if it has several.

    Raises
    ------
    DescriptionError
        If the rig has no damper law there, or several, or its law acts at the wheel.
    """
    if isinstance(rig, Vehicle) and not isinstance(rig, FullCar3D):
        raise DescriptionError(
            "the dampers of this vehicle act at the wheel, not at a damper", where="place",
            found=type(rig).__name__, allowed="a quarter car, a corner or a 3-D car",
            hint="Or state damping ratios with motion ratio, sprung mass and wheel rate.",
        )  # fmt: skip
    laws = dict(damper_laws(rig))
    chosen = {path: law for path, law in laws.items() if path.startswith(place)}
    own = {path: law for path, law in chosen.items() if "third_spring" not in path}
    chosen = own if len(own) == 1 else chosen
    if len(chosen) != 1:
        raise DescriptionError(
            "the rig has several dampers" if chosen else "the rig has no damper law there",
            where="place", found=place or "nothing", allowed=", ".join(laws) or "a rig with struts",
            hint="Name the damper by its path." if laws else "",
        )  # fmt: skip
    return next(iter(chosen.items()))


def steady_force(law: DamperLaw, rig: Rig | None, velocity: Array) -> Array:
    """Return the force of a law without that at rest (N) in steady motion at velocities (m/s), in mid-stroke.

    A law with a state (Bouc-Wen) is taken with the state to which steady motion leads. A map over length is taken at
    its length at design, or without a rig in the middle of the table.
    """
    if isinstance(law, MapDamper):
        middle = 0.5 * (law.length[0] + law.length[-1])
        law = law.at_length(rig.hardpoints.length("damper") if isinstance(rig, Corner) else middle)
    if not law.remembers:
        return np.asarray(law.forces(velocity) - law.forces(np.zeros(1)))
    point = _Settled(lambda name: getattr(law, name), np.asarray(velocity, dtype=float))
    rest = _Settled(lambda name: getattr(law, name), np.zeros(1))
    return np.asarray(law.evaluate(point) - law.evaluate(rest))


class _Settled(SampledPoint):
    """Operating points of steady motion: a normalised state has reached the sign of the velocity."""

    def state(self, name: str, rate: Any) -> Any:  # noqa: ARG002
        return np.sign(self.velocity)


def wheel_of(rig: Rig | None, given: Mapping[str, float | str | None]) -> DampedWheel | None:
    """Return what a damper works on, from a quarter car or corner, and numbers given instead; None if unknown.

    Raises
    ------
    DescriptionError
        If only some of the numbers are known.
    """
    own: dict[str, float] = {}
    if isinstance(rig, QuarterCar):
        ratio = math.cos(rig.strut.angle)
        spring = rig.strut.spring.rate
        own = {"motion_ratio": ratio, "sprung_mass": rig.sprung.mass}
        if spring is not None:
            own["wheel_rate"] = spring * ratio**2
    elif isinstance(rig, Corner) and any(value is None for value in given.values()):
        with suppress(
            JounceError
        ):  # without an equilibrium there are no ratios; forces are compared all the same
            lumping = lump(rig)
            own = {
                "motion_ratio": lumping.damper_ratio,
                "sprung_mass": lumping.static_masses[0],
                "wheel_rate": lumping.wheel_rate,
            }
    values: dict[str, Any] = own | {n: value for n, value in given.items() if value is not None}
    missing = [name for name in given if name not in values]
    if len(missing) == len(given):
        return None
    if missing:
        raise DescriptionError(
            "motion ratio, sprung mass and wheel rate are required together",
            where=missing[0],
            found="nothing",
            hint="Or give a quarter car or a corner as rig.",
        )
    return DampedWheel(**values)
