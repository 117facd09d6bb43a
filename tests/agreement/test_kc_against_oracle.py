"""Every quantity of every test on the K&C rig against the independent solver of ``kc_oracle``.

It has other unknowns (modified Rodrigues parameters), other equations (slopes of one energy and of conditions by
CasADi), and reads files by itself. Both agree to 1e-9 of each curve's range, and to rounding: a change of 1e-16 m is
1e-8 N in a bearing of 1e8 N/m.
"""

from __future__ import annotations

import kc_rigs
import kc_tests
import numpy as np
import pytest
from kc_oracle import Oracle

import jounce as jn
from jounce.kc.tests import TESTS

AGREEMENT = 1e-9  # of a curve's range
ROUNDING = {"N": 5e-8, "N*m": 1e-8, "m": 5e-13, "rad": 5e-13}  # Newton stops at changes of 1e-12
POINTS = 9


def bush(*stiffness: float, turning=(60.0, 50.0, 40.0), **other) -> dict:
    return {
        "stiffness": [1e6 * value for value in stiffness],
        "rotational_stiffness": list(turning),
        **other,
    }


OWN_AXES = {"x_axis": [1.0, 0.1, 0.0], "z_axis": [0.0, 0.1, 1.0], "preload": [100.0, 200.0, -50.0]}
POLYNOMIAL = {"kind": "polynomial", "coefficients": [6e6, 1e9, 3e12]}
TORQUES = {
    "kind": "table",
    "angle": [-0.2, -0.05, 0.05, 0.2],
    "torque": [-40.0, -5.0, 5.0, 40.0],
}
FORCES = {
    "kind": "table",
    "deflection": [-3e-3, -1e-3, 1e-3, 3e-3],
    "force": [-15e3, -2e3, 2e3, 15e3],
}
MOUNTS = [
    {"point": [0.25, 0.35, 0.25], **bush(8, 7, 6)},
    {"point": [-0.3, 0.38, 0.26], **bush(9, 5, 7)},
]
BEARING = {"stiffness": [1e8, 5e7, 1e8], "rotational_stiffness": [1e5, 0.0, 1.1e5]}
TORSION_BAR = {"stiffness": 900.0, "preload": 120.0, "on": "arm"}
HARD = {"turning": (5.0, 4.0, 3.0)}


def double_wishbone() -> jn.Rig:
    """It yields wherever it can."""
    bushings = {
        "lower_arm_front": bush(8, 6, 2, curves={"y": POLYNOMIAL, "rx": TORQUES}, **OWN_AXES),
        "lower_arm_rear": bush(4, 3, 2, rotational_preload=[3.0, 1.0, -2.0]),
        "upper_arm_front": bush(5, 5, 1),
        "upper_arm_rear": bush(5, 5, 1),
        "lower_ball_joint": bush(30, 30, 30, **HARD),
        "upper_ball_joint": bush(20, 20, 20, **HARD),
        "tie_rod_inner": bush(20, 30, 20, **HARD),
        "tie_rod_outer": bush(25, 35, 25, **HARD),
        "strut_top": bush(3, 3, 5),
        "strut_bottom": bush(6, 6, 9),
        "arb_pivot": bush(3, 3, 3),
        "arb_link_end": bush(10, 10, 10),
        "arb_arm_end": bush(10, 10, 10),
    }
    carries = ["lower_arm_front", "lower_arm_rear", "rack"]
    housing = [{"point": [-0.1, 0.25, 0.2], **bush(20, 5, 20)}]
    column = {"rack_ratio": 0.008, "column_stiffness": 2000.0, "assistance": 5.0}
    return jn.load("reference-double-wishbone").with_changes(
        {
            "bushings": bushings,
            "subframe": {"carries": carries, "mounts": MOUNTS},
            "bearing": BEARING,
            "links": {"tie_rod": {"stiffness": 5e7}, "lower_arm": {"stiffness": 6e7}},
            "steering": {**column, "housing": housing},
            "hardpoints.arb_pivot": [-0.3, 0.35, 0.3],
            "hardpoints.arb_arm_end": [-0.08, 0.45, 0.3],
            "hardpoints.arb_link_end": [-0.05, 0.6, 0.2],
            "anti_roll_bar": {"stiffness": 900.0, "on": "lower_arm", "kind": "u"},
        }
    )


