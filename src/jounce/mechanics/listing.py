"""Contents of a mechanism as plain data and text, for drawing, exchange and the browser."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import isfinite
from typing import Any

import casadi as ca
import numpy as np

from jounce.core.types import Array
from jounce.mechanics.bodies import Body
from jounce.mechanics.descriptions import Known, NamedPart, Plain, Write
from jounce.mechanics.expressions import text_of
from jounce.mechanics.structure import Structure

_ELEMENTS = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
_NO_NUMBERS = {
    "name",
    "kind",
    "units",
    "first",
    "second",
    "body",
    "carries",
    "coordinates",
    "speeds",
    "loop",
}
_NO_NUMBERS |= {"equations", "tracks", "bodies", "frame", "positive", "as_designed", "joint"}
_LONGEST = 160  # maximum number of characters of a law on a line


class Reading:
    """Evaluates and writes the expressions of a mechanism at given parameter values."""

    def __init__(self, mechanism: Structure, values: Mapping[str, float]) -> None:
        self._mechanism, collection = mechanism, mechanism.collection
        self._parameters = {
            symbol.element_hash(): path for path, symbol in collection.parameters.items()
        }
        given = {
            path: (symbol, values[path])
            for path, symbol in collection.parameters.items()
            if path in values
        }
        self._values = values
        self._numbers = {
            symbol.element_hash(): (symbol, value)
            for symbol, value in (given | collection.constants).values()
        }

    def value(self, path: str) -> float | None:
        """Return the value of a parameter; None if unknown."""
        number = self._values.get(path, np.nan)
        return number if isfinite(number) else None

    def numbers(self, expression: ca.SX) -> Array | None:
        """Return the values of an expression of parameters, in its shape; None if any of its symbols has no value."""
        given = [self._numbers.get(symbol.element_hash()) for symbol in ca.symvar(expression)]
        pairs = [pair for pair in given if pair is not None]
        if len(pairs) < len(given):
            return None
        symbols = ca.vertcat(*(symbol for symbol, _ in pairs))
        result = ca.Function("numbers", [symbols], [ca.densify(expression)])(
            [value for _, value in pairs]
        )
        return np.asarray(result.full(), dtype=np.float64).squeeze()

    def numbers_of(self, description: NamedPart) -> Known:
        """Return the values of a description's fields, NaN if unknown."""

        def value_of(field: str) -> Array:
            value = getattr(description, field)
            value = description.defaults().get(field) if value is None else value
            if not isinstance(value, ca.SX):
                return np.array(np.nan)
            result = self.numbers(value)
            return (
                np.full(value.numel() if value.numel() > 1 else (), np.nan)
                if result is None
                else result
            )

        return value_of

    def write(self, expression: ca.SX) -> Plain:
        """Return the values of an expression of parameters; else a dict with its text and its parameters."""
        numbers = self.numbers(expression)
        if numbers is not None:
            parts = [float(part) if isfinite(part) else None for part in numbers.ravel()]
            return parts[0] if expression.shape == (1, 1) else parts
        within = [self._parameters.get(symbol.element_hash()) for symbol in ca.symvar(expression)]
        if within and all(within):
            return None  # parameters without a value
        return self.law(expression)

    def law(self, expression: ca.SX) -> dict[str, Plain]:
        """Return an expression's text, with body points as ``body.point(x, y, z).z``, and its parameters."""
        for named in self._mechanism.poses.occurring(expression):
            place = self.numbers(named.design)
            parts = ca.vertsplit(named.design)
            shown = ", ".join(
                map(text_of, parts) if place is None else (f"{part:.6g}" for part in place)
            )
            whole = f"{named.body.name}.{'point' if named.is_point else 'direction'}({shown})"
            symbols = ca.vertcat(*(ca.SX.sym(f"{whole}.{axis}") for axis in "xyz"))
            expression = ca.substitute(expression, named.symbol, symbols)
        paths = [self._parameters.get(symbol.element_hash()) for symbol in ca.symvar(expression)]
        units = self._mechanism.units
        parameters: dict[str, Plain] = {
            path: {"value": self.value(path), "unit": units.get(path, "")}
            for path in paths
            if path is not None
        }
        texts: list[Plain] = [text_of(part) for part in ca.vertsplit(expression)]
        return {"expression": texts[0] if len(texts) == 1 else texts, "parameters": parameters}

    def ratios(self, expression: ca.SX) -> dict[str, Plain] | None:
        """Return coefficients of a linear expression by coordinate and track; None if it is not linear in them."""
        collection = self._mechanism.collection
        every = {
            name: track.value for name, track in collection.tracks.items()
        } | collection.coordinates
        within = {symbol.element_hash() for symbol in ca.symvar(expression)}
        result: dict[str, Plain] = {}
        for name, symbol in every.items():
            if symbol.element_hash() in within:
                ratio = self.numbers(ca.jacobian(expression, symbol))
                if ratio is None:
                    return None
                result[name] = float(ratio)
        return None if self._mechanism.poses.occurring(expression) else result


