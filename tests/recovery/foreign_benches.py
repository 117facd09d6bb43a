"""Virtual quarter-car benches that share nothing with jounce: own equations, own integration, own roads and sensors.

Everything here is NumPy: a fourth-order Runge-Kutta method of fixed step over all trials of many benches at once. A
bench is drawn from its seed. It hides from the model that is fitted to it: a progressive spring, a degressive and
asymmetric damper, friction of strut and guide (regularised, or Dahl's), a cubic tyre, masses, strut angle, height of
the obstacles, the speed of each trial and a belt that slows down on them, gains, bandwidths and delays of the sensors,
and noise. :func:`true_values` gives what a parameter of the simple laws should come out as.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

Array = np.ndarray
GRAVITY = 9.81
STEP = 5e-5
"""Step of the integration, s."""
RATE, DURATION = 1000.0, 1.5
"""Samples per second of the recordings (Hz), and their duration (s)."""
_SPARE = 0.02  # s that are simulated beyond a recording that begins early
CHANNELS = ("sprung.az", "unsprung.az", "strut.deflection", "sprung.z")
NOMINAL_ONSET = 5e-3
"""Velocity (m/s) over which friction turns over in the model that is fitted."""


@dataclass(frozen=True)
class Rig:
    """A quarter car, SI.

    ``rate`` and ``stiffness`` (N/m) are tangents at the static deflections of spring and tyre. The spring's tangent
    grows by the share ``growth`` over a static deflection; ``cube`` (N/m^3) is the tyre's cubic coefficient. The damper
    has the slopes ``bump`` and ``rebound`` (N s/m) at rest, and bends down around its ``knee`` (m/s) to a power
    ``exponent`` of the velocity. Friction of ``strut`` and ``guide`` (N) turns over an ``onset`` (m/s), or is Dahl's
    and builds up over a ``distance`` (m). Deflections are positive in compression.
    """

    sprung: float = 16.0
    unsprung: float = 5.0
    angle: float = math.radians(26.0)
    rate: float = 22730.0
    growth: float = 0.0
    bump: float = 150.0
    rebound: float = 150.0
    knee: float = 0.3
    exponent: float = 1.0
    strut: float = 0.0
    guide: float = 0.0
    is_dahl: bool = False
    onset: float = NOMINAL_ONSET
    distance: float = 2e-4
    stiffness: float = 138e3
    cube: float = 0.0
    tyre_damping: float = 10.0


@dataclass(frozen=True)
class Road:
    """``count`` obstacles of one shape, ``pitch`` from start to start, the first ``start`` from the wheel; m.

    ``shape`` is ``half-sine``, ``versine`` or ``trapezoid`` with straight ramps of length ``ramp``.
    """

    shape: str = "half-sine"
    height: float = 0.010
    length: float = 0.060
    ramp: float = 0.020
    start: float = 0.2
    count: int = 1
    pitch: float = 0.1


@dataclass(frozen=True)
class Pass:
    """A ride over a road: true speed (m/s), and the share of it that the belt loses over the first ``over`` m."""

    road: Road
    speed: float
    slowing: float = 0.0
    over: float = 0.06


@dataclass(frozen=True)
class Chain:
    """A sensor: gain (1), low pass of an ``order`` with its ``corner`` (Hz; 0 for none), noise (SI)."""

    gain: float = 1.0
    corner: float = 0.0
    order: int = 2
    noise: float = 0.0


@dataclass(frozen=True)
class Ride:
    """One trial as it was: pass, sensors by channel, and delays of its records by channel (s, positive is late)."""

    rig: Rig
    driven: Pass
    chains: dict[str, Chain] = field(default_factory=dict)
    delays: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Motion:
    """What happened in one trial, at :data:`RATE`: ``recorded`` channels and the true states and forces, SI."""

    recorded: dict[str, Array]
    strut: Array
    velocity: Array
    tyre: Array
    tyre_rate: Array
    body: Array
    strut_force: Array
    damper_force: Array
    guide_force: Array
    tyre_force: Array


@dataclass(frozen=True)
class Bench:
    """A bench: what its user states, and what is true.

    ``stated`` are values of the user's rig by its paths (SI), ``start`` those of its free parameters; ``roads`` and
    ``speeds`` are those of the trials as stated, ``channels`` those that were recorded.
    """

    seed: int
    kind: str
    rig: Rig
    rides: list[Ride]
    roads: list[Road]
    speeds: list[float]
    channels: tuple[str, ...]
    stated: dict[str, float]
    noise_seed: int


# drawing --------------------------------------------------------------------------------------------------------------

SPEEDS = (1.95, 2.86, 3.79, 1.97)
"""Stated speeds (m/s) of three passes of a single obstacle and one of five."""


HARSH = 1000
"""Seeds from here on draw benches whose errors are larger, and further from what is doubted."""


def drawn(seed: int) -> Bench:
    """Draw a bench: errors lie evenly within their bounds, or on harsh benches as often beyond as a normal error does.

    Harsh benches have also springs that bend more, delays of up to 15 ms, lower bandwidths, and belts that lose their
    speed at once.
    """
    draw = np.random.default_rng([35, seed])
    even, is_harsh = draw.uniform, seed >= HARSH

    def off(bound: float) -> float:
        return bound * (draw.standard_normal() if is_harsh else even(-1.0, 1.0))

    def about(value: float, share: float) -> float:
        return value * (1.0 + off(share))

    masses, angle = (16.0, 5.0), math.radians(26.0)
    place = str(draw.choice(["guide", "both", "strut"], p=[0.55, 0.3, 0.15]))
    guide = {"guide": even(3.0, 15.0), "both": even(3.0, 12.0), "strut": 0.0}[place]
    strut = {"guide": 0.0, "both": even(1.0, 5.0), "strut": even(3.0, 10.0)}[place]
    bump = even(80.0, 200.0)
    rig = Rig(
        sprung=about(masses[0], 0.03),
        unsprung=about(masses[1], 0.03),
        angle=angle + math.radians(off(0.5)),
        rate=even(20e3, 26e3),
        growth=even(0.0, 0.15 if is_harsh else 0.06),
        bump=bump,
        rebound=bump * even(1.0, 2.2),
        knee=even(0.2, 0.8),
        exponent=even(0.6, 0.95),
        strut=strut,
        guide=guide,
        is_dahl=bool(draw.random() < 0.5),
        onset=math.exp(even(math.log(0.5e-3), math.log(5e-3))),
        distance=math.exp(even(math.log(0.05e-3), math.log(0.3e-3))),
        stiffness=even(118e3, 150e3),
        tyre_damping=even(5.0, 15.0),
    )
    rest = (masses[0] + masses[1]) * GRAVITY / rig.stiffness
    bend = (
        even(0.0, 0.25) * rig.stiffness / (3.0 * (8e-3**2 - rest**2))
    )  # how much stiffer it is at 8 mm
    rig = replace(rig, cube=bend)
    shape = str(draw.choice(["half-sine", "versine", "trapezoid"], p=[0.6, 0.2, 0.2]))
    height, length = even(0.008, 0.012), 0.060 if shape == "half-sine" else even(0.06, 0.09)
    single = Road(shape, round(height, 4), round(length, 3), ramp=0.02)
    train = replace(single, count=5, pitch=float(draw.choice([0.10, 0.15, 0.20])))
    roads = [single, single, single, train]
    true_height = about(single.height, 0.015)
    more = str(draw.choice(["", "strut.deflection", "sprung.z"], p=[0.6, 0.2, 0.2]))
    channels = (*CHANNELS[:2], *([more] if more else []))
    sizes = {
        "sprung.az": even(0.08, 0.25),
        "unsprung.az": even(0.4, 1.2),
        "strut.deflection": 5e-5,
        "sprung.z": 5e-5,
    }
    chains = {
        name: Chain(
            gain=about(1.0, 0.01),
            corner=math.exp(even(math.log(80.0 if is_harsh else 120.0), math.log(400.0))),
            order=int(draw.choice([1, 2])),
            noise=sizes[name],
        )
        for name in channels
    }
    rides, slowest = [], even(0.0, 0.02)
    for road, speed in zip(roads, SPEEDS, strict=True):
        whole = road.length + (road.count - 1) * road.pitch
        late = even(-15e-3, 15e-3) if is_harsh else even(-5e-3, 5e-3)
        lost_over = [road.length, whole, *([0.01] if is_harsh else [])]
        rides.append(
            Ride(
                rig,
                Pass(
                    replace(road, height=true_height),
                    speed + off(5e-3),
                    slowing=slowest * even(0.5, 1.0),
                    over=float(draw.choice(lost_over)),
                ),
                chains,
                {name: late + even(-0.5e-3, 0.5e-3) for name in channels},
            )
        )
    stated = {
        "sprung.mass": masses[0],
        "unsprung.mass": masses[1],
        "strut.angle": angle,
        "tyre.damping_coefficient": rig.tyre_damping,
    }
    kind = f"{'Dahl' if rig.is_dahl else 'tanh'} friction in {'guide and strut' if place == 'both' else place}"
    return Bench(
        seed, kind, rig, rides, roads, list(SPEEDS), channels, stated, int(draw.integers(2**31))
    )


def starts(bench: Bench, truth: dict[str, tuple[float, float]]) -> dict[str, float]:
    """Start values of the free parameters: off by up to 10 % (rate and stiffness) or 25 % (damper)."""
    draw = np.random.default_rng([36, bench.seed])
    off = {"strut.spring.rate": 0.10, "tyre.stiffness": 0.10}
    found = {
        path: 0.5 * sum(both) * (1.0 + off.get(path, 0.25) * draw.uniform(-1.0, 1.0))
        for path, both in truth.items()
        if path != "guide.friction.force"
    }
    return {**found, "guide.friction.force": 5.0}


# laws -----------------------------------------------------------------------------------------------------------------


class _Lanes:
    """Numbers of many rides side by side, each shape (lanes,), and their laws."""

    def __init__(self, rides: Sequence[Ride]) -> None:
        for name in Rig.__dataclass_fields__:
            setattr(self, name, np.array([getattr(ride.rig, name) for ride in rides]))
        self.cos = np.cos(self.angle)
        self.sag = self._static_strut()
        self.square = 0.5 * self.rate * self.growth / self.sag
        self.straight = self.rate - 2.0 * self.square * self.sag
        self.rest, self.line = self._static_tyre()

    def _static_strut(self) -> Array:
        """Deflection at which the spring carries the body: force = rate (x - growth x / 2) there, whatever the bend."""
        return self.sprung * GRAVITY / (self.cos * self.rate * (1.0 - 0.5 * self.growth))

    def _static_tyre(self) -> tuple[Array, Array]:
        """Static deflection d, and the linear coefficient, of ``(stiffness - 3 cube d^2) d + cube d^3 = load``."""
        load = (self.sprung + self.unsprung) * GRAVITY
        d = load / self.stiffness
        for _ in range(30):
            d = (load + 2.0 * self.cube * d**3) / self.stiffness
        return d, self.stiffness - 3.0 * self.cube * d**2

    def spring(self, x: Array) -> Array:
        return (self.straight + self.square * x) * x

    def damper(self, v: Array) -> Array:
        speed = np.abs(v)
        bent = self.knee * ((1.0 + speed / self.knee) ** self.exponent - 1.0) / self.exponent
        return np.where(v > 0.0, self.bump, self.rebound) * np.sign(v) * bent

    def tyre(self, d: Array, rate: Array) -> Array:
        force = (self.line + self.cube * d * d) * d + self.tyre_damping * rate
        return np.where(d > 0.0, np.maximum(force, 0.0), 0.0)

    def sliding(self, v: Array, share: Array) -> Array:
        """Friction as a share of its force: Dahl's state, or a function of the velocity."""
        return np.where(self.is_dahl, share, np.tanh(v / self.onset))

    def sliding_rate(self, v: Array, share: Array) -> Array:
        return np.where(self.is_dahl, (v - np.abs(v) * share) / self.distance, 0.0)


