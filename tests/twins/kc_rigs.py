"""Rig files as plain data of the oracle (``kc_oracle``): corners, and axles of a corner and its mirror image.

A table is what a file contains, as numbers in SI: ``rig.model_dump(by_alias=True, exclude_none=True)``. Bodies of an
axle are called ``left.upright`` and so on; the body of the car is the ground.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from kc_oracle import GROUND, Data, Wheel, energy_of

SIDES = {"left": 1.0, "right": -1.0}
_ARMS = {"double-wishbone": ("lower", "upper"), "mcpherson": ("lower",)}
_NONE: dict = {}


def read_axle(table: Mapping, sides: Sequence[str] = tuple(SIDES)) -> Data:
    """Left and right wheel of a corner's table, with what joins them."""
    return _Axle(table, sides).build()


def law_of(spring: Mapping) -> dict:
    """Law of a spring, a curve in place of its rate."""
    law = {"preload": spring.get("preload") or 0.0}
    return law | (curve_of(spring["curve"]) if spring.get("curve") else {"rate": spring["rate"]})


def curve_of(curve: Mapping) -> dict:
    """Law of a curve of force over deflection, or of torque over angle."""
    kind = curve["kind"]
    if kind == "polynomial":
        return {"polynomial": tuple(curve["coefficients"])}
    if kind == "power":
        return {"power": (curve["coefficient"], curve["exponent"])}
    assert kind == "table", kind
    columns = [value for key, value in curve.items() if key != "kind"]
    assert len(columns) == 2, curve
    return {"table": tuple(columns)}


