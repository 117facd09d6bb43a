"""Equal parts side by side: what becomes a vector, what stays a number; the code gives what the graph gives."""

from __future__ import annotations

import ctypes

import casadi as ca
import numpy as np
import pytest

from jounce.kernel.native import compile_functions
from jounce.kernel.packing import SHARED, Packed, Parts

FOUR = Parts((("a", "front"), ("b", "front"), ("c", "rear"), ("d", "rear")), ((0, 1, 2, 3),))
PAIRS = Parts(FOUR.prefixes, ((0, 1), (2, 3)))
NAMES = "abcd"
X, U, P, M = (ca.SX.sym(name, size) for name, size in (("x", 9), ("u", 4), ("p", 7), ("m", 4)))
LABELS = (
    (*(FOUR.label(f"{part}.{name}") for part in NAMES for name in ("q", "v")), ("body", SHARED)),
    tuple(FOUR.label(f"{part}.road") for part in NAMES),
    (
        *(FOUR.label(f"{part}.k") for part in NAMES),
        FOUR.label("front.bar"),
        FOUR.label("rear.bar"),
        ("g", SHARED),
    ),
    tuple(FOUR.label(f"{part}.contact") for part in NAMES),
)


def packed(expression, parts=FOUR, table=None):
    function = ca.Function("f", [X, U, P, M], [ca.cse(ca.densify(ca.vertcat(expression)))])
    return Packed(function, parts, LABELS, table if table is not None else {})


def springs(law=lambda q, k: k * ca.tanh(q)):
    """A force a part, with bars between the parts of an axle and a body that all of them push."""
    force = [
        M[i] * law(X[2 * i] - U[i], P[i]) + ca.sin(X[2 * i + 1]) / (2.0 + X[8] ** 2)
        for i in range(4)
    ]
    bars = [P[4] * (X[0] - X[2]), P[5] * (X[4] - X[6])]
    force = [f + bars[i // 2] for i, f in enumerate(force)]
    total = P[6] - force[0] - force[1] - force[2] - force[3]
    return ca.vertcat(*(f + total * X[2 * i + 1] for i, f in enumerate(force)), total)


def test_names_say_which_parts_something_belongs_to():
    assert FOUR.label("a.q") == ("0.q", 0b0001)
    assert FOUR.label("d.q") == ("0.q", 0b1000)
    assert FOUR.label("front.bar") == ("1.bar", 0b0011)
    assert FOUR.label("rear.bar") == ("1.bar", 0b1100)
    assert FOUR.label("body.mass") == ("body.mass", SHARED)
    assert FOUR.label("another.q") == ("another.q", SHARED)


def numbers_alone(graph):
    """Operations that no vector holds."""
    return [i for i, node in enumerate(graph.nodes) if node.operands and graph.group_of(i) is None]


def test_what_parts_do_alike_is_one_vector_and_sums_over_parts_are_numbers():
    graph = packed(springs()).graph
    alone = {graph.nodes[i].operation for i in numbers_alone(graph)}
    assert len(numbers_alone(graph)) == 6  # four to add up the forces, two that are of the body
    assert alone <= {"OP_ADD", "OP_SUB", "OP_SQ", "OP_CONSTPOW"}
    spread = [i for i in range(len(graph.nodes)) if graph.is_mixed(i) and graph.group_of(i)]
    assert len(spread) == 2  # the difference across each bar is one number for both parts


def test_a_function_without_results_has_no_nodes():
    graph = packed(ca.SX(0, 1)).graph
    assert (graph.nodes, graph.results, graph.members) == ([], {}, [])


def test_a_part_that_differs_stays_a_number():
    same = [ca.sin(X[2 * i]) * P[i] for i in range(4)]
    odd = [*same[:3], ca.cos(X[6]) * P[3]]
    assert not numbers_alone(packed(ca.vertcat(*same)).graph)
    graph = packed(ca.vertcat(*odd)).graph
    assert len(numbers_alone(graph)) == 8
    pairs = packed(ca.vertcat(*odd), PAIRS).graph
    assert len(numbers_alone(pairs)) == 4  # front is alike all the same


CASES = {
    "tanh": springs(),
    "square root": springs(lambda q, k: k * ca.sqrt(1.0 + q * q)),
    "kinks": springs(lambda q, k: ca.fmax(k * q, 0.1) + ca.fabs(q) + ca.if_else(q > 0.0, q, -k)),
    "division": springs(lambda q, k: 1.0 / (k + q * q) + q / k),
    "constants": ca.vertcat(*(ca.SX(float(i)) for i in range(4)), X[8], 3.0 * X[0]),
    "a lane as it is": ca.vertcat(X[0], X[2], X[4], X[6], P[0], U[3]),
}


@pytest.mark.parametrize("parts", [FOUR, PAIRS], ids=["four", "pairs"])
@pytest.mark.parametrize("name", CASES)
def test_code_gives_what_the_graph_gives(name, parts):
    table: dict[tuple[int, ...], int] = {}
    made = packed(CASES[name], parts, table)
    random = np.random.default_rng(3)
    x, u, m = random.normal(size=9), random.normal(size=4), np.array([1.0, 0.0, 1.0, 1.0])
    p = 1.0 + random.random(7)
    wanted = made.function(x, u, p, m).full().ravel()
    for copied in (
        False,
        True,
    ):  # parameters gathered one by one, and side by side behind the others
        if copied:
            for elements in made.graph.tables(2):
                table[elements] = len(p)
                p = np.concatenate([p, p[list(elements)]])
        native = compile_functions({"f": made})
        found = native.evaluate("f", wanted.shape, x, u, p, m)
        assert np.allclose(found, wanted, rtol=1e-13, atol=1e-14)


def test_many_samples():
    made = packed(springs())
    random = np.random.default_rng(4)
    x, u = random.normal(size=(9, 5)), random.normal(size=(4, 5))
    p, m, out = 1.0 + random.random(7), np.ones(4), np.zeros((5, 5))
    native = compile_functions({"output": made})
    pointers = [array.ctypes.data for array in (x, u, p, m, out)]
    function = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5, *[ctypes.c_int64] * 3)(
        native.address["output"]
    )
    function(*pointers, 5, 1, 3)
    for k in range(5):
        wanted = made.function(x[:, k], u[:, k], p, m).full().ravel() if 1 <= k < 4 else 0.0
        assert np.allclose(out[:, k], wanted, rtol=1e-13, atol=1e-14)
