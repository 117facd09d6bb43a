"""Choice of the spring (paper 1 section 5, domain A4 and A5)."""

import math

import pytest

from jounce.bench.springs import SpringChoice, compare_springs
from jounce.core.errors import FitError
from jounce.core.serialise import to_json

pytestmark = pytest.mark.source(
    kind="computed",
    of="bench",
    key="quarter-car-prototype",
    where="section 5: springs, angles and mass; calculated by hand",
    tolerance="half a unit of the last printed digit",
)

PAPER = [("bicycle spring", 52775.0), ("scooter spring", 22730.0)]


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


@pytest.mark.parametrize(
    ("angle", "wheel_rate", "rigid", "in_series"),
    # domain A4: k = 22730 N/m, 16 kg, tyre 138468 N/m
    [
        (10, 22044.6, 5.908, 5.487),
        (16, 21003.1, 5.766, 5.373),
        (21, 19810.8, 5.600, 5.238),
        (26, 18362.0, 5.392, 5.066),
        (30, 17047.5, 5.195, 4.902),
    ],
)
def test_rates_and_frequencies_at_the_strut_angles(angle, wheel_rate, rigid, in_series):
    row = compare_springs(PAPER, SpringChoice(strut_angle=f"{angle} deg")).rows[1]
    assert row.wheel_rate == pytest.approx(wheel_rate, abs=0.1)
    assert row.natural_frequency_rigid_tyre == pytest.approx(rigid, abs=6e-4)
    assert row.natural_frequency == pytest.approx(in_series, abs=6e-4)


def test_the_stiff_spring_is_rejected_for_the_paper_s_reason():
    found = compare_springs(PAPER)
    assert found.chosen == "scooter spring"
    assert len(found.reasons) == 1
    assert found.reasons[0].startswith("bicycle spring (52775 N/m) is too stiff")
    stiff, soft = found.rows
    assert stiff.static_deflection == pytest.approx(
        16 * 9.81 / (52775 * math.cos(math.radians(26)) ** 2)
    )
    assert 1e3 * stiff.static_deflection == pytest.approx(3.68, abs=0.01)
    assert 1e3 * soft.static_deflection == pytest.approx(8.55, abs=0.01)
    # same damper: ratio falls with the square root of the rate
    assert stiff.damping_ratio / soft.damping_ratio == pytest.approx(math.sqrt(22730 / 52775))
    assert stiff.suspension_share < soft.suspension_share
    assert "still" in messages(found)  # even the better one is far above the target frequency


def test_damping_ratio_of_a_known_case():
    # domain A6: c = 120 N s/m at the wheel, k = 18362, m = 16: 0.110696
    choice = SpringChoice(damping_coefficient=120.0 / math.cos(math.radians(26.0)) ** 2)
    assert compare_springs(PAPER, choice).rows[1].damping_ratio == pytest.approx(0.110696, abs=2e-6)


@pytest.mark.no_source
def test_a_spring_that_uses_the_travel_up_is_too_soft():
    found = compare_springs([*PAPER, ("soft spring", 6000.0)])
    assert found.chosen == "scooter spring"
    assert any(reason.startswith("soft spring (6000 N/m) is too soft") for reason in found.reasons)


@pytest.mark.no_source
def test_a_spring_below_the_target_is_further_away():
    choice = SpringChoice(target_frequency="5 Hz", available_travel="100 mm")
    found = compare_springs([*PAPER, ("other", 9000.0)], choice)
    assert found.chosen == "scooter spring"
    assert any("further from the target" in reason for reason in found.reasons)


@pytest.mark.no_source
def test_steep_struts_are_warned_of():
    assert "Adams" in messages(compare_springs(PAPER, SpringChoice(strut_angle="31 deg")))
    assert "Adams" not in messages(compare_springs(PAPER))


@pytest.mark.no_source
def test_estimated_values_are_named_until_they_are_given():
    assert "friction_force = 15" in messages(compare_springs(PAPER))
    choice = SpringChoice(
        damping_coefficient=150.0,
        available_travel="40 mm",
        target_frequency="1.84 Hz",
        friction_force="15 N",
    )
    assert "estimated" not in messages(compare_springs(PAPER, choice))


@pytest.mark.no_source
def test_result_is_plain_data():
    assert "reasons" in to_json(compare_springs(PAPER))


@pytest.mark.no_source
@pytest.mark.parametrize(
    ("springs", "text"),
    [
        ([], "no springs"),
        ([("a", 1.0), ("a", 2.0)], "named twice"),
        ([("a", -1.0)], "a: the spring rate"),
    ],
)
def test_unusable_springs_are_refused(springs, text):
    with pytest.raises(FitError, match=text):
        compare_springs(springs)


@pytest.mark.no_source
def test_a_strut_that_lies_flat_is_refused():
    with pytest.raises(FitError, match="nearly horizontal"):
        compare_springs(PAPER, SpringChoice(strut_angle="89 deg"))
