"""Springs and dampers from frequencies and damping ratios."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.operation import MadeBy, Number, Switch, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import plain_table
from jounce.core.shown import Shown
from jounce.core.text import align_columns
from jounce.core.units import to_si
from jounce.parts import QuarterCar, Rig, as_rig
from jounce.parts.dampers import LinearDamper
from jounce.parts.options import AnyRig
from jounce.parts.vehicles import FullCar3D, HalfCar, Vehicle
from jounce.ride.closed_forms import (
    LumpedCorner,
    SpringAndDamper,
    as_built,
    corner_masses,
    spring_and_damper,
)


@dataclass(frozen=True)
class WheelCarriage:
    """Masses and stiffnesses of one wheel, and the paths of its spring and damper, SI.

    ``place`` is ``front``, ``rear``, or empty for a quarter car; ``spring`` and ``damper`` are the paths of rate and
    coefficient; ``motion_ratio`` is spring travel over wheel travel (1). Values are None if the model has no such part.
    """

    place: str
    sprung_mass: float
    spring: str
    damper: str
    motion_ratio: float = 1.0
    unsprung_mass: float | None = None
    tyre_stiffness: float | None = None
    tyre_damping: float = 0.0

    def quarter_car(self, values: Mapping[str, float]) -> LumpedCorner:
        """Return the quarter car of this wheel for parameter values (SI) of its rig."""
        if self.unsprung_mass is None or self.tyre_stiffness is None:
            raise DescriptionError(
                "the best damping needs a wheel mass and a constant tyre stiffness",
                where=self.place or "tyre",
                hint="Give unsprung masses and tyres: a quarter car, a half-car-4dof or a full car.",
            )
        lever = self.motion_ratio**2
        rates = values[self.spring] * lever, values[self.damper] * lever
        return LumpedCorner(
            self.sprung_mass, self.unsprung_mass, rates[0], self.tyre_stiffness, rates[1]
        )


def wheels_of(rig: Rig) -> tuple[WheelCarriage, ...]:
    """Return the wheel of a quarter car, or one per axle of a vehicle; reject 3-D rigs and nonlinear laws."""
    if isinstance(rig, QuarterCar):
        tyre, ratio = rig.tyre, float(np.cos(rig.strut.angle))
        damper = _linear("strut.damper", rig.strut.damper)
        return (
            WheelCarriage(
                "", rig.sprung.mass, _rate("strut.spring", rig.strut.spring.rate), damper, ratio,
                rig.unsprung.mass, tyre.stiffness, tyre.damping_coefficient,
            ),
        )  # fmt: skip
    if not isinstance(rig, Vehicle) or isinstance(rig, FullCar3D):
        raise DescriptionError(
            "only quarter cars and lumped vehicles are designed this way",
            where="design",
            found=getattr(rig, "model", type(rig).__name__),
            hint="jn.lumped_from(rig) gives the quarter car equivalent to a corner in 3-D.",
        )
    vehicle: Any = rig
    masses = corner_masses(vehicle.body.mass, vehicle.front.distance, vehicle.rear.distance)
    return tuple(
        _axle(rig, name, mass) for name, mass in zip(("front", "rear"), masses, strict=True)
    )


def _axle(rig: Rig, name: str, mass: float) -> WheelCarriage:
    axle: Any = getattr(rig, name)
    if isinstance(rig, HalfCar):
        return WheelCarriage(name, mass, f"{name}.spring_rate", f"{name}.damping_coefficient")
    if axle.spring_rate is not None:
        spring = f"{name}.spring_rate"
    else:
        spring = _rate(f"{name}.spring", axle.spring.rate)
    damper = (
        f"{name}.damping_coefficient"
        if axle.damper is None
        else _linear(f"{name}.damper", axle.damper)
    )
    tyre = axle.tyre
    return WheelCarriage(
        name,
        mass,
        spring,
        damper,
        1.0,
        axle.unsprung_mass,
        tyre.stiffness,
        tyre.damping_coefficient,
    )


def _rate(path: str, rate: float | None) -> str:
    if rate is None:
        raise DescriptionError(
            "the spring is a curve without a single rate",
            where=path,
            allowed=Phrase("{path}.rate", path=path),
        )
    return f"{path}.rate"


def _linear(path: str, damper: object) -> str:
    if not isinstance(damper, LinearDamper):
        kind = getattr(damper, "kind", type(damper).__name__)
        raise DescriptionError(
            "the damper is not linear", where=path, found=str(kind), allowed="linear"
        )
    return f"{path}.coefficient"


@dataclass(frozen=True)
class WheelDesign:
    """Spring and damper of one wheel, in the rig and as requested, SI; ``changes`` has the new values by path.

    ``place`` is ``front`` or ``rear``, empty for a quarter car.
    """

    place: str
    sprung_mass: float
    present: SpringAndDamper
    wanted: SpringAndDamper
    changes: dict[str, float]


@dataclass(frozen=True)
class SpringDesign(Shown):
    """Springs and dampers for the requested frequencies: the modified rig, and one wheel of each axle.

    ``with_tyre`` is True if the frequency is that of spring and tyre in series.
    """

    rig: Rig
    wheels: tuple[WheelDesign, ...]
    with_tyre: bool
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        rows = [["", "", "kg", "Hz", "damping ratio", "N/m", "N*s/m"]]
        for wheel in self.wheels:
            for state, design in (("as it is", wheel.present), ("wanted", wheel.wanted)):
                numbers = (
                    design.frequency_hz,
                    design.damping_ratio,
                    design.spring_rate,
                    design.damping_coefficient,
                )
                rows.append(
                    [
                        wheel.place or "wheel",
                        state,
                        *(f"{value:.5g}" for value in (wheel.sprung_mass, *numbers)),
                    ]
                )
        return "\n".join([*align_columns(rows), *map(str, self.findings)])

    @property
    def changes(self) -> dict[str, float]:
        """New values of all wheels by path, SI."""
        return {path: value for wheel in self.wheels for path, value in wheel.changes.items()}

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI; the rig by its changes."""
        return plain_table(
            {name: getattr(self, name) for name in ("wheels", "with_tyre", "changes", "findings")}
        )


