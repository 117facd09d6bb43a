"""The half car of paper 2 (table 2, eqs 6-11) and the demo it comes from: statics, matrices, modes, extremes.

Sources: MathWorks example "Automotive Suspension" (sldemo_suspn), parameters and equations as documented; paper 2
("suspension-system paper"), table 2 and its cases A and B, recomputed with the demo's sign of the rear moment. Every
number is compared to its printed digits.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.source(
    kind="computed",
    of="half car",
    key="suspension-system",
    where="Table 2 and eqs. (6) to (11), with the sign of the demo; solved beside jounce",
    tolerance="half a unit of the last printed digit",
)

AUDI = jn.load("audi-a6-half-car")
DEMO = jn.load("sldemo-half-car")
MASSES = np.diag([1636.0, 2500.0])


def printed(value: float, text: str) -> None:
    """Equal when rounded to the digits of the text."""
    digits = len(text.partition(".")[2])
    assert value == pytest.approx(float(text), abs=0.5000001 * 10.0**-digits)


def matrices(car: jn.LinearModel) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness and damping matrix about body height and pitch, from the linear model."""
    assert car.states == ("body.z", "body.pitch", "body.vz", "body.pitch_rate")
    return -MASSES @ car.A[2:, :2], -MASSES @ car.A[2:, 2:]


def eigenvalues(model: jn.LinearModel) -> list[complex]:
    found = np.linalg.eigvals(model.A)
    return sorted(found[found.imag > 0.0], key=abs)


# --- the demo (sldemo_suspn.json) ------------------------------------------------------------------------------------

OF_THE_DEMO = pytest.mark.source(
    kind="computed",
    of="half car",
    key="sldemo-suspn",
    where="parameters and equations as documented; solved beside jounce",
    tolerance="half a unit of the last printed digit",
)


@OF_THE_DEMO
def test_demo_rest():
    rest = jn.equilibrium(DEMO)
    assert rest["body.z"] == pytest.approx(-0.12012244897959184, abs=1e-14)
    assert abs(rest["body.pitch"]) < 1e-15  # 28000 * 0.9 = 21000 * 1.2


@OF_THE_DEMO
def test_demo_road_counts_downwards():
    trial = jn.Trial(road=jn.Step(height="10 mm", start="70 m"), speed="10 m/s", duration="30 s")
    run = jn.simulate(DEMO, trial)
    printed(float(run["body.z"][-1]), "-0.1301")
    up = jn.simulate(DEMO.with_changes({"compat": "sign-corrected"}), trial)
    assert float(up["body.z"][-1]) + 0.12012244897959184 == pytest.approx(0.01, abs=1e-7)


@OF_THE_DEMO
def test_demo_eigenvalues():
    pitch, bounce = eigenvalues(jn.linearise(DEMO))
    printed(bounce.real, "-3.74994"), printed(bounce.imag, "8.21646")
    printed(pitch.real, "-2.33577"), printed(pitch.imag, "6.70839")
    low, high = jn.modes(DEMO)
    printed(low.frequency_hz, "1.13054"), printed(low.damping_ratio, "0.3288")
    printed(high.frequency_hz, "1.43745"), printed(high.damping_ratio, "0.4152")
    assert abs(low.shape["body.pitch"][0]) == 1.0
    assert abs(high.shape["body.z"][0]) == 1.0


# --- the Audi --------------------------------------------------------------------------------------------------------


def test_rest():
    rest = jn.equilibrium(AUDI)
    printed(1e3 * rest["body.z"], "-163.91198")
    printed(1e3 * rest["body.pitch"], "-3.38437")
    (
        printed(2.0 * rest["front.strut.force"], "8934.584"),
        printed(2.0 * rest["rear.strut.force"], "7114.576"),
    )
    printed(rest["front.strut.force"], "4467.29"), printed(rest["rear.strut.force"], "3557.29")
    (
        printed(1e3 * rest["front.strut.deflection"], "159.546"),
        printed(1e3 * rest["rear.strut.deflection"], "169.395"),
    )