def as_data(
    mechanism: Structure, values: Mapping[str, float], watched: Iterable[NamedPart]
) -> dict[str, Any]:
    """Return bodies, joints, loops, conditions, loads, tracks and outputs (see :meth:`Mechanism.to_dict`)."""
    collection, loops, read = mechanism.collection, mechanism.loops(), Reading(mechanism, values)
    write = read.write

    def acts_on(symbols: ca.SX) -> dict[str, Plain]:
        names = [symbol.name() for symbol in ca.symvar(symbols)]
        bodies = dict.fromkeys(named.body.name for named in mechanism.poses.occurring(symbols))
        each = (
            ("coordinates", collection.coordinates),
            ("tracks", collection.tracks),
            ("bodies", bodies),
        )
        return {
            key: [name for name in listed if name in names or key == "bodies"]
            for key, listed in each
        }

    return {
        "gravity": write(mechanism.gravity),
        "bodies": [
            _body(body, write) for body in mechanism.bodies.values() if body is not mechanism.ground
        ],
        "joints": [
            hung.joint.to_plain(write)
            | {
                "carries": hung.child.name,
                "coordinates": _with_units(mechanism, (*hung.coordinates, *hung.quaternion)),
                "speeds": _with_units(mechanism, hung.speeds),
            }
            for hung in mechanism.hanging.values()
        ],
        "closures": [
            closed.joint.to_plain(write)
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
            {
                "name": condition.name,
                "kind": condition.kind,
                **read.law(condition.expression),
                "ratios": read.ratios(condition.expression),
            }
            | acts_on(condition.expression)
            for condition, _ in mechanism.conditions.values()
        ],
        "loads": [
            load.to_plain(write)
            | acts_on(ca.vertcat(*(expression for expression, _ in action.along)))
            if action.along
            else load.to_plain(write)
            for load, action in mechanism.loads
        ],
        "tracks": list(collection.tracks),
        "switches": [
            {"name": name, "above_zero": read.law(when)}
            for name, (_, when) in collection.switches.items()
        ],
        "internal_states": [
            {"name": name, "rate": None if rate is None else read.law(rate)}
            for name, (_, rate) in collection.internal.items()
        ],
        "parameters": {
            path: {"value": read.value(path), "unit": mechanism.units.get(path, "")}
            for path in collection.parameters
        },
        "watched": [watch.to_plain(write) for watch in watched],
        "outputs": [
            {"name": output.name, "unit": output.unit, "long_name": output.long_name}
            for output in collection.outputs
        ],
    }


def _body(body: Body, write: Write) -> dict[str, Plain]:
    result: dict[str, Plain] = {"name": body.name}
    if body.axes_of is not None:
        result["axes_of"] = body.axes_of.name
    properties = body.mass_properties
    if properties is not None:
        inertia = ca.vertcat(*(properties.inertia[i, j] for i, j in _ELEMENTS.values()))
        elements = write(inertia)
        result |= {"mass": write(properties.mass), "centre_of_mass": write(properties.centre)}
        result["inertia"] = (
            dict(zip(_ELEMENTS, elements, strict=True)) if isinstance(elements, list) else None
        )
    return result


def _with_units(mechanism: Structure, names: tuple[str, ...]) -> list[Plain]:
    return [{"name": name, "unit": mechanism.collection.units[name]} for name in names]


