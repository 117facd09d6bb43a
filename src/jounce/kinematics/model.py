"""Kinematic model of a corner: body fixed, wheel centre and rack driven, every quantity a function of the pose.

With all motions driven, a Newton step on the loops gives the pose, the speeds for a unit rate of travel or rack exact
slopes, and the accelerations for constant rates exact curvatures. Nothing depends on masses or gravity. Bushings are
treated as ideal joints.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.remembered import Recent
from jounce.core.turns import once
from jounce.core.types import Array
from jounce.kernel.native import Native, compile_functions
from jounce.kinematics.catalogue import Quantity, quantities
from jounce.kinematics.view import CornerView
from jounce.mechanics.driven import DrivenMechanism, Quasistatic
from jounce.models.attachments import still_third_law, third_law
from jounce.models.corner import suspension
from jounce.parts import Corner, DependentAxle, FullCar3D, Rig
from jounce.parts.rig import structure_of

_TRAVEL, _RACK = "travel", "rack"


@dataclass(frozen=True)
class KinematicModel:
    """Native functions of a corner's poses and quantities.

    ``rows`` are the catalogue's rows for this corner, in the order of the outputs; ``tracks`` the driven motions,
    ``"travel"``, and ``"rack"`` if the wheel steers. ``functions`` has, as CasADi functions, ``pose`` and ``output``
    (see ``kernel.poses``; ``native`` is their machine code), ``points`` (x, y, z of ``point_names``: all hardpoints and
    the contact point) and the ``gradient`` of the loop equations by the speeds; ``joints`` names the joint of each
    equation; ``closure`` is the violation of the loops, and ``yielding`` the slopes of the coordinates by it (its last
    argument). ``across`` returns the ends of connections to the other wheel, if the corner has some; ``third_force`` is
    the law of the third spring. All take the values of the description in the order of ``parameters``; ``start`` is the
    design pose.
    """

    rows: tuple[Quantity, ...]
    tracks: tuple[str, ...]
    parameters: tuple[str, ...]
    joints: tuple[str, ...]
    start: Array
    functions: dict[str, ca.Function]
    native: Native
    point_names: tuple[str, ...]

    def parameter_values(self, rig: Corner) -> Array:
        """Return the values of a description in the order of ``parameters``."""
        values = rig.parameters()
        return np.array([values[path] for path in self.parameters])

    @once
    def points(self) -> Native:
        """Machine code of ``points``, under the name ``output``."""
        return compile_functions({"output": self.functions["points"]})

    @once
    def tangents(self) -> Native:
        """Machine code of the slopes of all rows along a change of tracks and numbers, under the name ``output``.

        Its first argument has the coordinates of a pose, the change of the tracks, and that of ``parameters``. The pose
        changes with them, so that the loops stay closed.
        """
        return self._compile_slopes(self.functions["output"])

    @once
    def place_tangents(self) -> Native:
        """Machine code of the slopes of ``points``, camber and steer (rotation of the wheel's axis)."""
        angles = [
            next(i for i, row in enumerate(self.rows) if row.name == name)
            for name in ("camber", "steer")
        ]
        return self._compile_slopes(
            lambda *at: ca.vertcat(
                self.functions["points"](*at), self.functions["output"](*at)[angles]
            )
        )

    def _compile_slopes(self, values: Callable[..., ca.SX]) -> Native:
        q, u, p, m = (ca.SX.sym(name, n) for name, n in zip("qupm", self._sizes, strict=True))
        inputs = ca.vertcat(u, p)
        change = ca.SX.sym("change", inputs.shape[0])
        opened = ca.jtimes(self.functions["closure"](q, u, p, m), inputs, change)
        displacement = self.functions["yielding"](q, u, p, m, opened)
        slopes = ca.jtimes(
            values(q, u, p, m), ca.vertcat(q, inputs), ca.vertcat(displacement, change)
        )
        function = ca.Function(
            "output", [ca.vertcat(q, change), u, p, m], [ca.cse(ca.densify(slopes))]
        )
        return compile_functions({"output": function})

    @property
    def _sizes(self) -> tuple[int, ...]:
        return tuple(self.functions["output"].size1_in(i) for i in range(4))


_models: Recent[KinematicModel] = Recent()


def kinematic_model(rig: Rig) -> KinematicModel:
    """Return the kinematic model of a corner; corners of the same structure share one model."""
    corner = check_corner(rig)
    return _models.of(structure_of(corner), lambda: _build(_rigid(corner)))


def _rigid(rig: Corner) -> Corner:
    """Return the corner with ideal joints instead of bushings."""
    bushings = getattr(rig, "bushings", None)
    return rig if bushings is None else rig.model_copy(update={"bushings": type(bushings)()})


def check_corner(rig: Rig) -> Corner:
    """Return the rig as a corner; raise an error without hardpoints."""
    if isinstance(rig, Corner):
        return rig
    if isinstance(rig, DependentAxle):
        raise DescriptionError(
            "a dependent axle is not a corner",
            where="rig",
            found=Phrase('model = "{model}"', model=getattr(rig, "model", "")),
            allowed="a rig with hardpoints: double-wishbone, mcpherson, five-link, trailing-arm",
            hint="Sweep it by jn.sweep_travel, sweep_roll or sweep_axle, or test it by jn.kc_test.",
        )
    is_car = isinstance(rig, FullCar3D)
    raise DescriptionError(
        "only one corner can be swept at a time, not a whole car"
        if is_car
        else "a lumped rig has no kinematics",
        where=getattr(rig, "name", None) or "rig",
        found=f'model = "{getattr(rig, "model", type(rig).__name__)}"',
        allowed="a rig with hardpoints: double-wishbone, mcpherson, five-link, trailing-arm",
        hint="Give the rig of its front or rear corner."
        if is_car
        else "Try reference-double-wishbone of `jounce library`.",
    )


def has_rack(rig: Corner) -> bool:
    """Whether a rack moves the wheel: whether there is a tie rod or a toe link."""
    points = rig.hardpoints
    return hasattr(points, "tie_rod_inner") or hasattr(points, "link_5_inner")


def check_rack(rig: Corner, allowed: str = "a corner with a tie rod") -> None:
    """Raise an error if no rack moves the wheel of a corner."""
    if not has_rack(rig):
        model = f'model = "{getattr(rig, "model", "")}"'
        raise DescriptionError(
            "this wheel has no steering rack", where="rack travel", found=model, allowed=allowed
        )


def _build(rig: Corner) -> KinematicModel:
    mechanism = Quasistatic(gravity=ca.SX(0.0))
    tracks = [mechanism.track(name) for name in (_TRAVEL, _RACK)[: 1 + has_rack(rig)]]
    rack = tracks[1] if len(tracks) > 1 else None
    linkage = suspension(rig, mechanism, guide="fixed", rack=rack)
    height = linkage.wheel_centre.value[2] - linkage.number("hardpoints.wheel_centre[2]")
    mechanism.condition("wheel_travel", height - tracks[0].value)
    driven = DrivenMechanism(mechanism, tracks)
    view = CornerView(
        mechanism, linkage, tracks[0], rack, driven.along(1) if rack is not None else None
    )
    rows = quantities(view)
    places = _places(view)
    expressions = {
        "pose": driven.pose(),
        "output": driven.accelerated(ca.vertcat(*(row.formula(view) for row in rows))),
        "points": ca.vertcat(*(place for _, place in places)),
        "gradient": driven.gradient,
        "closure": driven.statics.constraint,
    }
    has_third_spring = rig.third_spring is not None
    if has_third_spring or (rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "t"):
        expressions["across"] = driven.accelerated(view.across)
    length = ca.SX.sym("length")
    if has_third_spring:
        expressions["third_force"] = ca.vertcat(
            third_law(linkage, length), still_third_law(linkage, length)
        )
    parameters = _occurring(mechanism, expressions)
    arguments = [
        driven.statics.q,
        ca.vertcat(*(track.value for track in tracks)),
        ca.vertcat(*parameters.values()),
        ca.SX.sym("m", 1),
    ]
    law = expressions.pop("third_force", None)
    functions = {
        name: ca.Function(name, arguments, [ca.cse(ca.densify(part))])
        for name, part in expressions.items()
    }
    if law is not None:
        functions["third_force"] = ca.Function("third_force", [arguments[2], length], [law])
    opened = ca.SX.sym("opened", driven.statics.constraint.shape[0])
    functions["yielding"] = ca.Function("yielding", [*arguments, opened], [driven.yielding(opened)])
    return KinematicModel(
        rows=rows,
        tracks=(_TRAVEL, _RACK)[: len(tracks)],
        parameters=tuple(parameters),
        joints=driven.statics.joints,
        start=np.array(driven.statics.start, dtype=float),
        functions=functions,
        native=compile_functions({name: functions[name] for name in ("pose", "output")}),
        point_names=tuple(name for name, _ in places),
    )


def _occurring(mechanism: Quasistatic, expressions: dict[str, ca.SX]) -> dict[str, ca.SX]:
    """Return the parameters of the description that occur in the expressions (no masses)."""
    used = {
        symbol.name()
        for symbol in ca.symvar(ca.vertcat(*(ca.vec(part) for part in expressions.values())))
    }
    return {path: symbol for path, symbol in mechanism.parameter_symbols().items() if path in used}


def _places(view: CornerView) -> list[tuple[str, ca.SX]]:
    """Return the positions of all hardpoints and of the contact point, ground axes, m."""
    linkage = view.linkage
    names = [
        name
        for name in type(linkage.rig.hardpoints).model_fields
        if getattr(linkage.rig.hardpoints, name)
    ]
    own = view.bar_points if linkage.rig.anti_roll_bar is not None else {}
    places = []
    for name in names:
        owner, place = linkage.owners.get(name), linkage.hardpoint(name)
        places.append(
            (name, own.get(name, place if owner is None else owner.frame.point(place).value))
        )
    mirror = ca.SX([1.0, view.side, 1.0])
    return [*places, ("contact_point", mirror * view.contact)]
