"""``jounce adjust`` and ``jounce study lumped-vs-spatial``: answers, files, and what one can get wrong."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.kinematics.adjustments import SETTINGS, apply_adjustments

RIG = "kart-double-wishbone"


def test_json_holds_every_setting_with_its_range_and_effect(cli) -> None:
    outcome = cli("adjust", RIG, "--json")
    assert outcome.exit_code == 0
    assert outcome.err == ""
    found = outcome.json
    own = [name for name, setting in SETTINGS.items() if setting.fits(jn.load(RIG))]
    assert [effect["setting"] for effect in found["effects"]] == own
    arm = next(effect for effect in found["effects"] if effect["setting"] == "upper_arm_length")
    assert (arm["unit"], arm["lowest"], arm["highest"]) == ("m", 0.0, 0.02)
    assert "section 4" in arm["source"]
    assert np.degrees(arm["at_highest"]["camber"]) == pytest.approx(5.0, abs=0.6)
    assert arm["per_unit"]["camber"] == pytest.approx(
        4.6, abs=0.1
    )  # rad/m: one over the upright and the tie rod's share
    assert found["before"] == found["after"]
    assert (found["settings"], found["lengths"], found["out"]) == ({}, None, None)


def test_table_for_people(cli) -> None:
    outcome = cli("adjust", RIG)
    assert outcome.exit_code == 0
    for word in ("upper_arm_length", "per mm", "[mm]", "camber", "wheel rate"):
        assert word in outcome.out
    assert "nan" not in outcome.out


def test_settings_are_made_and_written(cli, tmp_path: Path) -> None:
    outcome = cli(
        "adjust",
        RIG,
        "--set",
        "upper_arm_length=10 mm",
        "--set",
        "strut_angle=16 deg",
        "--out",
        "new.toml",
    )
    assert outcome.exit_code == 0
    assert "upper_arm_length 10 mm, strut_angle 16 deg" in " ".join(outcome.out.split())
    wanted = apply_adjustments(jn.load(RIG), {"upper_arm_length": "10 mm", "strut_angle": "16 deg"})
    assert jn.load(tmp_path / "new.toml") == wanted
    text = (tmp_path / "new.toml").read_text(encoding="utf-8")
    assert "# Kart-scale double-wishbone prototype." in text
    assert 'rate = "22.73 N/mm"' in text
    refused = cli("adjust", RIG, "--set", "upper_arm_length=5 mm", "--out", "new.toml")
    assert refused.exit_code == 2
    assert "exists" in refused.err
    assert jn.load(tmp_path / "new.toml") == wanted
    assert (
        cli(
            "adjust", RIG, "--set", "upper_arm_length=5 mm", "--out", "new.toml", "--force"
        ).exit_code
        == 0
    )


def test_lengths_for_camber_and_toe(cli) -> None:
    found = cli("adjust", RIG, "--camber", "-2 deg", "--toe", "0.5 deg", "--json").json
    assert np.degrees([found["after"]["camber"], found["after"]["toe"]]) == pytest.approx(
        [-2.0, 0.5], abs=1e-6
    )
    assert found["lengths"]["upper_arm_length"] == 0.0
    assert found["settings"]["lower_arm_length"] == found["lengths"]["lower_arm_length"]
    assert found["effects"] == []
    both = cli("adjust", RIG, "--camber", "-2 deg", "--set", "strut_angle=10 deg", "--json").json
    assert both["settings"]["strut_angle"] == pytest.approx(np.radians(10.0))
    assert both["after"]["wheel_rate"] > found["after"]["wheel_rate"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--set", "uper_arm_length=3 mm"), "Did you mean 'upper_arm_length'"),
        (("--set", "upper_arm_length=25 mm"), "0 mm to 20 mm"),
        (("--set", "upper_arm_length"), "not NAME=VALUE"),
        (("--camber", "9 deg"), "does not reach this"),
        (("--camber", "9"), "9 rad is implausible"),
        (("--camber", "9 mm"), "wrong unit"),
        (
            ("--camber", "1 deg", "--set", "lower_arm_length=3 mm"),
            "a length is both given and to be found",
        ),
        (("--out", "new.toml"), "nothing to adjust"),
        (
            ("--set", "upper_arm_length=5 mm", "--out", "new"),
            "new: rigs are not written in this format",
        ),
    ],
)
def test_mistakes_are_one_message(cli, tmp_path: Path, words, message) -> None:
    outcome = cli("adjust", RIG, *words)
    assert outcome.exit_code == 2
    assert outcome.out == ""
    assert message in outcome.err
    assert not (tmp_path / "new.toml").exists()


def test_lumped_rigs_have_no_arms(cli) -> None:
    outcome = cli("adjust", "kart-quarter-car", "--json")
    assert outcome.exit_code == 2
    assert "only a corner with hardpoints" in outcome.json["error"]["message"]


def test_other_suspensions_have_their_own_settings(cli) -> None:
    outcome = cli("adjust", "semi-trailing-arm", "--set", "toe_wedge=0.2 deg", "--json")
    assert outcome.exit_code == 0
    assert np.degrees(
        outcome.json["after"]["toe"] - outcome.json["before"]["toe"]
    ) == pytest.approx(0.2)
    assert outcome.json["after"]["caster"] is None
    shown = cli("adjust", "semi-trailing-arm", "--set", "toe_wedge=0.2 deg")
    assert "nan" not in shown.out.lower()


def test_steep_struts_are_warned_of(cli) -> None:
    outcome = cli("adjust", RIG, "--set", "strut_angle=33 deg")
    assert outcome.exit_code == 0
    assert "Adams" in outcome.out


# --- jounce study lumped-vs-spatial --------------------------------------------------------------------------------


def test_lumped_model_against_the_linkage(cli) -> None:
    found = cli(
        "study",
        "lumped-vs-spatial",
        RIG,
        "--lumped",
        "kart-quarter-car",
        "--duration",
        "0.5 s",
        "--json",
    ).json
    rows = {row["quantity"]: row for row in found["rows"]}
    assert rows["motion ratio at rest"]["spatial"] == pytest.approx(
        np.cos(np.radians(26.0)), rel=1e-4
    )
    assert rows["unsprung mass"]["lumped"] == 5.0
    assert all(row["why"] for row in found["rows"])
    assert len(found["peaks"]) == 9
    assert {peak["trial"] for peak in found["peaks"]} == {"1.95 m/s", "2.86 m/s", "3.79 m/s"}
    assert found["lumping"]["shares"]["upright"]["mass"] == 4.6


def test_lumped_model_of_its_own_over_a_road_of_ones_own(cli, bump: Path) -> None:
    words = (
        "study",
        "lumped-vs-spatial",
        RIG,
        "--road",
        bump,
        "--speed",
        "2 m/s",
        "--duration",
        "0.5 s",
    )
    outcome = cli(*words)
    assert outcome.exit_code == 0
    assert "inertance" in outcome.out
    assert "its equivalent quarter car" in outcome.out
    assert cli(*words, "--json").json["lumped_rig"] is None


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("kart-quarter-car",), "not a corner with hardpoints"),
        ((RIG, "--lumped", RIG), "not a quarter car"),
        ((RIG, "--speed", "0 m/s"), "--speed"),
        ((RIG, "--road", "nowhere"), "nowhere"),
    ],
)
def test_models_that_cannot_be_compared(cli, words, message) -> None:
    outcome = cli("study", "lumped-vs-spatial", *words)
    assert outcome.exit_code == 2
    assert message in outcome.err