class _Axle:
    def __init__(self, table: Mapping, sides: Sequence[str]) -> None:
        self.table, self.sides, self.data = table, sides, Data()
        self.own = SIDES[table.get("side", "left")]
        self.points = table["hardpoints"]
        self.bushings = table.get("bushings") or _NONE
        self.links = table.get("links") or _NONE
        self.carried = tuple((table.get("subframe") or _NONE).get("carries", ()))
        self.sign = 1.0

    # points and bodies -------------------------------------------------------------------------------------------

    def mirror(self, vector: Sequence[float]) -> np.ndarray:
        """A point or direction of the description on the side at hand."""
        return np.asarray(vector, dtype=float) * [1.0, self.sign, 1.0]

    def at(self, name: str) -> np.ndarray:
        element, _, end = name.partition("_")
        if name not in self.points and element in ("spring", "damper"):
            name = f"strut_{end}"
        return self.mirror(self.points[name])

    def has(self, *names: str) -> bool:
        return all(name in self.points for name in names)

    def body(self, name: str, reference: str) -> str:
        full = f"{self.side}.{name}"
        self.data.bodies[full] = tuple(self.at(reference))
        return full

    def holder(self, hardpoint: str) -> str:
        """The car's body, or the subframe that carries a hardpoint."""
        return "subframe" if hardpoint in self.carried else GROUND

    # joints ------------------------------------------------------------------------------------------------------

    def joint(self, kind: str, name: str, first: str, second: str, **row) -> None:
        self.data.joints.append(
            {"kind": kind, "name": f"{self.side}.{name}", "first": first, "second": second, **row}
        )

    def cushion(self, point: str, first: str, second: str) -> None:
        """The bushing at a hardpoint; the wheel's side is the second body."""
        self.bush(f"{self.side}.{point}", self.bushings[point], self.at(point), first, second)

    def bush(self, name: str, given: Mapping, at: Sequence[float], first: str, second: str) -> None:
        """A bushing of a description; on the other side it is what a mirror shows."""
        row = {
            "kind": "bushing", "name": name, "first": first, "second": second, "at": tuple(at),
            "stiffness": given["stiffness"],
            "rotational_stiffness": given.get("rotational_stiffness") or (0.0, 0.0, 0.0),
            "preload": (*(given.get("preload") or (0.0, 0.0, 0.0)),
                        *(given.get("rotational_preload") or (0.0, 0.0, 0.0))),
            "curves": {key: curve_of(c) for key, c in (given.get("curves") or {}).items() if c},
            "axes": axes_of(given), "mirrored": self.sign < 0.0, "friction": friction_of(given),
        }  # fmt: skip
        self.data.elastic.append(row)

    def ball(self, point: str, first: str, second: str) -> None:
        """A ball joint, or the bushing in its place; an arm that yields has a tip of its own before it."""
        arm = point.replace("ball_joint", "arm")
        stiffness = (self.links.get(arm) or _NONE).get("stiffness") if arm != point else None
        if stiffness is not None:
            tip = self.body(f"{arm}_tip", point)
            self.bush(
                f"{self.side}.{arm}.end", {"stiffness": [stiffness] * 3}, self.at(point), first, tip
            )
            self.joint("aligned", f"{arm}_tip", first, tip)
            first = tip
        if point in self.bushings:
            self.cushion(point, first, second)
        else:
            self.joint("spherical", point, first, second, at=self.at(point))

    def pivot(self, name: str, arm: str, ends: tuple[str, str]) -> None:
        """An arm on two hardpoints of the body: a hinge if both are ideal."""
        holder = self.holder(ends[0])
        if any(end in self.bushings for end in ends):
            for end in ends:
                self.ball(end, self.holder(end), arm)
        else:
            at, end = (self.at(each) for each in ends)
            self.joint("revolute", name, holder, arm, at=at, end=end)

    def link(self, name: str, first: tuple[str, str], second: tuple[str, str]) -> None:
        """A link between a point of one body and a point of another: (body, point)."""
        (holder, inner), (carrier, outer) = first, second
        start, end = self.at(inner), self.at(outer)
        stretch = (self.links.get(name) or _NONE).get("stiffness")
        soft = [point for point in (inner, outer) if point in self.bushings]
        if not soft and name not in self.carriers:
            row = {"first": holder, "second": carrier, "at": start, "end": end}
            if stretch is None:
                self.data.joints.append({"kind": "rod", "name": f"{self.side}.{name}", **row})
            else:
                law = {"rate": stretch}
                self.data.elastic.append(
                    {"kind": "spring", "name": f"{self.side}.{name}", "law": law, **row}
                )
            return
        link = far = self.carriers.get(name) or self.body(name, inner)
        self.carriers[name] = link
        if stretch is not None:  # two halves that slide in each other against a spring
            far, row = self.body(f"{name}_far", outer), {"at": end, "axis": end - start}
            self.joint("prismatic", f"{name}_stretch", link, far, **row)
            row = {"first": link, "second": far, "at": start, "end": end, "law": {"rate": stretch}}
            self.data.elastic.append({"kind": "spring", "name": f"{self.side}.{name}", **row})
        self.ball(inner, holder, link)
        self.ball(outer, far, carrier)
        if not any(_resists_turns(self.bushings[point]) for point in soft):
            along = (end - start) / np.linalg.norm(end - start)
            across = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
            across /= np.linalg.norm(across)
            self.joint(
                "perpendicular", f"{name}_spin", holder, link,
                axis=np.cross(across, along), other=across,
            )  # fmt: skip

    # suspensions -------------------------------------------------------------------------------------------------

    def build(self) -> Data:
        table = self.table
        self.side = "axle"
        if table.get("subframe"):
            self.add_subframe(table["subframe"])
        self.steered = self.has("tie_rod_inner") or self.has("link_5_inner")
        if self.steered:
            self.add_rack(table.get("steering") or _NONE)
        if table["model"] == "solid-axle":
            self.add_beam_axle()
        for side in self.sides:
            self.side, self.sign = side, SIDES[side] * self.own
            self.carriers: dict[str, str] = {}
            {
                "double-wishbone": self.double_wishbone,
                "mcpherson": self.mcpherson,
                "five-link": self.five_link,
                "trailing-arm": self.trailing_arm,
                "solid-axle": self.solid_axle,
                "twist-beam": self.twist_beam,
            }[table["model"]]()
            self.add_rocker()
            self.add_strut()
            self.add_torsion_bar()
            self.add_wheel()
        if table["model"] == "twist-beam":
            self.add_beam(table["beam"])
        self.add_bar()
        self.add_third_spring()
        return self.data

    def arm(self, name: str) -> str:
        arm = self.carriers[name] = self.body(name, f"{name}_front")
        self.pivot(name, arm, (f"{name}_front", f"{name}_rear"))
        return arm

    def double_wishbone(self) -> None:
        lower, upper = self.arm("lower_arm"), self.arm("upper_arm")
        upright = self.carry("upright", "wheel_centre")
        self.ball("lower_ball_joint", lower, upright)
        self.ball("upper_ball_joint", upper, upright)
        self.link("tie_rod", self.rack_end("tie_rod_inner"), (upright, "tie_rod_outer"))

    def mcpherson(self) -> None:
        lower = self.arm("lower_arm")
        upright = self.carry("upright", "wheel_centre")
        self.ball("lower_ball_joint", lower, upright)
        self.link("tie_rod", self.rack_end("tie_rod_inner"), (upright, "tie_rod_outer"))
        foot, top = self.at("strut_bottom"), self.at("strut_top")
        if "strut_top" not in self.bushings:
            row = {"at": foot, "axis": top - foot, "point": top}
            self.joint("point on line", "strut_slider", upright, self.holder("strut_top"), **row)
            return
        strut = self.carriers["strut"] = self.body("strut", "strut_top")
        self.joint("prismatic", "strut_slider", upright, strut, at=foot, axis=top - foot)
        self.cushion("strut_top", self.holder("strut_top"), strut)

    def five_link(self) -> None:
        upright = self.carry("upright", "wheel_centre")
        used = {self.table.get("strut", _NONE).get("on")}
        for i in range(1, 6):
            name, inner = f"link_{i}", f"link_{i}_inner"
            if name in used:
                self.carriers[name] = self.body(name, inner)
            start = self.rack_end(inner) if i == 5 else (self.holder(inner), inner)
            self.link(name, start, (upright, f"link_{i}_outer"))

    def trailing_arm(self) -> None:
        arm = self.carry("arm", "arm_outer")
        self.pivot("arm", arm, ("arm_outer", "arm_inner"))

    # dependent axles ---------------------------------------------------------------------------------------------

    def add_beam_axle(self) -> None:
        """The beam of a solid axle, and what guides it once."""
        centre = self.points["wheel_centre"]
        self.data.bodies["axle"] = (centre[0], 0.0, centre[2])
        self.side, self.carriers = "left", {}
        if self._upper_is_single:
            self.link("upper_link", (GROUND, "upper_link_body"), ("axle", "upper_link_axle"))
        if self.has("panhard_axle"):
            self.link("panhard", (GROUND, "panhard_body"), ("axle", "panhard_axle"))
        if self.has("watt_pivot"):
            pivot = self.at("watt_pivot")
            self.data.bodies["watt"] = tuple(pivot)
            self.joint("revolute", "watt_pivot", "axle", "watt", at=pivot, end=pivot + np.eye(3)[0])
            for name in ("watt_upper", "watt_lower"):
                self.link(name, (GROUND, f"{name}_body"), ("watt", f"{name}_axle"))

    @property
    def _upper_is_single(self) -> bool:
        names = ("upper_link_body", "upper_link_axle")
        return self.has(*names) and all(abs(self.points[name][1]) < 1e-9 for name in names)

    def solid_axle(self) -> None:
        self.carriers |= {"axle": "axle", "upright": "axle"}
        self.link("lower_link", (GROUND, "lower_link_body"), ("axle", "lower_link_axle"))
        if self.has("upper_link_axle") and not self._upper_is_single:
            self.link("upper_link", (GROUND, "upper_link_body"), ("axle", "upper_link_axle"))

    def twist_beam(self) -> None:
        """Half of a twist beam. Between ideal pivots a twisted beam is too long: the right one slides along y."""
        half, pivot = self.carry("axle", "pivot"), self.at("pivot")
        if "pivot" in self.bushings:
            self.cushion("pivot", GROUND, half)
        elif self.side == "left":
            self.joint("spherical", "pivot", GROUND, half, at=pivot)
        else:
            row = {"at": pivot, "axis": (0.0, 1.0, 0.0), "point": pivot}
            self.joint("point on line", "pivot", GROUND, half, **row)

    def add_beam(self, beam: Mapping) -> None:
        """The beam between the halves: it only twists, about the line across through its shear centre."""
        middle, ends = self.at("shear_centre"), {"first": "left.axle", "second": "right.axle"}
        row = {"at": middle, "end": middle + np.eye(3)[1]}
        self.data.joints.append({"kind": "revolute", "name": "beam", **ends, **row})
        law = {"rate": beam["torsional_stiffness"]}
        twist = {"kind": "twist", "name": "beam", "axis": (0.0, 1.0, 0.0), "law": law}
        self.data.elastic.append(twist | ends)

    def carry(self, name: str, reference: str) -> str:
        """The body that carries the wheel."""
        body = self.carriers[name] = self.carriers["upright"] = self.body(name, reference)
        return body

    def rack_end(self, inner: str) -> tuple[str, str]:
        return ("rack" if self.steered else self.holder(inner)), inner

    # what they carry ---------------------------------------------------------------------------------------------

    def add_wheel(self) -> None:
        wheel, carrier = self.table["wheel"], self.carriers["upright"]
        camber, toe = wheel.get("camber") or 0.0, wheel.get("toe") or 0.0
        side = SIDES[self.side]
        axis = (
            np.sin(toe) * np.cos(camber), side * np.cos(toe) * np.cos(camber), -np.sin(camber),
        )  # fmt: skip
        centre = tuple(self.at("wheel_centre"))
        bearing = self.table.get("bearing")
        if bearing:
            carrier = self.add_bearing(bearing, carrier, centre, np.array(axis))
        self.data.wheels[self.side] = Wheel(carrier, centre, axis, wheel["radius"])

    def add_bearing(self, bearing: Mapping, carrier: str, centre, axis: np.ndarray) -> str:
        """The hub on its bearing: y along the wheel's axis, z up in the wheel's plane; rigid where nothing is given."""
        hub = self.carriers["hub"] = self.body("hub", "wheel_centre")
        across = axis * SIDES[self.side]  # to the left
        up = np.array([0.0, 0.0, 1.0]) - across[2] * across
        up /= np.linalg.norm(up)
        seen = np.array([1.0, SIDES[self.side], 1.0])  # the right side is what a mirror shows
        given = {"x_axis": seen * np.cross(across, up), "z_axis": seen * up}
        stiffness, turning = bearing.get("stiffness"), bearing.get("rotational_stiffness")
        row = {
            "kind": "bushing", "name": f"{self.side}.bearing", "first": carrier, "second": hub,
            "at": centre, "axes": axes_of(given), "stiffness": stiffness or (0.0, 0.0, 0.0),
            "rotational_stiffness": (turning[0], 0.0, turning[2]) if turning else (0.0, 0.0, 0.0),
            "mirrored": self.side == "right",
        }  # fmt: skip
        self.data.elastic.append(row)
        if stiffness is None:
            self.joint("spherical", "bearing", carrier, hub, at=centre)
        if turning is None:
            self.joint("aligned", "bearing_turn", carrier, hub)
        else:
            ahead = np.cross(across, up)
            self.joint("perpendicular", "bearing_spin", carrier, hub, axis=ahead, other=up)
        return hub

    def add_rocker(self) -> None:
        if not self.has("rocker_pivot"):
            return
        rocker = self.carriers["rocker"] = self.body("rocker", "rocker_pivot")
        holder = self.holder("rocker_pivot")
        if "rocker_pivot" in self.bushings:
            self.cushion("rocker_pivot", holder, rocker)
        else:
            ends = {"at": self.at("rocker_pivot"), "end": self.at("rocker_axis")}
            self.joint("revolute", "rocker", holder, rocker, **ends)
        foot = self.carriers[self.table["strut"].get("pushrod_on", "upright")]
        self.link("pushrod", (foot, "pushrod_outer"), (rocker, "pushrod_inner"))

    def strut_end(self, element: str, end: str) -> tuple[str, np.ndarray]:
        """Body and point at which a spring ends: a bushing's outer part, if there is one."""
        own = f"{element}_{end}"
        name = own if own in self.points else f"strut_{end}"
        body = self.carriers[self.table["strut"]["on"]] if end == "bottom" else self.holder(name)
        if name in self.bushings and not (
            self.table["model"] == "mcpherson" and name == "strut_top"
        ):
            if name not in self.carriers:  # it turns with the body that carries it
                self.carriers[name] = self.body(name, name)
                self.cushion(name, body, self.carriers[name])
                self.joint("aligned", name, body, self.carriers[name])
            body = self.carriers[name]
        return body, self.at(name)

    def add_strut(self) -> None:
        strut = self.table.get("strut") or _NONE
        if not self.has("strut_bottom") or "spring" not in strut:
            return
        spring = strut["spring"]
        (first, at), (second, end) = (self.strut_end("spring", each) for each in ("bottom", "top"))
        row = {"kind": "spring", "first": first, "second": second, "at": at, "end": end}
        own = {"name": f"{self.side}.spring", "law": law_of(spring)}
        if spring.get("free_length"):
            own["length"] = spring["free_length"]
        self.data.elastic.append(row | own)
        for name in ("bump_stop", "rebound_stop"):
            if strut.get(name):
                own = {"name": f"{self.side}.{name}", "law": {name: strut[name]}}
                self.data.elastic.append(row | own)
        friction = strut.get("friction")
        if friction:
            (first, at), (second, end) = (self.strut_end("damper", e) for e in ("bottom", "top"))
            row = {"kind": "spring", "first": first, "second": second, "at": at, "end": end}
            hold = friction["force"] / (friction.get("presliding_distance") or 1e-4)
            dry = {"x": {"force": friction["force"], "hold": hold}}
            own = {"name": f"{self.side}.friction", "law": {}, "friction": dry}
            self.data.elastic.append(row | own)

    def add_torsion_bar(self) -> None:
        bar = self.table.get("torsion_bar")
        if not bar:
            return
        names = {"lower_arm": "lower", "upper_arm": "upper"}.get(bar["on"])
        first, other, tip = (
            ("arm_outer", "arm_inner", "wheel_centre") if names is None
            else (f"{names}_arm_front", f"{names}_arm_rear", f"{names}_ball_joint")
        )  # fmt: skip
        axis = self.at(other) - self.at(first)
        axis *= np.sign(np.cross(axis, self.at(tip) - self.at(first))[2])
        law = {"rate": bar["stiffness"], "preload": bar.get("preload") or 0.0}
        ends = {"first": self.holder(first), "second": self.carriers[bar["on"]], "axis": axis}
        self.data.elastic.append(
            {"kind": "twist", "name": f"{self.side}.torsion_bar", "law": law, **ends}
        )

    # what joins the wheels ---------------------------------------------------------------------------------------

    def add_rack(self, steering: Mapping) -> None:
        middle = self.points.get("tie_rod_inner") or self.points["link_5_inner"]
        at = (middle[0], 0.0, middle[2])
        housing = "subframe" if "rack" in self.carried else GROUND
        if steering.get("housing"):
            self.data.bodies["housing"] = at
            for i, mount in enumerate(steering["housing"]):
                for side in self.both(mount["point"]):
                    point = self.mirror(mount["point"])
                    self.bush(f"{side}.steering.housing[{i}]", mount, point, housing, "housing")
            housing = "housing"
        self.data.bodies["rack"] = at
        self.joint("prismatic", "rack", housing, "rack", at=at, axis=(0.0, 1.0, 0.0))
        row = {"axis": (0.0, 1.0, 0.0), "at": at}
        self.data.rack = {"first": housing, "second": "rack", **row}
        if steering.get("column_stiffness"):  # the handwheel drives a pinion, seen at the rack
            self.data.bodies["pinion"] = at
            self.joint("prismatic", "pinion", housing, "pinion", **row)
            self.data.rack |= {"second": "pinion"}
            hand = 1.0 + (steering.get("assistance") or 0.0)
            rate = hand * steering["column_stiffness"] / steering["rack_ratio"] ** 2
            ends = {"first": "pinion", "second": "rack"}
            column = {"kind": "bushing", "name": "column", "stiffness": (0.0, rate, 0.0)}
            self.data.elastic.append(column | ends | {"at": at})

    def add_subframe(self, subframe: Mapping) -> None:
        mounts = subframe["mounts"]
        middle = np.mean([mount["point"] for mount in mounts], axis=0)
        self.data.bodies["subframe"] = (middle[0], 0.0, middle[2])
        for i, mount in enumerate(mounts):
            for side in self.both(mount["point"]):
                point = self.mirror(mount["point"])
                self.bush(f"{side}.subframe.mounts[{i}]", mount, point, GROUND, "subframe")

    def both(self, point: Sequence[float]):
        """Both sides of a mount that is given on one side and mirrored; in the middle it stands once."""
        middle = abs(point[1]) < 1e-9
        for side, sign in SIDES.items():
            if middle and sign != self.own:
                continue
            self.sign = sign * self.own
            yield side
        self.sign = 1.0

    def add_bar(self) -> None:
        bar = self.table.get("anti_roll_bar")
        if not bar or len(self.sides) < 2:
            return
        assert bar.get("kind", "u") in ("u", "z"), "a T-bar"
        assert not bar.get("blade"), "blades"
        axes, halves, holder = [], [], self.holder("arb_pivot")
        table_is_solid = self.table["model"] == "solid-axle"
        for side in self.sides:
            self.side, self.sign = side, SIDES[side] * self.own
            on = "axle" if table_is_solid else f"{side}.{bar['on']}"
            self.carriers = {bar["on"]: on}
            pivot = self.at("arb_pivot")
            axis = (
                self.at("arb_axis") - pivot if self.has("arb_axis") else np.array([0.0, 1.0, 0.0])
            )
            axes.append(axis / np.linalg.norm(axis) * (-1.0 if axis[1] < 0.0 else 1.0))
            halves.append(self.body("anti_roll_bar", "arb_pivot"))
            if "arb_pivot" in self.bushings:
                self.cushion("arb_pivot", holder, halves[-1])
            else:
                ends = {"at": pivot, "end": pivot + axes[-1]}
                self.joint("revolute", "arb_pivot", holder, halves[-1], **ends)
            arm, far = (halves[-1], "arb_arm_end"), (self.carriers[bar["on"]], "arb_link_end")
            self.link("arb_link", arm, far)
        law = {"rate": bar["stiffness"]}
        if "arb_pivot" in self.bushings:  # the halves stay in line and twist against each other
            assert bar.get("kind", "u") == "u", "a Z-bar on bushings"
            ends = {"first": halves[0], "second": halves[1]}
            self.side = "axle"
            self.joint("revolute", "anti_roll_bar", **ends, at=pivot, end=pivot + axes[-1])
            row = {"kind": "twist", "axis": axes[0], "law": law, **ends}
        else:
            sign = -1.0 if bar.get("kind", "u") == "u" else 1.0
            row = {"kind": "bar", "holder": holder, "halves": halves, "axes": axes, "sign": sign}
        self.data.elastic.append({"name": "arb", "law": law, **row})

    def add_third_spring(self) -> None:
        third = self.table.get("third_spring")
        if not third or len(self.sides) < 2:
            return
        left, right = (
            np.multiply(self.points["third_spring_end"], (1.0, s * self.own, 1.0))
            for s in (1.0, -1.0)
        )
        row = {
            "kind": "spring", "name": "third_spring", "first": f"left.{third['on']}", "at": left,
            "second": f"right.{third['on']}", "end": right, "law": law_of(third["spring"]),
        }  # fmt: skip
        if third["spring"].get("free_length"):
            row["length"] = third["spring"]["free_length"]
        self.data.elastic.append(row)


