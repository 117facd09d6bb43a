"""Quarter, half and full car agree where they must: the same physics at less freedom."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

HALF = jn.load("audi-a6-half-car")
HALF4 = jn.load("audi-a6-half-car-4dof")
FULL = jn.load("audi-a6-full-car")
BUMP = jn.HalfSine(height="60 mm", length="0.5 m", start="2 m")
ROLLS = ("body.roll", "body.roll_rate", "body.roll_acceleration", "body.lateral_acceleration")


def run(car, *, road=BUMP, speed=10.0, duration=1.5, tolerance=1e-9, **loads):
    return jn.simulate(
        car, jn.Trial(road=road, speed=speed, duration=duration, **loads), tolerance=tolerance
    )


def same(a, b, *, allowed: float) -> None:
    a, b = np.asarray(a), np.asarray(b)
    assert np.max(np.abs(a - b)) <= allowed * max(np.ptp(b), 1e-12)


# --- full car = half car with unsprung masses ------------------------------------------------------------------------


@pytest.mark.parametrize(
    "loads", [{}, {"deceleration": {"value": 4.0, "start": 0.3}}, {"pitch_moment": 900.0}]
)
def test_full_car_on_equal_roads_is_the_half_car(loads):
    full, half = run(FULL, **loads), run(HALF4, **loads)
    for name in half:
        for twin in (
            [name]
            if name.startswith("body")
            else [name.replace(".", f"_{s}.", 1) for s in ("left", "right")]
        ):
            same(full[twin], half[name], allowed=1e-9)
    for name in ROLLS:
        assert np.max(np.abs(full[name].values)) < 1e-11


def test_full_car_on_equal_roads_with_every_law():
    damper = {
        "velocity": [-1.0, -0.1, 0.0, 0.1, 1.0],
        "force": [-3000.0, -600.0, 0.0, 300.0, 1500.0],
    }
    changes = {
        "front.damping_coefficient": None,
        "front.damper": damper,
        "front.bump_stop": {"gap": 0.18, "rate": 9e4},
        "rear.rebound_stop": {"gap": -0.15, "rate": 9e4},
        "rear.friction": {"force": 50.0},
    }
    full, half = run(FULL.with_changes(changes)), run(HALF4.with_changes(changes))
    for name in ("body.z", "body.pitch", "body.az"):
        same(full[name], half[name], allowed=1e-8)


def test_modes_of_the_half_car_are_among_those_of_the_full_car():
    full = [(mode.frequency_hz, mode.damping_ratio) for mode in jn.modes(FULL)]
    for mode in jn.modes(HALF4):
        assert (
            min(np.hypot(f / mode.frequency_hz - 1, d - mode.damping_ratio) for f, d in full)
            < 1e-10
        )


# --- half car = quarter cars -----------------------------------------------------------------------------------------


def quarter_of(axle, mass: float, damper=None):
    """Quarter car that stands under one end: ``mass`` is what one wheel carries."""
    strut = {
        "spring": {"rate": axle.spring_rate},
        "damper": damper or {"coefficient": axle.damping_coefficient},
    }
    table = {
        "model": "quarter-car",
        "sprung": {"mass": mass},
        "unsprung": {"mass": axle.unsprung_mass},
        "strut": strut,
        "tyre": axle.tyre.model_dump(exclude_none=True),
    }
    return type(jn.load("audi-a6-quarter-car")).model_validate({"schema": "jounce.rig/1", **table})


def with_index_one(car):
    """Pitch inertia m a b: each end of the body stands on its own."""
    body = car.body
    return car.with_changes(
        {"body.pitch_inertia": body.mass * car.front.distance * car.rear.distance}
    )


BOUC_WEN = {
    "kind": "bouc-wen",
    "coefficient": 1500.0,
    "hysteretic_force": 200.0,
    "rate": 300.0,
    "sigma": 0.8,
    "exponent": 2.0,
}


@pytest.mark.parametrize("damper", [None, BOUC_WEN], ids=["linear", "bouc-wen"])
def test_with_dynamic_index_one_each_end_is_a_quarter_car(damper):
    changes = {} if damper is None else {"front.damping_coefficient": None, "front.damper": damper}
    for car in (with_index_one(car).with_changes(changes) for car in (HALF4, FULL)):
        found = run(car)
        share = {
            "front": car.rear.distance / car.wheelbase,
            "rear": car.front.distance / car.wheelbase,
        }
        for end, late in (("front", 0.0), ("rear", car.wheelbase)):
            road = BUMP.model_copy(update={"start": BUMP.start + late})
            axle = getattr(HALF4, end)
            expected = run(
                quarter_of(
                    axle, 0.5 * car.body.mass * share[end], damper if end == "front" else None
                ),
                road=road,
            )
            corner = end if car.model == "half-car-4dof" else f"{end}_left"
            for name in (
                "sprung.z",
                "sprung.az",
                "unsprung.z",
                "strut.force",
                "tyre.force",
                "road.z",
            ):
                same(found[f"{corner}.{name}"], expected[name], allowed=3e-7)


def test_massless_half_car_with_index_one_is_an_oscillator():
    """Front end: m b/L z'' + 2 c z' + 2 k z = 2 k h + 2 c h', in closed form on a sine."""
    car = with_index_one(HALF)
    mass = 0.5 * car.body.mass * car.rear.distance / car.wheelbase
    k, c = car.front.spring_rate, car.front.damping_coefficient
    model = jn.linearise(car)
    for f in (0.3, 1.2, 5.0, 25.0):
        s = 2j * np.pi * f
        expected = (k + c * s) / (mass * s**2 + c * s + k)
        found = model.frequency_response(f, "front.sprung.z", "front.road.z")[0]
        assert abs(found - expected) < 1e-12
        assert abs(model.frequency_response(f, "front.sprung.z", "rear.road.z")[0]) < 1e-12


# --- stiff tyres, light wheels -> massless axles ---------------------------------------------------------------------


def test_stiff_tyres_and_light_wheels_give_the_half_car():
    """The difference falls in proportion to the tyre's compliance (wheel mass with it)."""
    road = jn.Versine(height="50 mm", length="4 m", start="1 m")
    exact = run(HALF, road=road, duration=1.0)
    errors = []
    for factor in (10.0, 100.0, 1000.0):
        changes = {
            f"{axle}.{path}": value
            for axle in ("front", "rear")
            for path, value in (
                ("tyre.stiffness", 3e5 * factor),
                ("tyre.damping_coefficient", 0.0),
                ("tyre.lift_off", False),
                ("unsprung_mass", 40.0 / factor),
            )
        }
        found = run(HALF4.with_changes(changes), road=road, duration=1.0)
        error = 0.0
        for name in ("body.z", "body.pitch"):
            moved, expected = (data[name].values - float(data[name][0]) for data in (found, exact))
            error = max(error, np.max(np.abs(moved - expected)) / np.ptp(expected))
        errors.append(error)
    rates = np.log10(np.array(errors[:-1]) / errors[1:])
    assert np.all(np.abs(rates - 1.0) < 0.1), errors
    assert errors[-1] < 2e-4