def mcpherson() -> jn.Rig:
    """On a subframe, with a top mount; its spring carries the car."""
    bushings = {
        "lower_arm_front": bush(8, 6, 2, x_axis=[1.0, 0.1, 0.0], preload=[10.0, 150.0, 5.0]),
        "lower_arm_rear": bush(4, 3, 2, curves={"y": FORCES}),
        "lower_ball_joint": bush(30, 30, 30),
        "tie_rod_inner": bush(20, 20, 20),
        "tie_rod_outer": bush(30, 20, 20),
        "strut_top": bush(1, 1, 0.8, turning=(30.0, 30.0, 2.0)),
    }
    return jn.load("generic-mcpherson").with_changes(
        {
            "bushings": bushings,
            "bearing": {"rotational_stiffness": BEARING["rotational_stiffness"]},
            "links": {"lower_arm": {"stiffness": 3e7}},
            "subframe": {
                "carries": ["lower_arm_front", "lower_arm_rear", "rack"],
                "mounts": MOUNTS,
            },
            "strut.spring": {"rate": 30e3, "preload": 3500.0},
            "strut.bump_stop": {"gap": 0.03, "rate": 60e3, "progression": 1e8},
        }
    )


def five_link() -> jn.Rig:
    inner = {f"link_{i}_inner": bush(3 + i, 4, 2, turning=(20.0, 15.0, 30.0)) for i in range(1, 6)}
    outer = {f"link_{i}_outer": bush(20, 4 + i, 12, **HARD) for i in range(1, 6)}
    inner["link_4_inner"] = bush(7, 4, 2, turning=(0.0, 0.0, 0.0))  # the spring stands on link 4:
    outer["link_4_outer"] = bush(
        20, 8, 12, turning=(0.0, 0.0, 0.0)
    )  # it does not turn about itself
    return jn.load("sedan-multi-link").with_changes(
        {
            "bushings": inner | outer,
            "bearing": {"stiffness": BEARING["stiffness"]},
            "links": {"link_3": {"stiffness": 3e7}, "link_1": {"stiffness": 4e7}},
        }
    )


def trailing_arm() -> jn.Rig:
    cubic = {"kind": "polynomial", "coefficients": [2e6, 0.0, 1e12]}
    mounts = [
        {"point": [0.5, 0.4, 0.3], **bush(8, 7, 6)},
        {"point": [0.1, 0.42, 0.3], **bush(9, 5, 7)},
    ]
    return jn.load("semi-trailing-arm").with_changes(
        {
            "bushings": {
                "arm_inner": bush(8, 6, 2, z_axis=[0.1, 0.2, 1.0]),
                "arm_outer": bush(8, 6, 2, curves={"z": cubic}),
            },
            "subframe": {"carries": ["arm_inner", "arm_outer"], "mounts": mounts},
        }
    )


def formula_student() -> jn.Rig:
    return jn.load("formula-student-front").with_changes(
        {
            "bushings": {
                "pushrod_inner": bush(20, 20, 20),
                "rocker_pivot": bush(20, 30, 10, turning=(0.0, 5e3, 5e3)),
                "lower_ball_joint": bush(30, 30, 30),
                "strut_bottom": bush(8, 8, 8),
            },
            "links": {"upper_arm": {"stiffness": 2e7}, "tie_rod": {"stiffness": 1e7}},
        }
    )


def solid_axle() -> jn.Rig:
    return jn.load("solid-axle").with_changes(
        {"bearing": BEARING, "links": {"panhard": {"stiffness": 2e7}}}
    )


