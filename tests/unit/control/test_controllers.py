"""Controllers as data: names, files, limits, what they refuse."""

from __future__ import annotations

import math
from pathlib import Path
from typing import ClassVar, Literal

import casadi as ca
import numpy as np
import pytest
from scipy.linalg import expm, solve_discrete_are

from jounce.control import (
    ADD,
    CONTROLS,
    LQR,
    PID,
    ActiveActuator,
    CornerModel,
    MagnetorheologicalDamper,
    PythonControl,
    SemiActiveDamper,
    Skyhook,
    as_controller,
    controller,
)
from jounce.control.actuators import Instant
from jounce.control.controller import TwoStateLaw
from jounce.control.design import (
    H_INFINITY_CHANNELS,
    _find_least_bound,
    corner_equations,
    corner_outputs,
)
from jounce.control.laws import (
    LQG,
    SHADD,
    Groundhook,
    HInfinity,
    Hybrid,
    TwoStateGroundhook,
    TwoStateSkyhook,
)
from jounce.control.preview import PreviewMPC, _actuator_functions, _horizon
from jounce.control.program import program, sensor_noise, values
from jounce.core.errors import DescriptionError

CORNER = CornerModel(400.0, 40.0, 25e3, 200e3, 1500.0)
TANH = {"kind": "tanh", "coefficient": 400.0, "force": 60.0, "slope": 25.0}


@pytest.mark.parametrize("name", CONTROLS)
def test_every_controller_is_found_with_defaults(name: str) -> None:
    found = controller(name)
    assert found == CONTROLS[name].law.from_table(dict(CONTROLS[name].fields))
    assert CONTROLS[name].summary
    low, high = found.complete_for(CORNER).actuator.limits
    assert low < high


@pytest.mark.parametrize("name", [name for name in CONTROLS if "mpc" not in name])
def test_every_formula_has_all_its_numbers(name: str) -> None:
    if "h-infinity" in name:
        pytest.importorskip("slycot")
    law = controller(name).complete_for(CORNER)
    made = program(law, ("front", "rear"))
    numbers = values({"front": law, "rear": law}, {"front": CORNER, "rear": CORNER}, made.numbers)
    assert len(numbers) == made.function.size1_in(2)
    assert made.function.size1_out(0) == 2 + made.memory
    places = {channel.partition(".")[0] for channel in made.channels}
    assert places == (set() if name == "passive" else {"front", "rear"})


def test_open_limits_come_from_the_corner() -> None:
    assert SemiActiveDamper().complete_for(CORNER).limits == pytest.approx((300.0, 4000.0))
    assert ActiveActuator().complete_for(CORNER).limits == pytest.approx((-1962.0, 1962.0))
    undamped = CornerModel(400.0, 40.0, 25e3, 200e3, 0.0)
    typical = 2.0 * 0.3 * math.sqrt(25e3 * 400.0)  # a damping ratio of 0.3
    assert SemiActiveDamper().complete_for(undamped).limits == pytest.approx(
        (typical / 5.0, typical / 1500.0 * 4000.0)
    )


@pytest.mark.parametrize("parting", [-0.4, 0.3])
@pytest.mark.parametrize("wheel", [-0.7, 0.6])
@pytest.mark.parametrize("body", [-0.2, 0.1])
def test_laws_are_what_their_words_say(body: float, wheel: float, parting: float) -> None:
    numbers = {"damping_coefficient": 4000.0, "skyhook_share": 0.3}
    seen = {
        "sprung.vz": body,
        "unsprung.vz": wheel,
        "strut.velocity": -parting,
        "sprung.az": 2.0 * body,
    }
    now = Instant(lambda name: ca.SX(seen[name]), lambda name: ca.SX(numbers[name]), ca.SX(0.0))
    sky, ground = (force if force * parting > 0.0 else 0.0 for force in (body, -wheel))
    forces = [float(law().force(now)) for law in (Skyhook, Groundhook, Hybrid)]
    assert forces == pytest.approx(
        [-4000.0 * body, 4000.0 * wheel, -4000.0 * (0.3 * sky + 0.7 * ground)]
    )
    ideal = Hybrid(actuator=ActiveActuator(force_limit=1e5))
    assert float(ideal.force(now)) == pytest.approx(-4000.0 * (0.3 * body - 0.7 * wheel))
    firm = [float(law().product(now)) for law in (TwoStateSkyhook, TwoStateGroundhook, ADD)]
    assert firm == pytest.approx([body * parting, -wheel * parting, 2.0 * body * parting])
    assert SHADD(crossover=2.0).numbers(CORNER) == {"crossover": pytest.approx(4.0 * math.pi)}
    for crossover, dominant in ((1.5, 2.0 * body), (2.5, body)):
        numbers["crossover"] = crossover
        assert float(SHADD().product(now)) == pytest.approx(dominant * parting)