# --- roll alone ------------------------------------------------------------------------------------------------------


def rigid_wheels(**changes):
    """Full car, all the same front and rear."""
    same_axles = {
        "rear.distance": 1.4,
        "front.distance": 1.4,
        "rear.spring_rate": 25e3,
        "front.spring_rate": 25e3,
        "rear.damping_coefficient": 2500.0,
        "front.damping_coefficient": 2500.0,
        "rear.unsprung_mass": 42.0,
        "front.unsprung_mass": 42.0,
        "rear.anti_roll_bar_rate": 8e3,
        "front.anti_roll_bar_rate": 8e3,
        "rear.roll_centre_height": 0.1,
        "front.roll_centre_height": 0.1,
    }
    for axle in ("front", "rear"):
        same_axles |= {f"{axle}.tyre.lift_off": False, f"{axle}.tyre.damping_coefficient": 0.0}
    return FULL.with_changes({**same_axles, **changes})


def test_roll_in_closed_form():
    """Two degrees of freedom of four equal corners: Ix p'' + 4 y^2 ..., the wheels antisymmetric.

    With w = wheel height on the left = -right and a roll p, a strut deflects by w - y p; the bar adds twice its rate.
    """
    car = rigid_wheels()
    y, k, c, kt = 0.5 * 1.54, 25e3 + 2 * 8e3, 2500.0, 3e5
    model = jn.linearise(car)
    for f in (0.2, 1.5, 4.0, 12.0):
        s = 2j * np.pi * f
        strut = k + c * s
        matrix = np.array(
            [
                [600.0 * s**2 + 4 * y**2 * strut, -4 * y * strut],
                [-y * strut, 42.0 * s**2 + strut + kt],
            ]
        )
        roll, wheel = np.linalg.solve(matrix, [0.0, kt])  # road +1 m on the left, -1 m on the right
        found = {
            name: sum(
                (1 if track.endswith("left.road.z") else -1)
                * model.frequency_response(f, name, track)[0]
                for track in model.inputs
                if track.endswith(".road.z") and "rate" not in track
            )
            for name in (
                "body.roll",
                "front_left.unsprung.z",
                "rear_right.unsprung.z",
                "body.z",
                "body.pitch",
            )
        }
        assert abs(found["body.roll"] - roll) < 1e-11 * abs(roll)
        assert abs(found["front_left.unsprung.z"] - wheel) < 1e-11 * abs(wheel)
        assert abs(found["rear_right.unsprung.z"] + wheel) < 1e-11 * abs(wheel)
        assert abs(found["body.z"]) < 1e-12
        assert abs(found["body.pitch"]) < 1e-12


