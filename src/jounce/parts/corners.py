"""3-D rigs: one corner of a car as rigid bodies between named hardpoints, one class per suspension type."""

from __future__ import annotations

import sys
from itertools import combinations
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, Union

from pydantic import (
    Field,
    SerializerFunctionWrapHandler,
    create_model,
    model_serializer,
    model_validator,
)

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import DescriptionError, nearest, show_value
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import Acceleration, Angle, Mass, PositiveLength
from jounce.parts.bodies import Inertia, Point, RigidBody, distance
from jounce.parts.bushings import Bushing, Link, Subframe, WheelBearing, mirror_bushing
from jounce.parts.elements import (
    AntiRollBar,
    CornerTyre,
    Friction,
    SpatialStrut,
    Steering,
    ThirdSpring,
    TorsionBar,
)
from jounce.parts.points import SAME_POINT, Axes, Groups, NamedPoints, write_point
from jounce.parts.rig import Rig

_NO_BODY = {
    "mass": 1.0,
    "centre_of_mass": (0.0, 0.0, 0.0),
    "inertia": {"xx": 1.0, "yy": 1.0, "zz": 1.0},
}
_NO_SPRING = {"rate": 1.0}
_ON_ROCKER = {"on": "rocker"}
_OWN_ENDS = ("spring_bottom", "spring_top", "damper_bottom", "damper_top")
_STANDING_IN = {
    "bodies": "bodies.",
    "spring": "strut.spring.",
    "damper": "strut.damper.",
    "tyre": "tyre.",
}
_TABLES = {
    "bodies": "[bodies] and [sprung]",
    "strut": "the ends of the strut (hardpoints.strut_bottom and strut_top)",
    "spring": "strut.spring",
    "damper": "strut.damper",
    "tyre": "[tyre]",
}
_ENDS = ("strut_bottom", "strut_top", *_OWN_ENDS)
_ON_BODY = ("strut_top", "spring_top", "damper_top", "arb_pivot")
_ON_BAR = ("arb_pivot", "arb_arm_end", "arb_link_end")
_ON_ROCKER_JOINTS = ("pushrod_outer", "pushrod_inner", "rocker_pivot")
RACK = "rack"
"""Name of the steering rack among the parts that a subframe carries."""
Rods = tuple[tuple[str, str], ...]


class Hardpoints(NamedPoints):
    """Hardpoints common to all suspensions: design positions in m, x forward, y left, z up; the road is z = 0.

    Spring and damper act along the strut unless they have end points of their own. Kinematics needs none of these ends.
    """

    wheel_centre: Point
    strut_bottom: Point | None = None
    strut_top: Point | None = None
    spring_bottom: Point | None = None
    spring_top: Point | None = None
    damper_bottom: Point | None = None
    damper_top: Point | None = None
    arb_pivot: Point | None = None
    arb_axis: Point | None = None
    arb_arm_end: Point | None = None
    arb_link_end: Point | None = None
    third_spring_end: Point | None = None

    outer: ClassVar[tuple[str, ...]] = ("wheel_centre",)
    """Points on the wheel's side of the links."""
    different: ClassVar[Groups] = (
        ("strut_bottom", "strut_top"),
        ("spring_bottom", "spring_top"),
        ("damper_bottom", "damper_top"),
        ("arb_pivot", "arb_arm_end"),
        ("arb_pivot", "arb_axis"),
        ("arb_arm_end", "arb_link_end"),
    )
    turning: ClassVar[Axes] = (("arb_pivot", "arb_axis", "arb_arm_end"),)
    together: ClassVar[Groups] = (
        ("strut_bottom", "strut_top"),
        ("arb_pivot", "arb_arm_end", "arb_link_end"),
    )
    rods: ClassVar[Rods] = ()
    """Links of constant length between wheel carrier and car body: (outer point, inner point)."""


_APART = 5e-3
"""Minimum distance in m of a third spring's end from the centre plane of the car."""
ACROSS = 0.05
"""Maximum distance of a point beyond the centre plane of the car, as a fraction of the wheel centre's distance."""


class Wheel(Description):
    """Wheel: ``radius`` (m); static ``camber`` (rad, positive top outward) and ``toe`` (rad, toe-in)."""

    radius: PositiveLength
    camber: Angle = 0.0
    toe: Angle = 0.0
    width: PositiveLength | None = None


