"""Verdicts of wheels, axles and vehicles, and what the reasons say."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.findings import Finding
from jounce.inspection.grading import (
    _of_tyre,
    difference_of,
    grade,
    grade_vehicle,
    near_edges,
    worst,
)
from jounce.inspection.limits import Limits, load_limits
from jounce.inspection.methods import QUANTITIES
from jounce.inspection.quarter_car import LinearQuarterCar, steady_state
from jounce.inspection.result import Inspection, WheelCurves, WheelResult

SOUND = {
    "static_load": 4316.0,
    "adhesion": 0.6025,
    "phase_angle_min_deg": 57.27,
    "phase_frequency_hz": 7.76,
    "relative_force_amplitude": 0.3975,
    "tyre_rigidity": 187.6e3,
    "theta_rig": 0.1708,
    "theta_road": 0.1708,
}


def wheel(side: str = "left", **changes) -> WheelResult:
    return WheelResult(side, **{**SOUND, **changes})


def axle(
    left=None, right=None, name: str = "front", methods=("eusama", "egea", "theta")
) -> Inspection:
    left, right = left or wheel(), right or wheel("right")
    return Inspection((left, right), {"axle": name}, {"tester": "lane 1"}, methods)


def test_a_sound_axle_passes_and_every_reason_names_value_limit_and_source() -> None:
    graded = grade(axle())
    assert (graded.verdict, [one.verdict for one in graded.wheels]) == ("pass", ["pass", "pass"])
    assert graded.wheels[0].grade == {"eusama": "good", "egea": "sufficient", "theta": "green"}
    said = " | ".join(graded.wheels[0].reasons)
    for part in (
        "60.2 %",
        "57.3°",
        "0.171",
        "from 60 %",
        "from 35°",
        "up to 0.3",
        "EUSAMA classes",
        "SPECSUS2018",
    ):
        assert part in said
    assert graded.axle == "front"


def test_the_worst_deciding_method_counts() -> None:
    worn = wheel(theta_road=0.11)
    assert grade(axle(worn)).wheels[0].verdict == "advise"
    assert grade(axle(worn), deciding=["egea"]).wheels[0].verdict == "pass"
    assert grade(axle(replace(worn, adhesion=0.1))).wheels[0].verdict == "fail"
    graded = grade(axle(replace(worn, adhesion=0.1)), deciding=["egea"])
    assert graded.wheels[0].verdict == "pass"
    assert graded.wheels[0].grade["eusama"] == "bad"
    assert "EGEA decides; other grades are for information." in graded.wheels[0].reasons
    assert graded.wheels[0].reasons[0].startswith("least phase angle")


def test_a_deciding_method_without_a_value_forbids_the_grade_but_no_failure() -> None:
    unknown = wheel(theta_road=None)
    assert grade(axle(unknown)).wheels[0].verdict == "pass"  # nobody asked for it
    graded = grade(axle(unknown), deciding=["egea", "theta"])
    assert graded.wheels[0].verdict == "not graded"
    assert graded.verdict == "not graded"
    assert any("is not known: no grade by THETA" in reason for reason in graded.wheels[0].reasons)
    failing = grade(
        axle(wheel(theta_road=None, phase_angle_min_deg=20.0)), deciding=["egea", "theta"]
    )
    assert failing.wheels[0].verdict == "fail"


def test_an_unfit_record_is_never_graded_whatever_its_values() -> None:
    unfit = wheel(findings=(Finding("left.plate.force", "problem", "the force is clipped."),))
    graded = grade(axle(unfit))
    assert (graded.wheels[0].verdict, graded.wheels[0].grade) == ("not graded", {})
    assert graded.wheels[0].reasons == ("the force is clipped.",)
    assert graded.wheels[1].verdict == "pass"
    assert graded.verdict == "not graded"
    assert graded.differences == ()
    assert graded.wheels[0].adhesion == SOUND["adhesion"]  # the values stay


def test_a_problem_of_the_whole_record_forbids_all() -> None:
    inspection = replace(axle(), findings=(Finding("time", "problem", "the clock jitters."),))
    assert [one.verdict for one in grade(inspection).wheels] == ["not graded", "not graded"]


def test_warnings_do_not_forbid() -> None:
    weak = wheel(findings=(Finding("left.phase", "warning", "sweep too fast."),))
    assert grade(axle(weak)).wheels[0].verdict == "pass"


def test_nothing_known_is_not_graded() -> None:
    empty = WheelResult("left")
    assert grade(Inspection((empty,), methods=("theta",))).wheels[0].verdict == "not graded"
    assert grade(Inspection(())).verdict == "not graded"


def test_nan_is_no_value() -> None:
    graded = grade(axle(wheel(adhesion=math.nan), methods=("eusama",)))
    assert graded.wheels[0].verdict == "not graded"


def test_a_value_outside_all_bands_is_not_graded() -> None:
    graded = grade(axle(wheel(adhesion=1.02), methods=("eusama",)))
    assert graded.wheels[0].verdict == "not graded"
    assert "is in no band" in graded.wheels[0].reasons[0]


def test_methods_without_limits_are_said() -> None:
    limits = load_limits()
    only = Limits.model_construct(
        **{**dict(limits), "methods": {"egea": limits.methods["egea"]}, "differences": {}}
    )
    graded = grade(axle(), only)
    assert graded.wheels[0].grade == {"egea": "sufficient"}
    assert any("there are no limits for THETA" in reason for reason in graded.wheels[0].reasons)
    assert graded.wheels[0].verdict == "pass"


def test_unknown_methods_are_refused() -> None:
    with pytest.raises(DescriptionError, match="Did you mean 'egea'"):
        grade(axle(), deciding=["egae"])


@pytest.mark.parametrize(
    ("value", "half", "uncertain"),
    [
        (36.0, 1.5, True),
        (36.0, 0.9, False),
        (34.0, 1.5, True),
        (34.0, 0.9, False),
        (36.0, None, False),
    ],
)
def test_near_an_edge_the_reasons_say_uncertain(
    value: float, half: float | None, uncertain: bool
) -> None:
    uncertainty = {} if half is None else {"phase_angle_min_deg": half}
    graded = grade(
        axle(wheel(phase_angle_min_deg=value, uncertainty=uncertainty)), deciding=["egea"]
    )
    said = [reason for reason in graded.wheels[0].reasons if "uncertain" in reason]
    assert bool(said) is uncertain
    assert graded.wheels[0].verdict == ("pass" if value >= 35.0 else "fail")  # the value decides
    if uncertain:
        assert f"{value - 1.5:.1f}° to {value + 1.5:.1f}°" in said[0]
        assert "35°" in said[0]


def test_a_value_just_below_a_limit_is_not_written_as_the_limit() -> None:
    graded = grade(axle(wheel(adhesion=0.39999)), deciding=["eusama"])
    assert "39.999 %" in graded.wheels[0].reasons[0]
    assert "insufficient" in graded.wheels[0].reasons[0]


def test_over_range_is_noted() -> None:
    graded = grade(axle(wheel(theta_road=0.395)))
    (said,) = (
        reason
        for reason in graded.wheels[0].reasons
        if "the source says nothing about such values" in reason
    )
    assert "0.395 is above the optimal band, which ends at 0.3;" in said
    assert graded.wheels[0].verdict == "pass"


def test_tyre_pressure_asks_for_advice_where_the_method_needs_it() -> None:
    soft = wheel(tyre_rigidity=150e3)
    graded = grade(axle(soft), deciding=["egea"])
    assert graded.wheels[0].verdict == "advise"
    assert any("inflate the tyre" in reason for reason in graded.wheels[0].reasons)
    assert grade(axle(soft), deciding=["theta"]).wheels[0].verdict == "pass"


# --- differences ----------------------------------------------------------------------------------------------------


def test_both_definitions_of_a_difference() -> None:
    found = difference_of(
        "adhesion", wheel(adhesion=0.45), wheel("right", adhesion=0.60), ("left", "right")
    )
    assert found.absolute == pytest.approx(0.15, abs=1e-12)
    assert found.relative == pytest.approx(0.25, abs=1e-12)  # 100 |L - R| / max(L, R)
    assert found.smaller == "left"
    plain = grade(axle(wheel(adhesion=0.45), wheel("right", adhesion=0.60))).to_dict()["axle"][
        "differences"
    ]["adhesion"]
    assert (plain["absolute"], plain["relative"]) == (pytest.approx(0.15), pytest.approx(0.25))


@pytest.mark.parametrize(
    ("quantity", "right", "verdict"),
    [
        ("phase_angle_min_deg", 40.1, "pass"),  # 57.27 * 0.7 = 40.089
        ("phase_angle_min_deg", 40.0, "fail"),
        ("relative_force_amplitude", 0.2783, "pass"),  # 0.3975 * 0.7 = 0.27825
        ("relative_force_amplitude", 0.2782, "fail"),
        ("tyre_rigidity", 288e3, "pass"),  # 187.6 / 0.65 = 288.6
        ("tyre_rigidity", 289e3, "advise"),
    ],
)
def test_relative_criteria_of_egea(quantity: str, right: float, verdict: str) -> None:
    graded = grade(axle(right=wheel("right", **{quantity: right})), deciding=["egea"])
    assert [one.verdict for one in graded.wheels] == ["pass", "pass"]
    assert graded.verdict == verdict
    said = [
        reason
        for reason in graded.inspection.axle["reasons"]
        if QUANTITIES[quantity].english in reason
    ]
    assert any("relative to the greater" in reason and "SPECSUS2018" in reason for reason in said)


def test_differences_of_methods_that_do_not_decide_do_not_count() -> None:
    right = wheel("right", phase_angle_min_deg=38.0)
    assert grade(axle(right=right), deciding=["egea"]).verdict == "fail"
    graded = grade(axle(right=right), deciding=["theta"])
    assert graded.verdict == "pass"
    assert (
        graded.inspection.axle["differences"]["phase_angle_min_deg"]["grade"]["phase-angle"][
            "verdict"
        ]
        == "fail"
    )


def test_a_relative_difference_of_values_that_are_not_positive_is_not_known() -> None:
    left, right = wheel(phase_angle_min_deg=-3.0), wheel("right", phase_angle_min_deg=-1.0)
    found = difference_of("phase_angle_min_deg", left, right, ("left", "right"))
    assert (found.absolute, found.relative) == (2.0, None)
    graded = grade(axle(left, right), deciding=["egea"])
    assert any("is not known" in reason for reason in graded.inspection.axle["reasons"])
    assert graded.verdict == "fail"


def test_one_wheel_alone_is_said() -> None:
    alone = Inspection((wheel(),), {"axle": "rear"}, methods=("egea",))
    graded = grade(alone)
    assert (graded.wheels[0].verdict, graded.verdict) == ("pass", "pass")
    assert (
        "the right wheel was not tested: the verdict holds for the other wheel alone"
        in graded.inspection.axle["reasons"][0]
    )
    assert graded.differences == ()
    failing = grade(replace(alone, wheels=(wheel(phase_angle_min_deg=12.0),)))
    assert failing.verdict == "fail"


def test_the_vehicle_takes_the_worst_axle_and_compares_front_and_rear() -> None:
    front, rear = grade(axle()), grade(axle(wheel(phase_angle_min_deg=20.0), name="rear"))
    vehicle = grade_vehicle([rear, front])
    assert [one.axle for one in vehicle.axles] == ["front", "rear"]
    assert vehicle.verdict == "fail"
    found = vehicle.to_dict()["differences"]["left"]["phase_angle_min_deg"]
    assert found["absolute"] == pytest.approx(37.27)
    assert found["relative"] == pytest.approx(37.27 / 57.27)
    assert found["smaller"] == "rear"
    assert vehicle.to_dict()["differences"]["right"]["phase_angle_min_deg"]["absolute"] == 0.0
    assert grade_vehicle([front]).verdict == "pass"


def test_front_and_rear_may_be_limited(tmp_path) -> None:
    from jounce.inspection.limits import shipped_limits

    extra = (
        '[differences.front-rear]\nquantity = "theta_road"\nacross = "axles"\ndefinition = "absolute"\n'
        'methods = ["theta"]\nsource = "lane"\nbands = ['
        '{from = 0, to = 0.1, label = "even", colour = "green", verdict = "pass"},'
        '{from = 0.1, label = "uneven", colour = "yellow", verdict = "advise"}]\n'
    )
    file = tmp_path / "lane.toml"
    file.write_text(shipped_limits().read_text(encoding="utf-8") + extra, encoding="utf-8")
    limits = load_limits(file)
    far = [wheel(side, theta_road=0.28) for side in ("left", "right")]
    axles = [grade(axle(), limits), grade(axle(*far, name="rear"), limits)]
    assert grade_vehicle(axles).verdict == "advise"
    assert any("front to rear" in reason.text() for reason in grade_vehicle(axles).reasons)
    assert grade_vehicle([axles[0], grade(axle(name="rear"), limits)]).verdict == "pass"


def test_pairs_of_axles_that_cannot_be_are_refused() -> None:
    with pytest.raises(RecordingError, match="two records of the same axle"):
        grade_vehicle([grade(axle()), grade(axle())])
    unnamed = grade(replace(axle(), axle={}))
    with pytest.raises(RecordingError, match="must state their axle"):
        grade_vehicle([grade(axle()), unnamed])
    assert grade_vehicle([unnamed]).verdict == "pass"


def test_worst_verdicts() -> None:
    assert worst(["pass", "fail", "not graded"]) == "fail"
    assert worst(["advise", "not graded"]) == "not graded"
    assert worst(["pass", "advise", "pass"]) == "advise"


# --- disagreement ---------------------------------------------------------------------------------------------------


def light_wheel() -> WheelResult:
    """A light car with a stiff tyre and a sound damper, by the linear model."""
    corner = LinearQuarterCar(230.0, 30.0, 16e3, 1100.0, 240e3)
    steady = steady_state(corner)
    curves = WheelCurves(
        *(np.full(3, value) for value in (0.0, 12.0, 0.0, 0.0, 60.0)), np.full(3, 3e-3)
    )
    return WheelResult(
        "left",
        static_load=corner.static_load,
        adhesion=steady.adhesion,
        phase_angle_min_deg=steady.phase_angle_min_deg,
        relative_force_amplitude=steady.relative_force_amplitude,
        tyre_rigidity=steady.tyre_rigidity,
        theta_road=0.17,
        corner=corner,
        curves=curves,
    )


def test_where_methods_disagree_load_and_tyre_are_named_with_numbers() -> None:
    light = light_wheel()
    assert 0.1 < light.adhesion < 0.4
    assert light.phase_angle_min_deg > 35.0
    graded = grade(axle(light, replace(light, wheel="right")), deciding=["egea"])
    assert graded.wheels[0].verdict == "pass"
    said = " | ".join(graded.wheels[0].reasons)
    assert "the methods disagree: EUSAMA" in said
    needed = (
        (1.0 - light.adhesion) * light.static_load / 0.6
    )  # the load on which this force amplitude leaves 40 %
    assert f"a wheel that carries {needed:.0f} N would reach the limit of 40 %" in said
    usual = steady_state(replace(light.corner, tyre_stiffness=200e3), light.static_load)
    assert f"200 N/mm instead of 240 N/mm it would be {100 * usual.adhesion:.1f} %" in said
    assert usual.adhesion > light.adhesion + 0.05


def test_the_load_that_is_named_is_right() -> None:
    """At the load named, the linear model of the same wheel has the adhesion of the limit within 0.2 points."""
    light = light_wheel()
    needed = (1.0 - light.adhesion) * light.static_load / 0.6
    heavier = replace(light.corner, sprung_mass=needed / 9.81 - light.corner.unsprung_mass)
    assert steady_state(heavier).adhesion == pytest.approx(0.4, abs=0.002)


def test_no_disagreement_no_words_about_it() -> None:
    said = " ".join(grade(axle()).wheels[0].reasons)
    assert "disagree" not in said
    assert "depends on the load" not in said


def test_adhesion_is_explained_only_where_it_stands_alone() -> None:
    worn = wheel(adhesion=0.3, phase_angle_min_deg=30.0, theta_road=0.11)
    said = " ".join(grade(axle(worn)).wheels[0].reasons)
    assert "the methods disagree" in said
    assert "adhesion depends on" not in said
    assert "limits of EGEA and THETA" in said


def test_lift_off_and_unequal_limits_are_explained() -> None:
    graded = grade(
        axle(
            wheel(adhesion=0.0, lift_off=True, theta_road=0.12), methods=("eusama", "egea", "theta")
        )
    )
    said = " ".join(graded.wheels[0].reasons)
    assert "the tyre leaves the plate" in said
    assert "limits of EGEA and THETA do not correspond to the same damping" in said


def test_reasons_are_said_in_german_too() -> None:
    light = light_wheel()
    graded = grade(axle(light, replace(light, wheel="right", lift_off=True)))
    for one in graded.grades:
        for reason in (*one.reasons, *graded.reasons):
            german = reason.text("de")
            assert german
            assert german != reason.text("en")
            assert german[0].isupper()
    assert any(
        "Bodenhaftung" in reason.text("de") and "," in reason.text("de")
        for reason in graded.grades[0].reasons
    )


def test_json_is_strict_and_has_the_keys_of_a_wheel() -> None:
    plain = json.loads(json.dumps(grade(axle()).to_dict(), allow_nan=False))
    assert {"wheels", "axle", "limits", "verdict", "reasons"} <= set(plain)
    keys = (
        "adhesion phase_angle_min_deg phase_frequency_hz relative_force_amplitude tyre_rigidity theta_rig theta_road "
        "lift_off grade verdict reasons uncertainty findings"
    )
    assert set(keys.split()) <= set(plain["wheels"][0])
    assert plain["limits"]["label"].startswith("jounce 1 (")


@pytest.mark.parametrize(
    ("value", "half", "near"),
    [(36.0, 1.0, []), (36.0, 1.01, [35.0]), (34.0, 1.0, [35.0]), (34.0, 0.99, [])],
)
def test_which_limits_an_interval_reaches(value: float, half: float, near: list[float]) -> None:
    found = near_edges(load_limits().methods["egea"], value, half, "egea")
    assert [(one.values["low"], one.values["high"], one.values["limit"]) for one in found] == [
        (value - half, value + half, edge) for edge in near
    ]


def test_intervals_of_differences() -> None:
    one, other = (wheel(side, adhesion=value, uncertainty={"adhesion": half})
                  for side, value, half in (("left", 0.45, 0.02), ("right", 0.6, 0.01)))  # fmt: skip
    for pair in ((one, other), (other, one)):
        found = difference_of("adhesion", *pair, tuple(each.wheel for each in pair))
        assert found.uncertainty == pytest.approx(math.hypot(0.02, 0.01))
        assert found.relative_uncertainty == pytest.approx(
            math.hypot(0.02, 0.01 * 0.45 / 0.6) / 0.6
        )
        assert found.smaller == "left"
    assert (
        difference_of(
            "adhesion", one, wheel("right", adhesion=0.6), ("left", "right")
        ).relative_uncertainty
        is None
    )


@pytest.mark.parametrize(
    ("stiffness", "said"), [(209e3, False), (211e3, True), (191e3, False), (189e3, True)]
)
def test_tyres_that_are_told_from_usual_ones(stiffness: float, said: bool) -> None:
    light = light_wheel()
    found = _of_tyre(replace(light, corner=replace(light.corner, tyre_stiffness=stiffness)))
    assert [one.kind for one in found] == (["tyre"] if said else [])
    for one in found:
        assert (one.values["usual"], one.values["stiffness"]) == (
            200.0,
            pytest.approx(1e-3 * stiffness),
        )
    (plain,) = _of_tyre(replace(light, corner=None, tyre_rigidity=187.6e3))
    assert (plain.kind, plain.values) == ("rigidity", {"rigidity": pytest.approx(187.6)})
    assert _of_tyre(replace(light, corner=None, tyre_rigidity=None)) == []


@pytest.mark.parametrize(
    ("name", "value", "text", "up", "limit"),
    [
        ("adhesion", 0.3996, "40.0 %", "40.0 %", "39.96 %"),
        ("adhesion", 0.0041, "0.4 %", "0.5 %", "0.41 %"),
        ("phase_angle_min_deg", -0.04, "0.0°", "0.0°", "−0.04°"),
        ("phase_angle_min_deg", -9.06, "−9.1°", "-9.0°", "−9.06°"),
        ("tyre_rigidity", 187.6e3, "188 N/mm", "188 N/mm", "187.6 N/mm"),
        ("theta_road", 0.12341, "0.123", "0.124", "0.12341"),
        ("boge_amplitude", 0.01234, "12.3 mm", "12.4 mm", "12.34 mm"),
    ],
)
def test_how_values_are_written(name: str, value: float, text: str, up: str, limit: str) -> None:
    one = QUANTITIES[name]
    assert one.text(value) == text
    assert one.text(value, "de") == text.replace(".", ",")
    if value > 0.0:
        assert one.rounded_up(value) == up
        assert one.rounded_up(value, "de") == up.replace(".", ",")
    assert one.limit_text(value) == limit
    assert one.text(None) == one.text(math.inf) == "–"
