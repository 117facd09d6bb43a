"""Laws on the measured magneto-rheological damper (Labcontrol, DOI 10.5281/zenodo.4445334)."""

from importlib.resources import files

import numpy as np
import pytest

import jounce as jn
from jounce.identify.damper import damper_curve, fit_damper
from jounce.identify.damper_laws import damper_law
from jounce.identify.damper_record import read_motion
from jounce.identify.hysteresis_path import bouc_wen_path

pytestmark = pytest.mark.source(
    kind="measured",
    of="signals and identification",
    key="vargas-mr-damper",
    where="DOI 10.5281/zenodo.4445334, three records",
    tolerance="two-sided limits of the misfit; the records resolve 0.5 mm/s",
)

RECORDS = ("shaking_table_0v", "shaking_table_088v", "drive_a1")
# published Bouc-Wen fit of the 0 V record in N, mm, s: Kx .7682051, Kw 57.42103, rho 27.4527, n 1.9092, sigma 127.1242
PUBLISHED = {
    "coefficient": 768.2051,
    "hysteretic_force": 57.42103,
    "rate": 27452.7,
    "exponent": 1.9092,
    "sigma": 127.1242,
}


def load(name):
    text = (
        files("jounce").joinpath("library", "measurements", "mr_damper", f"{name}.csv").read_text()
    )
    lines = text.splitlines()
    assert lines[0] == "time [s],displacement [mm],velocity [mm/s],force [N]"
    time, displacement, velocity, force = np.array([line.split(",") for line in lines[1:]], float).T
    return 1e-3 * displacement, 1e-3 * velocity, force, time


def between(low, high):
    return pytest.approx(0.5 * (low + high), abs=0.5 * (high - low))


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


@pytest.mark.no_source
@pytest.mark.parametrize("record", RECORDS)
def test_peculiarities_of_the_records_are_found(record):
    result = fit_damper(*load(record))
    assert "samples), like a backward difference" in messages(result)
    assert "in steps of 0.5 mm/s" in messages(result)
    assert "samples at rest" in messages(result)
    assert "hysteresis" in messages(result)
    assert "dry friction" in messages(result)
    assert result.energy_per_cycle > 0.0


@pytest.mark.parametrize(
    ("record", "law", "low", "high"),
    # two-sided limits on the share of the force's range that is left; a better result must be looked at as well
    [
        ("shaking_table_0v", "linear", 0.105, 0.125),
        ("shaking_table_0v", "tanh-hysteretic", 0.024, 0.030),
        ("shaking_table_0v", "bouc-wen", 0.025, 0.031),
        ("shaking_table_088v", "linear", 0.15, 0.175),
        ("shaking_table_088v", "tanh-hysteretic", 0.023, 0.030),
        ("shaking_table_088v", "bouc-wen", 0.033, 0.041),
        ("drive_a1", "linear", 0.11, 0.13),
        ("drive_a1", "tanh-hysteretic", 0.027, 0.034),
        ("drive_a1", "bouc-wen", 0.042, 0.052),
    ],
)
def test_misfit_of_each_law(record, law, low, high):
    assert fit_damper(*load(record), law=law).nrmse == between(low, high)


@pytest.mark.no_source
def test_friction_halves_the_misfit_of_a_velocity_law():
    record = load("shaking_table_0v")
    assert fit_damper(*record, friction=True).nrmse < 0.55 * fit_damper(*record).nrmse


@pytest.mark.source(
    kind="measured",
    of="signals and identification",
    key="vargas-mr-damper",
    where="DOI 10.5281/zenodo.4445334, the Bouc-Wen fit that goes with it",
    tolerance="its misfit to its own record is 4.5 to 6 %",
    compares="misfit of the published Bouc-Wen law, as share of the force range",
)
def test_bouc_wen_is_at_least_as_good_as_the_published_fit():
    displacement, velocity, force, time = load("shaking_table_0v")
    result = fit_damper(displacement, velocity, force, time, law="bouc-wen")
    motion, _ = read_motion(displacement, velocity, force, time)
    z = bouc_wen_path(
        motion.displacement, PUBLISHED["rate"], PUBLISHED["sigma"], PUBLISHED["exponent"], -1.0
    )
    settled = slice(100, None)
    published = PUBLISHED["coefficient"] * motion.velocity + PUBLISHED["hysteretic_force"] * z
    misfit = float(np.sqrt(np.mean((published - motion.force)[settled] ** 2))) / float(
        np.ptp(motion.force)
    )
    assert misfit == between(
        0.045, 0.06
    )  # the published parameters do describe this record: units and signs are right
    assert result.nrmse < 0.65 * misfit


@pytest.mark.no_source
def test_no_shape_of_the_published_fit_is_missed_by_the_search():
    displacement, velocity, force, time = load("shaking_table_0v")
    result = fit_damper(displacement, velocity, force, time, law="bouc-wen")
    motion, _ = read_motion(displacement, velocity, force, time)
    law = damper_law("bouc-wen", motion)
    shapes = np.array([PUBLISHED["rate"], PUBLISHED["sigma"], PUBLISHED["exponent"]])
    columns = law.columns(motion.displacement, motion.velocity, shapes)[100:]
    weights = np.linalg.lstsq(columns, motion.force[100:], rcond=None)[0]
    rms = float(np.sqrt(np.mean((columns @ weights - motion.force[100:]) ** 2)))
    assert result.rms_residual <= rms


