"""Rigs as files of MuJoCo: its engine stands and moves as ours, and the file read again has the same points."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import scipy.optimize

import jounce as jn
from jounce.exchange.chrono import write_chrono
from jounce.exchange.mjcf import write_mjcf
from jounce.parts.importers.drafts import tensor_of
from jounce.parts.importers.mjcf import _Tree, import_mjcf
from jounce.simulation.compiled import compile_rig


def engine():
    return pytest.importorskip("mujoco", reason="the engines of the benchmarks are not installed")


def opened(rig, folder: Path):
    mujoco = engine()
    made = write_mjcf(rig, folder / "rig.xml")
    model = mujoco.MjModel.from_xml_path(str(made.path))
    return made, model, mujoco.MjData(model)


def seen(model, data, name: str) -> np.ndarray:
    sensor = model.sensor(name)
    return data.sensordata[sensor.adr[0] : sensor.adr[0] + sensor.dim[0]].copy()


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        "generic-mcpherson",
        "sedan-multi-link",
        "formula-student-front",
        "hmmwv-front",
        "semi-trailing-arm",
    ],
)
def test_it_stands_as_ours(tmp_path: Path, name: str) -> None:
    rig = jn.load(name)
    _, model, data = opened(rig, tmp_path)
    for i in range(30_000):
        engine().mj_step(model, data)
        if i < 20_000:  # let it settle: a body's bounce of 1.2 Hz without overshoot
            data.qvel *= 0.9985
    ours = jn.simulate(rig, jn.Trial(road=jn.Flat(), speed=1.0, duration=0.002))
    assert seen(model, data, "tyre.force")[0] == pytest.approx(
        float(ours["tyre.force"][0]), rel=1e-6
    )
    assert seen(model, data, "sprung.z")[0] == pytest.approx(float(ours["sprung.z"][0]), abs=1e-7)
    height = rig.hardpoints.wheel_centre[2] + float(ours["unsprung.z"][0])
    assert seen(model, data, "wheel_centre")[2] == pytest.approx(height, abs=1e-7)


def driven(rig, model, data):
    """Our channels and MuJoCo's over a bump that the tyre does not lose, one after another."""
    trial = jn.Trial(road=jn.HalfSine(height="4 mm", length="300 mm"), speed="3 m/s", duration=0.2)
    ours = jn.simulate(rig, trial, tolerance=1e-9)

    def accelerations(pose: np.ndarray) -> np.ndarray:
        data.qpos, data.qvel[:] = pose, 0.0
        engine().mj_forward(model, data)
        return data.qacc.copy()

    if (
        not model.neq
    ):  # an arm and a body have no loop that a pose could open; the kart stands at design
        data.qpos = scipy.optimize.fsolve(accelerations, np.zeros(2), xtol=1e-12)

    def road(t: float) -> tuple[float, float]:
        phase = np.pi * t / 0.1
        return (
            (0.004 * np.sin(phase), 0.04 * np.pi * np.cos(phase)) if 0.0 <= t < 0.1 else (0.0, 0.0)
        )

    found, channels = [], ("sprung.z", "wheel_centre", "tyre.force")
    for i in range(2001):
        if i % 10 == 0:
            data.mocap_pos[0][2], data.ctrl[0] = road(1e-4 * i)
            engine().mj_forward(model, data)
            found.append([seen(model, data, name)[-1] for name in channels])
        data.mocap_pos[0][2], data.ctrl[0] = road(1e-4 * (i + 0.5))
        engine().mj_step(model, data)
    for channel, theirs in zip(
        ("sprung.z", "unsprung.z", "tyre.force"), np.array(found).T, strict=True
    ):
        own = ours[channel].values
        shift = rig.hardpoints.wheel_centre[2] if channel == "unsprung.z" else 0.0
        yield channel, own, theirs - shift


@pytest.mark.source(
    kind="program",
    of="models for other programs",
    key="mujoco",
    where="our file of a corner, run by its engine in steps of 0.1 ms",
    tolerance="0.5 % of a channel's range: its loops are a little soft",
    compares="a corner over a bump in MuJoCo",
)
def test_it_moves_as_ours(tmp_path: Path) -> None:
    """The loops of MuJoCo are a little soft."""
    rig = jn.load("kart-double-wishbone")
    _, model, data = opened(rig, tmp_path)
    for channel, own, theirs in driven(rig, model, data):
        assert own == pytest.approx(theirs, rel=0.0, abs=5e-3 * np.ptp(own)), channel


