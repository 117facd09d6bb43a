"""A virtual laboratory that records as laboratories do, and shares nothing with jounce: NumPy only.

A quarter car stands on a belt that has been running; one obstacle, or five, come round with it. What a laboratory
leaves behind is a folder of files: sixteen trials with accelerometers in volts behind AC-coupled conditioners and the
pulses of a photo sensor, spring and tyre on a test machine, free decays of a laser in volts, calibrations of both.
Only a short list of settings is written by hand. :func:`drawn` draws a laboratory from its seed, :func:`write` writes
its folder, and :func:`truths` says what is true.

The conventions are this laboratory's own: its accelerometers may be mounted upside down, its files carry its names,
its clock starts when somebody presses a key. Obstacles lie on the belt at rest, so the first passage of a record comes
anywhere, and the wheel still swings from the last one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

Array = np.ndarray
GRAVITY = 9.81
STEP = 2.5e-4
"""Step of the integration, s: a fourth-order method, and the wheel's mode lies at 30 Hz."""
RATE, DURATION, BEFORE = 2000, 10.0, 4.0
"""Samples per second of a trial (Hz), its length (s), and how long the belt has been running before it (s)."""
TABLE = (
    (1, 1.95, 26, 0.31, "A"), (2, 2.86, 26, 0.31, "A"), (3, 3.79, 26, 0.31, "A"), (4, 1.97, 26, 0.31, "B 0.10"),
    (5, 1.92, 26, 0.31, "B 0.15"), (6, 1.99, 26, 0.31, "B 0.20"), (7, 2.03, 16, 0.31, "A"), (8, 2.06, 10, 0.31, "A"),
    (9, 1.92, 26, 0.25, "A"), (10, 2.90, 26, 0.25, "A"), (11, 3.87, 26, 0.25, "A"), (12, 2.03, 16, 0.25, "A"),
    (13, 1.97, 10, 0.25, "A"), (14, 2.01, 26, 0.25, "B 0.10"), (15, 2.01, 26, 0.25, "B 0.15"),
    (16, 2.01, 26, 0.25, "B 0.20"),
)  # fmt: skip
"""Number, speed (m/s), angle of the strut (deg), pressure (MPa) and obstacles with their pitch (m): table 2 of the
quarter-car prototype paper."""


@dataclass(frozen=True)
class Bench:
    """The rig as it is, SI. Stiffness and cubic coefficient of the tyre by pressure (MPa); masses are weighed."""

    sprung: float = 16.0
    unsprung: float = 5.0
    rate: float = 22730.0
    bump: float = 140.0
    rebound: float = 170.0
    guide: float = 6.0
    onset: float = 2e-3
    tyre: dict[float, float] = field(default_factory=lambda: {0.31: 138e3, 0.25: 125e3})
    tyre_damping: float = 12.0
    height: float = 0.010
    length: float = 0.060


@dataclass(frozen=True)
class Belt:
    """Loop of the belt (m), its radius on the cylinder (m), slip on it (1), pulses of the photo sensor a turn."""

    loop: float = 1.97
    radius: float = 0.0515
    slip: float = 0.0
    pulses: int = 12
    ripple: float = 0.0  # share by which the speed swings, over ``ripple_time``
    ripple_time: float = 3.0  # s


@dataclass(frozen=True)
class Chain:
    """An accelerometer with its conditioner and its channel of the acquisition card.

    ``sensitivity`` in V/(m/s^2) as it is, ``stated`` as its label says; ``sign`` -1 where it hangs upside down;
    ``high_pass`` and ``low_pass`` in Hz (first order, and second-order Butterworth); ``offset``, ``noise`` and
    ``step`` of the converter in V, ``span`` the largest voltage.
    """

    sensitivity: float
    stated: float
    sign: int
    high_pass: float
    low_pass: float
    offset: float
    noise: float
    step: float = 20.0 / 2**16
    span: float = 10.0


@dataclass(frozen=True)
class Laboratory:
    """A laboratory: rig, belt, chains of both accelerometers, and the habits of those who record."""

    seed: int
    bench: Bench
    belt: Belt
    sprung: Chain
    unsprung: Chain
    laser: float  # V/m, as it is
    laser_stated: float
    speeds: tuple[float, ...]  # true mean speed of the belt in each trial, m/s
    phases: tuple[float, ...]  # where the loop stands when a record begins, m
    has_decimal_commas: bool = False
    missing_pulses: float = 0.0  # share
    double_pulses: float = 0.0
    jitter: float = 2e-5  # s


