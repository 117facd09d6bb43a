"""Extended rig for model error: nonlinear laws, additional friction, uncertain masses.

With all extensions at zero the extended rig moves like the original, so that its exact sensitivities give the effect of
each extension. The only exception is a fitted guide friction: half of it builds up over travel, until the recordings
determine the share.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.identify.doubt import Doubt
from jounce.parts import Corner, QuarterCar, Rig
from jounce.parts.dampers import DamperLaw, SampledPoint
from jounce.parts.elements import Friction
from jounce.parts.rig import unit_of, unknown_path

_KNOTS = (
    0.03,
    0.12,
    0.35,
    1.0,
)  # knots of the damper's law in either direction, as shares of the largest strut velocity
_KNEE = 0.1  # share of the largest strut velocity: below it velocities differ linearly, above it logarithmically
_LEAST = 1e-3  # share of the largest doubt of the damper's forces: one side may be fitted to zero
_STIFFENS = 0.5  # as a share of its doubt: tyres usually stiffen with deflection
_ONSET = math.log(2.0)
ONSET_VELOCITY: float = Friction.model_fields["regularisation_velocity"].default
"""Default regularisation velocity of friction, m/s."""
SLIDING_OVER = 5e-4
"""Travel over which a presliding force builds up, m."""
_RATES = {"strut.spring": "strut.spring.rate", "tyre": "tyre.stiffness"}  # paths of elastic parts
_MIDDLE = 0.5  # prior share of the guide's friction that builds up over travel


@dataclass(frozen=True)
class Nuisance:
    """An uncertain input with prior mean and standard deviation, in ``unit``.

    ``group`` is the corresponding entry of :class:`Doubt`.
    """

    name: str
    group: str
    unit: str
    mean: float
    deviation: float


@dataclass(frozen=True)
class RideExtent:
    """Operating range of a ride: static deflections of strut and tyre (m), largest strut speed (m/s)."""

    strut: float
    tyre: float
    velocity: float


class ExtendedRig:
    """An extended rig: its description, its uncertain inputs, and its parameters for given values of fit and inputs.

    ``free`` are the paths of the fitted parameters. ``nuisances`` have the order of the whitened unknowns ``xi``
    (independent, mean 0, standard deviation 1) that represent them. ``fitted`` are values (SI) that replace those of
    the rig: uncertainties stated as shares refer to these, not to the start values of the fit.
    """

    def __init__(
        self, rig: Rig, free: Sequence[str], doubt: Doubt, ridden: RideExtent, used: Sequence[str],
        fitted: Mapping[str, float] | None = None,
    ) -> None:  # fmt: skip
        self.rig, self.free, self.doubt, self.extent = rig, tuple(free), doubt, ridden
        self.has_laws = isinstance(rig, (QuarterCar, Corner))
        self.nuisances: list[Nuisance] = []
        self.values = {**rig.parameters(), **(fitted or {})}
        self._shares: dict[int, str] = {}
        self._added: dict[int, str] = {}
        self._factors: dict[int, str] = {}
        self._table: dict[str, Any] = rig.model_dump(by_alias=True, exclude_none=True)
        self._knots: Array | None = None
        self._knotted: tuple[tuple[int, ...], Array] | None = None
        self._curved: dict[str, tuple[int, ...]] = {}
        self._masses(used)
        if self.has_laws:
            self._damper()
            self._frictions()
            self._springs()
        self._others(used)

    @property
    def description(self) -> Rig:
        """Description of the extended rig, with the values of the original rig."""
        return type(self.rig).from_table(self._table)

    def of(self, rig: Rig) -> Rig:
        """Return the extended description of a different set-up of the same rig (angle, pressure)."""
        table = rig.model_dump(by_alias=True, exclude_none=True)
        return type(rig).from_table(_merge(self._table, table, self._own_tables()))

    def columns(self) -> tuple[str, ...]:
        """Paths of the extended rig that change with fitted parameters and nuisances."""
        return tuple(self.numbers(self.values, {}, np.zeros(len(self.nuisances))))

    def plain(
        self, values: Mapping[str, float], fitted: Mapping[str, float], xi: Array
    ) -> dict[str, float]:
        """Return parameters of the rig by path, with uncertain masses, angle and friction."""
        p = {**values, **fitted}
        for i, path in self._shares.items():
            p[path] = p[path] * (1.0 + self.nuisances[i].deviation * xi[i])
        for i, path in self._added.items():
            p[path] = p.get(path, self.nuisances[i].mean) + self.nuisances[i].deviation * xi[i]
        for i, path in self._factors.items():
            usual = SLIDING_OVER if path.endswith("distance") else ONSET_VELOCITY
            p[path] = p.get(path, usual) * math.exp(self.nuisances[i].deviation * xi[i])
        return p

    def numbers(
        self, values: Mapping[str, float], fitted: Mapping[str, float], xi: Array
    ) -> dict[str, float]:
        """Return parameters of the extended rig by path, from those of a set-up, the fitted ones and the nuisances."""
        p = self.plain(values, fitted, xi)
        moving = (
            *self.free,
            *self._shares.values(),
            *self._added.values(),
            *self._factors.values(),
        )
        gone = self._absent_paths()
        out = {path: p[path] for path in moving if path not in gone}
        if self._knots is not None:
            force = self.damper_force(p, xi, self._knots)
            out.update(
                {
                    f"strut.damper.force[{i}]": float(f)
                    for i, f in enumerate(force)
                    if self._knots[i] != 0.0
                }
            )
        for part, places in self._curved.items():
            out.update(
                {
                    f"{part}.curve.coefficients[{i}]": c
                    for i, c in enumerate(self.curve(part, p, xi, places))
                }
            )
        return out

    def damper_force(self, p: Mapping[str, float], xi: Array, velocity: Array) -> Array:
        """Return the force (N) of the extended damper law at strut velocities (m/s), linear between the knots."""

        def number(name: str) -> float:
            return p[f"strut.damper.{name}"]

        law = self._damper_law()
        if law is None:  # for a different law, its coefficient
            force = p.get("strut.damper.coefficient", 0.0) * velocity
        else:
            force = law.evaluate(SampledPoint(number, velocity))
        if self._knotted is None or self._knots is None:
            return np.asarray(force)
        places, root = self._knotted
        bends = np.zeros(len(self._knots))
        bends[self._knots != 0.0] = root @ xi[list(places)]
        return np.asarray(force + _straight(velocity, self._knots, bends))

    def curve(
        self, part: str, p: Mapping[str, float], xi: Array, places: tuple[int, ...]
    ) -> list[float]:
        """Return coefficients of spring or tyre whose tangent at the static deflection is the rig's stiffness."""
        rate, rest = (
            p[_RATES[part]],
            {"strut.spring": self.extent.strut, "tyre": self.extent.tyre}[part],
        )
        bends = [self.nuisances[i].mean + self.nuisances[i].deviation * xi[i] for i in places]
        square = rate * bends[0] / (2.0 * rest)
        cube = rate * bends[1] / (3.0 * rest**2) if len(bends) > 1 else 0.0
        coefficients = [rate - 2.0 * square * rest - 3.0 * cube * rest**2, square]
        return [*coefficients, cube] if len(bends) > 1 else coefficients

    def elastic_force(
        self, part: str, p: Mapping[str, float], xi: Array, deflection: Array
    ) -> Array:
        """Return the force (N) of spring or tyre at deflections (m), without preload."""
        if part not in self._curved:
            return p.get(_RATES[part], 0.0) * deflection
        coefficients = self.curve(part, p, xi, self._curved[part])
        return np.asarray(np.polyval([*reversed(coefficients), 0.0], deflection))

    # what may be off ------------------------------------------------------------------------------------------------

    def _add(
        self, name: str, group: str, deviation: float, *, unit: str = "1", mean: float = 0.0
    ) -> int | None:
        if deviation <= 0.0:
            return None
        self.nuisances.append(Nuisance(name, group, unit, mean, deviation))
        return len(self.nuisances) - 1

    def _masses(self, used: Sequence[str]) -> None:
        for path, value in self.values.items():
            if not path.endswith("mass") or path not in used or path in self.free or value <= 0.0:
                continue
            source = "stated" if isinstance(self.rig, Corner) else "lumped"
            group = "estimated" if self.rig.is_estimated(path) else source
            share, group = self._own(path, getattr(self.doubt, group), group)
            i = self._add(path, group, share)
            if i is not None:
                self._shares[i] = path

    def _own(self, path: str, share: float, group: str) -> tuple[float, str]:
        """Return the relative uncertainty of a value and its group: its own, or the default of its group."""
        if path not in self.doubt.values:
            return share, group
        return own_doubt(self.rig, path, self.doubt.values[path], "doubt.values"), "values"

    def _others(self, used: Sequence[str]) -> None:
        angle = "strut.angle"
        if (
            angle in self.values
            and angle in used
            and angle not in self.free
            and angle not in self.doubt.values
        ):
            i = self._add(angle, "angle", self.doubt.angle, unit="rad")
            if i is not None:
                self._added[i] = angle
        for path in self.doubt.values:
            share = own_doubt(self.rig, path, self.doubt.values[path], "doubt.values")
            if path in self._shares.values() or path in self.free or path in self._absent_paths():
                continue
            if path not in used:
                raise DescriptionError(
                    "not a parameter of the equations", where=f"doubt.values: {path}"
                )
            i = self._add(path, "values", share)
            if i is not None:
                self._shares[i] = path

    def _damper_law(self) -> DamperLaw | None:
        """Return the strut's damper if its law is linear in bump and in rebound, so that a table can extend it."""
        damper: DamperLaw = getattr(self.rig, "strut").damper  # noqa: B009 - rigs with laws have one
        return damper if damper.bends() == (0.0,) else None

    def _damper(self) -> None:
        if self._damper_law() is None or self.doubt.damper_shape <= 0.0:
            return
        positive = np.array(_KNOTS) * self.extent.velocity
        knots = np.concatenate([-positive[::-1], [0.0], positive])
        moving = knots[knots != 0.0]
        scale = self.doubt.damper_shape * np.abs(
            self.damper_force(self.values, np.zeros(0), moving)
        )
        scale = scale + self.doubt.damper_force
        if not np.any(scale):
            return  # a damper fitted to zero, of which any share is zero
        scale = np.maximum(scale, _LEAST * np.max(scale))
        at = np.arcsinh(moving / (_KNEE * self.extent.velocity))
        apart = math.sqrt(3.0) * np.abs(at[:, None] - at)
        root = np.linalg.cholesky(
            (1.0 + apart) * np.exp(-apart) * np.outer(scale, scale) + 1e-9 * np.diag(scale**2)
        )
        places = [
            self._add(f"damper force at {v:+.2g} m/s", "damper_shape", float(s), unit="N")
            for v, s in zip(moving, scale, strict=True)
        ]
        self._knotted = tuple(i for i in places if i is not None), root
        self._knots = knots
        force = self.damper_force(self.values, np.zeros(len(self.nuisances)), knots)
        self._table["strut"]["damper"] = {"velocity": tuple(knots), "force": tuple(force)}

    def laws_as_described(self) -> list[str]:
        """Return the laws of the rig that are assumed to be exact."""
        if not self.has_laws:
            return ["dampers", "friction", "springs", "tyres"]
        laws = [] if self._knots is not None or self.doubt.damper_shape <= 0.0 else ["damper"]
        return [
            *laws,
            *(["tyre"] if "tyre" not in self._curved and self.doubt.tyre_curvature > 0.0 else []),
        ]

    def damper_covariance_root(self) -> tuple[tuple[int, ...], Array] | None:
        """Return the indices of the damper's forces in the nuisances, and the root of their prior covariance, N."""
        return self._knotted

    def knot_velocities(self) -> Array:
        """Return strut velocities (m/s) of the damper's uncertain forces, symmetric in bump and rebound."""
        return np.zeros(0) if self._knots is None else self._knots[self._knots != 0.0]

    def _frictions(self) -> None:
        load = self.values.get("sprung.mass", 0.0) * self.values.get("gravity", 0.0)
        for path, holder in self._friction_places().items():
            table = holder.setdefault(path.rpartition(".")[2], {"force": 0.0})
            table.setdefault("regularisation_velocity", ONSET_VELOCITY)
            if f"{path}.force" not in self.free:
                i = self._add(f"{path}.force", "friction", self.doubt.friction * load, unit="N")
                if i is not None:
                    self._added[i] = f"{path}.force"
            if f"{path}.regularisation_velocity" not in self.free:
                deviation = self.doubt.friction_onset * _ONSET
                i = self._add(
                    f"{path}.regularisation_velocity", "friction_onset", deviation, unit="ln"
                )
                if i is not None:
                    self._factors[i] = f"{path}.regularisation_velocity"
            if path.startswith("guide") and f"{path}.force" in self.free:
                self._presliding(path, table)

    def _presliding(self, path: str, table: dict[str, Any]) -> None:
        """Let a share of the guide's friction build up over travel, with uncertain share and distance."""
        i = self._add(
            f"{path}.presliding", "guide_presliding", self.doubt.guide_presliding, mean=_MIDDLE
        )
        if i is None:
            return
        self._added[i] = f"{path}.presliding"
        self.values |= {f"{path}.presliding": _MIDDLE, f"{path}.presliding_distance": SLIDING_OVER}
        table |= {"presliding": _MIDDLE, "presliding_distance": SLIDING_OVER}
        j = self._add(f"{path}.presliding_distance", "guide_presliding", _ONSET, unit="ln")
        if j is not None:
            self._factors[j] = f"{path}.presliding_distance"

    def _friction_places(self) -> dict[str, dict[str, Any]]:
        """Return a mapping from the path of each friction to its table."""
        places = {"strut.friction": self._table["strut"]}
        if isinstance(self.rig, QuarterCar):
            places["guide.friction"] = self._table.setdefault("guide", {})
        elif getattr(self.rig, "guide", "fixed") != "fixed":
            places["guide_friction"] = self._table
        return places

    def _springs(self) -> None:
        doubt = self.doubt
        if (
            isinstance(self.rig, QuarterCar)
            and "strut.spring.rate" in self.values
            and self.extent.strut > 0.0
        ):
            self._bend("strut.spring", "spring_curvature", [(0.0, doubt.spring_curvature)], "rate")
        if "tyre.stiffness" in self.values and self.extent.tyre > 0.0:
            share = doubt.tyre_curvature
            self._bend(
                "tyre",
                "tyre_curvature",
                [(_STIFFENS * share, share), (0.0, 0.1 * share)],
                "stiffness",
            )

    def _bend(self, part: str, group: str, bends: list[tuple[float, float]], law: str) -> None:
        names = ("curvature", "change of curvature")
        places = [
            self._add(f"{part} {name}", group, deviation, mean=mean)
            for name, (mean, deviation) in zip(names, bends, strict=False)
        ]
        if None in places:
            return
        self._curved[part] = tuple(i for i in places if i is not None)
        table = self._table["strut"]["spring"] if part == "strut.spring" else self._table["tyre"]
        table.pop(law)
        table["curve"] = {"kind": "polynomial", "coefficients": (1.0,) * (1 + len(places))}

    def _own_tables(self) -> set[str]:
        """Return the tables that only the extended rig has."""
        parts = {f"{part}.curve" for part in self._curved}
        return parts | ({"strut.damper"} if self._knots is not None else set())

    def _absent_paths(self) -> set[str]:
        """Return the paths of the rig that the extended rig does not have."""
        gone = {
            f"{part}.{law}"
            for part, law in (("strut.spring", "rate"), ("tyre", "stiffness"))
            if part in self._curved
        }
        names = ("coefficient", "bump_coefficient", "rebound_coefficient")
        return gone | (
            {f"strut.damper.{name}" for name in names} if self._knots is not None else set()
        )