def as_text(listed: Mapping[str, Any]) -> str:
    """Write the mechanism for a reader, one line per part."""
    bodies = []
    for body in listed["bodies"]:
        if "mass" in body:
            elements = body["inertia"] or {}
            inertia = (
                ", ".join(f"{name} {_format_value(value)}" for name, value in elements.items())
                or "not known"
            )
            bodies.append(
                f"{body['name']}: mass {_format_value(body['mass'])} kg, "
                f"centre of mass {_format_value(body['centre_of_mass'])} m, "
                f"inertia {inertia}{' kg m^2' if elements else ''}"
            )
        else:
            carried = f"axes of {body['axes_of']}" if "axes_of" in body else "no mass of its own"
            bodies.append(f"{body['name']}: {carried}")
    joints = []
    for joint in listed["joints"]:
        names = ", ".join(f"{entry['name']} [{entry['unit']}]" for entry in joint["coordinates"])
        joints.append(f"{_line(joint)}{f'; {names}' if names else ''}")
    closures = [
        f"{_line(entry)}; equations {len(entry['equations'])}; loop {', '.join(entry['loop'])}"
        for entry in listed["closures"]
    ]
    conditions = [
        f"{entry['name']}: {entry['kind']} of {_names(entry)}, {_format_value(_law(entry))} = 0{_with(entry)}"
        for entry in listed["conditions"]
    ]
    loads = [_line(entry) for entry in listed["loads"]]
    parts = {
        "bodies": bodies,
        "joints": joints,
        "loops closed by": closures,
        "conditions": conditions,
        "loads": loads,
    }
    parts["tracks"] = listed["tracks"]
    parts["switches"] = [
        f"{entry['name']}: 1 where {_format_value(entry['above_zero'])} > 0{_with(entry['above_zero'])}"
        for entry in listed["switches"]
    ]
    parts["internal states"] = [
        f"{entry['name']}: rate {_format_value(entry['rate'])}{_with(entry['rate'] or {})}"
        for entry in listed["internal_states"]
    ]
    parts["watched"] = [f"{entry['name']}: {entry['kind']}" for entry in listed["watched"]]
    return "\n".join(
        line
        for name, lines in parts.items()
        if lines
        for line in (name, *(f"  {entry}" for entry in lines))
    )


def _line(entry: Mapping[str, Any]) -> str:
    """Return name, kind, bodies, numbers and laws on one line."""
    ends = " - ".join(entry[end] for end in ("first", "second", "body", "joint") if end in entry)
    units = {
        name: "" if unit == "1" else f" {unit.replace('*', ' ')}"
        for name, unit in entry["units"].items()
    }
    numbers = [
        f"{name.replace('_', ' ')} {_format_value(value)}{units.get(name, '')}"
        + (" as designed" if name in entry.get("as_designed", ()) else "")
        + (_with(value) if isinstance(value, dict) else "")
        for name, value in entry.items()
        if name not in _NO_NUMBERS
    ]
    name = f"{entry['name']}: " if entry["name"] else ""
    positive = [f"positive: {entry['positive']}"] if "positive" in entry else []
    return name + ", ".join([entry["kind"], *([ends] if ends else []), *numbers, *positive])


def _names(entry: Mapping[str, Any]) -> str:
    return ", ".join(
        name for part in ("coordinates", "bodies", "tracks") for name in entry.get(part, ())
    )


def _law(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {"expression": entry["expression"]}


def _with(law: Mapping[str, Any]) -> str:
    """Return the parameters of a law with their values."""
    parameters = (
        f"{path} {_format_value(parameter['value'])} {parameter['unit']}".rstrip(" 1")
        for path, parameter in law.get("parameters", {}).items()
    )
    text = ", ".join(parameters)
    return f" with {text}" if text else ""


def _format_value(value: Plain) -> str:
    if value is None:
        return "not known"
    if isinstance(value, dict):
        text = _format_value(value["expression"])
        return (
            text
            if len(text) <= _LONGEST
            else f"{text[:_LONGEST]}... ({len(text)} characters, whole in to_dict)"
        )
    if isinstance(value, list):
        return f"({', '.join(_format_value(part) for part in value)})"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
