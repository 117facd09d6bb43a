"""Static equilibrium of bodies between elastic elements and ideal joints, along a path of loads and controls.

A body has a pose: 12 numbers, its displacement from the design position and its rotation matrix, so that a point of the
design position ``p`` is at ``t + R p``. Its unknowns are a small displacement and a rotation about the ground's
origin. Forces and moments refer to that origin, too; an element then depends on a body through its points and
directions alone, and moving a point of the design is moving the body for that element.

Controls are heights of contact points and distances along ``DOT`` elements. Each has a multiplier, the force that it
exerts, and a step prescribes a mixture of values and forces: ``values @ c + forces @ multipliers = target``.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.kernel.arrays import Block, IntegerMatrix, Integers, Matrix, Vector
from jounce.kernel.call import Loop

BUSHING, LINE, TWIST, POINT, DOT, ALIGN, DISTANCE = range(7)
"""Kinds of elements; the first three are elastic, the others are constraints with multipliers."""
ROWS = {BUSHING: 0, LINE: 0, TWIST: 0, POINT: 3, DOT: 1, ALIGN: 1, DISTANCE: 1}
"""Number of multipliers of each kind."""
WIDTH = 48
"""Numbers of an element. ``P``, ``A`` ... are the first of each group:

BUSHING
    point P (3), axes A (3 x 3, in rows), stiffness K (6), preload F (6), friction S (6), stiffness before it slips B
    (6), factor C of each curve (6).
LINE
    points P and Q, length L at which a law is zero, sign of deflection, preload, friction, stiffness before it slips,
    rate K, factor of the curve. Force, pushing apart: ``preload + sign * law(sign * (L - length))``.
TWIST
    axis P and a direction Q across it on both bodies, angle L at which torque is zero, stiffness K.
POINT, DISTANCE
    points P and Q, and the length L of a distance.
DOT
    points P and Q, direction A on the first body, value L.
ALIGN
    direction A on the first body, P on the second, cosine L.