def _resists_turns(bushing: Mapping) -> bool:
    """Whether a bushing holds its link against turning about itself."""
    turning = list(bushing.get("rotational_stiffness") or (0.0, 0.0, 0.0))
    for i, name in enumerate(("rx", "ry", "rz")):
        curve = (bushing.get("curves") or _NONE).get(name)
        if curve:  # stiff at design
            step = 1e-6
            law = curve_of(curve)
            energies = [float(energy_of(law, x)) for x in (-step, 0.0, step)]
            turning[i] = (energies[0] - 2.0 * energies[1] + energies[2]) / step**2
    return all(rate > 0.0 for rate in turning)


def friction_of(given: Mapping) -> dict:
    """Friction of a bushing by direction; it builds up within 0.1 mm or 0.1 deg unless a stiffness is given."""
    out = {}
    for names, prefix, travel in (
        (("x", "y", "z"), "", 1e-4), (("rx", "ry", "rz"), "rotational_", np.radians(0.1)),
    ):  # fmt: skip
        forces = given.get(f"{prefix}friction") or (0.0, 0.0, 0.0)
        holds = given.get(f"{prefix}friction_stiffness") or [force / travel for force in forces]
        for name, force, hold in zip(names, forces, holds, strict=True):
            if force:
                out[name] = {"force": force, "hold": hold}
    return out


def axes_of(given: Mapping) -> np.ndarray:
    """Axes of a bushing as rows: x as given, z as given but normal to x, y completes them."""
    x = given.get("x_axis")
    z = given.get("z_axis")
    if x is None and z is None:
        return np.eye(3)
    if x is None:
        z = np.asarray(z, dtype=float) / np.linalg.norm(z)
        other = np.eye(3)[np.argmin(np.abs(z))]
        x = other - (other @ z) * z
    x = np.asarray(x, dtype=float) / np.linalg.norm(x)
    z = np.array([0.0, 0.0, 1.0] if z is None else z, dtype=float)
    z = z - (z @ x) * x
    z /= np.linalg.norm(z)
    return np.array([x, np.cross(z, x), z])
