"""C of expression graphs: what a compiler makes of it gives what the graph gives, in vectors and without them."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from jounce.exchange.fmu import code
from jounce.exchange.fmu.build import C, compile_library
from jounce.kernel import lowering
from jounce.kernel.packing import SHARED, Packed, Parts

PAIRS = Parts((("a",), ("b",)), ((0, 1),))
X, U, P, M = (ca.SX.sym(name, size) for name, size in (("x", 5), ("u", 2), ("p", 3), ("m", 2)))
LABELS = (
    (*(PAIRS.label(f"{part}.{name}") for part in "ab" for name in ("q", "v")), ("body", SHARED)),
    tuple(PAIRS.label(f"{part}.road") for part in "ab"),
    (*(PAIRS.label(f"{part}.k") for part in "ab"), ("g", SHARED)),
    tuple(PAIRS.label(f"{part}.contact") for part in "ab"),
)


def force(i: int) -> ca.SX:
    """What each of two parts does, every kind of operation in it."""
    q, v, k = X[2 * i], X[2 * i + 1], P[i]
    law = (
        k * ca.tanh(q) / (2.0 + v * v)
        + v / (2.0 + v * v)
        - ca.atan2(q, k)
        + ca.if_else(q > 0.1, -q, 1.0 / k)
    )
    return (
        M[i] * law
        + ca.fmax(q, ca.fabs(v))
        + ca.sign(v) * ca.sqrt(k)
        + 2.0 * ca.sin(U[i])
        + ca.constpow(k, 1.5)
    )


def packed(expression: ca.SX) -> Packed:
    return Packed(ca.Function("f", [X, U, P, M], [ca.cse(ca.densify(expression))]), PAIRS, LABELS)


BOTH = ca.vertcat(force(0), force(1), P[2] - force(0) - force(1), X[4], -3.0)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
@pytest.mark.parametrize(
    ("flags", "longest"), [((), 10**6), ((), 10), (("-DJN_NO_VECTORS",), 10**6)]
)
def test_code_gives_what_the_graph_gives(tmp_path, monkeypatch, flags, longest):
    monkeypatch.setattr(code, "_LONG", longest)
    text = code.function_text("found", packed(BOTH), ["x", "u", "p", "m"], {"one": 3, "two": 2})
    assert "times(" in text
    assert text.startswith("JN_LONG ") == (longest == 10)
    (tmp_path / "f.c").write_text(f'#include <math.h>\n#include "pairs.h"\n{text}')
    words = [
        "gcc",
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-Wno-unused-function",
        "-O1",
        "-shared",
        "-fPIC",
        f"-I{C}",
    ]
    subprocess.run([*words, *flags, "-o", tmp_path / "f.so", tmp_path / "f.c", "-lm"], check=True)
    found, rng = ctypes.CDLL(str(tmp_path / "f.so")).found, np.random.default_rng(3)
    for _ in range(5):
        given = [
            rng.uniform(-1.0, 1.0, 5),
            rng.uniform(-1.0, 1.0, 2),
            rng.uniform(0.5, 2.0, 3),
            np.array([1.0, 0.0]),
        ]
        out = np.zeros(5)
        found(*(ctypes.c_void_p(part.ctypes.data) for part in (*given, out[:3], out[3:])))
        assert out == pytest.approx(
            np.array(packed(BOTH).function(*given)).ravel(), rel=1e-13, abs=1e-14
        )


def test_what_divides_several_numbers_is_inverted_once():
    shared = ca.vertcat(X[4] / P[2], U[0] / P[2], X[4] / U[0])
    text = code.function_text("f", packed(shared), ["x", "u", "p", "m"], {"y": 3})
    assert text.count(" / ") == 2
    assert "1.0 / p[2]" in text


def test_every_operation_of_native_code_has_its_c():
    tables = (lowering._DIRECT, lowering._COMPARISONS, lowering._INTRINSICS, lowering._LIBRARY)
    native = {name.removeprefix("OP_") for table in tables for name in table} | {"OR"}
    assert native == set(code._NUMBERS)
    with pytest.raises(NotImplementedError, match="OP_ERF"):
        code.function_text("f", packed(ca.erf(X[4])), ["x", "u", "p", "m"], {"y": 1})


def test_constants_without_end_have_their_words_in_c():
    limits = ca.vertcat(X[0] * np.inf, X[0] * -np.inf, X[1] * np.nan, X[1] + -2.5)
    text = code.function_text("f", packed(limits), ["x", "u", "p", "m"], {"y": 4})
    for word in (" INFINITY", "(-INFINITY)", "NAN", "(-2.5)"):
        assert word in text
    assert "inf" not in text


def test_compilers_leave_nothing_elsewhere(tmp_path, monkeypatch) -> None:
    """Zig keeps some 50 MB in the home folder where nobody says another place."""
    script = tmp_path / "compiler.py"
    script.write_text(
        "import os, sys\n"
        "names = 'TMPDIR', 'ZIG_LOCAL_CACHE_DIR', 'ZIG_GLOBAL_CACHE_DIR'\n"
        "open(sys.argv[sys.argv.index('-o') + 1], 'w').write('|'.join(os.environ[name] for name in names))\n"
    )
    (tmp_path / "work").mkdir()
    (tmp_path / "work" / "model.c").touch()
    monkeypatch.delenv("ZIG_GLOBAL_CACHE_DIR", raising=False)
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))

    def places() -> list[str]:
        asked = ("zig", [sys.executable, str(script)])
        said = compile_library(tmp_path / "work", 2, "x86_64-linux", asked).decode().split("|")
        return [str(Path(one).relative_to(tmp_path)) for one in said]

    assert places() == ["work", "work/zig", "cache/zig"]
    monkeypatch.setenv("JOUNCE_CACHE_DIR", "nowhere")  # not absolute: none is known
    assert places() == ["work", "work/zig", "work/zig"]
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", str(tmp_path / "own"))
    assert places() == ["work", "work/zig", "own"]