def test_a_damped_tyre_feels_the_rate_of_the_road(tmp_path: Path) -> None:
    """On an arm without loops; a moved body has no velocity in MuJoCo, so that the rate is given by itself."""
    rig = jn.load("semi-trailing-arm").with_changes({"strut.damper": {"coefficient": "1.5 kN*s/m"}})
    made, model, data = opened(rig, tmp_path)
    assert any("also set the road's rate" in str(finding) for finding in made.findings)
    for channel, own, theirs in driven(rig, model, data):
        np.testing.assert_allclose(theirs, own, rtol=0.0, atol=3e-3 * np.ptp(own), err_msg=channel)


def test_stops_and_friction(tmp_path: Path) -> None:
    stops = {
        "strut.bump_stop": {"gap": "20 mm", "rate": "50 N/mm"},
        "strut.rebound_stop": {"gap": "30 mm", "rate": "40 N/mm"},
    }
    rig = jn.load("kart-double-wishbone").with_changes(
        {**stops, "strut.friction": {"force": "12 N"}}
    )
    made, model, _ = opened(rig, tmp_path)
    assert not made.findings
    design = rig.hardpoints.length("spring")
    assert model.tendon_lengthspring[model.tendon("bump_stop").id] == pytest.approx(
        [design - 0.02, 1e3]
    )
    assert model.tendon_lengthspring[model.tendon("rebound_stop").id] == pytest.approx(
        [0.0, design + 0.03]
    )
    assert model.tendon_frictionloss[model.tendon("damper").id] == 12.0


def test_what_cannot_be_written(tmp_path: Path) -> None:
    flat = {
        "kind": "table",
        "deflection": [-0.1, 0.0, 0.05, 0.1, 0.2],
        "force": [0.0, 0.0, 500.0, 500.0, 600.0],
    }
    kart = jn.load("kart-double-wishbone")
    length = kart.hardpoints.length("spring") + 0.075
    soft = kart.with_changes({"strut.spring": {"curve": flat, "free_length": length}})
    with pytest.raises(jn.OutputError, match="without a rate at design; found '0 N/m'"):
        write_mjcf(soft, tmp_path / "a.xml")
    with pytest.raises(jn.OutputError, match="nonzero rack travel at design"):
        write_mjcf(kart.with_changes({"steering.rack_travel": "10 mm"}), tmp_path / "a.xml")
    bar = {"on": "lower_arm", "stiffness": "500 N*m/rad", "preload": "10 N*m"}
    tables = kart.model_dump(by_alias=True, exclude_none=True) | {"torsion_bar": bar}
    del tables["strut"]["spring"]
    barred = type(kart).model_validate(tables)
    assert not barred.lacks
    with pytest.raises(jn.OutputError, match="a torsion bar instead of the strut's spring"):
        write_mjcf(barred, tmp_path / "a.xml")
    with pytest.raises(jn.OutputError, match="a torsion bar instead of the strut's spring"):
        write_chrono(barred, tmp_path / "a.json")
    with pytest.raises(jn.OutputError, match="not a 3-D mechanism; found 'quarter-car'"):
        write_mjcf(jn.load("kart-quarter-car"), tmp_path / "a.xml")
    with pytest.raises(jn.OutputError, match="format"):
        write_mjcf(jn.load("kart-double-wishbone"), tmp_path / "a.json")
    hysteretic = {"kind": "tanh", "coefficient": 800.0, "force": 50.0, "slope": 40.0}
    with pytest.raises(jn.OutputError, match="hysteresis"):
        write_mjcf(
            jn.load("kart-double-wishbone").with_changes({"strut.damper": hysteretic}),
            tmp_path / "a.xml",
        )
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "side"), [("kart-double-wishbone", "left"), ("generic-mcpherson", "right")]
)
def test_bodies_begin_to_move_as_ours(tmp_path: Path, name: str, side: str) -> None:
    """The body's acceleration at design, where nothing is in balance: masses, levers and forces of both sides."""
    changes = {
        "strut.spring": {"rate": "30 N/mm", "preload": "1 kN"},
        "wheel.camber": "-2 deg",
        "gravity": 5.0,
    }
    rig = jn.load(name).with_changes(changes)
    rig = rig if side == "left" else rig.mirrored()
    compiled = compile_rig(rig)
    count = len(compiled.facts.coordinates)
    x = np.concatenate(
        [compiled.facts.start, np.zeros(len(compiled.facts.speeds) + len(compiled.facts.internal))]
    )
    given = x, compiled.inputs({}), compiled.parameter_values(rig.parameters())
    modes = np.zeros(len(compiled.facts.switches))
    modes = (compiled.evaluate("switch", *given, modes) > 0.0).astype(float)
    ours = compiled.evaluate("rate", *given, modes)[
        count + compiled.facts.speeds.index("sprung.distance rate")
    ]
    _, model, data = opened(rig, tmp_path)
    engine().mj_forward(model, data)
    assert abs(ours) > 1.0
    assert data.qacc[model.joint("sprung").dofadr[0]] == pytest.approx(ours, rel=1e-4)


