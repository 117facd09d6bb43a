"""Slow, readable twins of the vehicles: half car, half car with unsprung masses, full car, with NumPy and SciPy only.

The oracle of the agreement tests; it shares no code with jounce, only the frozen descriptions (numbers) go in.

Axes (ISO 8855): x forward, y left, z up. Pitch q is positive nose down, roll p right side down, so the body's height
over a wheel at (x, y) is  z - x q + y p. A strut pushes its wheel's place of the body up and the wheel down.

With unsprung masses (``WheelsTwin``; half cars: two equal wheels in the middle of an axle, ``n = 2``):

    d   = zu - (z - x q + y p)                       strut deflection, v its rate
    F   = preload + spring(d) + damper(v) + friction(v) + bump stop(d) - rebound stop(-d)
    B   = anti-roll rate (d - d of the other wheel)
    S   = y/|y| roll centre height / track * Fy      what the links carry: Fy is the axle's share of m a_y
    T   = tyre force of road - zu and its rate; with lift-off never below 0
    m  z'' = sum n (F + B) - m g
    Iy q'' = -sum n x (F + B) + M_y + m a_x h
    Ix p'' =  sum n y (F + B) + m a_y (h - mean roll centre height under the centre of gravity)
    mu zu'' = -mu g - F - B - S' + T

The lateral forces at the road, one axle's share Fy of m a_y, reach the body at the roll centre. Their moment about the
wheels' contact line, Fy times roll centre height, stands as a couple on the axle's two wheels: S' = -Fy hr / track on
the left wheel and the opposite on the right one presses the right wheel down in a left turn.

The half car of paper 2 (``HalfCarTwin``) has no wheels: the road is under the springs.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from itertools import pairwise

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root


class Signal:
    """A signal of time as pieces ``(start, end, value(t), rate(t))``; before the first piece its first value holds."""

    def __init__(self, pieces, delay: float = 0.0) -> None:
        self.pieces = [
            (a + delay, b + delay, lambda t, f=f: f(t - delay), lambda t, f=r: f(t - delay))
            for a, b, f, r in pieces
        ]
        if delay > 0.0:
            level = pieces[0][2](pieces[0][0])
            self.pieces.insert(0, (0.0, delay, *held(level)))
        self.starts = [piece[0] for piece in self.pieces]

    def at(self, t: float) -> tuple[float, float]:
        piece = self.pieces[max(bisect_right(self.starts, t) - 1, 0)]
        return piece[2](t), piece[3](t)


def held(value: float, rate: float = 0.0):
    """A constant value and a constant rate, which need not belong to each other."""
    return (lambda _: value), (lambda _: rate)


def constant(value: float = 0.0, rate: float = 0.0) -> Signal:
    return Signal([(0.0, 1e9, *held(value, rate))])


def ramp(value: float, start: float, length: float = 0.0) -> Signal:
    """A load that begins at ``start`` and grows to ``value`` along a line of ``length`` seconds."""
    pieces = [(0.0, start, *held(0.0))] if start > 0.0 else []
    if length > 0.0:
        slope = value / length
        pieces.append((start, start + length, lambda t: slope * (t - start), lambda _: slope))
    pieces.append((start + length, 1e9, *held(value)))
    return Signal(pieces)


def _interpolated(x: float, points, values) -> float:
    i = min(max(bisect_right(list(points), x) - 1, 0), len(points) - 2)
    return values[i] + (values[i + 1] - values[i]) * (x - points[i]) / (points[i + 1] - points[i])


def _curve(curve, x: float) -> float:
    if curve.kind == "polynomial":
        return sum(c * x ** (i + 1) for i, c in enumerate(curve.coefficients))
    if curve.kind == "power":
        return curve.coefficient * x**curve.exponent if x > 0.0 else 0.0
    return _interpolated(x, curve.deflection, curve.force)


def _stop(stop, d: float) -> float:
    over = 0.0 if stop is None else max(d - stop.gap, 0.0)
    return 0.0 if over == 0.0 else stop.rate * over + stop.progression * over**3


class Twin:
    """What both twins share: pieces of smooth road, one after the other, and channels by name."""

    names: tuple[str, ...]
    signals: dict[str, Signal]

    def value(self, name: str, t: float) -> tuple[float, float]:
        return self.signals[name].at(t) if name in self.signals else (0.0, 0.0)

    def edges(self, first: float, last: float) -> list[float]:
        inner = {
            start
            for signal in self.signals.values()
            for start in signal.starts
            if first < start < last
        }
        return [first, *sorted(inner), last]

    def run(
        self, times, *, tolerance: float = 1e-11, max_step: float = 1e-2
    ) -> dict[str, np.ndarray]:
        """Integrate piece after piece; give every channel at ``times`` (at a jump: just after it)."""
        times = np.asarray(times, dtype=float)
        x, rows, edges = self.rest(), {}, self.edges(times[0], times[-1])
        for start, end in pairwise(edges):
            # signals are asked for inside of the piece only: at its edges the neighbour's value might come

            def inside(t, a=start, b=end):
                return min(max(t, a + 1e-13 * (1.0 + a)), b - 1e-13 * (1.0 + b))

            wanted = times[(times >= start - 1e-12) & (times < end - 1e-12)]
            done = solve_ivp(
                lambda t, x, inside=inside: self.rate(inside(t), x),
                (start, end),
                x,
                method="DOP853",
                rtol=tolerance,
                atol=tolerance * 1e-2,
                max_step=max_step,
                t_eval=[*np.clip(wanted, start, end), end],
            )
            assert done.success, done.message
            for t, state in zip(wanted, done.y.T[:-1], strict=True):
                self._store(rows, inside(t), state)
            x = done.y[:, -1]
        self._store(rows, times[-1], x)
        return {name: np.array(values) for name, values in rows.items()}

    def _store(self, rows, t: float, x) -> None:
        for name, value in self.channels(t, x).items():
            rows.setdefault(name, []).append(float(value))


class HalfCarTwin(Twin):
    """Eqs (6)-(11) of paper 2 with the demo's signs; state z, q, z', q'.

    ``compat``: "simulink" adds the road's height to the body's, "sign-corrected" subtracts it, both without its rate;
    "physical" has height and rate of each axle's own road. ``rear_sign = -1`` is eq. (9) as the paper prints it.
    """

    def __init__(self, vehicle, signals, *, rear_sign: float = 1.0) -> None:
        self.car, self.signals, self.rear_sign = vehicle, signals, rear_sign

    def axles(self, t: float, x):
        """Of front and rear: lever forward, deflection, rate the damper feels, force of one wheel."""
        z, q, vz, vq = x
        for name, sign in (("front", 1.0), ("rear", -1.0)):
            axle = getattr(self.car, name)
            lever = sign * axle.distance
            h, h_rate = self.value(f"{name}.road.z", t)
            h, h_rate = {
                "physical": (h, h_rate),
                "sign-corrected": (h, 0.0),
                "simulink": (-h, 0.0),
            }[self.car.compat]
            d, v = h - (z - lever * q), h_rate - (vz - lever * vq)
            yield name, lever, d, v, axle.spring_rate * d + axle.damping_coefficient * v

    def accelerations(self, t: float, x) -> tuple[float, float]:
        body = self.car.body
        heave, pitch = -body.mass * self.car.gravity, self.moment(t)
        for name, lever, _, _, force in self.axles(t, x):
            heave += 2.0 * force
            pitch += -lever * 2.0 * force * (self.rear_sign if name == "rear" else 1.0)
        return heave / body.mass, pitch / body.pitch_inertia

    def moment(self, t: float) -> float:
        moment = self.value("pitch_moment", t)[0]
        if self.car.body.height is not None:
            moment += self.car.body.mass * self.car.body.height * self.value("deceleration", t)[0]
        return moment

    def rate(self, t: float, x):
        return [x[2], x[3], *self.accelerations(t, x)]

    def rest(self):
        """Two linear equations: the constant part and the columns of the forces."""
        zero = np.array(self.accelerations(0.0, [0.0] * 4))
        columns = [
            np.array(self.accelerations(0.0, row)) - zero
            for row in ([1.0, 0, 0, 0], [0, 1.0, 0, 0])
        ]
        # the road's rate at the start is no part of rest
        still = {name: constant(signal.at(0.0)[0]) for name, signal in self.signals.items()}
        zero = np.array(
            type(self)(self.car, still, rear_sign=self.rear_sign).accelerations(0.0, [0.0] * 4)
        )
        return np.array([*np.linalg.solve(np.array(columns).T, -zero), 0.0, 0.0])

    def matrices(self) -> tuple[np.ndarray, np.ndarray]:
        """Stiffness and damping matrices of z, q (N/m, N, N m; times s)."""
        zero = np.array(self.accelerations(0.0, [0.0] * 4))
        rows = [np.array(self.accelerations(0.0, row)) - zero for row in np.eye(4)]
        masses = np.array([self.car.body.mass, self.car.body.pitch_inertia])
        columns = (-np.array(rows) * masses).T
        return columns[:, :2], columns[:, 2:]

    def channels(self, t: float, x):
        az, aq = self.accelerations(t, x)
        result = {
            "body.z": x[0],
            "body.vz": x[2],
            "body.az": az,
            "body.pitch": x[1],
            "body.pitch_rate": x[3],
            "body.pitch_acceleration": aq,
            "body.pitch_moment": self.moment(t),
        }
        for name, lever, d, v, force in self.axles(t, x):
            result |= {
                f"{name}.road.z": self.value(f"{name}.road.z", t)[0],
                f"{name}.sprung.z": x[0] - lever * x[1],
                f"{name}.sprung.vz": x[2] - lever * x[3],
                f"{name}.sprung.az": az - lever * aq,
                f"{name}.strut.deflection": d,
                f"{name}.strut.velocity": v,
                f"{name}.strut.force": force,
            }
        return result


class WheelsTwin(Twin):
    """Half car with unsprung masses and full car; state z, q, p, wheel heights, and the rates of all these."""

    def __init__(self, vehicle, signals) -> None:
        self.car, self.signals = vehicle, signals
        self.full = vehicle.model == "full-car"
        self.corners = (
            ("front_left", "front_right", "rear_left", "rear_right")
            if self.full
            else ("front", "rear")
        )
        self.axle = [getattr(vehicle, corner.split("_")[0]) for corner in self.corners]
        self.x = np.array(
            [
                axle.distance * (1.0 if c.startswith("front") else -1.0)
                for c, axle in zip(self.corners, self.axle, strict=True)
            ]
        )
        self.y = np.array(
            [
                (0.5 * a.track if c.endswith("left") else -0.5 * a.track) if self.full else 0.0
                for c, a in zip(self.corners, self.axle, strict=True)
            ]
        )
        self.wheels = 1.0 if self.full else 2.0
        self.unsprung = np.array([axle.unsprung_mass for axle in self.axle])
        self.bar_rates = (
            np.array([axle.anti_roll_bar_rate for axle in self.axle]) if self.full else None
        )
        self.n = 3 + len(self.corners)

    # --- laws of one wheel ------------------------------------------------------------------------------------

    def strut(self, i: int, d: float, v: float) -> float:
        axle = self.axle[i]
        if axle.spring is None:
            force = axle.spring_rate * d
        else:
            curve = axle.spring.curve
            force = axle.spring.preload + (
                axle.spring.rate * d if curve is None else _curve(curve, d)
            )
        force += (
            axle.damping_coefficient * v if axle.damper is None else self._damper(axle.damper, d, v)
        )
        if axle.friction is not None:
            force += axle.friction.force * math.tanh(v / axle.friction.regularisation_velocity)
        return force + _stop(axle.bump_stop, d) - _stop(axle.rebound_stop, -d)

    def _damper(self, law, d: float, v: float) -> float:
        if law.kind == "linear":
            return law.coefficient * v
        if law.kind == "bilinear":
            return (law.bump_coefficient if v > 0.0 else law.rebound_coefficient) * v
        if law.kind == "blow-off":
            side, speed = ("bump", v) if v > 0.0 else ("rebound", -v)
            knee, slope = (
                getattr(law, f"{side}_blow_off_velocity"),
                getattr(law, f"{side}_high_speed_coefficient"),
            )
            steep = min(speed / knee, 1.0) * getattr(law, f"{side}_blow_off_force")
            return math.copysign(steep + slope * max(speed - knee, 0.0), v)
        if law.kind == "tanh":
            bend = math.tanh(law.slope * (v + law.displacement_coupling * d))
            return law.coefficient * v + law.stiffness * d + law.force * bend + law.offset
        return _interpolated(v, law.velocity, law.force)

    def tyre(self, i: int, delta: float, rate: float) -> float:
        law = self.axle[i].tyre
        if law.lift_off and delta <= 0.0:
            return 0.0
        force = law.stiffness * delta if law.curve is None else _curve(law.curve, delta)
        force += law.damping_coefficient * rate
        return max(force, 0.0) if law.lift_off else force

    # --- the car ----------------------------------------------------------------------------------------------

    def forces(self, t: float, x):
        """Of every wheel: d, v, strut force, anti-roll force, tyre deflection and its force."""
        heave, rates = x[:3], x[self.n : self.n + 3]
        zu, vu = x[3 : self.n], x[self.n + 3 :]
        d = zu - (heave[0] - self.x * heave[1] + self.y * heave[2])
        v = vu - (rates[0] - self.x * rates[1] + self.y * rates[2])
        strut = np.array([self.strut(i, d[i], v[i]) for i in range(len(self.corners))])
        roads = np.array([self.value(f"{corner}.road.z", t) for corner in self.corners])
        delta = roads[:, 0] - zu
        tyre = np.array(
            [self.tyre(i, delta[i], roads[i, 1] - vu[i]) for i in range(len(self.corners))]
        )
        return d, v, strut, self.bars(d), delta, tyre

    def bars(self, d):
        if not self.full:
            return np.zeros(len(d))
        return self.bar_rates * (d - d[[1, 0, 3, 2]])

    def cornering(self, t: float) -> tuple[float, np.ndarray]:
        """Moment about the x axis on the body (N m), and what the links press each wheel down with (N)."""
        lateral = self.value("lateral_acceleration", t)[0] if self.full else 0.0
        if lateral == 0.0:
            return 0.0, np.zeros(len(self.corners))
        side = self.car.body.mass * lateral
        a, b = self.car.front.distance, self.car.rear.distance
        share = {"front": side * b / (a + b), "rear": side * a / (a + b)}
        moment = sum(
            share[n] * (self.car.body.height - getattr(self.car, n).roll_centre_height)
            for n in share
        )
        pressed = [
            -math.copysign(1.0, y)
            * share[corner.split("_")[0]]
            * axle.roll_centre_height
            / axle.track
            for corner, axle, y in zip(self.corners, self.axle, self.y, strict=True)
        ]
        return moment, np.array(pressed)

    def pitching(self, t: float) -> float:
        moment = self.value("pitch_moment", t)[0]
        if self.car.body.height is not None:
            moment += self.car.body.mass * self.car.body.height * self.value("deceleration", t)[0]
        return moment

    def accelerations(self, t: float, x):
        """Of body heave, pitch and roll (0 for a half car) and of the wheels."""
        body, g = self.car.body, self.car.gravity
        _, _, strut, bar, _, tyre = self.forces(t, x)
        push, (roll_moment, pressed) = strut + bar, self.cornering(t)
        heave = self.wheels * push.sum() / body.mass - g
        pitch = (self.pitching(t) - self.wheels * self.x @ push) / body.pitch_inertia
        roll = (self.wheels * self.y @ push + roll_moment) / body.roll_inertia if self.full else 0.0
        wheels = (tyre - push - pressed) / self.unsprung - g
        return np.array([heave, pitch, roll, *wheels])

    def rate(self, t: float, x):
        return np.concatenate((x[self.n :], self.accelerations(t, x)))

    def rest(self):
        """Where nothing accelerates, roads and loads held at their first values."""
        still = type(self)(
            self.car, {name: constant(signal.at(0.0)[0]) for name, signal in self.signals.items()}
        )
        size = np.ones(self.n)
        guess = np.array([-0.2, 0.0, 0.0, *[-0.02] * len(self.corners)])
        free = [i for i in range(self.n) if self.full or i != 2]

        def residual(u):
            x = np.zeros(2 * self.n)
            x[free] = u
            return (still.accelerations(0.0, x) * size)[free]

        found = root(residual, guess[free], method="hybr", options={"xtol": 1e-15})
        found = root(residual, found.x, method="hybr", options={"xtol": 1e-15})
        assert np.max(np.abs(residual(found.x))) < 1e-7, found.message
        x = np.zeros(2 * self.n)
        x[free] = found.x
        return x

    def channels(self, t: float, x):
        n, a = self.n, self.accelerations(t, x)
        result = {}
        for i, (name, rate, acceleration) in enumerate(
            (
                ("z", "vz", "az"),
                ("pitch", "pitch_rate", "pitch_acceleration"),
                ("roll", "roll_rate", "roll_acceleration"),
            )
        ):
            if i < 2 or self.full:
                result |= {
                    f"body.{name}": x[i],
                    f"body.{rate}": x[n + i],
                    f"body.{acceleration}": a[i],
                }
        result["body.pitch_moment"] = self.pitching(t)
        d, v, strut, _, delta, tyre = self.forces(t, x)
        for i, corner in enumerate(self.corners):
            row = np.array([1.0, -self.x[i], self.y[i]])
            result |= {
                f"{corner}.{name}": value
                for name, value in (
                    ("road.z", self.value(f"{corner}.road.z", t)[0]),
                    ("sprung.z", row @ x[:3]),
                    ("sprung.vz", row @ x[n : n + 3]),
                    ("sprung.az", row @ a[:3]),
                    ("unsprung.z", x[3 + i]),
                    ("unsprung.vz", x[n + 3 + i]),
                    ("unsprung.az", a[3 + i]),
                    ("strut.deflection", d[i]),
                    ("strut.velocity", v[i]),
                    ("strut.force", strut[i]),
                    ("tyre.deflection", delta[i]),
                    ("tyre.force", tyre[i]),
                )
            }
        return result


def road_pieces(segments):
    """Turn closed-form pieces against time (see their documentation) into ``(start, end, value(t), rate(t))``."""
    result = []
    for i in range(len(segments.kind)):
        start, end = float(segments.edges[i]), float(segments.edges[i + 1])
        law = (_line, _sine, _circle)[int(segments.kind[i])]
        result.append(
            (
                start,
                end,
                *law([float(c) for c in segments.coefficients[i]], start, float(segments.rate)),
            )
        )
    return result


def _line(c, start: float, speed: float):
    if not any(c[1:4]):
        return held(c[0])

    def height(t: float) -> float:
        s = speed * (t - start)
        return c[0] + s * (c[1] + s * (c[2] + s * c[3]))

    def rate(t: float) -> float:
        s = speed * (t - start)
        return speed * (c[1] + s * (2.0 * c[2] + s * 3.0 * c[3]))

    return height, rate


def _sine(c, start: float, speed: float):
    return (
        lambda t: c[0] + c[1] * math.sin(c[2] * speed * (t - start) + c[3]),
        lambda t: speed * c[1] * c[2] * math.cos(c[2] * speed * (t - start) + c[3]),
    )


def _circle(c, start: float, speed: float):
    def height(t: float) -> float:
        return math.sqrt(max(c[1] ** 2 - (speed * (t - start) - c[2]) ** 2, 0.0))

    return (
        lambda t: c[0] + c[3] * height(t),
        lambda t: (
            -speed * c[3] * (speed * (t - start) - c[2]) / height(t) if height(t) > 0.0 else 0.0
        ),
    )


def driven(
    vehicle, road, speed: float, duration: float, *, right=None, **loads: Signal
) -> dict[str, Signal]:
    """Tracks of a car on a road: wheels behind the front axle meet it later by their distance over the speed."""
    corners, behind = ("front", "rear"), vehicle.front.distance + vehicle.rear.distance
    if vehicle.model == "full-car":
        corners = ("front_left", "front_right", "rear_left", "rear_right")
    elif getattr(vehicle, "compat", "physical") != "physical":
        behind = 0.0
    signals: dict[str, Signal] = dict(loads)
    for corner in corners:
        under = right if right is not None and corner.endswith("right") else road
        late = behind if corner.startswith("rear") else 0.0
        if (
            under.kind == "table" and late
        ):  # which may begin before distance 0: the same table, put further ahead
            under, late = under.model_copy(update={"start": under.start + late}), 0.0
        pieces = road_pieces(under.segments(speed * duration).in_time(speed).with_ramps(1e-9))
        signals[f"{corner}.road.z"] = Signal(pieces, late / speed)
    return signals


def twin_of(vehicle, signals) -> Twin:
    return (
        HalfCarTwin(vehicle, signals)
        if vehicle.model == "half-car"
        else WheelsTwin(vehicle, signals)
    )