def test_steady_cornering_in_closed_form():
    """Roll of the body on springs and bars plus that on the tyres; load transfer m a h / track in all."""
    a, car = 3.0, rigid_wheels()
    rest = run(car, road=jn.Flat(), duration=0.01, lateral_acceleration=a)
    side, y = 1636.0 * a, 0.77
    strut_stiffness = 4 * y**2 * (25e3 + 2 * 8e3)
    tyre_stiffness = 4 * y**2 * 3e5
    roll = side * (0.55 - 0.1) / strut_stiffness + side * 0.55 / tyre_stiffness
    assert abs(float(rest["body.roll"][0]) - roll) < 1e-12
    for end in ("front", "rear"):
        left, right = (float(rest[f"{end}_{s}.tyre.force"][0]) for s in ("left", "right"))
        assert abs((right - left) * 0.5 * 1.54 - 0.5 * side * 0.55) < 1e-8
    np.testing.assert_allclose(rest["body.roll"], roll, rtol=0, atol=1e-12)  # and there it stays


def test_roll_centres_at_the_centre_of_gravity_leave_the_body_upright():
    car = rigid_wheels(**{"front.roll_centre_height": 0.55, "rear.roll_centre_height": 0.55})
    rest = run(car, road=jn.Flat(), duration=0.01, lateral_acceleration=5.0)
    struts = [float(rest[f"{corner}.strut.force"][0]) for corner in car.corners]
    assert np.ptp(struts) < 1e-8  # all of it goes through the links ...
    tyres = [float(rest[f"front_{side}.tyre.force"][0]) for side in ("left", "right")]
    assert (
        abs(tyres[1] - tyres[0] - 1636.0 * 5.0 * 0.55 / 1.54 / 1.0) < 1e-8
    )  # ... half of it at each axle, twice


# --- mirror ----------------------------------------------------------------------------------------------------------


def test_mirrored_roads_and_turns_mirror_everything():
    hole = jn.Trapezoid(height="-30 mm", length="1 m", ramp="0.2 m", start="3 m")
    load = {"start": 0.2, "ramp": 0.1}
    one = run(FULL, right=hole, lateral_acceleration={"value": 4.0, **load})
    other = run(FULL, road=hole, right=BUMP, lateral_acceleration={"value": -4.0, **load})
    for name in one:
        if name in ROLLS:
            same(other[name], -one[name], allowed=2e-8)
        else:
            twin = name.replace("left", "?").replace("right", "left").replace("?", "right")
            same(other[twin], one[name], allowed=2e-8)


