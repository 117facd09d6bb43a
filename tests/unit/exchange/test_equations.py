"""Equations of motion as symbols and as text: they give the accelerations that runs are made of, however written."""

from __future__ import annotations

import math
import subprocess
import sys
import types

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu.platforms import this_platform
from jounce.core.errors import OutputError
from jounce.exchange.expressions import LATEX, PYTHON, identifiers, write_expressions
from jounce.exchange.fmu import build as native
from jounce.models import build

RIGS = ("kart-quarter-car", "kart-double-wishbone", "audi-a6-half-car-4dof")


def numbers_for(found, seed=3):
    """Arguments near the design pose, each element another."""
    model = build(jn.load(found)) if isinstance(found, str) else None
    rng = np.random.default_rng(seed)
    n = len(model.start)
    x = np.array([*model.start, *np.zeros(model.x.shape[0] - n)]) + 0.01 * rng.standard_normal(
        model.x.shape[0]
    )
    u = 0.01 * rng.standard_normal(model.u.shape[0])
    p = np.array([jn.load(found).parameters()[path] for path in model.parameters])
    return model, [x, u, p, np.ones(model.m.shape[0])]


@pytest.mark.parametrize("name", RIGS)
def test_they_give_the_rates_of_a_run(name) -> None:
    model, where = numbers_for(name)
    found = jn.equations(jn.load(name))
    M, Q, G, gamma, dq, dz = (np.array(part) for part in found.function(*where))
    n, k = len(Q), len(gamma)
    assert (M.shape, G.shape, len(found.constraints)) == ((n, n), (k, n), k)
    np.testing.assert_allclose(M, M.T, rtol=1e-12, atol=1e-12)
    assert np.linalg.eigvalsh(M).min() > 0.0
    whole = np.block([[M, -G.T], [G, np.zeros((k, k))]])
    a = np.linalg.solve(whole, np.vstack([Q, -gamma]))[:n]
    rate = np.array(ca.Function("rate", [model.x, model.u, model.p, model.m], [model.rate])(*where))
    np.testing.assert_allclose(
        np.vstack([dq, a, dz]), rate, rtol=1e-8, atol=1e-8 * np.abs(rate).max()
    )


def fake_sympy(values):
    """SymPy's names over numbers: a symbol is its value."""
    module = types.ModuleType("sympy")
    known = (
        "acos",
        "asin",
        "atan",
        "atan2",
        "cos",
        "cosh",
        "exp",
        "log",
        "sin",
        "sinh",
        "sqrt",
        "tan",
        "tanh",
    )
    symbols = {name: getattr(math, name) for name in known}

    def piecewise(*pairs):
        return next(value for value, condition in pairs if condition)

    symbols |= {
        "Abs": abs,
        "Max": max,
        "Min": min,
        "Eq": lambda a, b: a == b,
        "Ne": lambda a, b: a != b,
    }
    symbols |= {"sign": np.sign, "Piecewise": piecewise, "Symbol": lambda name, **_: values[name]}
    symbols["Matrix"] = lambda *given: (
        np.zeros(given[:2]) if len(given) == 3 else np.array(given[0], dtype=float)
    )
    vars(module).update(symbols)
    return module


@pytest.mark.parametrize("name", RIGS)
def test_the_module_for_sympy_says_the_same(name, monkeypatch) -> None:
    _, where = numbers_for(name)
    found = jn.equations(jn.load(name))
    names = [part for group in found.arguments.values() for part in group]
    values = dict(zip(names, np.concatenate(where), strict=True))
    monkeypatch.setitem(sys.modules, "sympy", fake_sympy(values))
    scope: dict[str, object] = {}
    exec(compile(found.sympy(), "equations.py", "exec"), scope)  # noqa: S102 - what was just written
    for result, part in zip(("M", "Q", "G", "gamma", "dq"), found.function(*where), strict=False):
        own = np.array(part)
        np.testing.assert_allclose(np.reshape(scope[result], own.shape), own, rtol=1e-9, atol=1e-9)
    assert scope["numbers"] == found.numbers


def test_the_c_says_the_same(tmp_path) -> None:
    compiler = native.compiler_for((this_platform(),))
    if compiler is None:
        pytest.skip("no compiler")
    _, where = numbers_for("kart-double-wishbone")
    found = jn.equations(jn.load("kart-double-wishbone"))
    (tmp_path / "equations.c").write_text(found.c())
    library = tmp_path / "equations.so"
    subprocess.run(
        [
            *compiler[1],
            "-shared",
            "-fPIC",
            "-O1",
            str(tmp_path / "equations.c"),
            "-o",
            str(library),
            "-lm",
        ],
        check=True,
    )
    parts = ca.external("equations", str(library))(*where)
    for part, own in zip(parts, found.function(*where), strict=True):
        np.testing.assert_allclose(
            np.array(part).ravel(), np.array(own).ravel(order="F"), rtol=1e-12, atol=1e-12
        )


def test_latex_is_whole_and_names_everything() -> None:
    text = jn.equations(jn.load("kart-quarter-car")).latex()
    assert text.count("{") == text.count("}")
    assert text.count(r"\left") == text.count(r"\right")
    assert r"\mathrm{strut.spring.rate}" in text
    assert (
        r"M = \begin{pmatrix} \mathrm{sprung.mass} & 0 \\ 0 & \mathrm{unsprung.mass} \end{pmatrix}"
        in text
    )


def test_every_operation_is_written_as_it_computes() -> None:
    a, b = ca.SX.sym("a"), ca.SX.sym("b")
    parts = [
        a + b, a - (b - a), a * (b + a), a / (b * a), -a, -(a + b), a**2, (a + b) ** 2, 2 * (a + b), 1 / (a + b),
        ca.sqrt(a), a**b, (a + b) ** 2.5, ca.exp(a), ca.log(b), ca.sin(a), ca.cos(a), ca.tan(a), ca.asin(a), ca.acos(a),
        ca.atan(b), ca.atan2(a, b), ca.sinh(a), ca.cosh(a), ca.tanh(a), ca.fabs(-a), ca.sign(a - b), ca.copysign(a, -b),
        ca.fmin(a, b), ca.fmax(a, b), a < b, a <= b, ca.eq(a, b), ca.ne(a, b), ca.logic_not(a < b),
        ca.logic_and(a < b, b < a), ca.logic_or(a < b, b < a), ca.if_else(a < b, a, b), -2.0 * a, a - (-1.5), 1e-20 * b,
        (-a) ** 2, a - (a + b) * b,
    ]  # fmt: skip
    function = ca.Function("f", [a, b], [ca.vertcat(*parts)])
    found = write_expressions(function, [["a"], ["b"]], PYTHON)
    scope = {**vars(fake_sympy({})), "a": 0.3, "b": 1.7}
    for name, text in found.definitions:
        scope[name] = eval(text, scope)  # noqa: S307 - what was just written
    own = np.array(function(0.3, 1.7)).ravel()
    np.testing.assert_allclose([eval(text, scope) for text in found.results[0]], own, rtol=1e-12)  # noqa: S307
    latex = write_expressions(function, [["a"], ["b"]], LATEX)
    for text in (*latex.results[0], *(text for _, text in latex.definitions)):
        assert text.count("{") == text.count("}")
        assert text.count(r"\left") == text.count(r"\right")
        assert "--" not in text


def test_names_that_collide_are_refused() -> None:
    with pytest.raises(OutputError, match="two names are the same in Python"):
        identifiers(["a.b", "a b"])
