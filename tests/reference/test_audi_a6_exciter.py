"""The rebuilt exciter of paper 2: Table 1's statics, modes and answers at 5 Hz, in printed digits.

Source: computed from the stated equations with 460 kg on 45 kg (assumed), 38 N/mm and 2 N s/mm, tyre 300 N/mm and
1 N s/mm, exciter amplitude 3 mm (assumed).
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.papers.audi_a6_exciter import LARGEST, EccentricExciter, run_eccentric_exciter

pytestmark = pytest.mark.source(
    kind="computed",
    of="quarter car",
    key="suspension-system",
    where="Table 1, with 45 kg of wheel and 3 mm of plate assumed; equations solved beside jounce",
    tolerance="half a unit of the last printed digit",
)


@pytest.fixture(scope="module")
def study() -> EccentricExciter:
    return run_eccentric_exciter()


def test_static_compressions(study):
    summed, series, full = (run.statics for run in study.runs)
    assert 1e3 * summed["compression"] == pytest.approx(13.351, abs=5.1e-4)
    assert 1e3 * series["compression"] == pytest.approx(133.79, abs=5.1e-3)
    assert 1e3 * series["spring_compression"] == pytest.approx(118.75, abs=5.1e-3)
    assert 1e3 * (series["compression"] - series["spring_compression"]) == pytest.approx(
        15.04, abs=5.1e-3
    )
    assert 1e3 * full["spring_compression"] == pytest.approx(118.75, abs=5.1e-3)
    assert full["contact_force"] == pytest.approx((460.0 + 45.0) * 9.81, rel=1e-9)
    assert summed["contact_force"] == pytest.approx(4512.6, rel=1e-9)


def test_modes(study):
    found = {
        run.variant: [(one.frequency_hz, one.damping_ratio) for one in run.modes]
        for run in study.runs
    }
    assert found["summed"][0] == (
        pytest.approx(4.314, abs=5.1e-4),
        pytest.approx(0.1203, abs=5.1e-5),
    )
    assert found["two-mass"][0] == (
        pytest.approx(1.3749, abs=5.1e-5),
        pytest.approx(0.2022, abs=5.1e-5),
    )
    assert found["two-mass"][1] == (
        pytest.approx(13.672, abs=5.1e-4),
        pytest.approx(0.3930, abs=5.1e-5),
    )
    assert len(found["series"]) == 1


@pytest.mark.no_source
def test_the_two_mass_model_is_the_quarter_car(study):
    rig = jn.load("audi-a6-quarter-car")
    own = [(mode.frequency_hz, mode.damping_ratio) for mode in jn.modes(rig)]
    found = [(one.frequency_hz, one.damping_ratio) for one in study.run("two-mass").modes]
    assert np.array(found) == pytest.approx(np.array(own), rel=1e-9)


def test_answers_at_5_hz(study):
    summed, full = study.run("summed").amplitudes, study.run("two-mass").amplitudes
    assert summed["spring"] == pytest.approx(3.0376, abs=5.1e-5)
    assert summed["body"] == pytest.approx(2.3477, abs=5.1e-5)
    assert [full[name] for name in ("body", "wheel", "spring")] == pytest.approx(
        [0.1729, 0.9905, 1.0689], abs=5.1e-5
    )
    assert 1e-3 * full["contact"] == pytest.approx(73.79, abs=5.1e-3)


@pytest.mark.no_source
def test_simulation_and_closed_form_agree(study):
    for run in study.runs:
        assert run.amplitudes.keys() == run.closed_form.keys()
        for name, value in run.amplitudes.items():
            assert value == pytest.approx(run.closed_form[name], rel=1e-6)


def test_the_spring_of_341_mm(study):
    """Summed: about 327.65 mm by 9.1 mm; the paper's 328.8 mm could be the least compression for 0.38 mm only."""
    run = study.run("summed")
    assert float(run.signals["spring.length"][0]) == pytest.approx(0.341, abs=1e-12)
    assert 1e3 * run.spring_length.mean == pytest.approx(327.65, abs=5e-3)
    assert 1e3 * (run.spring_length.max - run.spring_length.mean) == pytest.approx(9.1, abs=0.051)
    assert run.spring_force.mean == pytest.approx(4512.6, rel=1e-6)
    assert 1e3 * study.fitting_amplitude == pytest.approx(0.38, abs=5.1e-3)
    for other in ("series", "two-mass"):
        assert 1e3 * study.run(other).spring_length.mean == pytest.approx(341.0 - 118.75, abs=0.01)


@pytest.mark.no_source
def test_the_drive_gives_what_the_dampers_take(study):
    for run in study.runs:
        assert run.drive.power == pytest.approx(run.drive.dissipated, rel=1e-6)
        assert run.drive.torque.mean * 2.0 * np.pi * 5.0 == pytest.approx(
            run.drive.dissipated, rel=1e-6
        )
    # closed form: c |v|^2 / 2 of each damper, amplitudes at 5 Hz
    speed = 2.0 * np.pi * 5.0 * study.amplitude
    summed = study.run("summed")
    assert summed.drive.power == pytest.approx(
        0.5 * 3000.0 * (speed * summed.closed_form["spring"]) ** 2, rel=1e-6
    )


@pytest.mark.no_source
def test_the_mean_torque_does_not_depend_on_the_plate():
    light, heavy = (
        run_eccentric_exciter(plate_mass=mass).run("two-mass").drive for mass in (0.0, 60.0)
    )
    assert light.torque.mean == pytest.approx(heavy.torque.mean, rel=1e-6)
    assert heavy.torque.max > light.torque.max + 0.5


def test_torque_of_the_drive(study):
    assert study.torque == pytest.approx(70.03, abs=5.1e-3)
    assert study.printed_torque == pytest.approx(4201.7, abs=0.051)
    assert study.torque * 2.0 * np.pi * 5.0 == pytest.approx(2200.0, rel=1e-12)


def test_eusama_tester(study):
    with_damping, without = study.eusama
    assert (100.0 * with_damping.adhesion, with_damping.frequency_hz) == pytest.approx(
        (72.5, 16.6), abs=0.051
    )
    assert (100.0 * without.adhesion, without.frequency_hz) == pytest.approx(
        (62.7, 14.6), abs=0.051
    )


@pytest.mark.no_source
def test_a_large_amplitude_lifts_the_wheel_off():
    found = run_eccentric_exciter(amplitude=0.08)
    assert float(found.run("two-mass").signals["tyre.force"].min()) == 0.0
    assert any("leaves the plate" in finding.message for finding in found.findings)


@pytest.mark.no_source
def test_the_largest_amplitude_leaves_the_spring_hardly_any_length():
    shortest = run_eccentric_exciter(amplitude=LARGEST).run("summed").shortest
    assert 0.0 < shortest < 0.01  # m of 0.341
    with pytest.raises(
        DescriptionError, match=r"^amplitude: .*found '3 m'; allowed: above 0 m, at most 0.095 m"
    ):
        run_eccentric_exciter(amplitude=3.0)


@pytest.mark.no_source
@pytest.mark.parametrize(
    ("amplitude", "mass"), [(0.0, 20.0), (-0.003, 20.0), (np.nan, 20.0), (0.003, -1.0)]
)
def test_senseless_inputs(amplitude, mass):
    with pytest.raises(DescriptionError, match="allowed"):
        run_eccentric_exciter(amplitude, mass)
