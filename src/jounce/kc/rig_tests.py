"""Which test a table of readings is, by its name or by what moves in it, and the input that it sweeps."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.text import without_accents
from jounce.core.types import Array
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import INPUTS

_OPPOSED = r"oppos|out of phase|anti ?phase|gegen"
_TRAVELLED, _FORCED, _STEERED, _TURNED = 0.004, 100.0, 0.004, 0.3
"""Least range of a travel (m), force (N), rack (m) and handwheel (rad) that is a sweep; for moments a tenth."""


def named_test(names: Iterable[str]) -> str:
    """Return the test that the first name with one says; empty if none does.

    >>> [named_test([text]) for text in ("Run 7 Lat. opposed", "Bump steer left", "Parallel wheel travel")]
    ['lateral-opposed', 'bounce', 'bounce']
    >>> [named_test([text]) for text in ("Roll steer", "Aligning torque in phase", "lateral", "Wanken")]
    ['roll', 'aligning-in-phase', '', 'roll']
    """
    return next((test for test in map(_named, names) if test), "")


def _named(name: str) -> str:
    plain = " ".join(re.findall(r"[^\W_]+", without_accents(name)))
    exact = plain.replace(" ", "-")
    if exact in TESTS:
        return exact
    for pattern, test in (
        (r"brak|brems", "braking-inboard" if "inboard" in plain else "braking"),
        (r"\bdriv(?:e|ing)\b|traction|antrieb|accelerat", "driving-hub" if "hub" in plain else "driving"),
        (r"align|ruckstell|\bmz\b", _phase("aligning", plain)),
        (r"\blat|\bfy\b|seitenkraft|querkraft|side force", _phase("lateral", plain)),
        (r"bump ?steer", "bounce"),
        (r"\broll|wank|opposite wheel travel|opposed (?:vertical|wheel travel)", "roll"),
        (r"bounce|bump|jounce|heave|vertical|parallel|ride|wheel travel|einfeder|radhub|\bhub\b", "bounce"),
        (r"\bsteer|lenk|rack|handwheel", "steer"),
    ):  # fmt: skip
        if re.search(pattern, plain):
            return test
    return ""


def _phase(kind: str, plain: str) -> str:
    """Return the test of a force by the words of its phase; empty if it has none."""
    words = {*plain.split()}
    if re.search(_OPPOSED, plain):
        return f"{kind}-opposed"
    if re.search(r"in phase|parallel|same|gleich", plain) and "trail" not in plain:
        return f"{kind}-in-phase"
    if kind == "lateral":
        if "trail" in plain or "nachlauf" in plain:
            return "lateral-trail"
        for side, names in (("left", {"left", "l", "links"}), ("right", {"right", "r", "rechts"})):
            if words & names:
                return f"lateral-{side}"
    return ""


def recognised_test(values: Mapping[str, Array]) -> str:
    """Return the test that readings (SI) come from, by what moves most; empty if nothing is swept."""
    rack = _range(values, "rack_travel") / _STEERED
    handwheel = _range(values, "handwheel_angle") / _TURNED
    travel = max(_both(values, name) for name in ("contact_point_z", "wheel_centre_z"))
    if max(rack, handwheel) > 1.0:
        return "steer"
    if travel > _TRAVELLED:
        name = max(("contact_point_z", "wheel_centre_z"), key=lambda name: _both(values, name))
        return "roll" if _phase_of(values, name) == "opposed" else "bounce"
    if _range(values, "roll_angle") > 0.005:
        return "roll"
    reach = {
        "lateral": _both(values, "lateral_force"),
        "longitudinal": _both(values, "longitudinal_force"),
        "aligning": 10.0 * _both(values, "aligning_moment"),
    }
    kind = max(reach, key=lambda kind: reach[kind])
    if reach[kind] < _FORCED:
        return ""
    if kind == "longitudinal":
        force = _stack(values, "longitudinal_force")
        return "driving" if abs(np.nanmax(force)) > abs(np.nanmin(force)) else "braking"
    phase = _phase_of(values, "lateral_force" if kind == "lateral" else "aligning_moment")
    if kind == "aligning":
        return f"aligning-{'opposed' if phase == 'opposed' else 'in-phase'}"
    return f"lateral-{phase}"


def _range(values: Mapping[str, Array], name: str) -> float:
    array = values.get(name)
    return (
        0.0
        if array is None or not np.isfinite(array).any()
        else float(np.nanmax(array) - np.nanmin(array))
    )


def _both(values: Mapping[str, Array], quantity: str) -> float:
    return max(_range(values, f"{wheel}.{quantity}") for wheel in ("left", "right"))


def _stack(values: Mapping[str, Array], quantity: str) -> Array:
    names = [f"{wheel}.{quantity}" for wheel in ("left", "right")]
    return np.array([values[name] for name in names if name in values])


def _phase_of(values: Mapping[str, Array], quantity: str) -> str:
    """Return ``in-phase``, ``opposed``, ``left`` or ``right``: how the wheels move."""
    left, right = (_range(values, f"{wheel}.{quantity}") for wheel in ("left", "right"))
    both = f"left.{quantity}" in values and f"right.{quantity}" in values
    if min(left, right) < 0.2 * max(left, right):
        is_force = both and quantity == "lateral_force"
        return ("left" if left > right else "right") if is_force else "in-phase"
    a, b = _stack(values, quantity)
    good = np.isfinite(a) & np.isfinite(b)
    product = float(np.sum((a[good] - a[good].mean()) * (b[good] - b[good].mean())))
    return "in-phase" if product > 0.0 else "opposed"


def swept_input(
    test: str, values: Mapping[str, Array], track: float | None, where: str
) -> tuple[Array, str, str]:
    """Return the input of a test (SI), its unit and what it is made of; ``track`` in m.

    Raises RecordingError if the readings hold no input of the test.
    """
    if "input" in values:
        return values["input"], TESTS[test].unit, "input"
    if test in ("bounce", "roll"):
        return _of_travel(test, values, track, where)
    if test == "steer":
        for name, unit in (("rack_travel", "m"), ("handwheel_angle", "rad")):
            if name in values:
                return values[name], unit, name
        raise _no_input(test, "rack travel or handwheel angle", where)
    quantity = INPUTS[TESTS[test].kind]
    left, right = (values.get(f"{wheel}.{quantity}") for wheel in ("left", "right"))
    sign = -1.0 if test.startswith("braking") else 1.0
    opposed = -1.0 if test.endswith("opposed") else 1.0
    if test in ("lateral-left", "lateral-right"):
        own = left if test == "lateral-left" else right
        if own is None:
            raise _no_input(test, TESTS[test].what, where)
        return own, TESTS[test].unit, quantity
    parts = [
        part for part in (left, None if right is None else opposed * right) if part is not None
    ]
    if not parts:
        raise _no_input(test, TESTS[test].what, where)
    together = np.asarray(np.mean(parts, axis=0), dtype=float)
    if len(parts) == 2 and np.ptp(together) < 0.2 * max(np.ptp(part) for part in parts):
        raise RecordingError(
            "left and right are not loaded as in this test",
            where=where,
            found=test,
            allowed="equal forces" if opposed > 0.0 else "opposite forces",
            hint="Is it another test, or is the sign of one side wrong?",
        )
    return 0.0 + sign * together, TESTS[test].unit, quantity


def _of_travel(
    test: str, values: Mapping[str, Array], track: float | None, where: str
) -> tuple[Array, str, str]:
    if test == "roll" and "roll_angle" in values:
        return values["roll_angle"], "rad", "roll_angle"
    for quantity in ("contact_point_z", "wheel_centre_z"):
        left, right = (values.get(f"{wheel}.{quantity}") for wheel in ("left", "right"))
        if test == "bounce" and (left is not None or right is not None):
            present = [part for part in (left, right) if part is not None]
            return np.mean(present, axis=0), "m", quantity
        if test == "roll" and left is not None and right is not None:
            if track is None:
                raise RecordingError(
                    "the roll angle needs the track",
                    where=where,
                    allowed="a column of the roll angle, or the distance of the contact points",
                    hint='Give it: track="1.5 m", or track in the channel map.',
                )
            return np.arctan2(left - right, track), "rad", quantity
    raise _no_input(test, TESTS[test].what, where)


def _no_input(test: str, wanted: str, where: str) -> RecordingError:
    return RecordingError(
        "no column with the input of this test",
        where=where,
        found=test,
        allowed=wanted,
        hint="Map a column to it, or to input, in the channel map.",
    )