class SprungBody(Description):
    """Sprung body on the guide: its mass (kg); with a spherical joint also centre of mass, inertia and joint."""

    mass: Mass
    centre_of_mass: Point | None = None
    inertia: Inertia | None = None
    joint: Point | None = None


class Corner(Rig):
    """Base of all 3-D rigs. x forward, y left, z up; hardpoints are given in the design position, z = 0 is the road.

    ``guide`` sets the motion of the body: fixed, free along z, or free along z and in rotation about ``sprung.joint``.
    """

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    gravity: Acceleration = GRAVITY
    side: Literal["left", "right"] = "left"
    guide: Literal["fixed", "vertical", "vertical+spherical"] = "vertical"
    guide_friction: Friction | None = None
    sprung: SprungBody | None = None
    wheel: Wheel
    tyre: CornerTyre
    hardpoints: Hardpoints
    bodies: Description
    strut: SpatialStrut
    anti_roll_bar: AntiRollBar | None = None
    torsion_bar: TorsionBar | None = None
    third_spring: ThirdSpring | None = None
    bushings: Description = Description()
    subframe: Subframe | None = None
    bearing: WheelBearing | None = None
    links: Description = Description()
    without: tuple[Literal["bodies", "spring", "damper", "tyre"], ...] = ()
    """Parts omitted from the file. Kinematics needs only hardpoints and wheel; unused placeholders replace the rest."""

    needed_bodies: ClassVar[tuple[str, ...]] = ()
    further_bodies: ClassVar[tuple[str, ...]] = ()
    """Optional bodies; without ``wheel`` the wheel is part of the body that carries it."""
    strut_on: ClassVar[tuple[str, ...]] = ()
    """Bodies that may carry the lower end of the strut, default first; likewise for push rod and anti-roll bar."""
    pushrod_on: ClassVar[tuple[str, ...]] = ()
    bar_on: ClassVar[tuple[str, ...]] = ()
    wound_on: ClassVar[tuple[str, ...]] = ()
    """Bodies whose axis may hold a torsion bar. A third spring is allowed on the same bodies as an anti-roll bar."""
    bushed: ClassVar[tuple[str, ...]] = ()
    """Hardpoints at which a bushing may replace an ideal joint."""
    bushed_in_runs: ClassVar[tuple[str, ...]] = ()
    """Those whose bushings act in runs; the K&C rig knows all."""
    on_body: ClassVar[tuple[str, ...]] = ()
    """Hardpoints on the car's body or the rack; a subframe may carry them."""
    on_rack: ClassVar[tuple[str, ...]] = ()
    """Those of them that are on the rack of a steered wheel."""
    yielding: ClassVar[tuple[str, ...]] = ()
    """Links and arms that may have a stiffness."""

    def __init_subclass__(cls, **options: Any) -> None:
        """Create the types of bodies, strut, anti-roll bar and bushings from the names above.

        They are annotated here because the class exists and pydantic has not read its fields yet.
        """
        super().__init_subclass__(**options)

        def part(
            what: str, base: type[Description], text: str, fields: dict[str, Any]
        ) -> type[Description]:
            name = f"{cls.__name__}{what}"
            made = create_model(
                name, __base__=base, __doc__=text, __module__=cls.__module__, **fields
            )
            setattr(
                sys.modules[cls.__module__], name, made
            )  # so that other processes can unpickle it
            return made

        def on(key: str, bodies: tuple[str, ...]) -> dict[str, Any]:
            return {key: (Literal[bodies], bodies[0])} if bodies else {}

        needed = dict.fromkeys(cls.needed_bodies, (RigidBody, ...))
        further = dict.fromkeys(cls.further_bodies, (RigidBody | None, None))
        text = "Bodies of the suspension; without ``wheel`` the wheel is part of the body that carries it."
        bodies = part("Bodies", Description, text, {**needed, **further})
        text = "Strut between the car's body and the body ``on``, or the rocker of a push rod on ``pushrod_on``."
        strut = part(
            "Strut",
            SpatialStrut,
            text,
            {**on("on", cls.strut_on), **on("pushrod_on", cls.pushrod_on)},
        )
        bar = part(
            "Bar", AntiRollBar, "Anti-roll bar linked to the body ``on``.", on("on", cls.bar_on)
        )
        text = "Torsion bar on the axis of the body ``on``."
        wound = part("TorsionBar", TorsionBar, text, on("on", cls.wound_on))
        text = "Third spring between the body ``on`` and its mirror image."
        third = part("ThirdSpring", ThirdSpring, text, on("on", tuple(reversed(cls.bar_on))))
        text = "Bushings in place of ideal joints."
        bushings = part(
            "Bushings", Description, text, dict.fromkeys(cls.bushed, (Bushing | None, None))
        )
        text = "Links and arms that yield under load."
        links = part("Links", Description, text, dict.fromkeys(cls.yielding, (Link | None, None)))
        cls.__annotations__ |= {
            "bodies": bodies,
            "strut": strut,
            "anti_roll_bar": bar | None,
            "bushings": bushings,
            "links": links,
        }
        cls.__annotations__ |= {"torsion_bar": wound | None, "third_spring": third | None}
        cls.anti_roll_bar, cls.torsion_bar, cls.third_spring = None, None, None
        cls.bushings, cls.links = bushings(), links()

    @model_validator(mode="before")
    @classmethod
    def _hardpoints_are_enough(cls, table: Any) -> Any:
        """Allow files without masses, springs, dampers and tyres: hardpoints and wheel are enough for a sweep.

        A table may only be omitted as a whole: a rig with some of its bodies is incomplete.
        """
        if not isinstance(table, dict):
            return table
        if "without" in table:
            raise error_at(("without",), "is derived from what the file omits; remove it")
        if (
            table.get("bodies")
            and table.get("torsion_bar")
            and isinstance(table.get("strut"), dict)
        ):
            coil = (
                "spring" in table["strut"]
            )  # without a coil spring the torsion bar alone carries the car
            strut = {"spring": _NO_SPRING, **table["strut"]}
            return table if coil else {**table, "strut": strut, "without": ["spring"]}
        if table.get("bodies") or not isinstance(table.get("hardpoints"), dict):
            return table
        if table.get("sprung") or table.get("guide", "fixed") != "fixed":
            return table
        rocker = table["hardpoints"].get("rocker_pivot") is not None
        names = (
            *cls.needed_bodies,
            *(("rocker",) if rocker and "rocker" in cls.further_bodies else ()),
        )
        strut = table.get("strut", {})
        if not isinstance(strut, dict):
            return table
        missing = ["bodies", *(name for name in ("spring", "damper") if name not in strut)]
        missing += [] if "tyre" in table else ["tyre"]
        return {
            **table,
            "guide": "fixed",
            "bodies": dict.fromkeys(names, _NO_BODY),
            "strut": {
                "spring": _NO_SPRING,
                "damper": {"coefficient": 1.0},
                **(_ON_ROCKER if rocker else {}),
                **strut,
            },
            "tyre": table.get("tyre", {"stiffness": 1.0}),
            "without": missing,
        }

    @model_serializer(mode="wrap")
    def _as_given(self, dump: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Omit placeholders of parts that the file leaves out: they must not appear in a written file."""
        table: dict[str, Any] = dump(self)
        entries = {
            key: value for key, value in table.items() if key not in ("without", *self.without)
        }
        if "bodies" in self.without:
            entries.pop("guide", None)
        if "strut" in entries and self.without:
            entries["strut"] = {
                key: value for key, value in table["strut"].items() if key not in self.without
            }
        return entries

    def parameters(self) -> dict[str, float]:
        """Return all numbers of the rig by path, SI, without placeholders of omitted parts."""
        numbers = super().parameters()
        unread = tuple(_STANDING_IN[name] for name in self.without)
        return (
            {path: value for path, value in numbers.items() if not path.startswith(unread)}
            if unread
            else numbers
        )

    @property
    def lacks(self) -> tuple[str, ...]:
        """Omitted parts that nothing replaces; a torsion bar, for example, replaces the strut's spring."""
        if not self.has_strut:
            return ("strut", *self.without)
        return tuple(name for name in self.without if name != "spring" or self.torsion_bar is None)

    @property
    def has_strut(self) -> bool:
        """Whether the hardpoints include the ends of a strut, which carries spring and damper."""
        return self.hardpoints.strut_bottom is not None

    @property
    def only_travels(self) -> bool:
        """Whether one coordinate describes the pose: ideal joints, a body that does not rotate, no omitted parts."""
        soft = self.elastic_points & {*self.bushed_in_runs}
        return self.guide != "vertical+spherical" and not soft and not self.lacks

    @property
    def elastic_points(self) -> frozenset[str]:
        """Hardpoints with a bushing."""
        return frozenset(name for name in self.bushed if getattr(self.bushings, name) is not None)

    @property
    def elastic_parts(self) -> tuple[str, ...]:
        """Paths of all descriptions of compliance: bushings, mounts, bearing, links and the steering's stiffness."""
        names = [f"bushings.{name}" for name in self.bushed if name in self.elastic_points]
        names += [name for name in ("subframe", "bearing") if getattr(self, name) is not None]
        names += [
            f"links.{name}" for name in self.yielding if getattr(self.links, name) is not None
        ]
        steering = getattr(self, "steering", None)
        names += [
            f"steering.{name}"
            for name in ("column_stiffness", "assistance", "housing")
            if getattr(steering, name, None) not in (None, ())
        ]
        return tuple(names)

    @property
    def besides_strut(self) -> tuple[str, ...]:
        """Tables of the springs in parallel with the strut's spring when both wheels move together."""
        has = {
            "torsion_bar": self.torsion_bar is not None,
            "third_spring": self.third_spring is not None,
        }
        has["anti_roll_bar"] = self.anti_roll_bar is not None and self.anti_roll_bar.kind == "z"
        return tuple(name for name, there in has.items() if there)

    def require(self, *parts: str, what: str) -> None:
        """Raise an error if the rig omits one of the parts (bodies, spring, damper, tyre) that ``what`` needs.

        Spring and damper also need the ends of the strut.
        """
        asked = {*parts, *(("strut",) if {"spring", "damper"} & {*parts} else ())}
        missing = [name for name in self.lacks if name in asked]
        if missing:
            tables = [_TABLES[name] for name in missing]
            raise DescriptionError(
                Phrase("{what} cannot be determined from hardpoints alone", what=what),
                where=self.source or "rig",
                found=f"a rig without {', '.join(missing)}",
                allowed="sweeps of wheel travel, roll or rack",
                hint=Phrase(
                    "Describe {filter}.",
                    filter=" and ".join(filter(None, (", ".join(tables[:-1]), tables[-1]))),
                ),
            )

    @property
    def sign(self) -> float:
        """Sign of y at the wheel: 1 on the left side of the car, -1 on the right."""
        return 1.0 if self.side == "left" else -1.0

    @property
    def undeformed_radius(self) -> float:
        """Radius of the unloaded tyre in m."""
        return (
            self.wheel.radius
            if self.tyre.undeformed_radius is None
            else self.tyre.undeformed_radius
        )

    def body_masses(self) -> dict[str, RigidBody]:
        """Bodies of the suspension in the description, by name, without the sprung body."""
        bodies = {name: getattr(self.bodies, name) for name in type(self.bodies).model_fields}
        return {name: body for name, body in bodies.items() if body is not None}

    def mirrored(self) -> Self:
        """Return the corner of the car's other side: mirrored at y = 0, including the rack's travel.

        Returns
        -------
        Corner
            The left corner for a right one, and vice versa.

        Examples
        --------
        >>> from jounce.parts import load
        >>> left = load("reference-double-wishbone")
        >>> left.mirrored().hardpoints.wheel_centre   # m
        (0.0, -0.76, 0.3)
        >>> left.mirrored().mirrored() == left
        True
        """
        table = _mirror(self.model_dump(by_alias=True, exclude_none=True))
        return type(self).from_table({**table, "side": "right" if self.side == "left" else "left"})

    @model_validator(mode="after")
    def _is_complete(self) -> Self:
        self._check_side()
        self._check_sprung()
        self._check_attachments()
        self._check_compliance()
        return self

    def _check_side(self) -> None:
        """Refuse points on the other side of the car, and wheels below the road."""
        centre = self.hardpoints.wheel_centre
        if self.sign * centre[1] <= 0.0:
            raise error_at(
                ("hardpoints", "wheel_centre"),
                "not on the left side of the car"
                if self.side == "left"
                else "not on the right side of the car",
                found=Phrase("y = {y:g} mm", y=1e3 * centre[1]),
                allowed='above 0 for side = "left" (y points to the left)'
                if self.side == "left"
                else 'below 0 for side = "right" (y points to the left)',
                hint="Change side, or reverse the sign of all y values.",
            )
        if centre[2] <= 0.0:
            raise error_at(
                ("hardpoints", "wheel_centre"),
                "is in or below the road (z = 0)",
                found=Phrase("z = {z:g} mm", z=1e3 * centre[2]),
                allowed=Phrase("above {bound:g}", bound=0.0),
                hint="Add the loaded radius of the tyre to all heights.",
            )
        for name, point in self.hardpoints.given().items():
            allowed = 0.0 if name in self.hardpoints.outer else ACROSS * abs(centre[1])
            if self.sign * point[1] < -allowed and name not in (
                "rocker_axis",
                "arb_pivot",
                "arb_axis",
            ):
                raise error_at(
                    ("hardpoints", name),
                    "not on the same side of the car as the wheel",
                    found=Phrase(
                        "{point}, the wheel centre has y = {y:g} mm",
                        point=write_point(point),
                        y=1e3 * centre[1],
                    ),
                    allowed="points of one side",
                    hint="Is the sign of y wrong?",
                )

    def _check_sprung(self) -> None:
        """Refuse a guided body without the properties that its guide requires."""
        if self.guide == "fixed":
            return
        needed = (
            ("mass",)
            if self.guide == "vertical"
            else ("mass", "centre_of_mass", "inertia", "joint")
        )
        missing = [
            name for name in needed if self.sprung is None or getattr(self.sprung, name) is None
        ]
        if missing:
            raise error_at(
                ("sprung",),
                Phrase(
                    '{missing} is missing; guide = "{guide}" needs {needed}',
                    missing=", ".join(missing),
                    guide=self.guide,
                    needed=", ".join(needed),
                ),
            )

    def _check_attachments(self) -> None:
        """Refuse elements attached to bodies that the rig does not have."""
        self._check_strut()
        self._require_body("strut", self.strut.on)
        rocker = getattr(self.hardpoints, "rocker_pivot", None)
        if self.strut.on == "rocker" and rocker is None:
            raise error_at(
                ("strut", "on"),
                "there is no rocker; allowed with hardpoints pushrod_outer, pushrod_inner, rocker_pivot, rocker_axis",
            )
        if rocker is not None:
            self._require_body("hardpoints", "rocker")
        bar_points = self.hardpoints.arb_pivot is not None
        if bar_points != (self.anti_roll_bar is not None):
            raise error_at(
                ("hardpoints",) if bar_points else ("anti_roll_bar",),
                "an anti-roll bar needs its table [anti_roll_bar] and hardpoints arb_pivot, arb_arm_end, arb_link_end",
                found=Phrase("only the points" if bar_points else "only the table"),
            )

        if self.hardpoints.arb_axis is not None and not bar_points:
            raise error_at(
                ("hardpoints", "arb_axis"),
                "is a point of the axis through arb_pivot, which is missing",
            )
        if self.anti_roll_bar is not None:
            self._require_body("anti_roll_bar", self.anti_roll_bar.on)
            if self.anti_roll_bar.kind == "t":
                self._check_stem()
        if self.torsion_bar is not None:
            self._require_body("torsion_bar", self.torsion_bar.on)
        self._check_third_spring()

    def _check_strut(self) -> None:
        """Refuse parts that need the ends of a strut if the hardpoints lack them."""
        if self.has_strut:
            return
        laws = [name for name in ("spring", "damper") if name not in self.without]
        laws += [
            name
            for name in ("friction", "bump_stop", "rebound_stop")
            if getattr(self.strut, name) is not None
        ]
        needing = [] if "bodies" in self.without else ["[bodies]"]
        needing += [f"strut.{name}" for name in laws]
        needing += [
            f"hardpoints.{name}" for name in _OWN_ENDS if getattr(self.hardpoints, name) is not None
        ]
        if needing:
            raise error_at(
                ("hardpoints", "strut_bottom"),
                "is missing, as is strut_top",
                found=Phrase("{names}, which need the ends of the strut", names=", ".join(needing)),
                hint=(
                    "Give both ends of the strut, or only the other points and [wheel], which are enough for "
                    "kinematics."
                ),
            )

    def _check_stem(self) -> None:
        """Refuse T-bars whose stem is not in the centre plane of the car."""
        points = self.hardpoints
        if points.arb_axis is None:
            raise error_at(
                ("hardpoints", "arb_axis"),
                "is missing; the stem of a T-bar runs from arb_pivot to it",
            )
        for name in ("arb_pivot", "arb_axis"):
            if abs(getattr(points, name)[1]) >= SAME_POINT:
                raise error_at(
                    ("hardpoints", name),
                    "not in the middle of the car",
                    found=Phrase(write_point(getattr(points, name))),
                    allowed="y = 0, where the stem of a T-bar is",
                )

    def _check_third_spring(self) -> None:
        """Refuse a third spring without its table or its point, and ends that leave no room for it."""
        end = self.hardpoints.third_spring_end
        if (end is None) != (self.third_spring is None):
            raise error_at(
                ("hardpoints",) if self.third_spring is None else ("third_spring",),
                "a third spring needs its table [third_spring] and hardpoint third_spring_end",
                found=Phrase(
                    "only the hardpoint" if self.third_spring is None else "only the table"
                ),
            )
        if end is None or self.third_spring is None:
            return
        self._require_body("third_spring", self.third_spring.on)
        if self.sign * end[1] < _APART:
            raise error_at(
                ("hardpoints", "third_spring_end"),
                "lies at or beyond the middle of the car, where the other end is",
                found=Phrase(write_point(end)),
                allowed=Phrase("at least {least:g} mm from it", least=1e3 * _APART),
            )

    def _check_compliance(self) -> None:
        """Refuse bushings at points, and stiffnesses of links, that the rig does not have."""
        points = self.hardpoints.given()
        for name in self.bushed:
            if name in self.elastic_points and name not in points:
                raise error_at(
                    ("bushings", name), Phrase("the hardpoint {name} is missing", name=name)
                )
        needed = {"pushrod": "pushrod_outer", "arb_link": "arb_link_end"}
        for name, point in needed.items():
            if getattr(self.links, name, None) is not None and point not in points:
                raise error_at(
                    ("links", name), Phrase("the hardpoint {name} is missing", name=point)
                )
        if self.subframe is None:
            return
        steered = getattr(self, "steering", None) is not None
        known = [name for name in self.on_body if name in points]
        known = [name for name in known if not (steered and name in self.on_rack)]
        known += [RACK] if steered else []
        for i, name in enumerate(self.subframe.carries):
            if name not in known:
                raise error_at(
                    ("subframe", "carries", i),
                    "the body of this rig has no such point",
                    found=name,
                    allowed=", ".join(known),
                    hint=self._carried_instead(name, known, steered=steered),
                )

    def _carried_instead(self, name: str, known: list[str], *, steered: bool) -> str:
        """Return advice on a name that a subframe cannot carry."""
        if steered and name in self.on_rack:
            return "This point is on the rack: name the rack."
        if name == RACK:
            return "A rack needs the table [steering]."
        return nearest(name, known)

    def _require_body(self, element: str, name: str) -> None:
        if name in self.body_masses():
            return
        raise error_at(
            (element,) if element == "hardpoints" else (element, "on"),
            Phrase("the body {name} that carries it does not exist", name=show_value(name)),
            allowed=Phrase(
                "{names}, or a table [bodies.{name}] with mass, centre_of_mass and inertia",
                names=", ".join(self.body_masses()),
                name=name,
            ),
        )


def _mirror(table: dict[str, Any]) -> dict[str, Any]:
    """Mirror the table of a rig at y = 0."""
    mirrored = dict(table)
    for key, value in table.items():
        if key == "bushings":
            mirrored[key] = {name: mirror_bushing(bushing) for name, bushing in value.items()}
        elif key in ("mounts", "housing"):
            mirrored[key] = tuple(mirror_bushing(mount) for mount in value)
        elif isinstance(value, dict):
            mirrored[key] = (
                _mirror_points(value) if key in ("hardpoints", "column") else _mirror(value)
            )
        elif key in ("centre_of_mass", "joint"):
            mirrored[key] = (value[0], -value[1], value[2])
        elif key in ("xy", "yz", "rack_travel"):
            mirrored[key] = -value
    return mirrored


def _mirror_points(table: dict[str, Any]) -> dict[str, Any]:
    """Return points with the sign of y changed, and angles with their sign changed."""
    return {
        name: -value if isinstance(value, float) else (value[0], -value[1], value[2])
        for name, value in table.items()
    }


class ArmHardpoints(Hardpoints):
    """Hardpoints of a lower arm that rotates about an axis through two points of the body."""

    lower_arm_front: Point
    lower_arm_rear: Point
    lower_ball_joint: Point

    turning: ClassVar[Axes] = (("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),)
    rods: ClassVar[Rods] = (
        ("lower_ball_joint", "lower_arm_front"),
        ("lower_ball_joint", "lower_arm_rear"),
    )


class RockerHardpoints(Hardpoints):
    """Hardpoints of a rocker on an axis fixed to the body, moved by a push rod; it carries the strut's lower end."""

    pushrod_outer: Point | None = None
    pushrod_inner: Point | None = None
    rocker_pivot: Point | None = None
    rocker_axis: Point | None = None

    different: ClassVar[Groups] = (
        ("pushrod_outer", "pushrod_inner"),
        ("rocker_pivot", "rocker_axis"),
    )
    turning: ClassVar[Axes] = (("rocker_pivot", "rocker_axis", "pushrod_inner"),)
    together: ClassVar[Groups] = (
        ("pushrod_outer", "pushrod_inner", "rocker_pivot", "rocker_axis"),
    )


class DoubleWishboneHardpoints(RockerHardpoints, ArmHardpoints):
    """Hardpoints of two arms, each on an axis through two points of the body, of the upright and of a tie rod."""

    upper_arm_front: Point
    upper_arm_rear: Point
    upper_ball_joint: Point
    tie_rod_inner: Point
    tie_rod_outer: Point

    outer = ("wheel_centre", "lower_ball_joint", "upper_ball_joint", "tie_rod_outer")
    different = (
        (
            "lower_arm_front",
            "lower_arm_rear",
            "lower_ball_joint",
            "upper_arm_front",
            "upper_arm_rear",
            "upper_ball_joint",
            "tie_rod_inner",
            "tie_rod_outer",
        ),
    )
    turning = (
        ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"),
        ("lower_ball_joint", "upper_ball_joint", "tie_rod_outer"),
    )
    rods = (
        *ArmHardpoints.rods,
        ("upper_ball_joint", "upper_arm_front"),
        ("upper_ball_joint", "upper_arm_rear"),
        ("tie_rod_outer", "tie_rod_inner"),
    )


class DoubleWishbone(Corner):
    """Double wishbone: two arms, an upright between their ball joints, a tie rod, a strut."""

    model: Literal["double-wishbone"] = "double-wishbone"
    hardpoints: DoubleWishboneHardpoints
    steering: Steering | None = None

    needed_bodies = ("lower_arm", "upper_arm", "upright")
    further_bodies = ("tie_rod", "rocker", "wheel")
    strut_on = ("lower_arm", "upper_arm", "upright", "rocker")
    pushrod_on = ("lower_arm", "upper_arm", "upright")
    bar_on = ("lower_arm", "upper_arm", "upright", "rocker")
    wound_on = ("lower_arm", "upper_arm", "rocker")
    on_rack = ("tie_rod_inner",)
    bushed_in_runs = (
        "lower_arm_front",
        "lower_arm_rear",
        "upper_arm_front",
        "upper_arm_rear",
        *on_rack,
    )
    bushed = (
        *bushed_in_runs,
        *("lower_ball_joint", "upper_ball_joint", "tie_rod_outer"),
        *(*_ENDS, *_ON_ROCKER_JOINTS, *_ON_BAR),
    )
    on_body = (*bushed_in_runs, "rocker_pivot", *_ON_BODY)
    yielding = ("lower_arm", "upper_arm", "tie_rod", "pushrod", "arb_link")


class McPhersonHardpoints(ArmHardpoints):
    """Hardpoints of one arm, a tie rod, and a strut that guides the upright from ``strut_bottom`` to ``strut_top``."""

    strut_bottom: Point
    strut_top: Point
    tie_rod_inner: Point
    tie_rod_outer: Point

    outer = ("wheel_centre", "lower_ball_joint", "tie_rod_outer", "strut_bottom")
    different = (
        (
            "lower_arm_front",
            "lower_arm_rear",
            "lower_ball_joint",
            "tie_rod_inner",
            "tie_rod_outer",
            "strut_top",
        ),
    )
    turning = (("lower_ball_joint", "strut_top", "tie_rod_outer"),)
    rods = (*ArmHardpoints.rods, ("tie_rod_outer", "tie_rod_inner"))


class McPherson(Corner):
    """McPherson strut: one arm, a tie rod, and a strut that guides the upright.

    The body ``strut`` is the part that slides in the upright and is attached to the car's body.
    """

    model: Literal["mcpherson"] = "mcpherson"
    hardpoints: McPhersonHardpoints
    steering: Steering | None = None

    needed_bodies = ("lower_arm", "upright")
    further_bodies = ("strut", "tie_rod", "wheel")
    strut_on = ("upright",)
    bar_on = ("upright", "lower_arm")
    wound_on = ("lower_arm",)
    on_rack = ("tie_rod_inner",)
    bushed_in_runs = ("lower_arm_front", "lower_arm_rear", *on_rack, "strut_top")
    bushed = (*bushed_in_runs, "lower_ball_joint", "tie_rod_outer", *_OWN_ENDS, *_ON_BAR)
    on_body = ("lower_arm_front", "lower_arm_rear", *on_rack, *_ON_BODY)
    yielding = ("lower_arm", "tie_rod", "arb_link")


class FiveLinkHardpoints(RockerHardpoints):
    """Hardpoints of five links, jointed to the body (inner) and the upright (outer); link 5 is the toe link."""

    link_1_inner: Point
    link_1_outer: Point
    link_2_inner: Point
    link_2_outer: Point
    link_3_inner: Point
    link_3_outer: Point
    link_4_inner: Point
    link_4_outer: Point
    link_5_inner: Point
    link_5_outer: Point

    outer = ("wheel_centre", *(f"link_{i}_outer" for i in range(1, 6)))
    different = tuple((f"link_{i}_inner", f"link_{i}_outer") for i in range(1, 6))
    rods = tuple((f"link_{i}_outer", f"link_{i}_inner") for i in range(1, 6))

    @model_validator(mode="after")
    def _no_rod_twice(self) -> Self:
        for i, j in combinations(range(1, 6), 2):
            ends = [
                (self.at(f"link_{i}_{end}"), self.at(f"link_{j}_{end}"))
                for end in ("inner", "outer")
            ]
            if all(
                a is not None and b is not None and distance(a, b) < SAME_POINT for a, b in ends
            ):
                raise error_at(
                    (f"link_{j}_inner",),
                    Phrase("link {second} has both ends of link {first}", second=j, first=i),
                    allowed="five different links",
                )
        return self


class FiveLink(Corner):
    """Five links between body and upright; links that share a point form an arm. Link 5 is the toe link or tie rod.

    A link that is not a body is a massless rod of fixed length.
    """

    model: Literal["five-link"] = "five-link"
    hardpoints: FiveLinkHardpoints
    steering: Steering | None = None

    needed_bodies = ("upright",)
    further_bodies = ("link_1", "link_2", "link_3", "link_4", "link_5", "rocker", "wheel")
    strut_on = ("upright", "link_1", "link_2", "link_3", "link_4", "link_5", "rocker")
    pushrod_on = ("upright",)
    bar_on = ("upright", "link_1", "link_2", "link_3", "link_4", "link_5", "rocker")
    wound_on = ("rocker",)
    on_rack = ("link_5_inner",)
    bushed_in_runs = tuple(f"link_{i}_inner" for i in range(1, 6))
    bushed = (
        *bushed_in_runs,
        *(f"link_{i}_outer" for i in range(1, 6)),
        *(*_ENDS, *_ON_ROCKER_JOINTS, *_ON_BAR),
    )
    on_body = (*bushed_in_runs, "rocker_pivot", *_ON_BODY)
    yielding = (*(f"link_{i}" for i in range(1, 6)), "pushrod", "arb_link")


class TrailingArmHardpoints(Hardpoints):
    """Hardpoints of one arm that carries the wheel, on the axis through ``arm_inner`` and ``arm_outer``."""

    arm_inner: Point
    arm_outer: Point

    different = (("arm_inner", "arm_outer", "wheel_centre"),)
    turning = (("arm_inner", "arm_outer", "wheel_centre"),)


class TrailingArm(Corner):
    """Trailing or semi-trailing arm: one body that carries the wheel and rotates about an axis fixed to the car."""

    model: Literal["trailing-arm"] = "trailing-arm"
    hardpoints: TrailingArmHardpoints

    needed_bodies = ("arm",)
    further_bodies = ("wheel",)
    strut_on = ("arm",)
    bar_on = ("arm",)
    wound_on = ("arm",)
    bushed_in_runs = ("arm_inner", "arm_outer")
    bushed = (*bushed_in_runs, *_ENDS, *_ON_BAR)
    on_body = (*bushed_in_runs, *_ON_BODY)
    yielding = ("arb_link",)


if TYPE_CHECKING:
    AnyCorner = Corner
else:
    AnyCorner = Annotated[Union[tuple(Corner.__subclasses__())], Field(discriminator="model")]  # noqa: UP007
"""Any of the suspensions above, selected by ``model``."""