def drawn(seed: int) -> Laboratory:
    """Draw a laboratory. Errors that its people would state as bounds lie evenly within them."""
    draw = np.random.default_rng([37, seed])
    even = draw.uniform
    bump = even(90.0, 200.0)
    stiffness = even(125e3, 150e3)
    bench = Bench(
        sprung=16.0 * (1.0 + even(-0.005, 0.005)),
        unsprung=5.0 * (1.0 + even(-0.005, 0.005)),
        rate=even(20e3, 26e3),
        bump=bump,
        rebound=bump * even(1.0, 1.8),
        guide=even(2.0, 12.0),
        onset=math.exp(even(math.log(1e-3), math.log(5e-3))),
        tyre={0.31: stiffness, 0.25: stiffness * even(0.85, 0.95)},
        tyre_damping=even(6.0, 15.0),
        height=0.010 * (1.0 + even(-0.01, 0.01)),
        length=0.060 * (1.0 + even(-0.01, 0.01)),
    )
    belt = Belt(
        radius=even(0.045, 0.060),
        slip=even(0.0, 0.02),
        pulses=int(draw.choice([1, 6, 12, 24])),
        ripple=even(0.0, 0.01),
        ripple_time=even(2.0, 6.0),
    )

    def chain(stated: float, level: float) -> Chain:
        return Chain(
            stated * (1.0 + even(-0.01, 0.01)),
            stated,
            int(draw.choice([-1, 1])),
            even(0.2, 1.0),
            even(250.0, 600.0),
            even(-0.05, 0.05),
            level * stated,
        )

    stated = 0.1 / GRAVITY  # 100 mV/g
    laser = 5.0 / 0.050
    return Laboratory(
        seed,
        bench,
        belt,
        chain(stated, even(0.1, 0.25)),
        chain(0.1 * stated, even(0.4, 1.2)),
        laser * (1.0 + even(-0.01, 0.01)),
        laser,
        tuple(row[1] + even(-5e-3, 5e-3) for row in TABLE),
        tuple(even(0.0, belt.loop) for _ in TABLE),
        has_decimal_commas=bool(draw.random() < 0.3),
        missing_pulses=even(0.0, 0.01) if draw.random() < 0.5 else 0.0,
        double_pulses=even(0.0, 0.005) if draw.random() < 0.5 else 0.0,
        jitter=even(0.0, 5e-5),
    )


# the belt -------------------------------------------------------------------------------------------------------------


def travelled(belt: Belt, speed: float, phase: float, time: Array) -> tuple[Array, Array]:
    """Place of the loop under the wheel (m, from the first obstacle's start) and its speed (m/s); ``time`` in s."""
    turn = 2.0 * math.pi / belt.ripple_time
    x = phase + speed * (time - belt.ripple / turn * (np.cos(turn * time) - 1.0))
    return x, speed * (1.0 + belt.ripple * np.sin(turn * time))


def obstacles(bench: Bench, belt: Belt, profile: str, x: Array) -> tuple[Array, Array]:
    """Height (m) and slope (1) of a belt with half-sines on it: one, or five at the pitch that ``profile`` says."""
    count, pitch = (1, belt.loop) if profile == "A" else (5, float(profile.split()[1]))
    s = np.mod(x, belt.loop)
    which = np.clip(np.floor(s / pitch), 0, count - 1)
    into = s - which * pitch
    on = (into >= 0.0) & (into < bench.length)
    wave = math.pi / bench.length
    height = np.where(on, bench.height * np.sin(wave * into), 0.0)
    return height, np.where(on, bench.height * wave * np.cos(wave * into), 0.0)


# motion ---------------------------------------------------------------------------------------------------------------


