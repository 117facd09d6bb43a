"""Slow, readable twin of a quarter car on a tester's plate: NumPy and SciPy only, no code of jounce.

It makes records for the tests of the evaluation, and is the oracle of tester models.

    F  = M g + kt (zp - zu) + ct (zp' - zu'), never negative with lift-off     force of the plate on the tyre
    ms zs'' = -k (zs - zu) - c (zs' - zu') - dry friction
    mu zu'' = +k (zs - zu) + c (zs' - zu') + dry friction + F - M g            heights about the static rest
    rigid plate   zp = e sin(theta(t))
    sprung plate  mp zp'' = kp (e sin(theta) - zp) + cp (...)' - (F - M g)

theta is 2 pi times: hold at the start frequency, then a frequency that changes linearly down (or up) to the end
frequency, then rest. The force cell stands under the plate, so it shows ``F + mp zp''``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

G = 9.81


@dataclass(frozen=True)
class Car:
    ms: float = 400.0
    mu: float = 40.0
    k: float = 25e3
    c: float = 1000.0
    kt: float = 200e3
    ct: float = 0.0
    friction: float = 0.0

    @property
    def static_load(self) -> float:
        return (self.ms + self.mu) * G

    def matrix(self) -> np.ndarray:
        """Of the state zs, zs', zu, zu' with the plate at rest."""
        ms, mu, k, c, kt, ct = self.ms, self.mu, self.k, self.c, self.kt, self.ct
        return np.array(
            [
                [0.0, 1.0, 0.0, 0.0],
                [-k / ms, -c / ms, k / ms, c / ms],
                [0.0, 0.0, 0.0, 1.0],
                [k / mu, c / mu, -(k + kt) / mu, -(c + ct) / mu],
            ]
        )

    def rig_matrix(self, mp: float, kp: float, cp: float = 0.0) -> np.ndarray:
        """Of the state zs, zs', zu, zu', zp, zp' with the exciter at rest."""
        a = np.zeros((6, 6))
        a[:4, :4] = self.matrix()
        a[3, 4:] = self.kt / self.mu, self.ct / self.mu
        a[4, 5] = 1.0
        a[5, 2:] = self.kt / mp, self.ct / mp, -(self.kt + kp) / mp, -(self.ct + cp) / mp
        return a

    def wheel_damping(self, matrix: np.ndarray | None = None) -> float:
        """Damping ratio of the mode in which the wheel bounces: the second lowest that oscillates."""
        values = np.linalg.eigvals(self.matrix() if matrix is None else matrix)
        poles = sorted(values[values.imag > 1e-9], key=abs)
        pole = poles[1 if len(poles) == len(values) // 2 else 0]
        return float(-pole.real / abs(pole))

    def response(self, frequency: np.ndarray) -> np.ndarray:
        """Dynamic tyre force over plate height, N/m (domain C1)."""
        s = 2j * np.pi * np.asarray(frequency)
        strut, tyre = self.k + self.c * s, self.kt + self.ct * s
        body = self.ms * s**2 + strut
        return tyre * (1.0 - body * tyre / (body * (self.mu * s**2 + strut + tyre) - strut**2))


@dataclass(frozen=True)
class Programme:
    start: float = 25.0
    end: float = 0.0
    rate: float = 2.5
    hold: float = 1.5
    rest: float = 0.5
    before: float = 0.0
    phase: float = 0.0

    @property
    def duration(self) -> float:
        return self.before + self.hold + abs(self.start - self.end) / self.rate + self.rest

    def angle(self, t: np.ndarray) -> np.ndarray:
        """Exciter angle, rad."""
        sign = math.copysign(1.0, self.end - self.start)
        length = abs(self.start - self.end) / self.rate
        held = np.clip(t - self.before, 0.0, self.hold)
        swept = np.clip(t - self.before - self.hold, 0.0, length)
        turns = self.start * (held + swept) + 0.5 * sign * self.rate * swept**2
        return 2.0 * np.pi * turns + self.phase


def grid(duration: float, sample_rate: float) -> np.ndarray:
    return np.arange(round(duration * sample_rate) + 1) / sample_rate


def linear_motion(a: np.ndarray, b: np.ndarray, drive: np.ndarray, step: float) -> np.ndarray:
    """States of x' = a x + b u from rest, u straight between samples: modes one by one (of a pair one), exact."""
    from scipy.signal import lfilter

    values, vectors = np.linalg.eig(a)
    into = np.linalg.solve(vectors, b.astype(complex)) * (1.0 + (values.imag > 0.0))
    into, vectors, values = (
        into[values.imag >= 0.0],
        vectors[:, values.imag >= 0.0],
        values[values.imag >= 0.0],
    )
    states = np.empty((len(values), len(drive)), dtype=complex)
    for i, pole in enumerate(values):
        z = pole * step
        grown = np.exp(z)
        now = (grown - 1.0) / z - (grown - 1.0 - z) / z**2  # weight of the earlier sample
        then = (grown - 1.0 - z) / z**2
        states[i] = lfilter(into[i] * step * np.array([then, now]), [1.0, -grown], drive)
        states[i] -= into[i] * step * then * drive[0] * grown ** np.arange(len(drive))
    return (vectors @ states).real


def rigid_record(
    car: Car, programme: Programme, *, e=3e-3, sample_rate=1000.0, fine=8, mp=0.0, lift_off=False
):
    """Time, plate height, measured force, contact force of a run on the rigid plate, at ``sample_rate``."""
    t = grid(programme.duration, sample_rate * fine)
    z = e * np.sin(programme.angle(t))
    a, b = car.matrix(), np.array([0.0, 0.0, 0.0, car.kt / car.mu])
    if lift_off or car.friction > 0.0:
        f = stepped(car, t, z)
    else:
        z0 = z - z[0]
        x = (
            linear_motion(a, b, z0, t[1])
            if car.ct == 0.0
            else linear_motion(*damped(car), z0, t[1])
        )
        wheel, wheel_rate = x[2], x[3]
        zdot = np.gradient(z, t[1], edge_order=2)
        f = car.static_load + car.kt * (z0 - wheel) + car.ct * (zdot - wheel_rate)
        if car.ct > 0.0:
            f = (
                car.static_load
                + car.kt * (z0 - x[2])
                + car.ct * (zdot - (x[3] + car.ct / car.mu * z0))
            )
    inertia = mp * np.gradient(np.gradient(z, t[1], edge_order=2), t[1], edge_order=2)
    return t[::fine], z[::fine], (f + inertia)[::fine], f[::fine]


def damped(car: Car) -> tuple[np.ndarray, np.ndarray]:
    """With tyre damping the input's rate acts: zu' is replaced by zu' - (ct / mu) zp, so that zp alone drives."""
    a = car.matrix()
    shift = np.array([0.0, 0.0, 0.0, car.ct / car.mu])
    return a, a @ shift + np.array([0.0, 0.0, 0.0, car.kt / car.mu])


def stepped(car: Car, t: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Contact force with lift-off and dry friction: RK4 over two fine samples, the mid one in between."""
    ms, mu, k, c, kt, ct, friction = car.ms, car.mu, car.k, car.c, car.kt, car.ct, car.friction
    load, h = car.static_load, 2.0 * (t[1] - t[0])
    rate = np.gradient(z, t[1], edge_order=2)
    force = np.empty(len(t))

    def contact(zu, vu, i):
        return max(0.0, load + kt * (z[i] - z[0] - zu) + ct * (rate[i] - vu))

    def slope(x, i):
        zs, vs, zu, vu = x
        strut = k * (zs - zu) + c * (vs - vu) + friction * math.tanh((vs - vu) / 2e-3)
        return vs, -strut / ms, vu, (strut + contact(zu, vu, i) - load) / mu

    x = (0.0, 0.0, 0.0, 0.0)
    force[0] = contact(0.0, 0.0, 0)
    for i in range(0, len(t) - 2, 2):
        k1 = slope(x, i)
        k2 = slope(tuple(a + 0.5 * h * b for a, b in zip(x, k1, strict=True)), i + 1)
        k3 = slope(tuple(a + 0.5 * h * b for a, b in zip(x, k2, strict=True)), i + 1)
        k4 = slope(tuple(a + h * b for a, b in zip(x, k3, strict=True)), i + 2)
        x = tuple(
            a + h / 6.0 * (p + 2 * q + 2 * r + s)
            for a, p, q, r, s in zip(x, k1, k2, k3, k4, strict=True)
        )
        force[i + 2] = contact(x[2], x[3], i + 2)
        force[i + 1] = 0.5 * (force[i] + force[i + 2])  # of no fine grid that is read
    return force


def sprung_record(
    car: Car, programme: Programme, *, e=3.25e-3, mp=20.0, kp=50e3, sample_rate=1000.0, fine=8
):
    """Time, plate height, measured force, contact force of a run on the sprung plate (linear)."""
    t = grid(programme.duration, sample_rate * fine)
    exciter = e * np.sin(programme.angle(t))
    b = np.zeros(6)
    b[5] = kp / mp
    x = linear_motion(car.rig_matrix(mp, kp), b, exciter - exciter[0], t[1])
    f = car.static_load + car.kt * (x[4] - x[2]) + car.ct * (x[5] - x[3])
    inertia = mp * np.gradient(np.gradient(x[4], t[1], edge_order=2), t[1], edge_order=2)
    return t[::fine], x[4][::fine], (f + inertia)[::fine], f[::fine]


def random_car(rng: np.random.Generator, *, e: float = 3e-3) -> Car:
    """A passenger car's corner that stays on the plate with room to spare."""
    while True:
        ms = rng.uniform(180.0, 550.0)
        car = Car(
            ms=ms,
            mu=rng.uniform(0.07, 0.16) * ms,
            k=ms * (2.0 * math.pi * rng.uniform(1.0, 1.6)) ** 2,
            kt=rng.uniform(140e3, 300e3),
            ct=rng.uniform(0.0, 150.0),
        )
        critical = 2.0 * math.sqrt((car.k + car.kt) * car.mu)
        car = replace(car, c=critical * rng.uniform(0.05, 0.35))
        if e * np.abs(car.response(np.linspace(0.3, 25.0, 400))).max() < 0.97 * car.static_load:
            return car
