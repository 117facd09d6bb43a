"""Adjustments vary like numbers of the rig: a swept adjustment is an adjusted rig."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.variants.study import read_sweep

KART = jn.load("kart-double-wishbone")
TRIAL = jn.Trial(
    road=jn.HalfSine(height="5 mm", length="60 mm", start="0.2 m"), speed="2 m/s", duration="0.3 s"
)
STUDY = """schema = "jounce.sweep/1"
rig = "kart-double-wishbone"
metrics = ["max sprung.az"]
trial = {speed = "2 m/s", duration = "0.3 s", road = {kind = "half-sine", height = "5 mm", length = "60 mm"}}
design = {kind = "grid"}
vary = {"upper_arm_length" = ["0 mm", "20 mm"], "strut_angle" = ["10 deg", "26 deg"]}
"""


def test_a_swept_adjustment_is_an_adjusted_rig() -> None:
    lengths, rates = ["0 mm", "8 mm", "20 mm"], [20e3, 21e3, 22e3]
    many = jn.simulate_many(
        KART,
        TRIAL,
        {"upper_arm_length": lengths, "strut.spring.rate": rates},
        outputs=["sprung.az", "strut.force"],
    )
    assert many["upper_arm_length"].attrs["units"] == "m"
    assert set(many["reason"].values) == {""}
    for row, (length, rate) in enumerate(zip(lengths, rates, strict=True)):
        rig = jn.apply_adjustments(
            KART.with_changes({"strut.spring.rate": rate}), {"upper_arm_length": length}
        )
        run = jn.simulate(rig, TRIAL)
        for name in ("sprung.az", "strut.force"):
            np.testing.assert_allclose(many[name][row], run[name], rtol=1e-9, atol=1e-9)
    assert np.ptp(many["strut.force"].to_numpy()[:, 0]) > 0.1


def test_a_design_draws_within_the_range_of_an_adjustment() -> None:
    spread = {"upper_arm_length": ("0 mm", "20 mm"), "strut_angle": ("10 deg", "26 deg")}
    many = jn.simulate_many(KART, TRIAL, jn.sobol(spread, 4), metrics=["max sprung.az"])
    assert np.isfinite(many["max sprung.az"]).all()
    assert many.attrs["outside"] == 0
    with pytest.raises(DescriptionError, match="exceeds the allowed range"):
        jn.simulate_many(
            KART,
            TRIAL,
            jn.sobol({"upper_arm_length": ("0 mm", "90 mm")}, 4),
            metrics=["max sprung.az"],
        )


def test_a_value_out_of_range_is_the_reason_of_its_variant() -> None:
    many = jn.simulate_many(
        KART, TRIAL, {"upper_arm_length": ["0 mm", "90 mm"]}, metrics=["max sprung.az"]
    )
    assert many.attrs["outside"] == 1
    assert many["reason"].values[0] == ""
    assert "upper_arm_length: out of range" in many["reason"].values[1]
    assert "0 mm to 20 mm" in many["reason"].values[1]


@pytest.mark.parametrize(
    ("rig", "name", "said"),
    [
        ("kart-double-wishbone", "upper_arm_lenght", "Did you mean 'upper_arm_length'"),
        (
            "kart-double-wishbone",
            "angle_of_attack",
            "lower_arm_length, .*strut_angle, .*upper_arm_length",
        ),
        ("kart-double-wishbone", "link_1_length", "unknown parameter"),
        ("kart-quarter-car", "upper_arm_length", "unknown parameter"),
    ],
)
def test_unknown_names_are_refused_with_what_is_allowed(rig: str, name: str, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        jn.simulate_many(rig, TRIAL, {name: [0.0]}, metrics=["max sprung.az"])


def test_a_study_varies_adjustments(tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    file.write_text(STUDY, encoding="utf-8")
    result = jn.run_sweep(file, tmp_path / "out")
    assert result.summary.ran == 4
    assert sorted(set(result.data["strut_angle"].values.round(6))) == [0.174533, 0.453786]
    file.write_text(STUDY.replace("upper_arm_length", "upper_arm_lenght"), encoding="utf-8")
    with pytest.raises(
        DescriptionError, match=r"study.toml, line 6: vary.upper_arm_lenght.*upper_arm_length"
    ):
        read_sweep(file)
