"""Slow, readable twin of the quarter car: the same physics written a second time, by hand, with SciPy only.

It is the oracle of the agreement tests, so it shares no code with jounce: only the frozen descriptions (numbers) go in.

Equations (z up, deflections and forces positive in compression, zero height = everything undeformed):

    d  = cos(angle) (zu - zs)            strut deflection, v its rate
    F  = preload + spring(d) + damper(d, v, w) + friction(v) + stop(d)
    T  = tyre force of delta = road - zu and its rate; with lift-off 0 for delta <= 0, else max(0, f(delta) + c rate)
    ms zs'' = -ms g + cos(angle) F - guide friction(zs')
    mu zu'' = -mu g - cos(angle) F + T
    w'  = Bouc-Wen

A jump of the road moves nothing by itself (the tyre damper feels the slope within the pieces only).
"""

from __future__ import annotations

import math
from bisect import bisect_right

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


def interpolated(x: float, points: tuple[float, ...], values: tuple[float, ...]) -> float:
    """Straight lines through the points; the outer ones go on."""
    i = min(max(bisect_right(points, x) - 1, 0), len(points) - 2)
    return values[i] + (values[i + 1] - values[i]) * (x - points[i]) / (points[i + 1] - points[i])


def curve_force(curve, x: float) -> float:
    if curve.kind == "polynomial":
        return sum(c * x ** (i + 1) for i, c in enumerate(curve.coefficients))
    if curve.kind == "power":
        return curve.coefficient * x**curve.exponent if x > 0.0 else 0.0
    return interpolated(x, curve.deflection, curve.force)


def deflection_under(load: float, force) -> float:
    """Smallest deflection (m, either sign) at which a rising force carries the load (N)."""
    reach = 1e-4
    while (force(-reach) - load) * (force(reach) - load) > 0.0:
        reach *= 1.3
    return brentq(lambda x: force(x) - load, -reach, reach, xtol=1e-17, rtol=1e-15)


def coulomb(friction, v: float) -> float:
    return (
        0.0
        if friction is None
        else friction.force * math.tanh(v / friction.regularisation_velocity)
    )


def blow_off_force(law, v: float) -> float:
    """Steep up to the blow-off force of the direction, flatter beyond."""
    side, speed = ("bump", v) if v > 0.0 else ("rebound", -v)
    force, knee, slope = (
        getattr(law, f"{side}_{name}")
        for name in ("blow_off_force", "blow_off_velocity", "high_speed_coefficient")
    )
    return math.copysign(
        force * speed / knee if speed < knee else force + slope * (speed - knee), v
    )


