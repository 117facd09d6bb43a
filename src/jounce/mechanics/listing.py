"""What a mechanism is made of, as plain data and as text: what drawing, exchange and a browser read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import isfinite
from typing import Any

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.descriptions import Description, Plain
from jounce.mechanics.structure import Structure

_ELEMENTS = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
_NO_NUMBERS = {"name", "kind", "units", "first", "second", "body", "carries", "coordinates", "speeds", "loop"}
_NO_NUMBERS |= {"equations", "tracks", "bodies", "frame"}


def as_data(mechanism: Structure, values: Mapping[str, float], watched: Iterable[Description]) -> dict[str, Any]:
    """Bodies, joints, loops, conditions, loads, tracks and what is watched (see :meth:`Mechanism.to_dict`)."""
    collection, loops = mechanism.collection, mechanism.loops()
    known = {name: (symbol, values[name]) for name, symbol in collection.parameters.items() if name in values}
    known |= collection.constants
    numbers = {symbol.element_hash(): (symbol, value) for symbol, value in known.values()}

    def evaluate(expression: ca.SX) -> Plain:
        needed = [numbers.get(symbol.element_hash()) for symbol in ca.symvar(expression)]
        given = [pair for pair in needed if pair is not None]
        if len(given) < len(needed):
            return None
        symbols = ca.vertcat(*(symbol for symbol, _ in given))
        found = ca.Function("numbers", [symbols], [ca.densify(expression)])([value for _, value in given])
        parts = [float(part) if isfinite(part) else None for part in found.full().ravel()]
        return parts[0] if expression.shape == (1, 1) else parts

    def acts_on(symbols: ca.SX) -> dict[str, Plain]:
        names = [symbol.name() for symbol in ca.symvar(symbols)]
        bodies = dict.fromkeys(named.body.name for named in mechanism.poses.occurring(symbols))
        each = (("coordinates", collection.coordinates), ("tracks", collection.tracks), ("bodies", bodies))
        return {key: [name for name in kept if name in names or key == "bodies"] for key, kept in each}

    return {
        "gravity": evaluate(mechanism.gravity),
        "bodies": [_body(body, evaluate) for body in mechanism.bodies.values() if body is not mechanism.ground],
        "joints": [
            hung.joint.listed(evaluate)
            | {
                "carries": hung.child.name,
                "coordinates": _with_units(mechanism, (*hung.coordinates, *hung.quaternion)),
                "speeds": _with_units(mechanism, hung.speeds),
            }
            for hung in mechanism.hanging.values()
        ],
        "closures": [
            closed.joint.listed(evaluate)
            | {
                "loop": list(loops[name]),
                "equations": [
                    {"name": equation.name, "unit": equation.unit}
                    for constraint in collection.constraints
                    for equation in constraint.equations
                    if equation.joint == name
                ],
            }
            for name, closed in mechanism.closing.items()
        ],
        "conditions": [
            {"name": one.name, "kind": one.kind} | acts_on(one.expression) for one, _ in mechanism.conditions.values()
        ],
        "loads": [
            load.listed(evaluate) | acts_on(ca.vertcat(*(expression for expression, _ in action.along)))
            if action.along
            else load.listed(evaluate)
            for load, action in mechanism.loads
        ],
        "tracks": list(collection.tracks),
        "watched": [watch.listed(evaluate) for watch in watched],
        "outputs": [{"name": one.name, "unit": one.unit, "long_name": one.long_name} for one in collection.outputs],
    }


def _body(body: Body, evaluate: Any) -> dict[str, Plain]:
    found: dict[str, Plain] = {"name": body.name}
    properties = body.mass_properties
    if properties is not None:
        inertia = ca.vertcat(*(properties.inertia[i, j] for i, j in _ELEMENTS.values()))
        elements = evaluate(inertia)
        found |= {"mass": evaluate(properties.mass), "centre_of_mass": evaluate(properties.centre)}
        found["inertia"] = dict(zip(_ELEMENTS, elements, strict=True)) if isinstance(elements, list) else None
    return found


def _with_units(mechanism: Structure, names: tuple[str, ...]) -> list[Plain]:
    return [{"name": name, "unit": mechanism.collection.units[name]} for name in names]


def as_text(listed: Mapping[str, Any]) -> str:
    """The same for a reader: one line for each thing."""
    bodies = []
    for body in listed["bodies"]:
        if "mass" in body:
            elements = body["inertia"] or {}
            inertia = ", ".join(f"{name} {_shown(value)}" for name, value in elements.items()) or "not known"
            bodies.append(
                f"{body['name']}: mass {_shown(body['mass'])} kg, centre of mass {_shown(body['centre_of_mass'])} m, "
                f"inertia {inertia}{' kg m^2' if elements else ''}"
            )
        else:
            bodies.append(f"{body['name']}: no mass of its own")
    joints = []
    for joint in listed["joints"]:
        names = ", ".join(f"{one['name']} [{one['unit']}]" for one in joint["coordinates"])
        joints.append(f"{_line(joint)}{f'; {names}' if names else ''}")
    closures = [
        f"{_line(one)}; equations {len(one['equations'])}; loop {', '.join(one['loop'])}" for one in listed["closures"]
    ]
    conditions = [f"{one['name']}: {one['kind']} of {_names(one)}" for one in listed["conditions"]]
    loads = [_line(one) + (f" of {_names(one)}" if _names(one) else "") for one in listed["loads"]]
    parts = {"bodies": bodies, "joints": joints, "loops closed by": closures, "conditions": conditions, "loads": loads}
    parts["tracks"] = listed["tracks"]
    parts["watched"] = [f"{one['name']}: {one['kind']}" for one in listed["watched"]]
    return "\n".join(line for name, lines in parts.items() if lines for line in (name, *(f"  {one}" for one in lines)))


def _line(one: Mapping[str, Any]) -> str:
    """Name, kind, bodies and numbers."""
    ends = " - ".join(one[end] for end in ("first", "second", "body") if end in one)
    units = {name: "" if unit == "1" else f" {unit.replace('*', ' ')}" for name, unit in one["units"].items()}
    numbers = [
        f"{name.replace('_', ' ')} {_shown(value)}{units.get(name, '')}"
        for name, value in one.items()
        if name not in _NO_NUMBERS
    ]
    name = f"{one['name']}: " if one["name"] else ""
    return name + ", ".join([one["kind"], *([ends] if ends else []), *numbers])


def _names(one: Mapping[str, Any]) -> str:
    return ", ".join(name for part in ("coordinates", "bodies", "tracks") for name in one.get(part, ()))


def _shown(value: Plain) -> str:
    if value is None:
        return "not known"
    if isinstance(value, list):
        return f"({', '.join(_shown(part) for part in value)})"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