# roads ----------------------------------------------------------------------------------------------------------------


def travelled(one: Pass, time: Array) -> tuple[Array, Array]:
    """Distance (m) and speed (m/s): the belt loses its share in proportion to the way over the first obstacles."""
    v, a, loss = one.speed, one.road.start, max(one.slowing, 1e-12)
    reached = a / v
    left = reached - one.over / (loss * v) * math.log1p(-loss)
    on = np.clip(time - reached, 0.0, left - reached)
    x = np.minimum(time, reached) * v + one.over / loss * -np.expm1(-loss * v / one.over * on)
    x = x + np.maximum(time - left, 0.0) * v * (1.0 - loss)
    return x, v * (1.0 - loss * np.clip((x - a) / one.over, 0.0, 1.0))


def height_and_slope(road: Road, x: Array) -> tuple[Array, Array]:
    """Height (m) and slope (1) of a road at distances x (m)."""
    into = x - road.start
    which = np.clip(np.floor(into / road.pitch), 0, road.count - 1)
    s = into - which * road.pitch
    on = (s >= 0.0) & (s < road.length)
    h, length = road.height, road.length
    if road.shape == "half-sine":
        height, slope = (
            h * np.sin(np.pi * s / length),
            h * np.pi / length * np.cos(np.pi * s / length),
        )
    elif road.shape == "versine":
        turn = 2.0 * np.pi / length
        height, slope = 0.5 * h * (1.0 - np.cos(turn * s)), 0.5 * h * turn * np.sin(turn * s)
    else:
        rise = h / road.ramp
        height = np.minimum(np.minimum(s, length - s) * rise, h)
        slope = np.where(s < road.ramp, rise, np.where(s > length - road.ramp, -rise, 0.0))
    return np.where(on, height, 0.0), np.where(on, slope, 0.0)


