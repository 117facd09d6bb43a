"""Component value and effective value of a parameter over the states of a ride.

The *component value* is the value that a test machine would measure on the part: the slope of the damper's force over
velocity alone (for each side if its law distinguishes them), the sliding friction force, the tangent of spring and tyre
at the static load. The *effective value* is the one for which the model's law best approximates the part's force over
the ride: a model with a linear damper represents a degressive damper without friction by a damper and some friction.
The two differ by definition, not by error; an interval for a parameter must contain both.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.types import Array
from jounce.identify.extended_rig import ONSET_VELOCITY, SLIDING_OVER, ExtendedRig
from jounce.simulation.compiled import Compiled
from jounce.simulation.result import Solution


@dataclass(frozen=True)
class States:
    """States of a ride, each shape (n,): time (s), strut and tyre deflections (m), rates (m/s), body velocity."""

    time: Array
    strut: Array
    velocity: Array
    tyre: Array
    tyre_rate: Array
    body: Array

    @classmethod
    def of(cls, compiled: Compiled, solution: Solution) -> States:
        """Extract the states from a simulation; states that the model does not have are zero."""
        names, time = compiled.output_names, solution.time

        def output(name: str) -> Array:
            return solution.outputs[names.index(name)] if name in names else np.zeros(len(time))

        tyre = output("tyre.deflection")
        return cls(
            time,
            output("strut.deflection"),
            output("strut.velocity"),
            tyre,
            np.gradient(tyre, time),
            output("sprung.vz"),
        )

    @classmethod
    def join(cls, all_of: Sequence[States], every: int = 1) -> States:
        """Concatenate rides, keeping one in ``every`` samples."""
        names = ("time", "strut", "velocity", "tyre", "tyre_rate", "body")
        return cls(
            *(np.concatenate([getattr(ride, name)[::every] for ride in all_of]) for name in names)
        )

    def sliding(self, velocity: Array, over: float = SLIDING_OVER) -> Array:
        """Return the presliding force as a share (-1 to 1) by Dahl's model: it builds up over travel (m)."""
        moved = 0.5 * (velocity[1:] + velocity[:-1]) * np.diff(self.time)
        left, ends = np.exp(-np.abs(moved) / over), np.sign(moved)
        z, now = [0.0], 0.0
        for end, share in zip(
            ends.tolist(), left.tolist(), strict=True
        ):  # plain floats: arrays are ten times slower
            now = end + (now - end) * share if end else now
            z.append(now)
        return np.array(z)

    def acceleration(self) -> Array:
        """Rate of the strut's velocity, m/s^2."""
        return np.gradient(self.velocity, self.time)