_FREQUENCY = (
    'Natural frequency of the body, e.g. "1.2 Hz"; of the front axle if --rear-frequency is given.'
)
_REAR_FREQUENCY = "Frequency of the rear axle, if different."
_REAR_DAMPING = "Damping ratio of the rear axle, if different."


def _frequencies(
    frequency: Annotated[float, Number(_FREQUENCY, "FREQUENCY", "Hz", is_positive=True)],
    rear_frequency: Annotated[
        float | None, Number(_REAR_FREQUENCY, "FREQUENCY", "Hz", is_positive=True)
    ] = None,
) -> float | tuple[float, float]:
    return frequency if rear_frequency is None else (frequency, rear_frequency)


def _damping_ratios(
    damping_ratio: Annotated[float, Number("Damping ratio, e.g. 0.3 or 30 %.", "RATIO")],
    rear_damping_ratio: Annotated[float | None, Number(_REAR_DAMPING, "RATIO")] = None,
) -> float | tuple[float, float]:
    return damping_ratio if rear_damping_ratio is None else (damping_ratio, rear_damping_ratio)


@operation(
    "design springs",
    named={"rig": "vehicle", "changes": "set"},
    echo={"rig": "vehicle", "set": "set"},
    offers=("rig",),
    page="jounce.report:springs_page",
    title="{vehicle}",
    comment="Springs and dampers of {vehicle} for {frequency} and a damping ratio of {damping_ratio}.",
    example='jounce design springs audi-a6-full-car --frequency "1.2 Hz" --rear-frequency "1.4 Hz" --damping-ratio 0.3',
)
def design_springs(
    rig: AnyRig,
    frequency: Annotated[
        float | str | tuple[float | str, float | str], MadeBy("jounce.design.springs:_frequencies")
    ],
    damping_ratio: Annotated[
        float | tuple[float, float], MadeBy("jounce.design.springs:_damping_ratios")
    ],
    *,
    with_tyre: Annotated[
        bool, Switch("The frequency includes the tyre in series with the spring.")
    ] = False,
) -> SpringDesign:
    """Size springs and dampers for a natural frequency and a damping ratio, compared with those of the vehicle.

    Parameters
    ----------
    rig : Rig, str or Path
        Quarter car, half car or full car, its file or its name in the library, with a constant spring rate and a linear
        damper. The lever rule gives the sprung mass on each wheel of a vehicle.
    frequency : float, str or tuple
        Hz; a pair for front and rear.
    damping_ratio : float or tuple of float
        Fraction of critical damping (1), with a rigid tyre; a pair for front and rear.
    with_tyre : bool
        Whether the frequency is that of spring and tyre in series, as measured on the car.

    Returns
    -------
    SpringDesign
        Values in SI, with the modified rig.

    Raises
    ------
    DescriptionError
        For values out of range, rigs in 3-D, and nonlinear springs or dampers.

    Examples
    --------
    >>> import jounce as jn
    >>> demo = design_springs(jn.load("sldemo-half-car"), "1.43828 Hz", 0.4)   # 28 and 21 N/mm: one frequency
    >>> [round(wheel.wanted.spring_rate, -1) for wheel in demo.wheels]
    [28000.0, 21000.0]
    """
    rig = as_rig(rig)
    wheels, values = wheels_of(rig), rig.parameters()
    wanted = zip(
        wheels,
        _each(frequency, wheels, "frequency"),
        _each(damping_ratio, wheels, "damping_ratio"),
        strict=True,
    )
    gravity = values["gravity"]
    designs = []
    for wheel, hertz, share in wanted:
        if with_tyre and wheel.tyre_stiffness is None:
            raise DescriptionError("the model has no tyre of constant stiffness", where="with_tyre")
        tyre = wheel.tyre_stiffness if with_tyre else None
        design = spring_and_damper(
            wheel.sprung_mass, hertz, to_si(share, "1", where="damping_ratio"),
            tyre_stiffness=tyre, motion_ratio=wheel.motion_ratio, gravity=gravity,
        )  # fmt: skip
        present = as_built(
            wheel.sprung_mass, values[wheel.spring], values[wheel.damper],
            tyre_stiffness=tyre, motion_ratio=wheel.motion_ratio, gravity=gravity,
        )  # fmt: skip
        changes = {wheel.spring: design.spring_rate, wheel.damper: design.damping_coefficient}
        designs.append(WheelDesign(wheel.place, wheel.sprung_mass, present, design, changes))
    changed = rig.with_changes(
        {path: value for wheel in designs for path, value in wheel.changes.items()}
    )
    return SpringDesign(changed, tuple(designs), with_tyre, tuple(_advice(rig, designs)))


