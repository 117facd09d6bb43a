"""The truth of the virtual bench: the double wishbone, richer than the models that campaigns update, and its machine.

The paper's recordings are lost, so a synthetic bench stands in for its laboratory. It runs the shipped kart-scale
double wishbone in 3-D, which is what the paper built; a quarter car that is fitted to it lacks the linkage (motion
ratio that changes with travel, inertia of arms and upright). What the bench has and both models lack: a slightly
heavier upright than its builders say, a tyre that stiffens with deflection and damps, a damper whose force falls behind
its velocity (degressive, softer in bump than in rebound), dry friction in strut and guide, and, on the test machine
only, a tyre that first settles on its support (the paper's explanation of its soft first 2 mm; a rolling tyre does not
do that). What the wheel meets is richer, too: a contact patch of finite length smooths the obstacle, and every obstacle
slows the belt down a little, which the motor then makes up for.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from jounce.core.types import Array
from jounce.parts import DoubleWishbone, load
from jounce.parts.variants import with_strut_angle
from jounce.roads import Excitation, Road, Train

SYNTHETIC = "Synthetic: made by jounce's virtual bench from a richer model (truth.toml); not a laboratory record."
RIG = "kart-double-wishbone"
"""Shipped rig whose geometry and masses the bench has, but for what is said here."""
SPRING_RATE = 22730.0  # N/m
SPRUNG_MASS = 16.0  # kg
UPRIGHT_MASS = 4.7  # kg, with wheel; campaigns are told 4.6 kg
TYRE_DAMPING = 20.0  # N s/m
STRUT_FRICTION = 5.0  # N
GUIDE_FRICTION = 9.0  # N
REGULARISATION_VELOCITY = 0.001  # m/s
DAMPER_VELOCITY = (-1.2, -0.5, -0.15, 0.0, 0.15, 0.5, 1.2)  # m/s, bump positive
DAMPER_FORCE = (-190.0, -92.0, -32.0, 0.0, 23.0, 66.0, 136.0)  # N
TYRE_CURVES: Mapping[float, tuple[float, float, float]] = MappingProxyType(
    {310e3: (128.8e3, 0.60e6, 30e6), 250e3: (114.2e3, 0.85e6, 22e6)}
)  # Pa: N/m, N/m^2, N/m^3, rolling
SETTLING = 0.45e-3, 50.0  # m, N: how far, and the force over which, a tyre settles on the test machine's support
CONTACT_LENGTH = 0.012  # m
SPEED_DROP = 0.006  # share of the belt's speed that each obstacle takes
SPEED_RECOVERY = 0.4  # s
TYRE_LOSS = 0.06  # share of the force missing when the tyre is unloaded


def true_rig(strut_angle: float = 0.4537856, tyre_pressure: float = 310e3) -> DoubleWishbone:
    """Give the rig that the virtual bench runs.

    Parameters
    ----------
    strut_angle : float
        Angle of the strut to the vertical in front view, rad; 26 degrees by default.
    tyre_pressure : float
        310e3 or 250e3 Pa.

    Returns
    -------
    DoubleWishbone
        The shipped one with tyre curve, degressive damper, friction and a heavier upright.

    Examples
    --------
    >>> rig = true_rig()
    >>> rig.guide_friction.force, rig.tyre.curve.kind
    (9.0, 'polynomial')
    """
    shipped = load(RIG)
    assert isinstance(shipped, DoubleWishbone)
    friction = {"regularisation_velocity": REGULARISATION_VELOCITY}
    table: dict[str, Any] = shipped.model_dump(by_alias=True, exclude_none=True)
    strut, upright = table["strut"], table["bodies"]["upright"]
    table |= {
        "source": SYNTHETIC,
        "estimated": (),
        "sprung": {"mass": SPRUNG_MASS},
        "bodies": {**table["bodies"], "upright": {**upright, "mass": UPRIGHT_MASS}},
        "strut": {
            **strut,
            "spring": {**strut["spring"], "rate": SPRING_RATE},
            "damper": {"velocity": DAMPER_VELOCITY, "force": DAMPER_FORCE},
            "friction": {"force": STRUT_FRICTION, **friction},
        },
        "guide_friction": {"force": GUIDE_FRICTION, **friction},
        "tyre": {
            "curve": {"kind": "polynomial", "coefficients": TYRE_CURVES[tyre_pressure]},
            "damping_coefficient": TYRE_DAMPING,
        },
    }
    return with_strut_angle(DoubleWishbone.from_table(table), strut_angle)


def spring_cycle(stroke: float, points: int, rate: float) -> tuple[Array, Array]:
    """Load and unload spring and strut on the test machine.

    Parameters
    ----------
    stroke : float
        Largest deflection, m.
    points : int
        Samples of one branch.
    rate : float
        Spring rate of this trial, N/m.

    Returns
    -------
    deflection, force : ndarray, shape (2 points - 1,)
        m and N; the load cell was zeroed with the strut sliding, so its friction shows as a drop of twice its force
        on the way back.
    """
    deflection, direction = _triangle(stroke, points)
    reversed_friction = 2.0 * STRUT_FRICTION * (1.0 - np.exp(-(stroke - deflection) / 0.1e-3))
    return deflection, rate * deflection - np.where(direction > 0.0, 0.0, reversed_friction)


def tyre_cycle(stroke: float, points: int, pressure: float, scale: float) -> tuple[Array, Array]:
    """Load and unload the standing tyre on the test machine.

    Parameters
    ----------
    stroke : float
        Largest deflection of the machine, m: tyre and settling together.
    points : int
        Samples of one branch.
    pressure : float
        310e3 or 250e3 Pa.
    scale : float
        Stiffness of this trial relative to the true curve.

    Returns
    -------
    deflection, force : ndarray, shape (2 points - 1,)
        m and N; softer than the rolling tyre at first, lower when unloading.
    """
    deflection, direction = _triangle(stroke, points)
    tyre = np.linspace(0.0, stroke, 4001)
    force = scale * np.polyval([*reversed(TYRE_CURVES[pressure]), 0.0], tyre)
    machine = tyre + SETTLING[0] * (1.0 - np.exp(-force / SETTLING[1]))
    loading = np.interp(deflection, machine, force)
    lost = np.where(direction > 0.0, 0.0, TYRE_LOSS * (1.0 - (deflection / stroke) ** 4))
    return deflection, loading * (1.0 - lost)


def _triangle(stroke: float, points: int) -> tuple[Array, Array]:
    """Deflections up and down again, and +1 or -1 for the direction."""
    up = np.linspace(0.0, stroke, points)
    return np.concatenate([up, up[-2::-1]]), np.concatenate([np.ones(points), -np.ones(points - 1)])


def wheel_path(road: Road, speed: float, duration: float, *, points: int = 60) -> Excitation:
    """Height that the wheel really meets while the belt carries obstacles past it.

    Parameters
    ----------
    road : Road
        One obstacle or a train of them.
    speed : float
        Speed of the belt before the first obstacle, m/s.
    duration : float
        Length of the recording, s.
    points : int
        Samples of an obstacle's length; between obstacles that lie apart the height stays level without any.

    Returns
    -------
    Excitation
        Height (m) against time (s): the mean of the obstacle's height over the contact patch, which begins half a
        patch before the foot, at the distance that the slowed belt has reached.
    """
    spacing = (road.end() - road.start) / points if not isinstance(road, Train) else road.of.profile().span / points
    reach = 0.5 * CONTACT_LENGTH + 2.0 * spacing
    distance = np.arange(road.start - reach, road.end() + reach, spacing)
    time = _time_at(distance, road, speed)
    height = _patch_mean(road, distance)
    ends = np.array([0.0, 0.5 * time[0]]), np.array([0.5 * (time[-1] + duration), duration])
    return Excitation(
        time=np.concatenate([ends[0], time, ends[1]]), height=np.concatenate([np.zeros(2), height, np.zeros(2)])
    )


def _patch_mean(road: Road, distance: Array) -> Array:
    """Mean height over the contact patch, from the integral of the height on a fine grid."""
    grid = np.arange(distance[0] - CONTACT_LENGTH, distance[-1] + CONTACT_LENGTH, 5e-5)
    height = road.height_at(grid)
    area = np.concatenate([[0.0], np.cumsum(0.5 * (height[1:] + height[:-1]) * np.diff(grid))])
    half = 0.5 * CONTACT_LENGTH
    gained = np.interp(distance + half, grid, area) - np.interp(distance - half, grid, area)
    return np.asarray(gained / CONTACT_LENGTH, dtype=float)


def _time_at(distance: Array, road: Road, speed: float) -> Array:
    """Time at which the belt has moved by ``distance``: each foot of an obstacle takes a share of the speed.

    The missing speed decays exponentially in time; over the few centimetres concerned, time is distance over speed.
    """
    feet = [road.start] if not isinstance(road, Train) else [road.start + i * road.pitch for i in range(road.count)]
    missing = np.zeros_like(distance)
    for foot in feet:
        since = np.maximum(distance - foot, 0.0) / speed
        missing += np.where(since > 0.0, SPEED_DROP * np.exp(-since / SPEED_RECOVERY), 0.0)
    slowness = 1.0 / (speed * (1.0 - missing))
    steps = 0.5 * (slowness[1:] + slowness[:-1]) * np.diff(distance)
    return np.asarray(distance[0] / speed + np.concatenate([[0.0], np.cumsum(steps)]), dtype=float)