"""
P, A, K, F, S, B, C = 0, 3, 12, 18, 24, 30, 36
Q, LENGTH, SIGN, PRELOAD, SLIP, HOLD, RATE, FACTOR, ALONG = 3, 6, 7, 8, 9, 10, 11, 12, 13
LINEAR, POLYNOMIAL, POWER, TABLE, STOP = range(5)
"""Laws: ``k x`` (the element's own stiffness), polynomial without constant, power, table, bump stop."""
LOADS = 7
"""Loads of a wheel: x, y of the force at the contact point, moment about z, x, y, z of the force at the wheel centre,
distance behind the contact point, against the wheel's heading, at which its horizontal force acts."""
WHEEL = 8
"""Numbers of a wheel: centre (3), axis (3), radius; the last is free."""
SETTLED, NO_EQUILIBRIUM, SINGULAR, NOT_TRIED = range(4)
"""Outcome of a step."""


class Assembly(NamedTuple):
    """Bodies and elements.

    ``kinds`` has for each element its kind, the two bodies (-1 is the ground), its first row of multipliers, and a law
    for each direction (-1: linear). ``wheels`` has numbers of each wheel, ``carriers`` its body. ``controls`` has for
    each control 0 and a wheel, or 1 and a DOT element without a row of its own.
    """

    kinds: IntegerMatrix
    data: Matrix
    laws: IntegerMatrix
    law_data: Vector
    carriers: Integers
    wheels: Matrix
    controls: IntegerMatrix


class Path(NamedTuple):
    """Steps: mixture of control values and forces, targets (steps, controls) and loads (steps, wheels * LOADS)."""

    values: Matrix
    forces: Matrix
    targets: Matrix
    loads: Matrix


class Settled(NamedTuple):
    """Equilibria.

    Poses (steps, bodies * 12), multipliers and controls' forces (steps, n), forces of elements (steps, elements * 6),
    outcome of each step, and the slopes of all unknowns by each seed's parameter (steps, n, parameters).
    """

    poses: Matrix
    multipliers: Matrix
    forces: Matrix
    outcome: Integers
    slopes: Block


class Seeds(NamedTuple):
    """Changes of elements' and wheels' numbers by parameters: (element or -1 - wheel, parameter), numbers of each."""

    places: IntegerMatrix
    changes: Matrix


class Space(NamedTuple):
    """Scratch: matrix, its factors in an ``order`` that keeps zeros, right-hand sides, poses, multipliers."""

    matrix: Matrix
    factors: Matrix
    order: Integers
    pivots: Integers
    filled: Integers
    right: Matrix
    ordered: Matrix
    change: Vector
    pose: Matrix
    multipliers: Matrix
    slipped: Matrix
    now: Vector
    work: Matrix


_settle = Loop("equilibrium")


def settle(
    assembly: Assembly,
    path: Path,
    seeds: Seeds,
    bodies: int,
    multipliers: int,
    parameters: int,
    start: tuple[Matrix, Vector, Matrix] | None = None,
) -> tuple[Settled, Space]:
    """Find equilibrium at each step, continued from the one before; the first from the design or a ``start``.

    A ``start`` has pose (bodies, 12), multipliers, and slipped deflections (elements, 6).
    """
    steps, controls = path.targets.shape
    elements = len(assembly.kinds)
    n = 6 * bodies + multipliers + controls
    settled = Settled(
        np.full((steps, 12 * bodies), np.nan),
        np.full((steps, multipliers + controls), np.nan),
        np.full((steps, 6 * elements), np.nan),
        np.full(steps, NOT_TRIED, dtype=np.int64),
        np.zeros((steps if parameters else 0, n, parameters)),
    )
    design = np.zeros((bodies, 12))
    design[:, 3] = design[:, 7] = design[:, 11] = 1.0
    pose, before, slipped = start or (
        design,
        np.zeros(multipliers + controls),
        np.zeros((elements, 6)),
    )
    space = Space(
        np.zeros((n, n)),
        np.zeros((n, n)),
        elimination_order(
            np.ascontiguousarray(assembly.kinds[:, :4]).tobytes(), bodies, n - controls, n
        ),
        np.zeros(n, dtype=np.int64),
        np.zeros(n, dtype=np.int64),
        np.zeros((n, 1 + parameters)),
        np.zeros((n, 1 + parameters)),
        np.zeros(n),
        np.concatenate([pose] * 4),
        np.stack([before] * 4),
        np.concatenate([slipped, slipped]),
        np.zeros(controls + path.loads.shape[1]),
        np.zeros((12, 12)),
    )
    _settle(assembly, path, seeds, settled, space)
    return settled, space


@lru_cache(64)  # paths of one assembly are followed many times
def elimination_order(
    connections: bytes, bodies: int, first_control: int, count: int
) -> NDArray[np.int64]:
    """Return the order in which the unknowns are eliminated: of the least connected first, controls last.

    Unknowns of a body stay together, and so do those of a constraint. ``connections`` are the first columns of an
    assembly's ``kinds``: kind, bodies, first row of multipliers.
    """
    groups = [list(range(6 * body, 6 * body + 6)) for body in range(bodies)]
    links: list[set[int]] = [set() for _ in groups]
    for kind, first, second, row in (
        np.frombuffer(connections, dtype=np.int64).reshape(-1, 4).tolist()
    ):
        ends = {body for body in (first, second) if body >= 0}
        if row >= 0:
            ends.add(len(groups))
            groups.append([6 * bodies + row + i for i in range(ROWS[kind])])
            links.append(set())
        for end in ends:
            links[end] |= ends - {end}
    order: list[int] = []
    left = set(range(len(groups)))
    while left:
        # A constraint has no stiffness of its own: one of its bodies comes before it.
        ready = [g for g in left if g < bodies or any(other not in left for other in links[g])]
        chosen = min(ready or left, key=lambda g: (sum(len(groups[o]) for o in links[g] & left), g))
        left.remove(chosen)
        order += groups[chosen]
        for other in links[chosen] & left:
            links[other] |= links[chosen] - {other}
    return np.array([*order, *range(first_control, count)], dtype=np.int64)