SAVED = """<mujoco><compiler angle="radian"/><compiler eulerseq="{order}"/>
<default><site pos="0 0 0.5"/><joint axis="0 1 0"/><default class="one"><joint pos="0.1 0 0"/></default></default>
<worldbody><body name="a" childclass="one" pos="0.1 0.2 0.3" {turns[0]}>
  <inertial pos="0.3 0.2 0.1" mass="2" {turns[1]} diaginertia="3 4 5"/><joint name="hinge"/><site name="p"/>
  <body name="b" pos="-0.3 0.1 0.2" {turns[2]}>
    <inertial pos="0.1 -0.2 0" mass="1" fullinertia="5 6 7 0.1 0.2 0.3"/><joint name="slide" type="slide"/>
    <site name="wheel_centre" pos="1 2 3" {turns[3]}/>
  </body></body></worldbody>
<worldbody><body name="c" pos="4 5 6" {turns[4]}><site name="q" pos="0.1 0.2 0.3"/></body></worldbody></mujoco>"""


def turns(rng) -> list[str]:
    """Each way in which MJCF turns a frame, in any order."""
    ways = {"quat": 4, "euler": 3, "axisangle": 4, "xyaxes": 6, "zaxis": 3}
    return [f'{w}="{" ".join(f"{x:.9g}" for x in rng.normal(size=n))}"' for w, n in ways.items()]


@pytest.mark.parametrize("order", ["xyz", "ZYX", "zxz"])
def test_places_are_those_of_the_engine(tmp_path: Path, order: str) -> None:
    """Frames turned in every way, several compilers and worlds, defaults of classes: MuJoCo is the oracle."""
    mujoco = engine()
    rng = np.random.default_rng(7)
    text = SAVED.format(order=order, turns=turns(rng))
    file = tmp_path / "frames.xml"
    file.write_text(text)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    read = _Tree(file, {})
    assert len(read.sites) == model.nsite
    for name, (place, _) in read.sites.items():
        np.testing.assert_allclose(place, data.site(name).xpos, atol=1e-9)
    axis = data.site("wheel_centre").xmat.reshape(3, 3)[:, 2]
    np.testing.assert_allclose(read.axle_end - read.sites["wheel_centre"][0], axis, atol=1e-9)
    for name, body in read.bodies.items():
        np.testing.assert_allclose(body.place, data.body(name).xpos, atol=1e-9)
        for joint, _, place, along in body.joints:
            np.testing.assert_allclose(place, data.joint(joint).xanchor, atol=1e-9)
            np.testing.assert_allclose(along, data.joint(joint).xaxis, atol=1e-9)
        if body.mass is not None:
            at = model.body(name).id
            axes = data.ximat[at].reshape(3, 3)
            np.testing.assert_allclose(body.mass["centre_of_mass"], data.xipos[at], atol=1e-9)
            np.testing.assert_allclose(
                tensor_of(body.mass), axes @ np.diag(model.body_inertia[at]) @ axes.T, atol=1e-8
            )


def test_what_the_engine_saves_again_is_the_same_rig(tmp_path: Path) -> None:
    """MuJoCo writes axes as quaternions: the wheel's camber and toe are in that of its centre."""
    mujoco = engine()
    rig = jn.load("kart-double-wishbone").with_changes(
        {"wheel.camber": "-1 deg", "wheel.toe": "0.3 deg"}
    )
    model = mujoco.MjModel.from_xml_path(str(write_mjcf(rig, tmp_path / "rig.xml").path))
    mujoco.mj_saveLastXML(str(tmp_path / "saved.xml"), model)
    before, after = (
        import_mjcf(tmp_path / name)[0].parameters() for name in ("rig.xml", "saved.xml")
    )
    assert set(before) == set(after)
    for path, value in after.items():
        assert value == pytest.approx(before[path], rel=1e-4, abs=1e-6), path  # it saves six digits