# --- linear model = simulation ---------------------------------------------------------------------------------------

LINEAR = {f"{axle}.tyre.lift_off": False for axle in ("front", "rear")}


@pytest.mark.parametrize(
    "car", [HALF, HALF4.with_changes(LINEAR), FULL.with_changes(LINEAR)], ids=lambda car: car.model
)
@pytest.mark.parametrize("frequency", [0.7, 1.4, 6.0])
def test_frequency_response_is_the_simulation_on_a_sine(car, frequency):
    speed, amplitude, duration = 10.0, 0.01, max(12.0 / frequency, 6.0)
    wavelength = speed / frequency
    x = np.arange(-0.3 * wavelength, speed * duration + 1.0, wavelength / 200.0)
    sine = amplitude * np.sin(2 * np.pi * x / wavelength)
    road = jn.Table(x=x, height=sine, interpolation="cubic")
    found = run(car, road=road, speed=speed, duration=duration)
    model = jn.linearise(car)
    t = found["time"].values
    late = t > duration - 2.0 / frequency
    for name in ("body.z", "body.pitch", "body.az", "body.pitch_acceleration"):
        total = 0.0
        for corner in car.corners:
            delay = np.exp(-2j * np.pi * car.wheels[corner].behind / wavelength)
            total += delay * model.frequency_response(frequency, name, f"{corner}.road.z")[0]
        expected = np.imag(amplitude * total * np.exp(2j * np.pi * frequency * t))
        rest = model_rest(car, name)
        error = np.max(np.abs(found[name].values - rest - expected)[late])
        assert error < 1e-6 * amplitude * abs(total), name


def model_rest(car, name: str) -> float:
    return 0.0 if name.endswith(("az", "acceleration")) else jn.equilibrium(car)[name]


@pytest.mark.parametrize("track", ["pitch_moment", "lateral_acceleration"])
def test_response_to_a_load_is_that_of_the_linear_model(track):
    car = FULL.with_changes(LINEAR)
    model = jn.linearise(car)
    value = 1000.0 if track == "pitch_moment" else 4.0
    found = run(car, road=jn.Flat(), duration=8.0, **{track: {"value": value, "start": 0.1}})
    name = "body.pitch" if track == "pitch_moment" else "body.roll"
    static = (model.C @ np.linalg.solve(-model.A, model.B))[
        model.outputs.index(name), model.inputs.index(track)
    ]
    assert abs(float(found[name][-1] - found[name][0]) - value * static) < 1e-6 * abs(
        value * static
    )


# --- wheelbase filtering ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("j", [1, 2, 3])
def test_wheelbase_filtering(j):
    """The symmetric car does not bounce on waves of 2L/(2j-1) and does not pitch on those of L/j."""
    car = rigid_wheels()
    model, length, speed = jn.linearise(car), car.wheelbase, 20.0

    def response(name: str, wavelength: float) -> float:
        f = speed / wavelength
        return abs(
            sum(
                np.exp(-2j * np.pi * car.wheels[corner].behind / wavelength)
                * model.frequency_response(f, name, f"{corner}.road.z")[0]
                for corner in car.corners
            )
        )

    for name, zero, other in (
        ("body.z", 2 * length / (2 * j - 1), length / j),
        ("body.pitch", length / j, 2 * length / (2 * j - 1)),
    ):
        assert response(name, zero) < 1e-12
        assert response(name, other) > 1e-4


def test_wheelbase_filtering_in_a_run():
    car = rigid_wheels()
    length, speed = car.wheelbase, 20.0
    for wavelength, quiet, loud in (
        (2 * length, "body.z", "body.pitch"),
        (length, "body.pitch", "body.z"),
    ):
        road = jn.Table(
            x=np.linspace(0.0, 200.0, 8001),
            height=0.01 * np.sin(2 * np.pi * np.linspace(0, 200.0, 8001) / wavelength),
        )
        found = run(car, road=road, speed=speed, duration=9.9)
        late = found["time"].values > 7.0
        assert np.ptp(found[quiet].values[late]) < 1e-3 * np.ptp(found[loud].values[late])
