"""Any rig written as a file reads back as the same rig."""

from __future__ import annotations

import tomllib

import pytest

from jounce.parts import Rig, library, load, rig_from_table
from jounce.parts.files import rig_text
from jounce.parts.rig import structure_of

KART = load("kart-quarter-car")
CORNER = load("reference-double-wishbone")
RIGS = {
    **{name: load(name) for name in library()},
    "laws": KART.with_changes(
        {
            "source": 'quoted "text" \\ of\ntwo lines',
            "strut.damper": {
                "kind": "bouc-wen",
                "coefficient": 200.0,
                "hysteretic_force": 30.0,
                "rate": 900.0,
                "sigma": 1.5,
                "exponent": 2.0,
            },
            "strut.bump_stop": {"gap": 0.02, "rate": 6e4, "progression": 1e8},
            "tyre.stiffness": None,
            "tyre.curve": {"kind": "power", "coefficient": 3e6, "exponent": 1.4},
            "tyre.lift_off": False,
        }
    ),
    "bar and bushings": CORNER.with_changes(
        {
            "anti_roll_bar": {"stiffness": "300 N*m/deg", "on": "upright"},
            "hardpoints.arb_pivot": [0.3, 0.0, 0.2],
            "hardpoints.arb_arm_end": [0.1, 0.45, 0.2],
            "hardpoints.arb_link_end": [0.1, 0.5, 0.15],
            "bushings.upper_arm_rear": {
                "stiffness": [1e6, 2e6, 3e6],
                "rotational_stiffness": [10.0, 20.0, 30.0],
            },
            "guide_friction": {"force": 5.0},
        }
    ),
    "right": CORNER.mirrored(),
}


def read(text: str) -> Rig:
    return rig_from_table(tomllib.loads(text), where="rig.toml", text=text)


@pytest.mark.parametrize("name", RIGS)
def test_round_trip(name: str):
    rig = RIGS[name]
    again = read(rig_text(rig, ["a comment", "another one " * 20]))
    assert again.parameters() == pytest.approx(rig.parameters(), rel=2e-6, abs=1e-9)
    assert again.source == rig.source
    assert structure_of(again) == structure_of(rig)


def test_units_and_long_lines():
    text = rig_text(RIGS["bar and bushings"])
    assert 'lower_ball_joint = ["5 mm", "720 mm", "140 mm"]' in text
    assert 'camber = "-1 deg"' in text
    assert "N*m/rad" in text
    assert (
        max(len(line) for line in rig_text(load("hmmwv-front")).splitlines() if '"kg*m' not in line)
        < 200
    )