def _each(value: Any, wheels: tuple[WheelCarriage, ...], where: str) -> tuple[Any, ...]:
    """Return one value for each wheel."""
    if not isinstance(value, (tuple, list)):
        return (value,) * len(wheels)
    if len(value) != len(wheels):
        places = ", ".join(wheel.place for wheel in wheels) or "one wheel"
        raise DescriptionError(
            "there must be one value for each axle", where=where, found=list(value), allowed=places
        )
    return tuple(value)


def _advice(rig: Rig, wheels: list[WheelDesign]) -> list[Finding]:
    sags = [(wheel.place or "spring", wheel.wanted.static_deflection) for wheel in wheels]
    # A static deflection of 0.25 m corresponds to 1 Hz, that of the softest passenger cars.
    findings = [
        finding("design.spring_sags", place, sag, deflection=sag)
        for place, sag in sags
        if sag > 0.25
    ]
    if len(wheels) == 2:
        front, rear = (wheel.wanted.frequency_hz for wheel in wheels)
        if rear < front:
            findings.append(finding("design.rear_softer", "rear", rear / front))
        vehicle: Any = rig
        levers = [w.wanted.wheel_rate * getattr(vehicle, w.place).distance for w in wheels]
        ratio = levers[0] / levers[1]
        findings.append(finding("design.bounce_and_pitch", "front, rear", ratio, ratio=ratio))
    return findings
