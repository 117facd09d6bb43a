"""The tests of a K&C laboratory on the oracle (``kc_oracle``), and the quantities that a sheet has of them.

What a test moves and loads follows from its name alone; nothing is taken from ``jounce.kc`` but the inputs at which its
samples are compared.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from kc_oracle import GROUND, Oracle, State, Wheel

SIDES = {"left": 1.0, "right": -1.0}
_SHARES = {"in-phase": (1.0, 1.0), "opposed": (1.0, -1.0), "left": (1.0, 0.0), "right": (0.0, 1.0)}
LONGITUDINAL = {  # force of the road forward for a unit of the input, and where it acts
    "braking": ("patch_x", -1.0),
    "braking-inboard": ("centre_x", -1.0),
    "driving": ("centre_x", 1.0),
    "driving-hub": ("patch_x", 1.0),
}
_DIRECTIONS = ("force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z")


class Rig:
    """An axle on its pads: the state in which tests begin, and tests from there."""

    def __init__(self, oracle: Oracle, travel: float = 0.0, rack: float = 0.0) -> None:
        self.oracle, wheels = oracle, oracle.data.wheels
        self.heights = {
            n: _lowest(w.centre, w.axis, w.radius)[2] + travel for n, w in wheels.items()
        }
        self.inputs = {f"{name}.held": 1.0 for name in wheels}
        if oracle.data.rack:
            self.inputs |= {"rack.held": 1.0, "rack.travel": rack}
        steps = 1 + int(np.ceil(max(abs(travel), abs(rack)) / 5e-3))
        self.rest: State | None = None
        for share in np.linspace(0.0, 1.0, steps) if steps > 1 else [1.0]:
            at = {f"{n}.height": z - (1.0 - share) * travel for n, z in self.heights.items()}
            if oracle.data.rack:
                at["rack.travel"] = share * rack
            self.rest = oracle.solve({**self.inputs, **at}, self.rest)
        self.inputs |= {f"{name}.height": z for name, z in self.heights.items()}
        self.loads = {n: float(self.rest.shown[f"{n}.vertical_force"][0]) for n in wheels}
        self.rack = rack

    def run(
        self,
        test: str,
        samples: Sequence[float],
        *,
        held: str = "load",
        handwheel: str = "locked",
        trail: float | None = None,
    ) -> list[State]:
        """Equilibria of a test at its inputs, one after another."""
        path = [self.at(test, value, held, handwheel, trail) for value in samples]
        return self.oracle.follow(path, self.rest)

    def at(
        self, test: str, value: float, held: str, handwheel: str, trail: float | None
    ) -> dict[str, float]:
        """Inputs of the oracle at an input of a test."""
        inputs = dict(self.inputs)
        if handwheel == "free" and test != "steer" and self.oracle.data.rack:
            inputs |= {"rack.held": 0.0, "rack.force": float(self.rest.shown["rack.force"][0])}
        if test == "bounce":
            inputs |= {f"{name}.height": z + value for name, z in self.heights.items()}
            return inputs
        if test == "roll":
            left, right = self.heights.values()
            track = np.subtract(*(w.centre[1] for w in self.oracle.data.wheels.values()))
            inputs |= {"roll": 1.0, "roll.difference": left - right + np.tan(value) * track}
            return inputs | {"roll.load": sum(self.loads.values())}
        if held == "load":
            inputs |= {f"{name}.held": 0.0 for name in SIDES}
            inputs |= {f"{name}.load": load for name, load in self.loads.items()}
        if test == "steer":
            return inputs | {"rack.held": 1.0, "rack.travel": self.rack + value}
        if test in LONGITUDINAL:
            name, sign = LONGITUDINAL[test]
            return inputs | {f"{side}.{name}": sign * value for side in SIDES}
        kind, _, phase = test.partition("-")
        name = {"lateral": "patch_y", "aligning": "moment_z"}[kind]
        shares = _SHARES["in-phase" if phase == "trail" else phase]
        inputs |= {f"{side}.{name}": s * value for side, s in zip(SIDES, shares, strict=True)}
        if kind == "lateral":
            behind = (0.03 if phase == "trail" else 0.0) if trail is None else trail
            inputs |= {f"{side}.trail": behind for side in SIDES}
        return inputs


def _lowest(centre, axis, radius: float) -> np.ndarray:
    """Lowest point of a thin disc."""
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    down = axis * axis[2] - [0.0, 0.0, 1.0]
    return np.asarray(centre, dtype=float) + radius * down / np.linalg.norm(down)


def quantities(state: State, table: Mapping) -> dict[str, float]:
    """What a sheet says of an equilibrium of a rig's table, by the names of ``jounce.kc_test``."""
    steering = _steering_axes(table)
    shown, data = state.shown, state.oracle.data
    out: dict[str, float] = {}
    for name, wheel in data.wheels.items():
        out |= {f"{name}.{key}": float(v) for key, v in _wheel(state, name, wheel).items()}
        if name in steering:
            low, high = (np.array(state.place(*end)) for end in steering[name])
            out[f"{name}.caster"] = float(np.arctan2(-(high - low)[0], (high - low)[2]))
        loads = {key: state.inputs.get(f"{name}.{key}", 0.0) for key in (
            "patch_x", "patch_y", "centre_x", "moment_z",
        )}  # fmt: skip
        out[f"{name}.longitudinal_force"] = loads["patch_x"] + loads["centre_x"]
        out[f"{name}.lateral_force"] = loads["patch_y"]
        out[f"{name}.aligning_moment"] = loads["moment_z"]
        out[f"{name}.vertical_force"] = float(shown[f"{name}.vertical_force"][0])
    for row in data.elastic:
        name = row["name"]
        if row["kind"] == "bushing":
            values = zip(_DIRECTIONS, shown[f"{name}.force"], strict=True)
            out |= {f"{name}.{key}": float(value) for key, value in values}
        elif row["kind"] == "spring":
            out |= {
                f"{name}.{key}": float(shown[f"{name}.{key}"][0]) for key in ("force", "length")
            }
        elif row["kind"] in ("twist", "bar"):
            out[f"{name}.twist"] = float(shown[f"{name}.angle"][0])
            out[f"{name}.torque"] = float(shown[f"{name}.torque"][0])
    for row in data.joints:
        if row["kind"] == "rod":  # compression positive
            out[f"{row['name']}.force"] = -float(shown[f"{row['name']}.multipliers"][0])
    if data.rack:
        out["rack_travel"] = float(shown["rack.place"][0])
        out["rack_force"] = float(shown["rack.force"][0])
        ratio = (table.get("steering") or {}).get("rack_ratio")
        if ratio:  # without a column the handwheel turns the pinion
            hand = 1.0 + (table["steering"].get("assistance") or 0.0)
            out["handwheel_angle"] = float(shown["rack.travel"][0]) / ratio
            out["handwheel_torque"] = out["rack_force"] / hand * ratio
    return out


