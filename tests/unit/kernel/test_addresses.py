"""Whoever holds an address holds its code: a run goes on though its model was let go meanwhile."""

from __future__ import annotations

import gc
import weakref

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.kernel.engine import Engine
from jounce.kernel.machine import Address
from jounce.kernel.methods.rows import row_loops
from jounce.kernel.native import _evaluate, compile_functions
from jounce.kinematics.sweeps import prepare_sweep
from jounce.simulation.compiled import compile_rig
from jounce.simulation.linear_systems import slopes_of


def test_code_is_unloaded_with_its_last_address():
    x, u, p, m = (ca.SX.sym(name, 1) for name in "xupm")
    native = compile_functions({"f": ca.Function("f", [x, u, p, m], [3.0 * x])})
    address, out, one = native.address["f"], np.empty(1), np.ones(1)
    code = weakref.ref(address._code)
    del native
    gc.collect()
    assert code() is not None
    _evaluate(address, 2.0 * one, one, one, one, out)
    assert out == 6.0
    del address
    assert code() is None


def engine(rig: str, free: tuple[str, ...] = ()) -> Engine:
    return compile_rig(jn.load(rig), free).engine


TUPLES = {
    "of a run": lambda: engine("kart-quarter-car"),
    "of a mechanism": lambda: engine("kart-double-wishbone"),
    "with slopes": lambda: engine("kart-quarter-car", ("tyre.stiffness",)),
    "of steps of lower order": lambda: compile_rig(jn.load("kart-quarter-car")).short_engine,
    "of loops over rows": lambda: row_loops(4, 3),
    "of linear systems": lambda: slopes_of(compile_rig(jn.load("kart-quarter-car"))),
    "of poses": lambda: prepare_sweep(jn.load("kart-double-wishbone"), [0.0]).walk,
}


@pytest.mark.parametrize("which", TUPLES)
def test_what_loops_work_on_holds_its_code(which):
    numbers = [
        value for value in TUPLES[which]() if isinstance(value, int) and abs(value) > 1 << 16
    ]
    assert numbers
    assert all(isinstance(number, Address) for number in numbers)
