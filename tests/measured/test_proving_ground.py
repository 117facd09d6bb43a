"""The study on real measurements: damper records, a vehicle's hardpoints, a proving-ground course."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

import jounce as jn
from jounce.cli import main
from jounce.core.errors import OutputError
from jounce.papers.proving_ground import (
    BEGIN,
    COURSE,
    END,
    OWN,
    ForceScaling,
    FrontView,
    ProvingGround,
    contact_length,
    drive,
    envelope,
    equivalent_coefficient,
    hmmwv_corner,
    lumped_corner,
    referred_to_wheel,
    ride_figures,
    run_proving_ground,
)
from jounce.report import write_page
from jounce.report.papers import proving_ground_page

pytestmark = pytest.mark.source(
    kind="measured",
    of="signals and identification",
    key="vargas-mr-damper",
    where="DOI 10.5281/zenodo.4445334, 0 V and 0.88 V",
    tolerance="two-sided limits of misfit and force",
)


@pytest.fixture(scope="module")
def study() -> ProvingGround:
    return run_proving_ground((10.0 / 3.6, 20.0 / 3.6, 30.0 / 3.6))


@pytest.fixture(scope="module")
def corner() -> jn.ChronoCorner:
    return hmmwv_corner()


def between(low: float, high: float) -> object:
    return pytest.approx(0.5 * (low + high), abs=0.5 * (high - low))


def figure(study: ProvingGround, name: str, damper: str) -> np.ndarray:
    return study.figures[name].sel(damper=damper).to_numpy()


# --- the damper records ---


@pytest.mark.parametrize(("name", "low", "high"), [("0 V", 0.015, 0.035), ("0.88 V", 0.015, 0.035)])
def test_hysteretic_law_fits_the_records_and_a_line_does_not(
    study: ProvingGround, name: str, low: float, high: float
):
    laws = next(one for one in study.dampers if one.name == name).laws
    assert laws["tanh-hysteretic"].nrmse == between(low, high)
    assert laws["linear"].nrmse == between(0.10, 0.18)
    fit = laws["tanh-hysteretic"]
    assert fit.fitted_energy_per_cycle == pytest.approx(fit.energy_per_cycle, rel=0.01)


def test_voltage_raises_the_yield_force_of_the_damper(study: ProvingGround):
    force = [one.laws["tanh-hysteretic"].parameters["force"].value for one in study.dampers]
    assert force[0] == between(
        55.0, 75.0
    )  # N; the records themselves: about 60 N and 220 N where the velocity turns
    assert force[1] == between(200.0, 245.0)


# --- similitude ---


@pytest.mark.no_source
@pytest.mark.parametrize(
    "table",
    [
        {"coefficient": 750.0},
        {"kind": "tanh", "coefficient": 750.0, "stiffness": 960.0, "force": 65.0, "slope": 250.0,
         "displacement_coupling": 0.26, "offset": -3.0},
        {"kind": "bouc-wen", "coefficient": 810.0, "stiffness": 770.0, "hysteretic_force": 62.0, "rate": 20000.0,
         "sigma": 3.9, "exponent": 1.2, "offset": -3.0},
    ],
)  # fmt: skip
def test_work_at_the_wheel_is_the_scaled_work_of_the_small_damper(table: dict):
    # Virtual work: the large damper at the wheel takes up force scale * stroke scale times what the small one does in
    # the motion that belongs to it.
    scales = ForceScaling(stroke_scale=4.0, force_scale=9.0, motion_ratio=0.45)
    wheel = jn.harmonic_energy(referred_to_wheel(table, scales), 0.03, 1.1)
    small = jn.harmonic_energy(table, 0.03 * 0.45 / 4.0, 1.1)
    assert wheel == pytest.approx(9.0 * 4.0 * small, rel=1e-9)


@pytest.mark.no_source
def test_dry_friction_has_the_textbook_equivalent_coefficient():
    # 4 F X per cycle, so c = 4 F / (pi omega X)
    table = {"kind": "tanh", "coefficient": 0.0, "stiffness": 0.0, "force": 100.0, "slope": 1e5,
             "displacement_coupling": 0.0, "offset": 0.0}  # fmt: skip
    expected = 4.0 * 100.0 / (np.pi * 2.0 * np.pi * 1.0 * 0.02)
    assert equivalent_coefficient(table, 0.02, 1.0) == pytest.approx(expected, rel=1e-3)


@pytest.mark.no_source
def test_scale_gives_the_stated_damping_ratio(study: ProvingGround):
    assert study.equivalent["0 V"] == pytest.approx(0.25, rel=1e-9)
    assert 0.7 < study.equivalent["0.88 V"] < 0.9
    at_inch = study.damping["damping_ratio"].interp(amplitude=0.0254)
    assert float(at_inch.sel(damper="0 V")) == pytest.approx(0.25, rel=0.01)
    falls = study.damping["damping_ratio"].sel(damper="0.88 V").to_numpy()
    assert np.all(np.diff(falls) < 0.0)


# --- the vehicle ---


def wheel_in_space(corner: jn.ChronoCorner, angle: float) -> np.ndarray:
    """The double wishbone in space with its tie rod, independent of the front view: lower arm turned by an angle."""
    p = corner.points
    joint = FrontView(corner).on_lower_arm("lower_ball_joint", angle)

    def gaps(turn: np.ndarray) -> list[float]:
        rotation = Rotation.from_rotvec(turn)
        found = []
        for moving, fixed in (
            ("upper_ball_joint", "upper_arm_front"),
            ("upper_ball_joint", "upper_arm_rear"),
            ("tie_rod_outer", "tie_rod_inner"),
        ):
            place = joint + rotation.apply(p[moving] - p["lower_ball_joint"])
            found.append(
                float(np.linalg.norm(place - p[fixed]) - np.linalg.norm(p[moving] - p[fixed]))
            )
        return found

    rotation = Rotation.from_rotvec(fsolve(gaps, np.zeros(3), xtol=1e-12))
    return joint + rotation.apply(p["wheel_centre"] - p["lower_ball_joint"])


@pytest.mark.no_source
def test_front_view_agrees_with_the_linkage_in_space(corner: jn.ChronoCorner):
    view, step = FrontView(corner), 2e-3
    rise = wheel_in_space(corner, step)[2] - wheel_in_space(corner, -step)[2]
    for element, ratio in (("spring", 0.45033), ("damper", 0.45247)):
        in_space = (view.length(element, -step) - view.length(element, step)) / rise
        assert view.motion_ratio(element) == pytest.approx(in_space, rel=0.005)
        assert view.motion_ratio(element) == pytest.approx(
            ratio, abs=1e-5
        )  # our own number, pinned
    for angle in (-0.15, 0.15):
        height = wheel_in_space(corner, angle)[2] - wheel_in_space(corner, 0.0)[2]
        assert view.wheel_height(angle) - view.wheel_height(0.0) == pytest.approx(height, rel=0.005)


@pytest.mark.no_source
def test_spring_carries_the_corner_and_its_work_is_that_of_the_wheel_rate(corner: jn.ChronoCorner):
    lumped, view = lumped_corner(corner), FrontView(corner)
    rig, angle = lumped.rig, 1e-3
    rest = jn.equilibrium(rig)
    assert rest["strut.deflection"] == pytest.approx(0.0, abs=1e-9)
    assert rest["tyre.force"] == pytest.approx(
        (rig.sprung.mass + rig.unsprung.mass) * 9.81, rel=1e-9
    )

    def wheel_force(a: float) -> float:  # spring force through the motion ratio, N
        return (
            corner.spring_rate
            * (corner.spring_free_length - view.length("spring", a))
            * view.motion_ratio("spring", a)
        )

    rise = view.wheel_height(angle) - view.wheel_height(-angle)
    assert rig.strut.spring.rate == pytest.approx(
        (wheel_force(angle) - wheel_force(-angle)) / rise, rel=1e-5
    )
    assert 0.9 < jn.modes(rig)[0].frequency_hz < 1.2
    assert 8.0 < jn.modes(rig)[1].frequency_hz < 11.0


@pytest.mark.no_source
def test_shipped_rig_is_the_derived_one(corner: jn.ChronoCorner):
    shipped, derived = (
        jn.load("hmmwv-front-corner").parameters(),
        lumped_corner(corner).rig.parameters(),
    )
    assert shipped.keys() == derived.keys()
    for path, value in derived.items():
        assert shipped[path] == pytest.approx(value, rel=1e-4), path


# --- the course and the ride ---


@pytest.mark.source(
    kind="measured",
    of="ride and roughness",
    key="project-chrono",
    where="detrended one-inch r.m.s. course (OpenCRG)",
    tolerance="1 % of its r.m.s. height",
)
def test_envelope_keeps_the_course_and_takes_the_edges():
    measured = jn.load_road(COURSE)
    course = envelope(measured, 0.18)
    x = np.arange(BEGIN, END, 0.01)
    assert np.std(measured.height_at(x)) == pytest.approx(
        0.0243, rel=0.01
    )  # the course's own r.m.s., SOURCE.md
    assert np.std(course.height_at(x)) == pytest.approx(np.std(measured.height_at(x)), rel=0.03)
    assert np.abs(course.slope_at(x)).max() < 0.7 * np.abs(measured.slope_at(x)).max()
    direct = np.mean(measured.height_at(300.0 + np.linspace(-0.09, 0.09, 20001)))
    assert float(course.height_at(300.0)) == pytest.approx(direct, abs=1e-6)


@pytest.mark.no_source
def test_power_from_the_road_is_what_damper_and_tyre_take_up(study: ProvingGround):
    assert np.abs(study.figures["power_gap"].to_numpy()).max() < 0.01
    without = study.corner.rig.with_changes(
        {"tyre.damping_coefficient": 0.0}
    )  # nothing is lost at lift-off then
    course = envelope(jn.load_road(COURSE), contact_length(without))
    speed = 30.0 / 3.6
    balance = ride_figures(drive(without, course, speed), without, study.corner)
    assert balance["lift_off"] > 0.01
    assert balance["road_power"] == pytest.approx(balance["damper_power"], rel=0.003)
    assert abs(balance["power_gap"]) < 5e-4
    assert balance["tyre_power"] == 0.0


@pytest.mark.no_source
def test_linear_response_is_that_of_the_frequency_response(study: ProvingGround):
    """R.m.s. acceleration from transfer function times spectrum of the course, against the simulation in time."""
    rig = study.corner.rig.with_changes(
        {"strut.damper": {"coefficient": 3500.0}, "tyre.lift_off": False}
    )
    speed, step, count = 20.0 / 3.6, 0.001, 2**17
    length = contact_length(rig)
    course = envelope(jn.load_road(COURSE), length)
    run = drive(rig, course, speed)
    time = run["time"].to_numpy()
    driven = np.zeros(count)
    way = (
        run["road.z"].to_numpy() - run["road.z"].to_numpy()[0]
    )  # the run begins in equilibrium at that height
    driven[: len(time)] = way * np.minimum(1.0, (time[-1] - time) / 1.0)  # back to it in 1 s
    frequency = np.fft.rfftfreq(count, step)
    gain = np.concatenate(
        [[0.0], jn.linearise(rig).frequency_response(frequency[1:20000], "sprung.az")]
    )
    spectrum = np.fft.rfft(driven)
    spectrum[: len(gain)] *= gain
    spectrum[len(gain) :] = 0.0
    part = time < time[-1] - 1.5
    expected = np.fft.irfft(spectrum, count)[: len(time)][part]
    simulated = run["sprung.az"].to_numpy()[part]
    assert np.sqrt(np.mean((simulated - expected) ** 2)) < 0.01 * np.std(simulated)


@pytest.mark.no_source
def test_figures_follow_the_physics(study: ProvingGround):
    for damper in ("0 V", "0.88 V", OWN):
        for name in (
            "damper_power",
            "road_power",
            "tyre_power",
            "wheel_load_variation",
            "lift_off",
        ):
            assert np.all(np.diff(figure(study, name, damper)) > 0.0), (name, damper)
    for name in (
        "bump_travel_utilisation",
        "rebound_travel_utilisation",
        "wheel_load_variation",
        "lift_off",
    ):
        assert np.all(figure(study, name, "0.88 V") < figure(study, name, "0 V")), name
    assert np.all(figure(study, "damper_power", "0.88 V") > figure(study, "damper_power", "0 V"))


@pytest.mark.no_source
def test_own_damper_keeps_the_vehicle_within_its_travel(study: ProvingGround):
    # what such a vehicle is made for: independent evidence that masses, rate and damping are of the right size
    for name in ("bump_travel_utilisation", "rebound_travel_utilisation"):
        use = figure(study, name, OWN)
        assert np.all((use > 0.3) & (use < 1.0))
    assert np.all(figure(study, "body_acceleration", OWN) > 0.8)
    assert np.all(figure(study, "body_acceleration", OWN) < 3.5)
    assert study.point_contact > float(figure(study, "body_acceleration", "0 V")[1])


@pytest.mark.no_source
def test_extrapolation_and_lost_travel_are_said(study: ProvingGround):
    messages = [(item.place, item.severity, item.message) for item in study.findings]
    assert any(
        place == "0 V" and kind == "warning" and "extrapolated" in text
        for place, kind, text in messages
    )
    assert any("stop" in text and place == "0 V" for place, _, text in messages)
    assert not any(place == OWN for place, _, _ in messages)


@pytest.mark.no_source
def test_results_are_plain_and_the_runs_are_recordings(study: ProvingGround):
    plain = study.to_dict()
    assert (
        plain["figures"]["body_acceleration"][OWN]
        == figure(study, "body_acceleration", OWN).tolist()
    )
    assert sum(item["is_estimated"] for item in plain["model"]) == 6
    assert all(isinstance(run, xr.Dataset) for run in study.runs.values())


# --- page and command ---


@pytest.mark.no_source
def test_page_holds_every_figure_and_says_what_is_estimated(study: ProvingGround, tmp_path: Path):
    files = {
        file.name
        for file in write_page(proving_ground_page(study), tmp_path / "out", figures=("svg", "png"))
    }
    assert {
        "report.html",
        "results.json",
        "course.svg",
        "damper-0V.png",
        "ride-figures.svg",
        "signals-own-damper.png",
    } <= files
    text = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    for words in (
        "estimated",
        "ISO 2631 is not applied",
        "force scale of the measured damper",
        "HMMWV",
    ):
        assert words in text
    plain = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert plain["similitude"]["stroke_scale"] == pytest.approx(study.similitude.stroke_scale)
    with pytest.raises(OutputError, match="not empty"):
        write_page(proving_ground_page(study), tmp_path / "out")


@pytest.mark.no_source
def test_command_answers_with_one_json_object_and_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.chdir(tmp_path)
    assert main(["study", "proving-ground", "--json"]) == 0
    plain = json.loads(capsys.readouterr().out)
    assert plain["course"] == COURSE
    assert plain["out"] is None
    assert len(plain["speed"]) == 7
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine.txt").touch()
    assert main(["study", "proving-ground", "--out", "full"]) == 2
    assert "not empty" in capsys.readouterr().err