def twist_beam() -> jn.Rig:
    return jn.load("twist-beam").with_changes(
        {"bushings.pivot": bush(1.5, 2.5, 1.5, x_axis=[1.0, 0.4, 0.0], curves={"y": FORCES})}
    )


def ideal(name: str, **changes):
    return lambda: jn.load(name).with_changes(changes)


RIGS = {
    "double wishbone": (double_wishbone, 0.05),
    "mcpherson": (mcpherson, 0.05),
    "five links": (five_link, 0.05),
    "trailing arm": (trailing_arm, 0.05),
    "push rod and rocker": (formula_student, 0.02),
    "solid axle": (solid_axle, 0.05),
    "twist beam": (twist_beam, 0.05),
    "ideal double wishbone": (ideal("reference-double-wishbone"), 0.05),
    "ideal mcpherson": (ideal("generic-mcpherson"), 0.05),
    "ideal five links": (ideal("sedan-multi-link"), 0.05),
    "ideal trailing arm": (ideal("semi-trailing-arm", torsion_bar=TORSION_BAR), 0.05),
}
STATES = {  # travel as a share of the rig's, rack travel (m), what is held
    "ride height": (0.0, 0.0, "load"),
    "bump": (1.0, 0.0, "load"),
    "rebound": (-1.0, 0.0, "height"),
    "steered": (0.0, 0.015, "load"),
}


class Both:
    """A rig for both: its description for jounce, and the oracle's equations from its table."""

    def __init__(self, rig: jn.Rig, travel: float) -> None:
        self.rig, self.travel = rig, travel
        self.table = rig.model_dump(by_alias=True, exclude_none=True)
        self.oracle = Oracle(kc_rigs.read_axle(self.table))
        self.states: dict[tuple, kc_tests.Rig] = {}

    @property
    def is_steered(self) -> bool:
        return self.oracle.data.rack is not None

    def state(self, travel: float, rack: float) -> kc_tests.Rig:
        if (travel, rack) not in self.states:
            self.states[travel, rack] = kc_tests.Rig(self.oracle, travel, rack)
        return self.states[travel, rack]

    def compare(
        self, test: str, travel: float = 0.0, rack: float = 0.0, loops: int = 1, **options
    ) -> None:
        given = {"points": POINTS, "travel": travel, **options}
        if self.is_steered:
            given["steer"] = rack
        sheet = jn.kc_test(self.rig, test, **given)
        own = {key: options[key] for key in ("held", "handwheel", "trail") if key in options}
        inputs = sheet["input"].values
        states = self.state(travel, rack).run(test, np.tile(inputs, loops), **own)[-len(inputs) :]
        rows = [kc_tests.quantities(state, self.table) for state in states]
        assert set(rows[0]) == {str(name) for name in sheet.data_vars}
        wrong = {}
        for name in rows[0]:
            mine, its = np.array([row[name] for row in rows]), sheet[name].values
            allowed = AGREEMENT * np.ptp(mine) + ROUNDING[sheet[name].attrs["units"]]
            if not np.abs(its - mine).max() <= allowed:
                wrong[name] = float(np.abs(its - mine).max()), float(np.ptp(mine))
        assert not wrong


QUICK = ("mcpherson", "solid axle", "twist beam")  # the others take some minutes


@pytest.fixture(
    scope="module",
    params=[pytest.param(n, marks=() if n in QUICK else pytest.mark.slow) for n in RIGS],
)
def both(request: pytest.FixtureRequest) -> Both:
    make, travel = RIGS[request.param]
    return Both(make(), travel)


@pytest.mark.parametrize("state", STATES)
def test_every_quantity_of_every_test(both: Both, state: str) -> None:
    share, rack, held = STATES[state]
    if rack and not both.is_steered:
        rack, share = 0.0, 0.5  # what cannot be steered is compared at half its travel
    for test in TESTS:
        if test == "steer" and not both.is_steered:
            continue
        small = {"to": 0.015} if test == "steer" and both.travel < 0.05 else {}
        both.compare(test, share * both.travel, rack, held=held, **small)