class Laws:
    """Compute component and effective values of the fitted parameters over the states of the ride."""

    def __init__(self, richer: ExtendedRig, states: Sequence[States], every: int = 3) -> None:
        self.richer = richer
        self.seen = States.join(states, every)
        self.sliding = np.concatenate([ride.sliding(ride.velocity)[::every] for ride in states])
        self._states, self._every = states, every
        self._built_up: dict[float, Array] = {}
        self._plain = richer.rig.parameters()
        self._inverse: dict[str, Array] = {}

    def readings(
        self, path: str, p: Mapping[str, float], xi: Array, presliding: float
    ) -> tuple[float, float]:
        """Return component and effective value of each parameter, SI; ``p`` are the rig's numbers with fitted ones.

        ``presliding`` (N) builds up in the strut.
        """
        if not self.richer.has_laws:
            return p[path], p[path]
        if path in ("tyre.stiffness", "tyre.damping_coefficient"):
            stiffness, damping = self._tyre(p, xi)
            return p[path], stiffness if path == "tyre.stiffness" else damping
        if path.endswith("friction.force") and path.startswith("guide"):
            return self._guide(path, p)
        if path in ("strut.spring.rate", "strut.friction.force") or path in self._sides():
            component, effective = (
                self._strut_components(p, xi, presliding),
                self._strut(p, xi, presliding),
            )
            return component[path], effective.get(path, component[path])
        return p[path], p[path]

    def _strut_components(
        self, p: Mapping[str, float], xi: Array, presliding: float
    ) -> dict[str, float]:
        force = self.richer.damper_force(p, xi, self.seen.velocity)
        return {
            **{
                path: float(v @ force / (v @ v)) if np.any(v) else p[path]
                for path, v in self._sides().items()
            },
            "strut.spring.rate": p.get("strut.spring.rate", 0.0),
            "strut.friction.force": p.get("strut.friction.force", 0.0) + presliding,
        }

    def _sides(self) -> dict[str, Array]:
        """Return the strut velocities (m/s) to which each damper coefficient applies, 0 elsewhere."""
        v, place = self.seen.velocity, "strut.damper."
        sides = {
            "coefficient": v, "bump_coefficient": np.maximum(v, 0.0), "rebound_coefficient": np.minimum(v, 0.0)
        }  # fmt: skip
        return {place + name: side for name, side in sides.items() if place + name in self._plain}

    def _strut(self, p: Mapping[str, float], xi: Array, presliding: float) -> dict[str, float]:
        """Fit line, damper and friction to the strut's force; friction that is not fitted keeps its value."""
        x, v = self.seen.strut, self.seen.velocity
        onset = p.get("strut.friction.regularisation_velocity", ONSET_VELOCITY)
        force = self.richer.elastic_force("strut.spring", p, xi, x) + self.richer.damper_force(
            p, xi, v
        )
        force = (
            force
            + p.get("strut.friction.force", 0.0) * np.tanh(v / onset)
            + presliding * self.sliding
        )
        columns = {"": np.ones(len(v)), "strut.spring.rate": x, **self._sides()}
        turned = np.tanh(v / self._nominal("strut.friction"))
        if "strut.friction.force" in self.richer.free:
            columns["strut.friction.force"] = turned
        else:
            force = force - self._plain.get("strut.friction.force", 0.0) * turned
        columns = {name: column for name, column in columns.items() if np.any(column)}
        return dict(
            zip(
                columns, self._nearest("strut", list(columns.values()), force).tolist(), strict=True
            )
        )

    def _tyre(self, p: Mapping[str, float], xi: Array) -> tuple[float, float]:
        touching = self.seen.tyre > 0.0
        d, rate = self.seen.tyre[touching], self.seen.tyre_rate[touching]
        force = (
            self.richer.elastic_force("tyre", p, xi, d)
            + p.get("tyre.damping_coefficient", 0.0) * rate
        )
        _, stiffness, damping = self._nearest("tyre", [np.ones(len(d)), d, rate], force)
        return float(stiffness), float(damping)

    def _guide(self, path: str, p: Mapping[str, float]) -> tuple[float, float]:
        """Return the sliding force, and the force of the model's law that best approximates it over the ride."""
        u, place = self.seen.body, path.removesuffix(".force")
        law = np.tanh(u / p.get(f"{place}.regularisation_velocity", ONSET_VELOCITY))
        share = p.get(f"{place}.presliding", 0.0)
        if share:
            law = law + share * (
                self._guide_built_up(p.get(f"{place}.presliding_distance", SLIDING_OVER)) - law
            )
        column = np.tanh(u / self._nominal(place))
        return p[path], float(self._nearest(place, [column], p[path] * law)[0])

    def _guide_built_up(self, over: float) -> Array:
        """Return the guide's friction as a share of its full force (1) if it builds up over travel ``over`` (m)."""
        if over not in self._built_up:
            parts = [ride.sliding(ride.body, over)[:: self._every] for ride in self._states]
            self._built_up[over] = np.concatenate(parts)
        return self._built_up[over]

    def _nominal(self, place: str) -> float:
        """Return the regularisation velocity of the plain rig's friction."""
        return self._plain.get(f"{place}.regularisation_velocity", ONSET_VELOCITY)

    def _nearest(self, name: str, columns: Sequence[Array], force: Array) -> Array:
        if name not in self._inverse:
            self._inverse[name] = np.linalg.pinv(np.column_stack(columns))
        return np.asarray(self._inverse[name] @ force)