def accelerations(lab: Laboratory) -> tuple[Array, Array]:
    """Accelerations (m/s^2) of body and wheel in all trials, each shape (samples, trials), from the record's start."""
    bench, belt = lab.bench, lab.belt
    angle = np.radians([row[2] for row in TABLE])
    cos = np.cos(angle)
    stiffness = np.array([bench.tyre[row[3]] for row in TABLE])
    sag = bench.sprung * GRAVITY / (cos * bench.rate)  # of the strut, along it
    rest = (bench.sprung + bench.unsprung) * GRAVITY / stiffness
    count = round((BEFORE + DURATION) / STEP)
    half = 0.5 * STEP * np.arange(2 * count + 1) - BEFORE
    height, climb = np.empty((2, len(half), len(TABLE)))
    for k, row in enumerate(TABLE):
        x, v = travelled(belt, lab.speeds[k], lab.phases[k], half)
        height[:, k], slope = obstacles(bench, belt, row[4], x)
        climb[:, k] = slope * v

    def rates(y: Array, road: Array, rise: Array) -> Array:
        body, wheel, v, w = y
        x, closing = cos * (wheel - body) + sag, cos * (w - v)
        along = bench.rate * x + np.where(closing > 0.0, bench.bump, bench.rebound) * closing
        deflection = road - wheel + rest
        contact = np.where(
            deflection > 0.0,
            np.maximum(stiffness * deflection + bench.tyre_damping * (rise - w), 0.0),
            0.0,
        )
        up = cos * along - bench.guide * np.tanh(v / bench.onset)
        return np.stack(
            [v, w, up / bench.sprung - GRAVITY, (contact - cos * along) / bench.unsprung - GRAVITY]
        )

    y = np.zeros((4, len(TABLE)))
    kept = round(1.0 / (RATE * STEP))
    first = round(BEFORE / STEP)
    samples = round(DURATION * RATE)
    read = np.empty((2, samples, len(TABLE)))
    for i in range(count):
        h, r = height[2 * i : 2 * i + 3], climb[2 * i : 2 * i + 3]
        one = rates(y, h[0], r[0])
        if i >= first and (i - first) % kept == 0:
            read[:, (i - first) // kept] = one[2:]
        two = rates(y + 0.5 * STEP * one, h[1], r[1])
        three = rates(y + 0.5 * STEP * two, h[1], r[1])
        four = rates(y + STEP * three, h[2], r[2])
        y = y + STEP / 6.0 * (one + 2.0 * (two + three) + four)
    return read[0], read[1]


# records --------------------------------------------------------------------------------------------------------------


def volts(chain: Chain, signal: Array, draw: np.random.Generator) -> Array:
    """What the card records of an acceleration (m/s^2), shape (samples, ...): V."""
    filtered = _filtered(signal, chain)
    out = (
        chain.sign * chain.sensitivity * filtered
        + chain.offset
        + chain.noise * draw.standard_normal(signal.shape)
    )
    return np.clip(np.round(out / chain.step) * chain.step, -chain.span, chain.span)


def _filtered(signal: Array, chain: Chain) -> Array:
    """First-order high pass and second-order Butterworth low pass, by Fourier: both started long before the record."""
    padded = 2 * len(signal)
    frequency = np.fft.rfftfreq(padded, 1.0 / RATE)[:, None]
    s = 1j * frequency
    high = s / (s + chain.high_pass)
    low = chain.low_pass**2 / (s**2 + math.sqrt(2.0) * chain.low_pass * s + chain.low_pass**2)
    lead = np.concatenate([signal[::-1], signal]).reshape(
        padded, -1
    )  # mirrored: no jump where the record begins
    return np.fft.irfft(np.fft.rfft(lead, axis=0) * high * low, padded, axis=0)[
        len(signal) :
    ].reshape(signal.shape)


def pulse_times(lab: Laboratory, trial: int, draw: np.random.Generator) -> Array:
    """Instants (s) at which the photo sensor sees a mark, from before the record to its end."""
    belt = lab.belt
    time = np.linspace(-0.5, DURATION + 0.1, 400_001)
    x, _ = travelled(belt, lab.speeds[trial], lab.phases[trial], time)
    turns = (
        x / ((1.0 - belt.slip) * 2.0 * math.pi * belt.radius) * belt.pulses
    )  # the cylinder runs ahead of the belt
    marks = np.arange(math.ceil(turns[0]), math.floor(turns[-1]) + 1)
    at = np.interp(marks, turns, time) + lab.jitter * draw.standard_normal(len(marks))
    at = at[draw.random(len(at)) >= lab.missing_pulses]
    doubled = at[draw.random(len(at)) < lab.double_pulses]
    return np.sort(np.concatenate([at, doubled + 0.2 * np.median(np.diff(at))]))


def pulse_volts(at: Array, time: Array, draw: np.random.Generator) -> Array:
    """Voltage of the photo sensor: 0.2 V, and 4.8 V for 1 ms (two samples) after each mark."""
    since = time - at[np.clip(np.searchsorted(at, time, side="right") - 1, 0, None)]
    seen = (since >= 0.0) & (since < 1e-3)
    return np.where(seen, 4.8, 0.2) + 0.03 * draw.standard_normal(time.size)


# files ----------------------------------------------------------------------------------------------------------------


def write(lab: Laboratory, folder: Path) -> None:
    """Write the 31 files of a laboratory into one folder."""
    folder.mkdir(parents=True, exist_ok=True)
    draw = np.random.default_rng([38, lab.seed])
    for name, columns in _files(lab, draw):
        _write_text(folder / name, columns, has_commas=lab.has_decimal_commas)


def _files(lab: Laboratory, draw: np.random.Generator) -> Iterator[tuple[str, dict[str, Array]]]:
    time = np.arange(round(DURATION * RATE)) / RATE
    body, wheel = accelerations(lab)
    first, second = volts(lab.sprung, body, draw), volts(lab.unsprung, wheel, draw)
    for k, (number, speed, angle, pressure, profile) in enumerate(TABLE):
        level = 1 + sum(speed > limit for limit in (2.4, 3.3))
        name = f"P{level}_{round(100 * pressure):03d}_{angle}_{profile[0]}_{number:02d}.csv"
        pulses = pulse_volts(pulse_times(lab, k, draw), time, draw)
        yield (
            name,
            {"Time [s]": time, "ch0 [V]": first[:, k], "ch1 [V]": second[:, k], "ch2 [V]": pulses},
        )
    yield from _machine(lab.bench, draw)
    yield from _decays(lab, draw)
    yield from _calibrations(lab, draw)


def _machine(bench: Bench, draw: np.random.Generator) -> Iterator[tuple[str, dict[str, Array]]]:
    """Five runs of the spring over 15 mm, and three of the tyre at each pressure over 10 mm."""

    def forces(law: Array) -> Array:
        return law * (1.0 + 0.002 * draw.standard_normal()) + 0.5 * draw.standard_normal(law.size)

    stroke = np.linspace(0.0, 15.0, 61)
    for number in range(1, 6):
        yield (
            f"mola_{number}.csv",
            {"Extension [mm]": stroke, "Load [N]": forces(bench.rate * 1e-3 * stroke)},
        )
    stroke = np.linspace(0.0, 10.0, 81)
    for pressure, stiffness in bench.tyre.items():
        for number in range(1, 4):
            name = f"tyre_{round(100 * pressure):03d}_{number}.csv"
            yield name, {"Extension [mm]": stroke, "Load [N]": forces(stiffness * 1e-3 * stroke)}


def _decays(lab: Laboratory, draw: np.random.Generator) -> Iterator[tuple[str, dict[str, Array]]]:
    """Two free decays of the body, the wheel on its tyre at 0.31 MPa; a laser's voltage."""
    time = np.arange(0.0, 3.0, 1.0 / 500.0)
    for number, lifted in enumerate((0.020, 0.015), 1):
        yield (
            f"decay_{number}.csv",
            {
                "Time [s]": time,
                "ch3 [V]": 2.5
                + lab.laser * _released(lab.bench, lifted, time)
                + 2e-3 * draw.standard_normal(time.size),
            },
        )


def _released(bench: Bench, lifted: float, time: Array) -> Array:
    """Height (m) of the body after it is let go, from rest."""
    cos = math.cos(math.radians(26.0))
    stiffness = bench.tyre[0.31]
    y = np.array(
        [lifted, lifted * bench.rate * cos**2 / (bench.rate * cos**2 + stiffness), 0.0, 0.0]
    )
    step, out = 5e-4, [y[0]]

    def rates(y: Array) -> Array:
        body, wheel, v, w = y
        closing = cos * (w - v)
        along = (
            bench.rate * cos * (wheel - body)
            + (bench.bump if closing > 0.0 else bench.rebound) * closing
        )
        contact = -stiffness * wheel - bench.tyre_damping * w
        up = cos * along - bench.guide * math.tanh(v / bench.onset)
        return np.array([v, w, up / bench.sprung, (contact - cos * along) / bench.unsprung])

    fine = round(time[-1] / step)
    for _ in range(fine):
        one = rates(y)
        two = rates(y + 0.5 * step * one)
        three = rates(y + 0.5 * step * two)
        y = y + step / 6.0 * (one + 2.0 * (two + three) + rates(y + step * three))
        out.append(y[0])
    return np.interp(time, step * np.arange(fine + 1), out)


def _calibrations(
    lab: Laboratory, draw: np.random.Generator
) -> Iterator[tuple[str, dict[str, Array]]]:
    """The laser against gauge blocks, and the body's accelerometer on a hand-held shaker: both by hand, as a table."""
    blocks = np.array([0.0, 5.0, 10.0, 20.0, 30.0, 40.0])
    reading = 0.4 + 1e-3 * lab.laser * blocks + 2e-3 * draw.standard_normal(blocks.size)
    yield "cal_laser.csv", {"displacement [mm]": blocks, "ch3 [V]": reading}
    levels = np.array([1.0, 2.0, 5.0, 10.0])
    reading = lab.sprung.sensitivity * levels * (1.0 + 5e-4 * draw.standard_normal(levels.size))
    yield "cal_acc_sprung.csv", {"acceleration [m/s^2]": levels, "ch0 [V]": reading}


def _write_text(file: Path, columns: dict[str, Array], *, has_commas: bool) -> None:
    text = "\n".join(
        (";" if has_commas else ",").join(f"{value:.6g}" for value in row)
        for row in np.column_stack([*columns.values()])
    )
    header = (";" if has_commas else ",").join(columns)
    file.write_text(
        f"{header}\n{text.replace('.', ',') if has_commas else text}\n", encoding="utf-8"
    )


# what is true ---------------------------------------------------------------------------------------------------------


def truths(lab: Laboratory) -> dict[str, float]:
    """Values that an update of the quarter car is to find, SI, by the rig's paths."""
    bench = lab.bench
    return {
        "strut.spring.rate": bench.rate,
        "strut.damper.bump_coefficient": bench.bump,
        "strut.damper.rebound_coefficient": bench.rebound,
        "guide.friction.force": bench.guide,
        "tyre.stiffness": bench.tyre[0.31],
        "tyre.damping_coefficient": bench.tyre_damping,
    }


def passages(lab: Laboratory, trial: int) -> Array:
    """Instants (s) at which the first obstacle of the belt meets the wheel within a trial's record."""
    time = np.linspace(0.0, DURATION, 200_001)
    x, _ = travelled(lab.belt, lab.speeds[trial], lab.phases[trial], time)
    loops = np.arange(math.ceil(x[0] / lab.belt.loop), math.floor(x[-1] / lab.belt.loop) + 1)
    return np.interp(loops * lab.belt.loop, x, time)


def write_book(lab: Laboratory, folder: Path) -> None:
    """Write what somebody noted by hand: the settings, and table 2 with its blank cells."""
    belt = lab.belt
    first, second = (
        f'sensitivity = "{label}", orientation = {chain.sign}, high_pass = "{chain.high_pass:.3g} Hz"'
        for label, chain in (("100 mV/g", lab.sprung), ("10 mV/g", lab.unsprung))
    )
    folder.joinpath("settings.toml").write_text(
        f"""schema = "jounce.laboratory/1"
synthetic = "A virtual laboratory"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {{height = "10 mm", length = "60 mm"}}
belt = {{length = "{belt.loop:g} m", radius = "{1e3 * belt.radius:.2f} mm", pulses = {belt.pulses}, column = "ch2"}}
[channels]
ch0 = {{measures = "sprung.az", {first}}}
ch1 = {{measures = "unsprung.az", {second}}}
ch3 = {{measures = "sprung.z", sensitivity = "5 V / 50 mm"}}
""",
        encoding="utf-8",
    )
    lines, above = ["trial,speed [m/s],angle [deg],pressure [MPa],profile"], ("", "", "")
    for number, speed, angle, pressure, profile in TABLE:
        here = (f"{angle}", f"{pressure}", profile)
        cells = ["" if cell == before else cell for cell, before in zip(here, above, strict=True)]
        lines.append(f"{number},{speed},{','.join(cells)}")
        above = here
    folder.joinpath("table.csv").write_text("\n".join(lines), encoding="utf-8")