def test_pid_of_an_even_acceleration_and_at_its_limit() -> None:
    """Of a ramp the filtered derivative becomes its slope; what is missed at a limit comes off the integral."""
    law = PID(
        proportional=3000.0,
        integral=2000.0,
        derivative=50.0,
        rate=200.0,
        filter_time=0.02,
        tracking_time=0.1,
    )
    corner = CornerModel(400.0, 40.0, 25e3, 200e3, 1500.0, motion_ratio=0.8)
    period, slope, memory = 1.0 / 200.0, 1.5, (0.0, 0.0, 0.0)

    def decided(
        velocity: float, memory: tuple[float, ...], limit: float
    ) -> tuple[float, tuple[float, ...]]:
        numbers = {**law.numbers(corner), "minimum": -limit, "maximum": limit}
        kept = [ca.SX(value) for value in memory]
        look = (lambda _: ca.SX(velocity)), (lambda name: ca.SX(numbers[name]))
        found = law.decide(Instant(*look, ca.SX(0.0), kept))
        return float(found.command), tuple(float(value) for value in found.memory)

    for step in range(1, 101):
        before = memory
        command, memory = decided(-slope * step * period, before, 1e6)
        if step == 1:
            assert memory[1] == pytest.approx(slope * period / (0.02 + period), rel=1e-9)
    assert before[0] == pytest.approx(2000.0 * slope * period**2 * 99 * 100 / 2, rel=1e-9)
    assert command * 0.8 == pytest.approx(3000.0 * slope * 0.5 + before[0] + 50.0 * slope, rel=1e-9)
    held, after = decided(-slope * 0.5, before, 1000.0)
    assert held == 1000.0
    assert after[0] - memory[0] == pytest.approx(period / 0.1 * 0.8 * (1000.0 - command), rel=1e-9)


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="control",
    where="scipy.linalg: solve_discrete_are, expm",
    tolerance="rounding, through ill-conditioned plans",
    compares="first force of a plan without limits is that of the regulator",
)
@pytest.mark.parametrize(
    ("lag", "price"), [(0.0, 0.0), (0.0, 2e-7), (0.006, 1e-3 / 400.0**2), (0.006, 2e-7)]
)
def test_a_plan_without_limits_begins_with_the_regulator(lag: float, price: float) -> None:
    """Whatever the horizon, for its end costs what the regulator would; behind a lag a force has a price of its own."""
    weights, period, steps = (900.0, 30000.0), 1.0 / 200.0, 6
    a, b, _ = corner_equations(CORNER)
    c, d = corner_outputs(CORNER, ("sprung.az",))
    if lag:
        a, b = (
            np.block([[a, b], [np.zeros((1, 4)), -1.0 / lag]]),
            np.vstack([np.zeros((4, 1)), 1.0 / lag]),
        )
        c, d = np.hstack([c, d]), 0.0 * d
    n = len(a)
    whole = expm(period * np.block([[a, b], [np.zeros((1, n + 1))]]))
    F, H = whole[:n, :n], whole[:n, n:]
    Q = c.T @ c + np.diag([weights[0], 0.0, weights[1], *np.zeros(n - 3)])
    R, S = d.T @ d + price, c.T @ d
    P = solve_discrete_are(F, H, Q, R, s=S)
    gain = np.linalg.solve(R + H.T @ P @ H, H.T @ P @ F + S.T)
    law = PreviewMPC(
        actuator=ActiveActuator(lag=lag),
        deflection_weight=weights[0],
        tyre_weight=weights[1],
        force_weight=price if price == 2e-7 else 0.0,
    )
    plan = _horizon(law, CORNER, steps)
    found = np.linalg.solve(plan.H[:steps, :steps], plan.gx[:steps])
    np.testing.assert_allclose(found[:1], gain, rtol=1e-6, atol=1e-6 * abs(gain).max())