def _wheel(state: State, name: str, wheel: Wheel) -> dict[str, float]:
    side, shown = SIDES[name], state.shown
    axis = shown[f"{name}.axis"]
    left = side * axis
    ahead = np.array([left[1], -left[0], 0.0]) / np.hypot(left[0], left[1])
    design = np.asarray(wheel.axis, dtype=float) / np.linalg.norm(wheel.axis)
    mark = side * np.array([design[1], -design[0], 0.0]) / np.hypot(design[0], design[1])
    mark = state.turn(wheel.body) @ mark  # pointed ahead in the wheel's plane at design
    steer = np.arctan2(-left[0], left[1])
    out = {
        "steer": steer,
        "toe": -side * steer,
        "camber": -np.arcsin(axis[2]),
        "spin": np.arctan2(np.cross(mark, ahead) @ -left, mark @ ahead),
    }
    centre = shown[f"{name}.centre"] - wheel.centre
    patch = shown[f"{name}.patch"] - _lowest(wheel.centre, wheel.axis, wheel.radius)
    for place, change in (("wheel_centre", centre), ("contact_point", patch)):
        out |= {f"{place}_{letter}": change[k] for k, letter in enumerate("xyz")}
    return out


def _steering_axes(table: Mapping) -> dict[str, tuple]:
    """Lower and upper point of the steering axis on each side, where ball joints make one."""
    points, own = table["hardpoints"], SIDES[table.get("side", "left")]
    out = {}
    for side, sign in SIDES.items():
        mirror = np.array([1.0, sign * own, 1.0])
        carrier = f"{side}.upright"
        if table["model"] == "double-wishbone":
            names = ((carrier, "lower_ball_joint"), (carrier, "upper_ball_joint"))
        elif table["model"] == "mcpherson":
            carries = (table.get("subframe") or {}).get("carries", ())
            top = "subframe" if "strut_top" in carries else GROUND
            names = ((carrier, "lower_ball_joint"), (top, "strut_top"))
        else:
            continue
        out[side] = tuple((body, mirror * points[point]) for body, point in names)
    return out