@pytest.mark.parametrize("test", ["bounce", "braking", "aligning-opposed", "lateral-opposed"])
@pytest.mark.parametrize("rig", [double_wishbone, mcpherson])
@pytest.mark.some(2)
def test_a_free_handwheel(rig, test: str) -> None:
    Both(rig(), 0.05).compare(test, handwheel="free")


@pytest.mark.parametrize("test", ["bounce", "lateral-in-phase", "lateral-left", "braking"])
def test_loops_of_friction(test: str) -> None:
    dry = {"friction": [60.0, 90.0, 40.0], "rotational_friction": [0.4, 0.3, 0.2]}
    rig = jn.load("reference-double-wishbone").with_changes(
        {
            "bushings": {
                "lower_arm_front": bush(8, 6, 2, **dry),
                "lower_arm_rear": bush(6, 5, 2, **dry, friction_stiffness=[2e6, 3e6, 1e6]),
                "upper_arm_front": bush(5, 5, 1),
                "upper_arm_rear": bush(5, 5, 1, **dry),
            },
            "strut.friction": {"force": 80.0},
        }
    )
    Both(rig, 0.05).compare(test, points=21, loops=2)


@pytest.mark.parametrize("rig", [mcpherson, solid_axle, twist_beam])
def test_roll_centre_and_support_from_forces(rig) -> None:
    """Wheel loads of held pads under horizontal forces: their slopes at ride height, exact in the oracle."""
    both = Both(rig(), 0.05)
    state = both.state(0.0, 0.0).rest
    loads = [f"{side}.vertical_force" for side in kc_tests.SIDES]
    across = np.array([state.shown[f"{side}.patch"][1] for side in kc_tests.SIDES])

    def changes(name: str) -> np.ndarray:
        """Of each wheel's load, for a newton on both tyres."""
        rows = [state.slopes(f"{side}.{name}") for side in kc_tests.SIDES]
        return np.array([sum(row[load][0] for row in rows) for load in loads])

    centres = jn.kc_centres(both.rig).sel(source="forces")
    height = -(across * changes("patch_y")).sum() / 2.0
    # the rig fits a line over half the usual range, on which the loads are nearly linear
    assert float(centres["roll_centre_height"]) == pytest.approx(height, rel=0.03, abs=2e-3)
    for test, (name, sign) in kc_tests.LONGITUDINAL.items():
        angle = np.arctan(sign * changes(name).mean())
        assert float(centres[test]) == pytest.approx(angle, rel=0.05, abs=3e-3)


@pytest.mark.parametrize(
    ("parameter", "step"),
    [
        ("hardpoints.tie_rod_outer[2]", 1e-4),
        ("hardpoints.lower_ball_joint[1]", 1e-4),
        ("bushings.lower_arm_front.stiffness[1]", 2e4),
        ("bearing.rotational_stiffness[2]", 1e3),
    ],
)
def test_sensitivities_are_differences_of_the_oracle(parameter: str, step: float) -> None:
    rig, test = mcpherson(), "lateral-opposed"
    names = ["left.toe", "left.camber", "right.wheel_centre_y"]
    rows = jn.kc_sensitivities(rig, test, [parameter], quantities=names, points=POINTS)
    value = rig.parameters()[parameter]
    ends = []
    for sign in (1.0, -1.0):
        moved = Both(rig.with_changes({parameter: value + sign * step}), 0.05)
        states = moved.state(0.0, 0.0).run(test, rows["input"].values)
        ends.append([kc_tests.quantities(state, moved.table) for state in states])
    for name in names:
        rise = [(a[name] - b[name]) / (2.0 * step) for a, b in zip(ends[0], ends[1], strict=True)]
        slopes = rows["sensitivity"].sel(quantity=name, parameter=parameter).values
        assert slopes == pytest.approx(np.array(rise), rel=2e-4, abs=2e-4 * np.ptp(rise))