@pytest.mark.parametrize("compat", ["physical", "sign-corrected", "simulink"])
def test_stiffness_and_damping_matrices(compat):
    k, c = matrices(jn.linearise(AUDI.with_changes({"compat": compat})))
    np.testing.assert_allclose(k, [[98000.0, -4200.0], [-4200.0, 203414.4]], rtol=0, atol=1e-7)
    np.testing.assert_allclose(c, [[11000.0, 360.0], [360.0, 23106.6]], rtol=0, atol=1e-8)


def test_modes():
    bounce, pitch = eigenvalues(jn.linearise(AUDI))
    printed(bounce.real, "-3.3903"), printed(bounce.imag, "6.978")
    printed(pitch.real, "-4.5929"), printed(pitch.imag, "7.734")
    low, high = jn.modes(AUDI)
    printed(low.frequency_hz, "1.2347"), printed(low.damping_ratio, "0.4370")
    printed(high.frequency_hz, "1.4316"), printed(high.damping_ratio, "0.5106")
    undamped = AUDI.with_changes(
        {"front.damping_coefficient": 0.0, "rear.damping_coefficient": 0.0}
    )
    low, high = jn.modes(undamped)
    printed(low.frequency_hz, "1.22975"), printed(high.frequency_hz, "1.43738")


def test_uncoupled_frequencies_and_axles():
    k, c = matrices(jn.linearise(AUDI))
    frequencies = np.sqrt(np.diag(k) / np.diag(MASSES))
    (
        printed(frequencies[0] / (2 * np.pi), "1.23180"),
        printed(frequencies[1] / (2 * np.pi), "1.43562"),
    )
    ratios = np.diag(c) / (2.0 * frequencies * np.diag(MASSES))
    printed(ratios[0], "0.4344"), printed(ratios[1], "0.5123")
    rest, body = jn.equilibrium(AUDI), AUDI.body
    printed(body.pitch_inertia / body.mass / (AUDI.front.distance * AUDI.rear.distance), "0.7312")
    for name, text in (("front", "1.2480"), ("rear", "1.2112")):
        axle = getattr(AUDI, name)
        mass = 2.0 * rest[f"{name}.strut.force"] / AUDI.gravity
        printed(np.sqrt(2.0 * axle.spring_rate / mass) / (2 * np.pi), text)


def test_static_response_to_a_moment():
    model = jn.linearise(AUDI)
    x = -np.linalg.solve(model.A, 100.0 * model.B[:, model.inputs.index("pitch_moment")])
    printed(1e3 * x[1], "0.492043"), printed(1e3 * x[0], "0.021088")


@pytest.mark.no_source
def test_reciprocity():
    """Lift at the front wheel under a unit force at the rear = lift at the rear under that force at the front."""
    k, _ = matrices(jn.linearise(AUDI))
    front, rear = np.array([1.0, -1.29]), np.array([1.0, 1.62])
    flexibility = np.linalg.inv(k)
    assert abs(front @ flexibility @ rear - rear @ flexibility @ front) < 1e-18
    moment, force = flexibility @ [0.0, 1.0], flexibility @ [1.0, 0.0]
    assert abs(moment[0] - force[1]) < 1e-20


def test_equation_9_as_printed_is_unstable():
    """M_rear = -L_r F_rear: one eigenvalue is real and positive, the rest position a fiction (0.997 rad)."""
    forces = np.array(
        [[1.0, -1.29], [1.0, 1.62]]
    )  # rows: deflection of front and rear from -(z, pitch)
    as_printed = np.array([[1.0, 1.0], [-1.29, -1.62]])
    demo = np.array([[1.0, 1.0], [-1.29, 1.62]])
    for moments, growing in ((as_printed, True), (demo, False)):
        k = moments @ np.diag([56000.0, 42000.0]) @ forces
        c = moments @ np.diag([6000.0, 5000.0]) @ forces
        a = np.block(
            [
                [np.zeros((2, 2)), np.eye(2)],
                [-np.linalg.solve(MASSES, k), -np.linalg.solve(MASSES, c)],
            ]
        )
        fastest = max(np.linalg.eigvals(a), key=lambda value: value.real)
        assert (fastest.real > 0.0) == growing
        if growing:
            printed(fastest.real, "3.570")
            assert abs(fastest.imag) < 1e-12
            printed(np.linalg.solve(k, [-1636.0 * 9.81, 0.0])[1], "0.997")
        else:
            np.testing.assert_allclose(
                np.linalg.eigvals(a), np.linalg.eigvals(jn.linearise(AUDI).A), rtol=1e-10
            )