# motion ---------------------------------------------------------------------------------------------------------------

_ZS, _ZU, _VS, _VU, _STRUT, _GUIDE, _FILTERS = range(7)


def ridden(rides: Sequence[Ride], *, duration: float = DURATION) -> list[Motion]:
    """Simulate rides side by side; noise is not in it."""
    lanes = _Lanes(rides)
    count = round((duration + _SPARE) / STEP)
    half = 0.5 * STEP * np.arange(2 * count + 1)
    roads = [(ride.driven, *travelled(ride.driven, half)) for ride in rides]
    tables = [(*height_and_slope(one.road, x), v) for one, x, v in roads]
    height = np.array([h for h, _, _ in tables]).T.copy()
    climb = np.array([slope * v for _, slope, v in tables]).T.copy()

    static_wheel = -lanes.rest
    static_body = static_wheel - lanes.sag / lanes.cos
    corner = (
        2.0 * np.pi * np.array([[_chain(ride, name).corner for ride in rides] for name in CHANNELS])
    )
    is_filtered = corner > 0.0
    is_first = np.array([[_chain(ride, name).order == 1 for ride in rides] for name in CHANNELS])
    y = np.zeros((_FILTERS + 2 * len(CHANNELS), len(rides)))
    y[_ZS], y[_ZU] = static_body, static_wheel
    kept = round(1.0 / (RATE * STEP))
    read = np.empty((count, len(CHANNELS), len(rides)))
    states = np.empty((count // kept + 1, _FILTERS, len(rides)))

    def rates(y: Array, road: Array, rise: Array) -> tuple[Array, Array]:
        x, v = lanes.cos * (y[_ZU] - y[_ZS]), lanes.cos * (y[_VU] - y[_VS])
        along = lanes.spring(x) + lanes.damper(v) + lanes.strut * lanes.sliding(v, y[_STRUT])
        contact = lanes.tyre(road - y[_ZU], rise - y[_VU])
        guided = lanes.guide * lanes.sliding(y[_VS], y[_GUIDE])
        out = np.empty_like(y)
        out[_ZS], out[_ZU] = y[_VS], y[_VU]
        out[_VS] = (lanes.cos * along - guided) / lanes.sprung - GRAVITY
        out[_VU] = (contact - lanes.cos * along) / lanes.unsprung - GRAVITY
        out[_STRUT], out[_GUIDE] = (
            lanes.sliding_rate(v, y[_STRUT]),
            lanes.sliding_rate(y[_VS], y[_GUIDE]),
        )
        seen = np.stack([out[_VS], out[_VU], x - lanes.sag, y[_ZS] - static_body])
        first, second = y[_FILTERS::2], y[_FILTERS + 1 :: 2]
        out[_FILTERS::2] = np.where(is_first, corner * (seen - first), second)
        bent = corner * (corner * (seen - first) - math.sqrt(2.0) * second)
        out[_FILTERS + 1 :: 2] = np.where(is_first, 0.0, bent)
        return out, np.where(is_filtered, first, seen)

    for i in range(count):
        h, r = height[2 * i : 2 * i + 3], climb[2 * i : 2 * i + 3]
        one, read[i] = rates(y, h[0], r[0])
        if i % kept == 0:
            states[i // kept] = y[:_FILTERS]
        two, _ = rates(y + 0.5 * STEP * one, h[1], r[1])
        three, _ = rates(y + 0.5 * STEP * two, h[1], r[1])
        four, _ = rates(y + STEP * three, h[2], r[2])
        y = y + STEP / 6.0 * (one + 2.0 * (two + three) + four)

    samples = round(duration * RATE) + 1
    states, at = states[:samples], kept * np.arange(samples)
    strut, velocity = (
        lanes.cos * (states[:, _ZU] - states[:, _ZS]),
        lanes.cos * (states[:, _VU] - states[:, _VS]),
    )
    tyre, tyre_rate = height[2 * at] - states[:, _ZU], climb[2 * at] - states[:, _VU]
    damper = lanes.damper(velocity)
    force = lanes.spring(strut) + damper + lanes.strut * lanes.sliding(velocity, states[:, _STRUT])
    guide = lanes.guide * lanes.sliding(states[:, _VS], states[:, _GUIDE])
    contact = lanes.tyre(tyre, tyre_rate)
    found = []
    for k, ride in enumerate(rides):
        recorded = {}
        for place, name in enumerate(CHANNELS):
            late = round(ride.delays.get(name, 0.0) / STEP)
            recorded[name] = (
                _chain(ride, name).gain * read[np.clip(at - late, 0, count - 1), place, k]
            )
        true = (strut, velocity, tyre, tyre_rate, states[:, _VS], force, damper, guide, contact)
        found.append(Motion(recorded, *(one[:, k] for one in true)))
    return found


def _chain(ride: Ride, channel: str) -> Chain:
    return ride.chains.get(channel, Chain())


def run(benches: Sequence[Bench], *, at_once: int = 25) -> list[list[Motion]]:
    """Run all trials of benches: a list of motions for each, without noise."""
    found = []
    for first in range(0, len(benches), at_once):
        some = benches[first : first + at_once]
        motions = iter(ridden([ride for bench in some for ride in bench.rides]))
        found += [[next(motions) for _ in bench.rides] for bench in some]
    return found


def records(bench: Bench, motions: Sequence[Motion]) -> list[dict[str, Array]]:
    """Give what was recorded in each trial: channels of the bench with white noise, SI."""
    draw = np.random.default_rng(bench.noise_seed)
    return [
        {
            name: motion.recorded[name]
            + ride.chains[name].noise * draw.standard_normal(len(motion.strut))
            for name in bench.channels
        }
        for ride, motion in zip(bench.rides, motions, strict=True)
    ]


# what is true ---------------------------------------------------------------------------------------------------------


def true_values(bench: Bench, motions: Sequence[Motion]) -> dict[str, tuple[float, float]]:
    """Component and effective value of each parameter that is fitted, SI.

    The component value is what a test machine gives of the part alone: tangents of spring and tyre at the static
    deflection, the line through zero nearest to the damper's force over the velocities ridden on that side, friction
    while it slides. The effective value is that of the fitted law nearest to the true force over the states ridden, in
    least squares: the strut's force by a constant, spring, bump and rebound (the fitted strut has no friction); the
    tyre's force while it touches by a constant, stiffness and damping; the guide's by ``tanh(v / 5 mm/s)``.
    """
    lanes = _Lanes(bench.rides[:1])

    def all_of(name: str) -> Array:
        return np.concatenate([getattr(motion, name) for motion in motions])

    v, damper = all_of("velocity"), all_of("damper_force")
    up, down = np.maximum(v, 0.0), np.minimum(v, 0.0)
    tyre, rate = all_of("tyre"), all_of("tyre_rate")
    touches, turned = tyre > 0.0, np.tanh(all_of("body") / NOMINAL_ONSET)
    one = np.ones(len(v))
    strut = _nearest([one, all_of("strut"), up, down], all_of("strut_force"))
    contact = _nearest([one[touches], tyre[touches], rate[touches]], all_of("tyre_force")[touches])
    guide = _nearest([turned], all_of("guide_force"))
    return {
        "strut.spring.rate": (float(lanes.rate[0]), strut[1]),
        "strut.damper.bump_coefficient": (float(up @ damper / (up @ up)), strut[2]),
        "strut.damper.rebound_coefficient": (float(down @ damper / (down @ down)), strut[3]),
        "guide.friction.force": (bench.rig.guide, guide[0]),
        "tyre.stiffness": (float(lanes.stiffness[0]), contact[1]),
    }


def _nearest(columns: Sequence[Array], force: Array) -> list[float]:
    return np.linalg.lstsq(np.column_stack(columns), force, rcond=None)[0].tolist()
