"""Directional derivatives of a model's equations, without differentiating the solution for its accelerations.

With the balance ``r(x, u, p, a) = 0`` solved for the unknowns ``a`` by factors ``K``, their change along a direction is
``K`` applied to the change of ``r`` at constant ``a``: the factors are reused and not differentiated.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.mechanics.model import Model


@dataclass(frozen=True)
class Tangent:
    """Changes of a model's expressions along one direction, linear in it.

    ``projection`` is the change of the projected states, evaluated on the constraints; empty without loops.
    """

    rate: ca.SX
    output: ca.SX
    switch: ca.SX
    constraint: ca.SX
    projection: ca.SX


def tangent(model: Model, dx: ca.SX, du: ca.SX, dp: ca.SX) -> Tangent:
    """Differentiate a model along a direction of states, inputs and parameters; exploits structural zeros."""
    balance = model.balance
    known, along = ca.vertcat(model.x, model.u, model.p), ca.vertcat(dx, du, dp)
    answered = balance.answer(ca.jtimes(balance.residual, known, along))
    every, directions = ca.vertcat(known, balance.unknown), ca.vertcat(along, answered)
    change = ca.jtimes(ca.vertcat(balance.rate, balance.output), every, directions)
    change, count = ca.substitute(change, balance.unknown, balance.found), balance.rate.shape[0]
    rate, output = change[:count], change[count:]
    switch, constraint = (
        ca.jtimes(part, known, along) for part in (model.switch, model.constraint)
    )
    return Tangent(rate, output, switch, constraint, _projection(model, dx, dp, known, along))


def _projection(model: Model, dx: ca.SX, dp: ca.SX, known: ca.SX, along: ca.SX) -> ca.SX:
    """Return the changes of coordinates and speeds projected onto the constraints, then those of internal states."""
    if not model.projection.shape[0]:
        return ca.SX(0, 1)
    balance, (n_q, n_v) = model.balance, (len(model.coordinates), len(model.speeds))
    residual, drifted = (
        ca.jtimes(part, known, along) for part in (model.constraint, balance.constraint_rate)
    )
    shift = ca.SX.sym("shift", n_v)
    displaced = balance.moved(shift)
    start = ca.vertcat(model.x[:n_q], model.p, shift)
    change = ca.jtimes(displaced, start, ca.vertcat(dx[:n_q], dp, -balance.correction(residual)))
    coordinates = ca.substitute(change, shift, ca.SX.zeros(n_v))
    speeds = dx[n_q : n_q + n_v] - balance.correction(drifted)
    return ca.vertcat(coordinates, speeds, dx[n_q + n_v :])