# --- the cases -------------------------------------------------------------------------------------------------------

# of the two computations that the printed extremes come from, which agree to 1e-3 (mm, mrad; times to the sample)


def near(value: float, text: str) -> None:
    """Equal to one unit of the last printed digit."""
    assert value == pytest.approx(float(text), abs=1.0000001 * 10.0 ** -len(text.partition(".")[2]))


WINDOWS = ((3.0, 6.0), (6.0, 8.0), (8.0, 10.0))


def changes(run) -> dict[str, np.ndarray]:
    """Body height in mm and pitch in mrad, from rest."""
    return {
        name: 1e3 * (run[f"body.{name}"].values - float(run[f"body.{name}"][0]))
        for name in ("z", "pitch")
    }


def extremes(time: np.ndarray, values: np.ndarray) -> list[tuple[float, float, float, float]]:
    result = []
    for start, end in WINDOWS:
        inside = (time >= start - 1e-9) & (time <= end + 1e-9)
        v, t = values[inside], time[inside]
        result.append((v.max(), t[v.argmax()], v.min(), t[v.argmin()]))
    return result


def run_case(compat: str, height: float, moment: float):
    trial = jn.Trial(
        road=jn.Rectangle(height=height, start="60 m", length="20 m"),
        speed="10 m/s",
        duration="10 s",
        pitch_moment={"value": moment, "start": "3 s"},
    )
    run = jn.simulate(AUDI.with_changes({"compat": compat}), trial, tolerance=1e-9)
    found = changes(run)
    return [extremes(run["time"].values, found[name]) for name in ("z", "pitch")]


def test_case_a_literally():
    z, pitch = run_case("simulink", 0.05, 100.0)
    near(z[0][0], "0.029"), near(z[0][2], "-0.001")
    near(pitch[0][0], "0.5670"), near(pitch[0][1], "3.406")
    assert abs(pitch[0][2]) < 1e-12
    near(z[1][2], "-60.932"), near(z[1][3], "6.451")
    near(pitch[1][0], "1.4638"), near(pitch[1][2], "0.1071")
    near(z[2][0], "10.966"), near(z[2][2], "-49.941")
    near(pitch[2][0], "0.8768"), near(pitch[2][2], "-0.4793")


def test_case_a_with_the_sign_right():
    z, pitch = run_case("sign-corrected", 0.05, 100.0)
    near(z[1][0], "60.974"), near(z[1][1], "6.451")
    near(pitch[1][0], "0.8770"), near(pitch[1][2], "-0.4797")
    near(z[2][2], "-10.924"), near(z[2][3], "8.451")
    near(pitch[2][0], "1.4634"), near(pitch[2][2], "0.1073")


def test_case_a_braking_at_3_metres_per_second_squared():
    z, pitch = run_case("sign-corrected", 0.05, 1636.0 * 3.0 * 0.55)
    near(z[0][0], "0.779"), near(z[0][2], "-0.033")
    near(pitch[0][0], "15.306"), near(pitch[0][1], "3.406")
    near(z[1][0], "61.522"), near(pitch[1][0], "13.667"), near(pitch[1][2], "12.311")
    near(z[2][2], "-10.375"), near(pitch[2][0], "14.254"), near(pitch[2][2], "12.898")


