"""Load cases of an axle: accelerations of the car to forces in every link, joint and pickup point of both wheels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.core.units import Mass, PositiveLength, Unit
from jounce.kinematics.loads import ContactLoad, pickup_loads
from jounce.kinematics.model import check_corner
from jounce.kinematics.sweeps import prepare_sweep
from jounce.parts import Corner, Rig

if TYPE_CHECKING:
    import xarray as xr

_Share = Annotated[float, Unit("1", at_least=0.0, at_most=1.0)]
_Gs = Annotated[float, Unit("1")]
_TRAVELS = np.linspace(-0.1, 0.1, 41)  # m: where the spring's equilibrium is looked for


class LoadedAxle(Description):
    """The car around an axle, for its wheel loads.

    ``axle``; ``mass`` (kg) of the whole car, ``wheelbase`` (m), ``centre_of_mass_height`` (m, above the ground);
    ``weight_share`` of this axle at rest, ``brake_share`` and ``drive_share`` of it in longitudinal forces, and
    ``roll_share`` of it in the lateral load transfer, that of its weight where it is not given.
    """

    axle: Literal["front", "rear"]
    mass: Mass
    wheelbase: PositiveLength
    centre_of_mass_height: PositiveLength
    weight_share: _Share
    brake_share: _Share
    drive_share: _Share = 0.0
    roll_share: _Share | None = None


class LoadCase(Description):
    """Accelerations of the car in g.

    ``longitudinal`` is forward (braking is negative), ``lateral`` to the left; ``vertical`` multiplies the weight on
    the wheels: 3 in a bump of 3 g.
    """

    longitudinal: _Gs = 0.0
    lateral: _Gs = 0.0
    vertical: _Gs = 1.0


LOAD_CASES: dict[str, LoadCase] = {
    "static": LoadCase(),
    "braking 1 g": LoadCase(longitudinal=-1.0),
    "cornering 1 g": LoadCase(lateral=1.0),
    "bump 3 g": LoadCase(vertical=3.0),
    "braking and cornering 0.7 g each": LoadCase(longitudinal=-0.7, lateral=0.7),
}
"""Usual load cases by name."""


def load_cases(
    rig: Rig, car: LoadedAxle, cases: Mapping[str, LoadCase | Mapping[str, float]] | None = None
) -> xr.Dataset:
    """Give the forces in every link, joint and pickup point of both wheels of an axle for load cases of the car.

    Wheel loads follow from weight and load transfer of a rigid car; a wheel that would be pulled off the road carries
    nothing, and the other one all. Longitudinal and lateral forces of the axle are shared by the wheels in proportion
    to their loads; brakes are outboard, drive torque is reacted by the body. Each wheel stands where its spring and
    stops carry its load (at design where the rig has no spring); anti-roll bars do not count. Parts have no weight.
    ``attrs["findings"]`` names cases that the spring cannot carry.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints; the other side is its mirror image.
    car : LoadedAxle
        The car around it.
    cases : mapping of str to LoadCase, optional
        Cases by name, accelerations in g; `LOAD_CASES` by default.

    Returns
    -------
    xarray.Dataset
        On ``case`` and ``wheel`` (left, right): ``longitudinal_force``, ``lateral_force``, ``vertical_force`` at the
        contact point (N), ``wheel_travel`` (m), and what :func:`pickup_loads` gives at each hardpoint (N).

    Raises
    ------
    DescriptionError
        For a rig without hardpoints, or no case.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass="280 kg", wheelbase="1.55 m", centre_of_mass_height="0.3 m", weight_share=0.48,
    ...     brake_share=0.65,
    ... )
    >>> found = jn.load_cases(jn.load("formula-student-front"), car)
    >>> round(float(found["vertical_force"].sel(case="static", wheel="left")), 1)   # N
    659.2
    """
    import xarray as xr

    corner = check_corner(rig)
    chosen = LOAD_CASES if cases is None else cases
    if not chosen:
        raise DescriptionError("no load case", where="cases", allowed="a name and its accelerations")
    read = {name: case if isinstance(case, LoadCase) else LoadCase(**case) for name, case in chosen.items()}
    left = corner if corner.side == "left" else corner.mirrored()
    sides = {"left": left, "right": left.mirrored()}
    found, told = [], []
    for name, case in read.items():
        pair = []
        for (wheel, side), load in zip(sides.items(), wheel_loads(car, case, left), strict=True):
            travel, findings = _equilibrium(side, load, f"{name}, {wheel} wheel")
            pair.append(_of_wheel(side, load, travel))
            told += findings
        found.append(pair)
    units = {name: unit for name, (_, unit, _) in found[0][0].items()}
    texts = {name: text for name, (_, _, text) in found[0][0].items()}
    variables = {
        name: (
            ("case", "wheel"),
            np.array([[wheel[name][0] for wheel in pair] for pair in found]),
            {"units": units[name], "long_name": texts[name]},
        )
        for name in units
    }
    facts = {"model": str(getattr(rig, "model", "")), "findings": "; ".join(map(str, told))}
    return xr.Dataset(variables, {"case": list(read), "wheel": list(sides)}, facts)


def wheel_loads(car: LoadedAxle, case: LoadCase, rig: Corner) -> tuple[ContactLoad, ContactLoad]:
    """Loads of the road on the left and the right wheel (N, ground axes) in a case."""
    weight = car.mass * GRAVITY
    ahead = weight * case.longitudinal * car.centre_of_mass_height / car.wheelbase
    axle = max(case.vertical * weight * car.weight_share + (-ahead if car.axle == "front" else ahead), 0.0)
    share = car.weight_share if car.roll_share is None else car.roll_share
    track = 2.0 * abs(rig.hardpoints.wheel_centre[1])
    across = weight * case.lateral * car.centre_of_mass_height * share / track
    left = min(max(0.5 * axle - across, 0.0), axle)
    braked = case.longitudinal < 0.0
    longitudinal = weight * case.longitudinal * (car.brake_share if braked else car.drive_share)
    lateral = weight * case.lateral * car.weight_share
    parts = (left / axle, 1.0 - left / axle) if axle > 0.0 else (0.0, 0.0)
    one, other = (
        ContactLoad(
            longitudinal_force=longitudinal * part,
            lateral_force=lateral * part,
            vertical_force=axle * part,
            through="contact_point" if braked else "wheel_centre",
        )
        for part in parts
    )
    return one, other


def _of_wheel(rig: Corner, load: ContactLoad, travel: float) -> dict[str, tuple[float, str, str]]:
    """Every force of one wheel: value, unit and what it is."""
    loads = pickup_loads(rig, load, travel)
    found = {
        name: (float(getattr(load, name)), "N", f"{name.replace('_', ' ')} of the road on the wheel")
        for name in ("longitudinal_force", "lateral_force", "vertical_force")
    }
    found["wheel_travel"] = travel, "m", "vertical travel of the wheel centre, bump positive"
    for name, variable in loads.data_vars.items():
        found[str(name)] = float(variable[0]), "N", str(variable.attrs["long_name"])
    return found


def _equilibrium(rig: Corner, load: ContactLoad, where: str) -> tuple[float, list[Finding]]:
    """Travel (m) at which spring and stops have the force that the load asks of them, or come nearest to it."""
    if "spring" in rig.without:
        return 0.0, []
    sweep = prepare_sweep(rig, _TRAVELS)
    rows = {name: value[:, 0] for name, value in sweep.quantities().items()}
    kept = np.flatnonzero(np.isfinite(rows["wheel_travel"]))
    low, high = float(_TRAVELS[kept[0]]), float(_TRAVELS[kept[-1]])

    def over(travel: Array) -> Array:
        own = prepare_sweep(rig, travel).quantities()
        has = (own["spring_force"] + own["stop_force"])[:, 0]
        return np.asarray(has - pickup_loads(rig, load, travel)["spring.force"].to_numpy())

    for _ in range(4):
        travels = np.linspace(low, high, 41)
        excess = over(travels)
        crossed = np.flatnonzero((excess[:-1] <= 0.0) & (excess[1:] > 0.0))
        if not len(crossed):
            nearest = float(travels[np.nanargmax(np.where(excess > 0.0, -excess, excess))])
            text = (
                f"spring and stops cannot carry it within {1e3 * _TRAVELS[-1]:g} mm of travel: forces are those at "
                f"{1e3 * nearest:.4g} mm, where they come nearest, and the spring has what the load asks for."
            )
            return nearest, [Finding(where, "warning", text, float(load.vertical_force))]
        i = int(crossed[np.argmin(np.abs(travels[crossed]))])
        low, high = float(travels[i]), float(travels[i + 1])
    return 0.5 * (low + high), []


def load_case_table(found: xr.Dataset, quantities: Sequence[str] | None = None) -> str:
    """Give load cases as CSV, a row for each case and wheel, SI.

    Parameters
    ----------
    found : xarray.Dataset
        As :func:`load_cases` gives it.
    quantities : sequence of str, optional
        Which columns; all by default.

    Returns
    -------
    str
        Header ``name [unit]`` and rows.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48, brake_share=0.65
    ... )
    >>> jn.load_case_table(jn.load_cases(jn.load("formula-student-front"), car)).splitlines()[0][:32]
    'case,wheel,longitudinal_force [N'
    """
    names = list(map(str, quantities or found.data_vars))
    rows = [",".join(["case", "wheel", *(f"{name} [{found[name].attrs['units']}]" for name in names)])]
    for case in found["case"].to_numpy():
        for wheel in found["wheel"].to_numpy():
            one: Any = found.sel(case=case, wheel=wheel)
            label = str(case).replace('"', "'")
            rows.append(",".join([f'"{label}"', str(wheel), *(repr(float(one[name])) for name in names)]))
    return "\n".join([*rows, ""])