@pytest.mark.source(
    kind="measured",
    of="signals and identification",
    key="vargas-mr-damper",
    where="DOI 10.5281/zenodo.4445334, the Bouc-Wen fit that goes with it",
    tolerance="another form and criterion: 10 %, of the rate 40 %",
)
def test_force_parameters_resemble_the_published_ones():
    # another form (it has no stiffness and no offset) and another criterion: same size is what can be asked
    result = fit_damper(*load("shaking_table_0v"), law="bouc-wen")
    assert result.parameters["coefficient"].value == pytest.approx(
        PUBLISHED["coefficient"], rel=0.1
    )
    assert result.parameters["hysteretic_force"].value == pytest.approx(
        PUBLISHED["hysteretic_force"], rel=0.1
    )
    assert result.parameters["rate"].value == pytest.approx(PUBLISHED["rate"], rel=0.4)


@pytest.mark.parametrize("law", ["tanh-hysteretic", "bouc-wen"])
def test_first_half_predicts_the_second(law):
    record = load("shaking_table_0v")
    half = len(record[3]) // 2
    result = fit_damper(*(column[:half] for column in record), law=law)
    curve = damper_curve(result, *(column[half:] for column in record))
    left = float(np.sqrt(np.mean((curve.fitted - curve.measured)[100:] ** 2))) / float(
        np.ptp(curve.measured)
    )
    assert left == between(0.02, 0.035)


@pytest.mark.no_source
def test_more_voltage_means_more_hysteretic_force():
    forces = [
        fit_damper(*load(name), law="tanh-hysteretic").parameters["force"] for name in RECORDS[:2]
    ]
    assert forces[1].interval[0] > 3.0 * forces[0].interval[1]


@pytest.mark.parametrize("record", RECORDS)
def test_energy_per_cycle_is_kept_by_the_law(record):
    result = fit_damper(*load(record), law="bouc-wen")
    assert result.fitted_energy_per_cycle == pytest.approx(result.energy_per_cycle, rel=2e-3)


@pytest.mark.no_source
def test_velocity_over_displacement_shows_the_half_sample_that_it_is_late():
    displacement, velocity, force, time = load("shaking_table_0v")
    signals = {"strut.deflection": (displacement, "m", ""), "strut.velocity": (velocity, "m/s", "")}
    run = jn.recording(time, {**signals, "strut.force": (force, "N", "")})
    found = jn.estimate_transfer(
        run, "strut.velocity", "strut.deflection", segment="7.5 s", band=(0.5, 1.2)
    )
    at = int(np.argmin(abs(found.frequency - DRIVE)))
    assert found.coherence[at] > 0.999
    assert found.gain[at] == pytest.approx(2.0 * np.pi * DRIVE, rel=0.01)
    assert np.degrees(found.phase[at]) == pytest.approx(90.0 - 360.0 * DRIVE * 0.005, abs=0.5)


@pytest.mark.no_source
def test_friction_makes_odd_multiples_of_the_drive_in_the_force():
    displacement, _, force, time = load("shaking_table_0v")
    run = jn.recording(
        time, {"strut.deflection": (displacement, "m", ""), "strut.force": (force, "N", "")}
    )
    found = jn.estimate_spectra(run, "strut.force", band=(0.3, 10.0))
    multiples = np.array([peak.frequency for peak in found.channels[0].peaks]) / DRIVE
    assert multiples[0] == pytest.approx(1.0, abs=0.03)
    assert len(multiples) >= 4
    assert np.round(multiples) % 2 == pytest.approx(1.0)


DRIVE = 0.84
"""Frequency of the drive in the record, Hz; SOURCE.md tells it."""


@pytest.mark.no_source
@pytest.mark.parametrize("record", ["shaking_table_0v", "shaking_table_088v"])
def test_a_map_needs_no_law_to_find_the_forces_of_the_published_law(record):
    x, v, force, time = load(record)
    channels = {"displacement": (x, "m", ""), "velocity": (v, "m/s", ""), "force": (force, "N", "")}
    made = jn.damper_map([jn.RecordFile(f"{record}.csv", jn.recording(time, channels))])
    (run,), (item,) = made.runs, made.settings
    assert (run.motion, made.reading) == ("sine", "continuous")
    # It has next to no gas, and yields by much more: nothing shows that its signs are others than stated.
    assert "dampers.both_signs_reversed" not in {each.code for each in made.findings}
    with_gas = item.force + item.gas_force.value
    ends = [run.peak_rebound_force.value, run.peak_bump_force.value]
    assert with_gas[[0, -1]] == pytest.approx(ends, rel=0.05)
    if record == "shaking_table_0v":
        law = PUBLISHED["coefficient"] * item.velocity[[0, -1]]
        law += PUBLISHED["hysteretic_force"] * np.sign(item.velocity[[0, -1]])
        assert with_gas[[0, -1]] == pytest.approx(law, rel=0.15)
    half = np.interp([-0.5 * run.peak_velocity, 0.5 * run.peak_velocity], item.velocity, with_gas)
    assert np.all(half / with_gas[[0, -1]] > 0.7)  # the fluid yields: speed adds little