@pytest.mark.no_source
def test_deceleration_is_that_moment():
    car = AUDI.with_changes({"body.height": 0.55})
    common = {"road": jn.Flat(), "speed": "10 m/s", "duration": "2 s"}
    braked = jn.simulate(
        car, jn.Trial(**common, deceleration={"value": "3 m/s^2", "start": "0.5 s"})
    )
    moved = jn.simulate(
        car, jn.Trial(**common, pitch_moment={"value": "2699.4 N*m", "start": "0.5 s"})
    )
    for name in ("body.z", "body.pitch", "body.pitch_moment"):
        np.testing.assert_allclose(braked[name], moved[name], rtol=1e-12, atol=1e-12)


def test_case_b():
    for compat, z1, z2, pitch1, pitch2 in (
        ("simulink", "24.360", "-4.399", ("-0.338", "-0.881"), ("-0.104", "-0.646")),
        ("sign-corrected", "-24.402", "4.357", ("-0.103", "-0.646"), ("-0.338", "-0.881")),
    ):
        z, pitch = run_case(compat, -0.02, -100.0)
        near(z[0][2], "-0.029"), near(pitch[0][2], "-0.5670")
        first, second = (0, 2) if float(z1) > 0.0 else (2, 0)
        near(z[1][first], z1), near(z[2][second], z2)
        near(pitch[1][0], pitch1[0]), near(pitch[1][2], pitch1[1])
        near(pitch[2][0], pitch2[0]), near(pitch[2][2], pitch2[1])


def physical_case(height: float, moment: float):
    """On raised-cosine ramps of 0.5 m at 6 s and 8 s: up now, the same later and down (the half car is linear)."""
    ramp = jn.Ramp(height=height, length="0.5 m", shape="cosine", start="60 m")
    common = {"speed": "10 m/s", "duration": "10 s"}
    up = jn.simulate(AUDI, jn.Trial(road=ramp, **common), tolerance=1e-9)
    moved = jn.simulate(
        AUDI, jn.Trial(road=jn.Flat(), pitch_moment={"value": moment, "start": "3 s"}, **common)
    )
    result = []
    for name in ("z", "pitch"):
        once = changes(up)[name]
        total = once + changes(moved)[name]
        total[2000:] -= once[:-2000]
        result.append(extremes(up["time"].values, total))
    return result


def test_case_a_on_a_real_road():
    z, pitch = physical_case(0.05, 100.0)
    near(z[1][0], "58.090"), near(z[1][1], "6.566")
    near(pitch[1][0], "5.854"), near(pitch[1][2], "-21.933"), near(pitch[1][3], "6.292")
    near(z[2][2], "-8.041"), near(pitch[2][0], "22.918"), near(pitch[2][1], "8.292")
    near(pitch[2][2], "-4.870")


def test_case_b_on_a_real_road():
    z, pitch = physical_case(-0.02, -100.0)
    near(z[1][2], "-23.249"), near(z[1][3], "6.566")
    near(pitch[1][0], "8.478"), near(pitch[1][2], "-2.637")
    near(z[2][0], "3.204"), near(pitch[2][0], "1.653"), near(pitch[2][2], "-9.462")


def test_peak_acceleration_at_the_step():
    """2 (K_f + K_r) h / m at once; as a real car 5.953 m/s^2 on the ramp."""
    road = jn.Rectangle(height="50 mm", start="60 m", length="20 m")
    trial = jn.Trial(road=road, speed="10 m/s", duration="7 s")
    run = jn.simulate(AUDI.with_changes({"compat": "sign-corrected"}), trial, tolerance=1e-9)
    near(float(run["body.az"].max()), "2.995")
    ramp = jn.Ramp(height="50 mm", length="0.5 m", shape="cosine", start="60 m")
    run = jn.simulate(
        AUDI, jn.Trial(road=ramp, speed="10 m/s", duration="7 s"), tolerance=1e-9, output_step=1e-4
    )
    near(float(abs(run["body.az"]).max()), "5.953")
