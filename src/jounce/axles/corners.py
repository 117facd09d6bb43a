"""The axle on its rig: bodies, joints, bushings and springs of both sides, from the description of a corner.

The left wheel is the corner's (or its mirror image), the right one its mirror image. What both sides share is built
once: subframe, rack and its housing, and the anti-roll bar between its halves.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from jounce.axles.assembly import GROUND, cross, unit
from jounce.axles.builder import LEFT, SIDES, AxleBuilder
from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.parts import Corner
from jounce.parts.leverage import AXES

_CENTRED = 1e-9  # m: a mount in the centre plane is its own mirror image


class BuiltAxle(AxleBuilder):
    """An axle of a corner and its mirror image."""

    rig: Corner

    # the axle --------------------------------------------------------------------------------------------------------

    def _build(self) -> None:
        rig = self.rig
        self._add_subframe()
        self.steered = self._add_rack()
        for side in SIDES:
            self.side = side
            template = getattr(self, "_" + rig.model.replace("-", "_"), None)  # type: ignore[attr-defined]
            if template is None:
                raise DescriptionError(
                    "the K&C rig does not know this suspension",
                    where="model",
                    found=Phrase(str(getattr(rig, "model", ""))),
                    allowed="double-wishbone, mcpherson, five-link, trailing-arm",
                )
            template()
            self._add_rocker()
            self.add_strut()
            self._add_torsion_bar()
            self.add_wheel()
        self.add_bar()
        self.add_third_spring()

    def _add_subframe(self) -> None:
        frame = self.rig.subframe
        if frame is not None:
            self._mount("subframe.mounts", frame.mounts, self.shared("subframe"), GROUND)

    def _mount(self, path: str, mounts: Any, body: int, holder: int) -> None:
        for i, mount in enumerate(mounts):
            sides = SIDES if abs(mount.point[1]) > _CENTRED else (self.rig.side,)
            for side in sides:
                self.side = side
                at = self.vector(f"{path}[{i}].point")
                self.soft(f"{path}[{i}]", mount, f"{side}.{path}[{i}]", holder, body, at)

    def _add_rack(self) -> bool:
        """Add the rack in its housing; its travel is a control. Return whether there is one."""
        inner = {"tie_rod_inner", "link_5_inner"} & set(type(self.rig.hardpoints).model_fields)
        if not inner:
            return False
        steering = getattr(self.rig, "steering", None)
        self.side = "left"
        at = self.point(inner.pop()) * np.array([[1.0], [0.0], [1.0]])
        holder = self.holder("rack")
        housing = getattr(steering, "housing", ())
        if housing:
            body = self.shared("housing")
            self._mount("steering.housing", housing, body, holder)
            holder = body
        rack = self.shared("rack")
        self.assembly.slide("rack", holder, rack, at, LEFT + 0.0 * at)
        driven = rack
        if getattr(steering, "column_stiffness", None) is not None:
            # The pinion, seen at the rack: a slide that the handwheel drives, and the rack on a spring beside it.
            driven = self.shared("pinion")
            self.assembly.slide("pinion", holder, driven, at, LEFT + 0.0 * at)
            rate = self.number("steering.column_stiffness")
            rate = rate / self.number("steering.rack_ratio") ** 2
            if getattr(steering, "assistance", None) is not None:
                rate = rate * (1.0 + self.number("steering.assistance"))
            zero = 0.0 * rate
            stiffness = np.stack([zero, rate, zero, zero, zero, zero])
            self.assembly.bushing("column", driven, rack, at, stiffness=stiffness)
        self.assembly.along("rack", holder, driven, (at, at), LEFT + 0.0 * at, is_control=True)
        return True

    def _steered_holder(self, point: str) -> int:
        return self.shared("rack") if self.steered else self.holder(point)

    def _arm(self, name: str) -> int:
        arm = self.own(name)
        self.turning(name, arm, (f"{name}_front", f"{name}_rear"))
        return self._yielding(name, arm)

    def _yielding(self, name: str, arm: int) -> int:
        """Return the end of an arm at its ball joint, on a spring of the arm's stiffness if it has one."""
        if getattr(self.rig.links, name, None) is None:
            return arm
        end = self.own(f"{name}.end")
        rate = self.number(f"links.{name}.stiffness")
        zero = 0.0 * rate
        ball = self.point(name.replace("arm", "ball_joint"))
        stiffness = np.stack([rate, rate, rate, zero, zero, zero])
        label, axes = self.called(f"{name}.end"), np.eye(3)[:, :, None] * self.mirror[None]
        axes = np.broadcast_to(axes, (3, 3, self.assembly.columns))
        self.assembly.bushing(label, arm, end, ball, stiffness=stiffness, axes=axes)
        self.assembly.parallel(label, arm, end)
        return end

    def _double_wishbone(self) -> None:
        lower, upper, upright = self._arm("lower_arm"), self._arm("upper_arm"), self.own("upright")
        self.joint("lower_ball_joint", lower, upright)
        self.joint("upper_ball_joint", upper, upright)
        self.rod(
            "tie_rod",
            ("tie_rod_inner", "tie_rod_outer"),
            (self._steered_holder("tie_rod_inner"), upright),
        )
        self.upright[self.side] = upright
        bottom, top = self.point("lower_ball_joint"), self.point("upper_ball_joint")
        self.steering_axis[self.side] = ((upright, bottom), (upright, top))

    def _mcpherson(self) -> None:
        lower, upright, strut = self._arm("lower_arm"), self.own("upright"), self.own("strut")
        self.joint("lower_ball_joint", lower, upright)
        foot, top = self.point("strut_bottom"), self.point("strut_top")
        self.assembly.slide(self.called("strut"), upright, strut, foot, top - foot)
        self.joint("strut_top", self.holder("strut_top"), strut)
        self.rod(
            "tie_rod",
            ("tie_rod_inner", "tie_rod_outer"),
            (self._steered_holder("tie_rod_inner"), upright),
        )
        self.upright[self.side] = upright
        bottom = self.point("lower_ball_joint")
        self.steering_axis[self.side] = ((upright, bottom), (self.holder("strut_top"), top))

    def _five_link(self) -> None:
        upright = self.own("upright")
        for i in range(1, 6):
            inner = f"link_{i}_inner"
            holder = self._steered_holder(inner) if i == 5 else self.holder(inner)
            self.rod(f"link_{i}", (inner, f"link_{i}_outer"), (holder, upright))
        self.upright[self.side] = upright

    def _trailing_arm(self) -> None:
        arm = self.own("arm")
        self.turning("arm", arm, ("arm_outer", "arm_inner"))
        self.upright[self.side] = arm

    def carrier(self, name: str) -> int:
        """Return the body of this side with a name used in descriptions."""
        if name == "upright":
            return self.upright[self.side]
        return self.bodies[self.called(name)]

    def _add_rocker(self) -> None:
        if not self.has("rocker_pivot"):
            return
        rocker = self.own("rocker")
        self.carry(rocker, "rocker_pivot", "rocker_axis")
        if self.is_soft("rocker_pivot"):
            self.joint("rocker_pivot", self.holder("rocker_pivot"), rocker)
        else:
            points, holder = (
                (self.point("rocker_pivot"), self.point("rocker_axis")),
                self.holder("rocker_pivot"),
            )
            self.assembly.hinge(self.called("rocker"), (holder, holder), rocker, points)
        foot = getattr(self.rig.strut, "pushrod_on", "upright")
        self.rod("pushrod", ("pushrod_outer", "pushrod_inner"), (self.carrier(foot), rocker))

    def _add_torsion_bar(self) -> None:
        bar = self.rig.torsion_bar
        if bar is None:
            return
        first, other, tip = AXES[bar.on]
        pivot = self.point(first)
        axis = unit(self.point(other) - pivot)
        lever = self.point(tip) - pivot
        ahead = cross(axis, lever)[2].real
        if bar.on == "rocker":
            rod = self.point("pushrod_inner") - self.point("pushrod_outer")
            turned = cross(axis, lever)
            ahead = (np.sum(rod * turned, axis=0) * rod[2]).real
        axis = axis * np.where(ahead < 0.0, -1.0, 1.0)
        self.assembly.twist(
            self.called("torsion_bar"),
            self.holder(first),
            self.carrier(bar.on),
            axis,
            self.number("torsion_bar.stiffness"),
            -self.number("torsion_bar.preload"),
        )
