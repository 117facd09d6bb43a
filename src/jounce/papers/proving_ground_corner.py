"""A real double wishbone as a quarter car: everything referred to the wheel, every number with its origin."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.types import Array
from jounce.parts import QuarterCar
from jounce.parts.importers import ChronoCorner, RigidPart

WHEEL_MASS, TYRE_MASS, TYRE_STIFFNESS, TYRE_DAMPING = 18.8, 37.6, 326332.0, 500.0
"""Of the same vehicle in the same repository as its hardpoints; see SOURCE.md beside them. kg, kg, N/m, N s/m."""
_STEP = 1e-4  # rad, of the lower arm
_SOURCE = "suspension file"
_SPRUNG = "spring force × motion ratio / g: what the spring carries at design position"
_UNSPRUNG = (
    "spindle, upright; arms as I/lever² about their axes; a third of the tie rod; wheel 18.8 kg and tyre 37.6 kg of "
    "the same vehicle"
)
_TYRE = "a tyre file of the same vehicle; other files of it say 411 121 and 441 900 N/m"
_TYRE_DAMPING = "a tyre file of the same vehicle, scaled by its author from another tyre"


@dataclass(frozen=True)
class Derived:
    """One number of the model and where it comes from.

    Attributes
    ----------
    name : str
        In words.
    value : float
        In ``unit``.
    unit : str
        SI.
    origin : str
        Source, or formula.
    is_estimated : bool
        Neither measured nor stated by the vehicle's file.
    """

    name: str
    value: float
    unit: str
    origin: str
    is_estimated: bool = False


@dataclass(frozen=True)
class LumpedCorner:
    """A corner with its spring and damper referred to vertical motion of the wheel centre.

    Attributes
    ----------
    rig : QuarterCar
        With the vehicle's own damper; strut deflection 0 is the design position.
    spring_motion_ratio, damper_motion_ratio : float
        Shortening of the element over rise of the wheel centre [1].
    bump_travel, rebound_travel : float
        Wheel travel from design to the spring's shortest and longest length, both positive [m].
    damper_stroke : float
        Range of lengths the vehicle's damper map covers [m].
    derived : tuple of Derived
        Every number with its origin.
    """

    rig: QuarterCar
    spring_motion_ratio: float
    damper_motion_ratio: float
    bump_travel: float
    rebound_travel: float
    damper_stroke: float
    derived: tuple[Derived, ...]


class FrontView:
    """Motion of a double wishbone in front view, steering and the slant of the upper arm's axis left out.

    The lower arm turns in space about its axis; upright and upper arm are then a four-bar linkage in the y-z plane, its
    fixed upper pivot being where the upper arm's axis passes the x of its ball joint.
    """

    def __init__(self, corner: ChronoCorner) -> None:
        points = corner.points
        self.points = points
        self.axis_point = points["lower_arm_front"]
        axis = points["lower_arm_front"] - points["lower_arm_rear"]
        self.axis = axis / np.linalg.norm(axis)
        slant = points["upper_arm_rear"] - points["upper_arm_front"]
        share = (points["upper_ball_joint"][0] - points["upper_arm_front"][0]) / slant[0]
        self.upper_pivot = (points["upper_arm_front"] + share * slant)[1:]
        self.design = self.points["lower_ball_joint"][1:], self.points["upper_ball_joint"][1:]

    def on_lower_arm(self, name: str, angle: float) -> Array:
        """Where a point of the lower arm is, shape (3,) in m, the arm turned by ``angle`` in rad, bump positive."""
        away = self.points[name] - self.axis_point
        cosine, sine = np.cos(angle), np.sin(angle)
        along = self.axis * (self.axis @ away)
        return np.asarray(self.axis_point + along + cosine * (away - along) + sine * np.cross(self.axis, away))

    def wheel_height(self, angle: float) -> float:
        """Height of the wheel centre in m at an ``angle`` of the lower arm in rad."""
        lower = self.on_lower_arm("lower_ball_joint", angle)[1:]
        upper = self._upper_ball_joint(lower)
        before, now = self.design[1] - self.design[0], upper - lower
        turn = np.arctan2(now[1], now[0]) - np.arctan2(before[1], before[0])
        out = self.points["wheel_centre"][1:] - self.design[0]
        return float(lower[1] + np.sin(turn) * out[0] + np.cos(turn) * out[1])

    def length(self, element: str, angle: float) -> float:
        """Length of ``"spring"`` or ``"damper"`` in m at an ``angle`` of the lower arm in rad."""
        foot = self.on_lower_arm(f"{element}_bottom", angle)
        return float(np.linalg.norm(self.points[f"{element}_top"] - foot))

    def motion_ratio(self, element: str, angle: float = 0.0) -> float:
        """Shortening of an element over rise of the wheel centre, 1, at an ``angle`` of the lower arm in rad."""
        low, high = angle - _STEP, angle + _STEP
        shortening = self.length(element, low) - self.length(element, high)
        return shortening / (self.wheel_height(high) - self.wheel_height(low))

    def lever(self) -> float:
        """Rise of the wheel centre per angle of the lower arm at design position in m/rad."""
        return (self.wheel_height(_STEP) - self.wheel_height(-_STEP)) / (2.0 * _STEP)

    def travel_at(self, element: str, length: float) -> float:
        """Rise of the wheel centre from design in m at which an element has a ``length`` in m."""
        from scipy.optimize import brentq

        angle = float(brentq(lambda angle: self.length(element, angle) - length, -0.5, 0.6))
        return self.wheel_height(angle) - self.wheel_height(0.0)

    def _upper_ball_joint(self, lower: Array) -> Array:
        """Where two circles meet: about the upper pivot and about the lower ball joint; the outer of both points."""
        upright = float(np.linalg.norm(self.design[1] - self.design[0]))
        arm = float(np.linalg.norm(self.design[1] - self.upper_pivot))
        between = lower - self.upper_pivot
        distance = float(np.linalg.norm(between))
        along = (arm**2 - upright**2 + distance**2) / (2.0 * distance)
        aside = float(np.sqrt(arm**2 - along**2))
        unit = between / distance
        return np.asarray(self.upper_pivot + along * unit + aside * np.array([-unit[1], unit[0]]))


def lumped_corner(corner: ChronoCorner) -> LumpedCorner:
    """Refer a double wishbone to the vertical motion of its wheel centre.

    Parameters
    ----------
    corner : ChronoCorner
        The vehicle's file.

    Returns
    -------
    LumpedCorner
        The quarter car, SI, with the origin of every number.

    Examples
    --------
    >>> from jounce.parts.importers import shipped_corner
    >>> lumped = lumped_corner(shipped_corner())
    >>> round(lumped.spring_motion_ratio, 3), round(lumped.rig.sprung.mass)   # 1, kg
    (0.45, 711)
    """
    view = FrontView(corner)
    ratios = view.motion_ratio("spring"), view.motion_ratio("damper")
    design = view.length("spring", 0.0)
    spring_force = corner.spring_rate * (corner.spring_free_length - design)
    turned = 10.0 * _STEP
    rise = view.wheel_height(turned) - view.wheel_height(-turned)
    bend = (view.motion_ratio("spring", turned) - view.motion_ratio("spring", -turned)) / rise
    rate = corner.spring_rate * ratios[0] ** 2 + spring_force * bend
    bump, rebound = corner.damper.coefficients_at(view.length("damper", 0.0))
    travels = view.travel_at("spring", corner.spring_shortest), -view.travel_at("spring", corner.spring_longest)
    masses = spring_force * ratios[0] / GRAVITY, _unsprung_mass(corner, view)
    damping = bump * ratios[1] ** 2, rebound * ratios[1] ** 2
    stroke = float(np.ptp(corner.damper.length))
    likewise, in_map = "likewise, damper", "middle of the damper map × ratio²"
    origins = (
        Derived("spring length at design position", design, "m", _SOURCE),
        Derived("spring force at design position", spring_force, "N", f"rate × (free length − length), {_SOURCE}"),
        Derived(
            "motion ratio of the spring", ratios[0], "1", "front view of arms and spring: −dℓ/dz at the wheel centre"
        ),
        Derived("motion ratio of the damper", ratios[1], "1", likewise),
        Derived("wheel rate", rate, "N/m", "rate × ratio² + spring force × d(ratio)/dz"),
        Derived("sprung mass of the corner", masses[0], "kg", _SPRUNG, True),
        Derived("unsprung mass", masses[1], "kg", _UNSPRUNG, True),
        Derived("tyre stiffness", TYRE_STIFFNESS, "N/m", _TYRE, True),
        Derived("tyre damping coefficient", TYRE_DAMPING, "N*s/m", _TYRE_DAMPING, True),
        Derived("bump travel", travels[0], "m", "wheel travel from design to the spring's shortest length"),
        Derived("rebound travel", travels[1], "m", "wheel travel from design to the spring's longest length"),
        Derived("own damper at the wheel, bump", damping[0], "N*s/m", in_map),
        Derived("own damper at the wheel, rebound", damping[1], "N*s/m", in_map),
        Derived("stroke of the damper", stroke, "m", "range of lengths of the damper map"),
    )
    return LumpedCorner(_rig(corner, masses, rate, damping), *ratios, *travels, stroke, origins)


def _rig(corner: ChronoCorner, masses: tuple[float, float], rate: float, damping: tuple[float, float]) -> QuarterCar:
    return QuarterCar.from_table(
        {
            "source": f"{corner.name}, github.com/projectchrono/chrono, BSD-3-Clause; referred to the wheel centre",
            "estimated": ["sprung.mass", "unsprung.mass", "tyre.stiffness", "tyre.damping_coefficient"],
            "gravity": GRAVITY,
            "sprung": {"mass": masses[0]},
            "unsprung": {"mass": masses[1]},
            "strut": {
                "spring": {"rate": rate, "preload": masses[0] * GRAVITY},
                "damper": {"bump_coefficient": damping[0], "rebound_coefficient": damping[1]},
            },
            "tyre": {"stiffness": TYRE_STIFFNESS, "damping_coefficient": TYRE_DAMPING},
        }
    )


def _unsprung_mass(corner: ChronoCorner, view: FrontView) -> float:
    """Mass at the wheel centre with the kinetic energy of the parts in kg."""
    parts, points = corner.parts, corner.points
    lower = _about_axis(parts["lower_arm"], view.axis, view.axis_point)
    upper_axis = points["upper_arm_front"] - points["upper_arm_rear"]
    upper_axis = upper_axis / np.linalg.norm(upper_axis)
    upper = _about_axis(parts["upper_arm"], upper_axis, points["upper_arm_front"])
    reach = float(points["upper_ball_joint"][1] - view.upper_pivot[0])
    whole = parts["spindle"].mass + parts["upright"].mass + WHEEL_MASS + TYRE_MASS
    return whole + lower / view.lever() ** 2 + upper / reach**2 + corner.tie_rod_mass / 3.0


def _about_axis(part: RigidPart, axis: Array, point: Array) -> float:
    """Moment of inertia about an axis (unit vector through a point) in kg m^2."""
    away = part.centre - point
    return float(axis**2 @ part.moments + part.mass * np.linalg.norm(np.cross(axis, away)) ** 2)