class QuarterCarTwin:
    """One rig on one road; ``road`` is a list of pieces ``(start, end, height(t), rate(t))`` in seconds."""

    def __init__(self, rig, road) -> None:
        self.rig, self.road, self.cos = rig, road, math.cos(rig.strut.angle)

    # --- laws -------------------------------------------------------------------------------------------------

    def damper(self, d: float, v: float, w: float) -> float:
        law = self.rig.strut.damper
        if law.kind == "linear":
            return law.coefficient * v
        if law.kind == "bilinear":
            return (law.bump_coefficient if v > 0.0 else law.rebound_coefficient) * v
        if law.kind == "blow-off":
            return blow_off_force(law, v)
        if law.kind == "table":
            return interpolated(v, law.velocity, law.force)
        if law.kind == "tanh":
            bend = math.tanh(law.slope * (v + law.displacement_coupling * d))
            return law.coefficient * v + law.stiffness * d + law.force * bend + law.offset
        return law.coefficient * v + law.stiffness * d + law.hysteretic_force * w + law.offset

    def hysteresis_rate(self, v: float, w: float) -> float:
        law = self.rig.strut.damper
        if law.kind != "bouc-wen":
            return 0.0
        n, sigma = law.exponent, law.sigma
        return law.rate * (
            v - sigma * abs(v) * abs(w) ** (n - 1.0) * w + (sigma - 1.0) * v * abs(w) ** n
        )

    def strut(self, d: float, v: float, w: float) -> float:
        spring, stop = self.rig.strut.spring, self.rig.strut.bump_stop
        force = spring.preload + (
            spring.rate * d if spring.curve is None else curve_force(spring.curve, d)
        )
        force += self.damper(d, v, w) + coulomb(self.rig.strut.friction, v)
        if stop is not None and d > stop.gap:
            force += stop.rate * (d - stop.gap) + stop.progression * (d - stop.gap) ** 3
        return force

    def tyre(self, delta: float, rate: float) -> float:
        law = self.rig.tyre
        if law.lift_off and delta <= 0.0:
            return 0.0
        force = law.stiffness * delta if law.curve is None else curve_force(law.curve, delta)
        force += law.damping_coefficient * rate
        return max(0.0, force) if law.lift_off else force

    # --- motion -----------------------------------------------------------------------------------------------

    def forces(self, x, height: float, rate: float) -> tuple[float, float, float, float, float]:
        """Strut deflection, its rate, strut force, tyre deflection and tyre force."""
        zs, zu, vs, vu, w = x
        d, v, delta = self.cos * (zu - zs), self.cos * (vu - vs), height - zu
        return d, v, self.strut(d, v, w), delta, self.tyre(delta, rate - vu)

    def accelerations(self, x, strut: float, tyre: float) -> tuple[float, float]:
        rig = self.rig
        body = self.cos * strut - coulomb(rig.guide.friction, x[2])
        return body / rig.sprung.mass - rig.gravity, (
            tyre - self.cos * strut
        ) / rig.unsprung.mass - rig.gravity

    def rest(self, height: float) -> list[float]:
        """State of rest on a level road of that height, nothing hysteretic wound up."""
        rig = self.rig
        d = deflection_under(
            rig.sprung.mass * rig.gravity, lambda d: self.cos * self.strut(d, 0.0, 0.0)
        )
        load = (rig.sprung.mass + rig.unsprung.mass) * rig.gravity
        delta = deflection_under(load, lambda delta: self.tyre(delta, 0.0))
        return [height - delta - d / self.cos, height - delta, 0.0, 0.0, 0.0]

    def run(
        self, times, *, tolerance: float = 1e-10, max_step: float = 1e-3, offset=None
    ) -> dict[str, np.ndarray]:
        """Integrate piece after piece; give every channel at ``times`` (at a jump: just after it)."""
        times = np.asarray(times, dtype=float)
        x = np.array(self.rest(self.road[0][2](times[0])))
        x = x if offset is None else x + np.asarray(offset)
        rows: dict[str, list[float]] = {}
        for start, end, height, rate in self._clipped(times[0], times[-1]):
            if end > start:
                wanted = times[(times >= start) & (times < end)]
                done = solve_ivp(
                    self._rate(height, rate),
                    (start, end),
                    x,
                    method="DOP853",
                    rtol=tolerance,
                    max_step=max_step,
                    atol=tolerance * np.array([1e-3, 1e-3, 1e-1, 1e-1, 1.0]),
                    t_eval=[*wanted, end],
                )
                assert done.success, done.message
                for t, state in zip(wanted, done.y.T[:-1], strict=True):
                    self._store(rows, state, height(t), rate(t))
                x = done.y[:, -1]
        self._store(rows, x, height(times[-1]), rate(times[-1]))
        return {name: np.array(values) for name, values in rows.items()}

    def _clipped(self, first: float, last: float):
        """The pieces between two times, the outermost going on."""
        for i, (start, end, height, rate) in enumerate(self.road):
            low = first if i == 0 else max(start, first)
            high = last if i == len(self.road) - 1 else min(end, last)
            if high > low:
                yield low, high, height, rate

    def _rate(self, height, rate):
        def slope(t: float, x):
            _, v, strut, _, tyre = self.forces(x, height(t), rate(t))
            body, wheel = self.accelerations(x, strut, tyre)
            return x[2], x[3], body, wheel, self.hysteresis_rate(v, x[4])

        return slope

    def _store(self, rows: dict[str, list[float]], x, height: float, rate: float) -> None:
        d, v, strut, delta, tyre = self.forces(x, height, rate)
        body, wheel = self.accelerations(x, strut, tyre)
        names = {
            "strut.deflection": d,
            "strut.velocity": v,
            "strut.force": strut,
            "tyre.deflection": delta,
            "tyre.force": tyre,
            "road.z": height,
            "sprung.z": x[0],
            "sprung.vz": x[2],
            "sprung.az": body,
            "unsprung.z": x[1],
            "unsprung.vz": x[3],
            "unsprung.az": wheel,
            "hysteresis": x[4],
            "guide.force": -coulomb(self.rig.guide.friction, x[2]),
        }
        for name, value in names.items():
            rows.setdefault(name, []).append(float(value))


def road_pieces(segments):
    """Turn closed-form pieces of a height against time (see their documentation) into functions of time."""
    result = []
    for i in range(len(segments.kind)):
        kind = ("line", "sine", "circle")[segments.kind[i]]
        c = [float(value) for value in segments.coefficients[i]]
        start, end = float(segments.edges[i]), float(segments.edges[i + 1])
        result.append((start, end, *_functions(kind, c, start, float(segments.rate))))
    return result


def _functions(kind: str, c: list[float], start: float, speed: float):
    def s(t: float) -> float:
        return speed * (t - start)

    if kind == "line":
        return (
            lambda t: c[0] + c[1] * s(t) + c[2] * s(t) ** 2 + c[3] * s(t) ** 3,
            lambda t: speed * (c[1] + 2.0 * c[2] * s(t) + 3.0 * c[3] * s(t) ** 2),
        )
    if kind == "sine":
        return (
            lambda t: c[0] + c[1] * math.sin(c[2] * s(t) + c[3]),
            lambda t: speed * c[1] * c[2] * math.cos(c[2] * s(t) + c[3]),
        )

    def root(t: float) -> float:
        return math.sqrt(max(c[1] ** 2 - (s(t) - c[2]) ** 2, 0.0))

    return (
        lambda t: c[0] + c[3] * root(t),
        lambda t: -speed * c[3] * (s(t) - c[2]) / root(t) if root(t) > 0.0 else 0.0,
    )
