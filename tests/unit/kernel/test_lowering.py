"""Native code computes what CasADi computes: every operation, and random graphs of them."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from itertools import product

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from llvmlite import ir
from llvmlite.binding import parse_assembly

from jounce.kernel.lowering import _OPCODES, _SMALL, Lanes, Lowering, Wide
from jounce.kernel.machine import MachineCode, machine_code, this_machine
from jounce.kernel.native import compile_functions

UNARY = {
    "sin": ca.sin,
    "cos": ca.cos,
    "tan": ca.tan,
    "sqrt": ca.sqrt,
    "exp": ca.exp,
    "log": ca.log,
    "fabs": ca.fabs,
    "floor": ca.floor,
    "ceil": ca.ceil,
    "sign": ca.sign,
    "tanh": ca.tanh,
    "sinh": ca.sinh,
    "cosh": ca.cosh,
    "asin": ca.asin,
    "acos": ca.acos,
    "atan": ca.atan,
    "log1p": ca.log1p,
    "expm1": ca.expm1,
    "not": ca.logic_not,
    "negative": lambda x: -x,
    "square": lambda x: x**2,
    "inverse": lambda x: 1 / x,
    "twice": lambda x: 2 * x,
    "power of a constant": lambda x: x**2.5,
    "assign": lambda x: x + 0,
    "constant": lambda x: ca.SX(0.1) + 0 * x,
}
BINARY = {
    "plus": lambda x, y: x + y,
    "minus": lambda x, y: x - y,
    "times": lambda x, y: x * y,
    "over": lambda x, y: x / y,
    "less": lambda x, y: x < y,
    "at most": lambda x, y: x <= y,
    "equal": lambda x, y: x == y,
    "other": lambda x, y: x != y,
    "fmin": ca.fmin,
    "fmax": ca.fmax,
    "copysign": ca.copysign,
    "atan2": ca.atan2,
    "hypot": ca.hypot,
    "power": ca.power,
    "and": lambda x, y: ca.logic_and(x > 0, y > 0),
    "or": lambda x, y: ca.logic_or(x > 0, y > 0),
    "if else": lambda x, y: ca.if_else(x < y, x, 3 * y),
    "if": lambda x, y: ca.if_else(x, y, 0),
}
X = ca.SX.sym("x", 2)
OTHERS = [ca.SX.sym(name, 1) for name in "upm"]
ONE = np.ones(1)
VALUES = [-2.5, -1.0, -0.3, -0.0, 0.0, 1e-300, 0.3, 0.5, 1.0, 2.0, 700.0]


def native_and_reference(expressions, points):
    """Values of the expressions at the points, by native code and by CasADi."""
    expression = ca.vertcat(*expressions)
    function = ca.Function("f", [X, *OTHERS], [ca.densify(expression)])
    native = compile_functions({"f": function})
    shape = (expression.shape[0],)
    found = np.array(
        [
            native.evaluate("f", shape, np.array(point, dtype=float), ONE, ONE, ONE)
            for point in points
        ]
    )
    return found, np.array([function(point, 1, 1, 1).full().ravel() for point in points])


@pytest.mark.parametrize("name", UNARY)
def test_unary(name):
    points = [(value, 1.0) for value in VALUES]
    found, expected = native_and_reference([UNARY[name](X[0])], points)
    np.testing.assert_allclose(found, expected, rtol=3e-15, atol=0.0)


@pytest.mark.parametrize("name", BINARY)
def test_binary(name):
    points = [(a, b) for a in VALUES for b in VALUES]
    found, expected = native_and_reference([BINARY[name](X[0], X[1])], points)
    np.testing.assert_allclose(found, expected, rtol=3e-15, atol=0.0)


@pytest.mark.parametrize("name", ["sin", "exp", "tanh", "negative", "square"])
def test_what_is_no_number_stays_none(name):
    found, _ = native_and_reference([UNARY[name](X[0])], [(np.nan, 1.0)])
    assert np.isnan(found).all()


def test_samples_side_by_side_are_each_what_they_are_alone():
    """Numbers that all samples share meet vectors, and what has no form for vectors is done one by one."""
    both, (u, p, m) = X[0] * OTHERS[0] + X[1], OTHERS
    expressions = [
        *(f(both) for f in UNARY.values()),
        *(f(both, u) for f in BINARY.values()),
        p + m,
        ca.SX(2.0),
    ]
    function = ca.Function("f", [X, u, p, m], [ca.densify(ca.vertcat(*expressions))])
    lowering = Lowering()
    lowering.add_wide("f", function, 8)
    random = np.random.default_rng(5)
    x, at_u, shared = random.normal(size=(2, 8)), random.normal(size=(1, 8)), np.array([0.7, 0.2])
    found = np.empty((len(expressions), 8))
    code = MachineCode(
        [machine_code(parse_assembly(str(lowering.module)), this_machine(), 3)], ("f",)
    )
    pointer = ctypes.POINTER(ctypes.c_double)
    call = ctypes.CFUNCTYPE(None, *[pointer] * 5)(code.address["f"])
    call(*(array.ctypes.data_as(pointer) for array in (x, at_u, shared[:1], shared[1:], found)))
    expected = np.column_stack(
        [function(x[:, i], at_u[:, i], 0.7, 0.2).full().ravel() for i in range(8)]
    )
    np.testing.assert_allclose(found, expected, rtol=3e-14, atol=1e-300)


@pytest.mark.parametrize("operation", [ca.logic_and, ca.logic_or])
def test_logic_of_any_number(operation):
    found, expected = native_and_reference(
        [operation(X[0], X[1])], [(2.0, 3.0), (0.3, -0.7), (-2.5, 0.0)]
    )
    np.testing.assert_array_equal(found, expected)


def test_sign_of_what_is_no_number():
    found, _ = native_and_reference([ca.sign(X[0])], [(np.nan, 1.0)])
    assert np.isnan(found).all()


@pytest.mark.parametrize("operation", [ca.erf, ca.asinh, lambda x: ca.fmod(x, 2.0)])
def test_an_operation_without_native_form_is_named(operation):
    with pytest.raises(NotImplementedError, match=r"OP_(ERF|ASINH|FMOD) has no native form"):
        native_and_reference([operation(X[0])], [(1.0, 1.0)])


def test_every_operation_tried_here_is_the_one_meant():
    """The graphs above really contain the operations (CasADi simplifies some expressions away)."""
    found = set()
    for expression in [
        *(f(X[0]) for f in UNARY.values()),
        *(f(X[0], X[1]) for f in BINARY.values()),
    ]:
        function = ca.Function("f", [X], [expression])
        found |= {_OPCODES[function.instruction_id(k)] for k in range(function.n_instructions())}
    assert {
        "OP_SIGN",
        "OP_CONSTPOW",
        "OP_POW",
        "OP_IF_ELSE_ZERO",
        "OP_COPYSIGN",
        "OP_SQ",
        "OP_INV",
    } <= found
    assert {
        "OP_NOT",
        "OP_AND",
        "OP_OR",
        "OP_LT",
        "OP_LE",
        "OP_EQ",
        "OP_NE",
        "OP_HYPOT",
        "OP_EXPM1",
    } <= found


SMOOTH = [
    ca.sin,
    ca.cos,
    ca.tanh,
    ca.atan,
    lambda x: x**2 / (1 + x**2),
    lambda x: ca.sqrt(1 + x**2),
    lambda x: -x,
]
JOINED = [
    lambda x, y: x + y,
    lambda x, y: x - y,
    lambda x, y: x * y / 3,
    ca.fmin,
    ca.fmax,
    ca.hypot,
    lambda x, y: x / (2 + y**2),
    lambda x, y: ca.atan2(x, 1 + y**2),
]


@given(st.integers(0, 2**32 - 1))
def test_random_graphs(seed):
    """Forty operations at random on two numbers, at five points: equal to rounding."""
    generator = np.random.default_rng(seed)
    pool = [X[0], X[1], ca.if_else(X[0] < X[1], X[0], 0.5), ca.SX(0.7)]
    for _ in range(40):
        if generator.random() < 0.4:
            pool.append(
                SMOOTH[generator.integers(len(SMOOTH))](pool[generator.integers(len(pool))])
            )
        else:
            a, b = (pool[i] for i in generator.integers(len(pool), size=2))
            pool.append(JOINED[generator.integers(len(JOINED))](a, b))
    found, expected = native_and_reference(pool[-12:], generator.normal(0.0, 2.0, (5, 2)))
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize("count", [4, 8])
def test_systems_side_by_side_are_each_what_they_are_alone(count):
    """Every system has its own states, numbers and modes; what they feel they have in common."""
    x, u, p, m = (ca.SX.sym(name, size) for name, size in (("x", 2), ("u", 2), ("p", 3), ("m", 1)))
    parts = [
        x[0] * p[0] + u[1],
        ca.tanh(x[1]) * p[2] + ca.fmin(x[0], m[0]) + 1 / p[1],
        ca.if_else(x[0] < u[0], 2, p[1]),
    ]
    function = ca.Function("f", [x, u, p, m], [ca.vertcat(*parts, ca.SX(0.25), m[0] * x[1])])
    random = np.random.default_rng(count)
    states, numbers, modes = (random.uniform(0.5, 2.0, (size, count)) for size in (2, 3, 1))
    felt = random.uniform(0.5, 2.0, 2)
    native = compile_functions({"rate": Wide(function, count)})
    found = native.evaluate(
        "rate", (5 * count,), states.ravel(), felt, numbers.ravel(), modes.ravel()
    )
    for i, alone in enumerate(found.reshape(5, count).T):
        expected = function(states[:, i], felt, numbers[:, i], modes[:, i]).full().ravel()
        assert alone == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("systems", [1, 4])
def test_samples_of_a_large_function_are_each_what_they_are_alone(systems):
    """However many there are: fewer than a vector holds, whole vectors, some more; and no other is touched."""
    x, u, p, m = (ca.SX.sym(name, size) for name, size in (("x", 2), ("u", 1), ("p", 2), ("m", 1)))
    value = x[0]
    for k in range(40):
        value = ca.sqrt(1 + value**2) * p[k % 2] + x[1] * (u + k) / (60 + value**2) + m / (k + 1)
    function = ca.Function(
        "output", [x, u, p, m], [ca.vertcat(ca.sin(value), ca.exp(-x[1] * p[0]), ca.SX(0.25))]
    )
    assert function.n_instructions() > _SMALL
    native = compile_functions({"output": function if systems == 1 else Wide(function, systems)})
    total, random = 30, np.random.default_rng(systems)
    states, felt = random.normal(size=(2, systems, total)), random.normal(size=(1, total))
    numbers, modes = random.uniform(0.2, 0.9, (2, systems)), random.uniform(0.0, 1.0, (1, systems))
    pointer = ctypes.POINTER(ctypes.c_double)
    call = ctypes.CFUNCTYPE(None, *[pointer] * 5, *[ctypes.c_int64] * 3)(native.address["output"])
    for first, count in ((3, 0), (29, 1), (0, 3), (5, 8), (2, 9), (0, 30)):
        found = np.full((3, systems, total), -7.0)
        call(
            *(array.ctypes.data_as(pointer) for array in (states, felt, numbers, modes, found)),
            total,
            first,
            count,
        )
        for i, sample in product(range(systems), range(total)):
            alone = function(
                states[:, i, sample], felt[:, sample], numbers[:, i], modes[:, i]
            ).full()[:, 0]
            expected = alone if first <= sample < first + count else np.full(3, -7.0)
            np.testing.assert_allclose(found[:, i, sample], expected, rtol=1e-12, atol=1e-13)


@dataclass(frozen=True)
class Rows:
    """A function over so many of nineteen samples, inlined into another."""

    count: int
    names = ("rows",)

    def add(self, lowering: Lowering) -> None:
        x, u, p, m = (
            ca.SX.sym(name, size) for name, size in (("x", 2), ("u", 1), ("p", 1), ("m", 1))
        )
        function = ca.Function("f", [x, u, p, m], [ca.vertcat(p * x[0] + u, x[1] - m)])
        lowering.add_wide("inner", function, self.count, 19, inlined=True)
        native = lowering.declare("rows", [ir.DoubleType().as_pointer()] * 5)
        builder = ir.IRBuilder(native.append_basic_block())
        builder.call(lowering.module.globals["inner"], native.args)
        builder.ret_void()


@pytest.mark.parametrize("count", [1, 8, 9, 16, 19])
def test_the_first_samples_only_are_taken(count):
    x, u = np.arange(38.0).reshape(2, 19), np.linspace(-1.0, 1.0, 19)
    native, out, pointer = (
        compile_functions({}, Rows(count)),
        np.full((2, 19), -7.0),
        ctypes.POINTER(ctypes.c_double),
    )
    call = ctypes.CFUNCTYPE(None, *[pointer] * 5)(native.address["rows"])
    call(*(array.ctypes.data_as(pointer) for array in (x, u, 3.0 * ONE, 0.5 * ONE, out)))
    assert (out[:, count:] == -7.0).all()
    np.testing.assert_allclose(
        out[:, :count], np.array([3.0 * x[0] + u, x[1] - 0.5])[:, :count], rtol=1e-14
    )


def test_several_functions_and_outputs_share_a_module():
    f = ca.Function("f", [X, *OTHERS], [ca.vertcat(X[0] + OTHERS[0], X[1] * OTHERS[1])])
    g = ca.Function("g", [X, *OTHERS], [ca.densify(ca.jacobian(X[0] ** 2 * X[1], X))])
    native = compile_functions({"f": f, "g": g})
    point = np.array([2.0, 3.0])
    assert native.evaluate("f", (2,), point, 5 * ONE, 7 * ONE, ONE).tolist() == [7.0, 21.0]
    assert native.evaluate("g", (1, 2), point, ONE, ONE, ONE).tolist() == [[12.0, 4.0]]


def test_matrices_are_column_major():
    matrix = ca.SX([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]) * X[0]
    native = compile_functions({"f": ca.Function("f", [X, *OTHERS], [matrix])})
    found = native.evaluate("f", (2, 3), np.array([10.0, 0.0]), ONE, ONE, ONE)
    assert found.tolist() == [[10.0, 20.0, 30.0], [40.0, 50.0, 60.0]]


def test_code_has_no_branches():
    lowering = Lowering()
    lowering.add(
        "f", ca.Function("f", [X], [ca.if_else(X[0] < X[1], ca.fabs(X[0]), ca.sign(X[1]))])
    )
    text = str(lowering.module)
    assert " br " not in text
    assert text.count("define ") == 1


@pytest.mark.parametrize("count", [1, 3, 8, 10])
def test_lanes_are_directions_side_by_side(count):
    """Value and directional derivatives of a graph with branches, division and library calls."""
    d, dp = ca.SX.sym("d", 2), ca.SX.sym("dp")
    u, p, m = OTHERS
    value = ca.if_else(
        X[0] < X[1],
        ca.tanh(X[0]) / (2 + p * X[1] ** 2),
        ca.fmin(X[0], 3) * ca.sqrt(1 + X[1] ** 2) * u,
    )
    along = ca.jtimes(value, ca.vertcat(X, p), ca.vertcat(d, dp))
    result = ca.vertcat(value, X[1], along, d[1] - 2 * d[0], 3 * m, -dp)
    function = ca.Function("f", [ca.vertcat(X, d), u, ca.vertcat(p, dp), m], [result])
    native = compile_functions({"f": Lanes(function, count, (2, 1, 1, 1, 2))})
    generator = np.random.default_rng(count)
    for point in generator.normal(size=(5, 2)):
        directions, slopes = generator.normal(size=(2, count)), generator.normal(size=count)
        found = native.evaluate(
            "f",
            (2 + 4 * count,),
            np.concatenate([point, directions.ravel()]),
            0.7 * ONE,
            np.concatenate([1.3 * ONE, slopes]),
            ONE,
        )
        each = [
            function(np.concatenate([point, directions[:, i]]), 0.7, [1.3, slopes[i]], 1).full()[
                :, 0
            ]
            for i in range(count)
        ]
        np.testing.assert_allclose(found[:2], each[0][:2], rtol=3e-15)
        np.testing.assert_allclose(found[2:].reshape(4, count), np.array(each).T[2:], rtol=3e-14)


@pytest.mark.parametrize("operation", [ca.sin, lambda x: 1 / x, lambda x: ca.fmax(x, 0)])
def test_lanes_must_be_linear(operation):
    function = ca.Function("f", [X, *OTHERS], [operation(X[1])])
    with pytest.raises(NotImplementedError, match="no form for lanes"):
        compile_functions({"f": Lanes(function, 4, (1, 1, 1, 1, 0))})


@pytest.mark.parametrize(
    "row",
    [
        lambda c, x, u: (c * u + (c + 0.1)) * x + (c + 0.2) * x,
        lambda c, x, u: c * x + (c + 0.3) * (x - u * x),
    ],
)
def test_lanes_take_each_constant_for_itself(row):
    """Constants come and go while a graph is lowered: none may be taken for one that is gone."""
    constants, lanes = np.arange(1.0, 33.0) / 7.0, np.array([1.0, -2.0, 3.0, 0.5])
    u, p, m = OTHERS
    function = ca.Function("f", [X, u, p, m], [ca.vertcat(*(row(c, X[1], u) for c in constants))])
    native = compile_functions({"f": Lanes(function, 4, (1, 1, 1, 1, 0))})
    found = native.evaluate(
        "f", (32 * 4,), np.concatenate([[0.0], lanes]), 2 * ONE, ONE, ONE
    ).reshape(32, 4)
    np.testing.assert_allclose(found, row(constants[:, None], lanes, 2.0), rtol=1e-14)


def test_what_is_called_seldom_is_cut_into_blocks_and_gives_the_same():
    from llvmlite import binding as llvm

    from jounce.kernel.lowering import Lowering
    from jounce.kernel.native import compile_functions

    x, nothing = ca.SX.sym("x", 3), [ca.SX.sym(name, 0) for name in "upm"]
    value = x[0]
    for k in range(400):
        value = ca.sin(value) * x[k % 3] + k
    function = ca.Function("derived", [x, *nothing], [ca.vertcat(value, x)])
    lowering = Lowering()
    lowering.add("derived", function, seldom=True)
    module = llvm.parse_assembly(str(lowering.module))
    blocks = list(module.get_function("derived").blocks)
    sizes = [len(list(block.instructions)) for block in blocks]
    assert len(sizes) > 3
    assert max(sizes) < 300
    at = np.array([0.3, -0.7, 0.2])
    found = compile_functions({"derived": function}).evaluate(
        "derived", (4,), at, *[np.zeros(0)] * 3
    )
    np.testing.assert_allclose(found, function(at, [], [], []).full()[:, 0], rtol=1e-12)


def test_whatever_numbers_are_given_are_read():
    """Rows of numbers side by side go straight to native code, all others are copied first."""
    x, nothing = ca.SX.sym("x", 2), [ca.SX.sym(name, 0) for name in "upm"]
    native = compile_functions(
        {"rate": ca.Function("rate", [x, *nothing], [ca.horzcat(x, 2 * x, x**2)])}
    )
    right = [[1.0, 2.0, 1.0], [3.0, 6.0, 9.0]]
    empty = [np.zeros(0)] * 3
    for numbers in (
        np.array([1.0, 3.0]),
        np.array([1, 3]),
        np.array([1.0, 0.0, 3.0])[::2],
        np.array([[1.0], [3.0]]),
    ):
        assert native.evaluate("rate", (2, 3), numbers, *empty).tolist() == right
    read_only = np.array([1.0, 3.0])
    read_only.setflags(write=False)
    assert native.evaluate("rate", (6,), read_only, *empty).tolist() == [
        1.0,
        3.0,
        2.0,
        6.0,
        1.0,
        9.0,
    ]


@dataclass(frozen=True)
class Sums:
    """Sums of a function over so many of nine samples."""

    count: int
    names = ("sums",)

    def add(self, lowering: Lowering) -> None:
        x, u, p, m = (
            ca.SX.sym(name, size) for name, size in (("x", 2), ("u", 1), ("p", 2), ("m", 1))
        )
        function = ca.Function(
            "f", [x, u, p, m], [ca.vertcat(p[0] * x[0] * m + u, ca.sin(x[1]) - p[1])]
        )
        lowering.add_sum("sums", function, 9, self.count)


@pytest.mark.parametrize("count", [1, 2, 7, 9])
def test_a_sum_goes_over_the_first_samples_only(count):
    x, m = np.arange(18.0).reshape(2, 9) / 7.0, np.linspace(2.0, -1.0, 9)
    found = compile_functions({}, Sums(count)).evaluate(
        "sums", (2,), x, 0.5 * ONE, np.array([3.0, 0.25]), m
    )
    first = np.sum((3.0 * x[0] * m + 0.5)[:count]), np.sum((np.sin(x[1]) - 0.25)[:count])
    np.testing.assert_allclose(found, first, rtol=1e-14, atol=1e-14)