def own_doubt(rig: Rig, path: str, given: object, where: str) -> float:
    """Return the relative uncertainty (1) of a parameter, given as a share or in its unit; errors mention ``where``."""
    values, place = rig.parameters(), f"{where}: {path}"
    if path not in values:
        raise unknown_path(place, values, name=path)
    try:
        share = to_si(given, "1", where=place)
    except DescriptionError:
        share = (
            to_si(given, unit_of(rig, path), where=place) / abs(values[path])
            if values[path]
            else 0.0
        )
    if share < 0.0:
        raise DescriptionError(
            "a negative uncertainty", where=place, found=given, allowed="0 or more"
        )
    return share


def _merge(
    richer: dict[str, Any], plain: dict[str, Any], own: set[str], prefix: str = ""
) -> dict[str, Any]:
    """Return ``richer`` with the values of ``plain``, except for tables in ``own`` and entries that ``plain`` lacks."""
    merged = {}
    for key, value in richer.items():
        path = f"{prefix}{key}"
        other = plain.get(key)
        if path in own or key not in plain:
            merged[key] = value
        elif isinstance(value, dict) and isinstance(other, dict):
            merged[key] = _merge(value, other, own, f"{path}.")
        else:
            merged[key] = other
    return merged


def _straight(x: Array, knots: Array, values: Array) -> Array:
    """Interpolate linearly through points and extrapolate beyond the ends."""
    inside = np.interp(x, knots, values)
    first, last = (
        (values[i + 1] - values[i]) / (knots[i + 1] - knots[i]) for i in (0, len(knots) - 2)
    )
    return np.asarray(
        inside + np.minimum(x - knots[0], 0.0) * first + np.maximum(x - knots[-1], 0.0) * last
    )