def test_an_h_infinity_law_that_asks_for_nothing_is_the_damper_itself() -> None:
    pytest.importorskip("slycot")
    law = HInfinity(actuator=SemiActiveDamper(minimum=0.0, maximum=1e5))
    corner = CornerModel(400.0, 40.0, 25e3, 200e3, 1500.0, motion_ratio=0.8)
    numbers = {**law.numbers(corner), "minimum": 0.0, "maximum": 1e5}
    seen = dict.fromkeys(H_INFINITY_CHANNELS, 0.0) | {"strut.velocity": 0.3}
    look = (lambda name: ca.SX(seen[name])), (lambda name: ca.SX(numbers[name]))
    now = Instant(*look, ca.SX(0.0), [ca.SX(0.0)] * law.memory_size)
    assert float(law.decide(now).command) == pytest.approx(1500.0 / 0.8**2, rel=1e-9)


@pytest.mark.parametrize(
    ("lag", "late", "mean_late"),
    [(0.01, math.exp(-0.5), 2.0 - 2.0 * math.exp(-0.5)), (0.0, 0.0, 0.0)],
)
def test_an_observer_knows_the_lag_of_its_actuator(
    lag: float, late: float, mean_late: float
) -> None:
    numbers = LQG(rate=200.0, actuator=ActiveActuator(lag=lag)).numbers(CORNER)
    assert (numbers["late"], numbers["mean_late"]) == pytest.approx((late, mean_late), rel=1e-12)


def test_a_plan_knows_what_a_magnetorheological_damper_can_give() -> None:
    damper = MagnetorheologicalDamper(
        off=TANH, on={**TANH, "coefficient": 900.0, "force": 800.0}, maximum=5.0
    )
    velocity = np.array([0.1, 0.3])
    low, high = _actuator_functions(damper, CORNER, 2)[0](velocity, np.zeros(2))
    np.testing.assert_allclose(low, 400.0 * velocity + 60.0 * np.tanh(25.0 * velocity), rtol=1e-12)
    np.testing.assert_allclose(
        high, 900.0 * velocity + 800.0 * np.tanh(25.0 * velocity), rtol=1e-12
    )


def test_controller_from_a_file(tmp_path: Path) -> None:
    file = tmp_path / "skyhook.toml"
    file.write_text(
        'schema = "jounce.control/1"\nlaw = "skyhook"\ndamping_coefficient = "3 N*s/mm"\nrate = "500 Hz"\n'
        'noise = { "sprung.vz" = "1 cm/s" }\n[actuator]\nminimum = "300 N*s/m"\nmaximum = "4 N*s/mm"\nlag = "8 ms"\n',
        encoding="utf-8",
    )
    found = controller(file)
    assert found == Skyhook(
        damping_coefficient=3000.0,
        rate=500.0,
        noise={"sprung.vz": 0.01},
        actuator=SemiActiveDamper(minimum=300.0, maximum=4000.0, lag=0.008),
    )
    assert controller(str(file), rate=200.0).rate == 200.0


def test_a_file_may_name_a_variant(tmp_path: Path) -> None:
    file = tmp_path / "clipped.toml"
    file.write_text('schema = "jounce.control/1"\nlaw = "clipped-lqr"\n', encoding="utf-8")
    assert controller(file) == LQR(actuator=SemiActiveDamper())


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('schema = "jounce.rig/1"\n', "schema"),
        ('schema = "jounce.control/1"\nlaw = "skyhok"\n', "Did you mean 'skyhook'"),
        ('schema = "jounce.control/1"\nlaw = "skyhook"\ngain = 3\n', "gain"),
        ('schema = "jounce.control/1"\nlaw = "skyhook"\nrate = "1 kN"\n', "rate"),
        ('schema = "jounce.control/1"\nlaw = "skyhook"\n[actuator]\nkind = "magic"\n', "magic"),
    ],
)
def test_bad_files_are_refused(tmp_path: Path, text: str, message: str) -> None:
    file = tmp_path / "bad.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(DescriptionError, match=message):
        controller(file)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: controller("skyhok"), r"unknown controller 'skyhok'.*Did you mean 'skyhook'"),
        (
            lambda: SemiActiveDamper(minimum=4000.0, maximum=300.0),
            "maximum = 300 N.s/m is not above",
        ),
        (lambda: SemiActiveDamper(lag=-0.01), "lag: out of range; found -0.01"),
        (lambda: SemiActiveDamper(rate_limit=0.0), "rate_limit"),
        (lambda: ActiveActuator(lag=0.01, bandwidth=20.0), "both lag and bandwidth"),
        (lambda: ActiveActuator(force_limit=-1.0), "force_limit"),
        (lambda: ADD(actuator=ActiveActuator()), "is for a switched damper"),
        (lambda: Skyhook(rate=0.0), "rate"),
        (lambda: Skyhook(noise={"sprung.colour": 1.0}), "sprung.colour"),
        (lambda: Skyhook(noise={"sprung.az": "1 mm"}), "sprung.az"),
        (lambda: Skyhook(noise={"sprung.az": -1.0}), "below 0"),
        (
            lambda: MagnetorheologicalDamper(off=TANH, on={**TANH, "kind": "magic"}, maximum=5.0),
            "magic",
        ),
        (lambda: PythonControl(function=3), "function"),
        (lambda: as_controller(3), "not a controller"),
    ],
)
def test_what_makes_no_sense_is_refused(make: object, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        make()


def test_two_laws_of_one_damper_must_be_of_one_kind() -> None:
    bouc_wen = {
        "kind": "bouc-wen",
        "coefficient": 1.0,
        "hysteretic_force": 1.0,
        "rate": 1.0,
        "sigma": 1.0,
        "exponent": 1.0,
    }
    with pytest.raises(DescriptionError, match="give two laws of the same kind"):
        MagnetorheologicalDamper(off=TANH, on=bouc_wen, maximum=5.0)


def test_a_function_is_a_controller() -> None:
    def own(measurement: dict[str, float], t: float) -> float:
        return 1000.0 + t * measurement["sprung.vz"]

    assert as_controller(own).function is own
    assert as_controller("skyhook") == controller("skyhook")


def test_noise_by_channel_and_corner() -> None:
    noise = sensor_noise(
        {"sprung.az": 0.1, "rear.sprung.az": 0.5},
        1,
        ("front.sprung.az", "rear.sprung.az", "x.y"),
        20000,
    )
    assert noise.std(axis=0) == pytest.approx([0.1, 0.5, 0.0], rel=0.02)
    assert sensor_noise({}, 1, ("sprung.az",), 10).shape == (0, 1)


def test_a_controller_is_one_class(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(CONTROLS, "_rows", {**CONTROLS})

    class PowerDriven(TwoStateLaw):
        """Firm where the spring gives energy to the body."""

        law: Literal["power-driven"] = "power-driven"
        catalogue: ClassVar = {
            "power-driven": ("firm where the spring gives energy to the body", SemiActiveDamper())
        }

        def product(self, now: Instant) -> object:
            return -now.seen("strut.deflection") * now.extension_rate

    law = controller("power-driven", rate="500 Hz").complete_for(CORNER)
    assert isinstance(law, PowerDriven)
    made = program(law, ("",))
    assert made.channels == ("strut.deflection", "strut.velocity")
    numbers = values({"": law}, {"": CORNER}, made.numbers)
    command = made.function([0.0], [-0.01, -0.2, 0.0], numbers, [])
    assert float(command[0]) == pytest.approx(4000.0), (
        "the spring is extended, and the strut extends"
    )


@pytest.mark.parametrize("least", [0.037, 0.8, 5.0, 700.0])
def test_the_least_bound_is_found_to_one_percent(least: float) -> None:
    found = _find_least_bound(lambda bound: () if bound >= least else None)
    assert least <= found <= 1.01 * least


def test_no_bound_is_infinite() -> None:
    assert _find_least_bound(lambda _: None) == float("inf")


def test_the_former_name_of_two_state_laws_warns():
    with pytest.warns(DeprecationWarning, match="TwoStateLaw"):
        from jounce.control.controller import DamperLaw
    assert DamperLaw is TwoStateLaw
    with pytest.raises(ImportError):
        from jounce.control.controller import DamperLaws  # noqa: F401
