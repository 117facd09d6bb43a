"""Loops come as machine code: of the sources as they are, by one way or the next, and refuse what they are not for."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from jounce.core.optional import MissingPackageError
from jounce.core.sources import digest_of
from jounce.kernel import arrays, cache, call, loops
from jounce.kernel.call import Loop
from jounce.kernel.loops import BUILT, LOOPS, PLATFORMS, key_of, make, this_platform

PATH = np.array([0.0, 1.0, 2.0, 1.5, -1.0])
SOURCES = Path(call.__file__).parent.parent


def follow(path: object = PATH, **changed: object) -> np.ndarray:
    """State of the Bouc-Wen law along a path, by the smallest of the loops."""
    given = {
        "path": path,
        "rate": 1.0,
        "sigma": 0.5,
        "exponent": 1.0,
        "start": 0.0,
        "state": np.full(5, np.nan),
    }
    given |= changed
    assert Loop("hysteresis")(*given.values()) == 0
    return given["state"]


@pytest.fixture(scope="session")
def right() -> np.ndarray:
    return np.array([0.0, 1.0 - np.exp(-1.0), 1.0 - np.exp(-2.0)])


@pytest.fixture
def elsewhere(tmp_path, monkeypatch):
    """An empty folder of built code and an empty cache."""
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setattr(call, "BUILT", tmp_path / "built")
    monkeypatch.setattr(make, "BUILT", tmp_path / "built")
    return tmp_path


@pytest.fixture
def steps(monkeypatch):
    """What had to be made."""
    done = []
    for name in ("object_for", "bitcode_from_sources"):
        real = getattr(call, name)
        monkeypatch.setattr(
            call, name, lambda *given, name=name, real=real: done.append(name) or real(*given)
        )
    return done


def test_every_loop_is_listed_and_used() -> None:
    used = {
        name
        for file in SOURCES.rglob("*.py")
        for name in re.findall(r'Loop\("(\w+)"\)', file.read_text("utf-8"))
    }
    assert used == set(LOOPS)
    for module, function in LOOPS.values():
        assert hasattr(import_module(f"jounce.kernel.loops.{module}"), function)


@pytest.mark.skipif(not BUILT.exists(), reason="make loops")
def test_built_code_is_of_the_sources_as_they_are() -> None:
    """Or an edit would run old code, or a checkout compile at its first run."""
    digest, platform = digest_of(*loops.SOURCES), this_platform()
    for name in LOOPS:
        assert cache.read_sealed(BUILT / f"{name}.bc", key_of(name, digest)), name
        if platform in PLATFORMS:
            file = BUILT / platform / f"{name}.o"
            assert cache.read_sealed(file, key_of(name, digest, platform)), name
            assert cache.read_sealed(file, key_of(name, "another", platform)) is None
            assert cache.read_sealed(file, key_of("another", digest, platform)) is None


def test_a_printed_table_of_a_cached_run_imports_no_table_library(tmp_path) -> None:
    (tmp_path / "bump.toml").write_text('kind = "half-sine"\nheight = "10 mm"\nlength = "60 mm"\n')
    script = """
import sys
from jounce.cli import main
sys.argv[1:] = ["simulate", "kart-quarter-car", "--road", sys.argv[1], "--speed", "1.95 m/s", "--duration", "0.5 s"]
try:
    main()
except SystemExit as end:
    assert not end.code, end
print(sorted({"numba", "pandas", "scipy.interpolate", "xarray"} & set(sys.modules)))
"""
    command = [sys.executable, "-c", script, str(tmp_path / "bump.toml")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.endswith("[]\n"), done.stdout


@pytest.mark.skipif(not BUILT.exists(), reason="make loops")
def test_a_first_run_compiles_no_loop_and_imports_no_compiler_of_them(tmp_path) -> None:
    script = """
import sys
import jounce as jn
trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
from jounce.kernel import call
call.bitcode_from_sources = None
if call._suits(call.this_platform()):  # older processors take the bitcode
    call.object_for = None
jn.simulate(jn.load("kart-quarter-car"), trial)
assert "numba" not in sys.modules
"""
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_the_law_is_followed(right) -> None:
    np.testing.assert_allclose(follow()[:3], right, rtol=1e-3)
    path = PATH.copy()
    path.setflags(write=False)
    assert np.array_equal(follow(path), follow())
    assert np.array_equal(follow(rate=np.float64(1.0), exponent=1), follow())


BAD = {
    "numbers of half the size": PATH.astype(np.float32),
    "integers": PATH.astype(np.int64),
    "complex numbers": PATH.astype(complex),
    "bytes the other way round": PATH.astype(">f8"),
    "every second": np.zeros(10)[::2],
    "backwards": PATH[::-1],
    "two dimensions": PATH[None],
    "no dimension": np.array(1.0),
    "not aligned": np.frombuffer(b"x" * 41, dtype=np.uint8)[1:].view(np.float64),
    "a list": PATH.tolist(),
    "a tuple": tuple(PATH),
    "a masked array": np.ma.masked_array(PATH),
    "None": None,
    "a number": 1.0,
}


@pytest.mark.parametrize("bad", BAD)
def test_what_is_no_such_array_is_refused(bad) -> None:
    state = np.full(5, np.nan)
    with pytest.raises(
        TypeError, match=r"loop 'hysteresis': displacement is .*, allowed is float64, 1 dimension"
    ):
        follow(BAD[bad], state=state)
    assert np.isnan(state).all()


def test_other_bad_arguments_are_refused() -> None:
    state = np.full(5, np.nan)
    with pytest.raises(TypeError):
        follow(rate="fast", state=state)
    with pytest.raises(TypeError, match="arguments is tuple of 1, allowed is a tuple of 6"):
        Loop("hysteresis")(PATH)
    with pytest.raises(TypeError, match="problem is int, allowed is a tuple of 7"):
        Loop("rate_bound")(1, 2)
    assert np.isnan(state).all()


def test_what_is_refused_is_named_through_all_tuples() -> None:
    from jounce.kernel.engine import Engine, Problem, Tracks

    none, whole = np.zeros(0), np.zeros(0, dtype=np.int64)
    tracks = Tracks(whole, none, none, whole, np.zeros((4, 3)).T, none)
    problem = Problem(Engine(*[0] * 11), tracks, whole, none, none, none, 0)
    with pytest.raises(
        TypeError, match=r"problem\.tracks\.coefficients is <f8, 2 dimensions, order F, allowed is"
    ):
        Loop("rate_bound")(problem, ())


def test_the_ways_after_each_other(elsewhere, steps, right) -> None:
    """Nothing there: from the sources. Then from what that left, whatever of it is taken away or damaged."""
    expected = follow()
    np.testing.assert_allclose(expected[:3], right, rtol=1e-3)
    assert steps == ["bitcode_from_sources", "object_for"]
    assert np.array_equal(follow(), expected)
    assert len(steps) == 2
    (object_file,) = elsewhere.rglob("*.o")
    (bitcode_file,) = elsewhere.rglob("*.bc")
    for damage in (b"", object_file.read_bytes()[:-1], b"x" * 1000, bitcode_file.read_bytes()):
        steps.clear()
        object_file.write_bytes(damage)
        assert np.array_equal(follow(), expected)
        assert steps == ["object_for"]
    object_file.unlink()
    bitcode_file.write_bytes(bitcode_file.read_bytes()[:-1])
    steps.clear()
    assert np.array_equal(follow(), expected)
    assert steps == ["bitcode_from_sources", "object_for"]


def test_bitcode_that_this_llvm_cannot_read_is_passed_over(elsewhere, steps) -> None:
    expected, digest = follow(), digest_of(*loops.SOURCES)
    (file,) = elsewhere.rglob("*.bc")
    cache.write_sealed(
        file, key_of("hysteresis", digest), cache.join({}, b"bitcode of a newer LLVM")
    )
    for file in elsewhere.rglob("*.o"):
        file.unlink()
    steps.clear()
    assert np.array_equal(follow(), expected)
    assert steps[-2:] == ["bitcode_from_sources", "object_for"]


def test_edited_sources_never_run_old_code(elsewhere, steps, monkeypatch) -> None:
    follow()
    steps.clear()
    monkeypatch.setattr(call, "digest_of", lambda *_: "edited")
    monkeypatch.setattr(cache, "digest_of", lambda *_: "edited")
    follow()
    assert steps == ["bitcode_from_sources", "object_for"]


@pytest.mark.parametrize("lacking", ["platform", "processor", "folder"])
def test_elsewhere_code_is_made_for_this_processor_and_kept_in_the_cache(
    elsewhere, steps, monkeypatch, lacking
) -> None:
    if lacking == "platform":
        monkeypatch.setattr(call, "this_platform", lambda: "plan9-mips")
    elif lacking == "processor":
        monkeypatch.setattr(call, "_suits", lambda _: False)
    else:
        (elsewhere / "built").write_text("in the way")
    expected = follow()
    assert steps == ["bitcode_from_sources", "object_for"]
    assert len(list((elsewhere / "cache").iterdir())) == 1
    assert np.array_equal(follow(), expected)
    assert len(steps) == 2


def test_a_loop_made_for_this_very_processor_takes_no_object_for_the_platform(
    elsewhere, steps
) -> None:
    expected = follow()
    made = [] if not call._suits(this_platform()) else ["object_for"]  # an older one has it already
    steps.clear()
    for _ in range(2):
        state = np.full(5, np.nan)
        Loop("hysteresis", here=True)(PATH, 1.0, 0.5, 1.0, 0.0, state)
        assert np.array_equal(state, expected)
    assert steps == made  # from the bitcode, once
    assert len(list((elsewhere / "cache").iterdir())) == 1


def test_without_any_folder_code_is_made_each_time(elsewhere, steps, monkeypatch) -> None:
    for name in ("built", "cache"):
        (elsewhere / name).write_text("in the way")
    assert np.array_equal(follow(), follow())
    assert len(steps) == 4


def test_without_numba_it_is_said_what_to_install(elsewhere, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "numba", None)
    with pytest.raises(MissingPackageError, match="make loops"):
        follow()


def test_an_unknown_build_of_python_has_numba_itself_call_the_loop(monkeypatch, caplog) -> None:
    expected = follow()
    monkeypatch.setattr(call, "objects_are_known", lambda: False)
    script = """
import numpy as np
from jounce.kernel import call
call.objects_are_known = lambda: False
state = np.empty(5)
assert call.Loop("hysteresis")(np.array([0.0, 1.0, 2.0, 1.5, -1.0]), 1.0, 0.5, 1.0, 0.0, state) == 0
print(state.tobytes().hex())
"""
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert bytes.fromhex(done.stdout) == expected.tobytes()
    assert "this build of Python" in done.stderr


def test_objects_for_all_platforms(elsewhere) -> None:
    """They are written; only those of this platform can be run here."""
    assert make.make("hysteresis", list(PLATFORMS)) > 0.0
    assert make.make("hysteresis", list(PLATFORMS)) == 0.0
    digest = digest_of(*loops.SOURCES)
    starts = {"linux": b"\x7fELF", "windows": b"\x7fELF", "darwin": b"\xcf\xfa\xed\xfe"}
    for platform in PLATFORMS:
        content = cache.read_sealed(
            elsewhere / "built" / platform / "hysteresis.o", key_of("hysteresis", digest, platform)
        )
        assert content is not None
        assert cache.split(content)[1].startswith(starts[platform.partition("-")[0]])


def test_the_digest_covers_all_that_loops_are_made_of() -> None:
    """Of the kernel they import nothing else but what calls them and what writes machine code."""
    script = """
import sys
from importlib import import_module
from jounce.kernel.loops import LOOPS
for module, _ in LOOPS.values():
    import_module(f"jounce.kernel.loops.{module}")
import jounce.kernel.loops.build
print(*sorted(name for name in sys.modules if name.startswith("jounce.kernel.")))
"""
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    covered = tuple(f"jounce.{source.replace('/', '.')}" for source in loops.SOURCES)
    others = {name for name in done.stdout.split() if not name.startswith(covered)}
    assert others == {
        f"jounce.kernel.{name}" for name in ("apart", "cache", "call", "machine", "native")
    }


@pytest.mark.parametrize(
    "name", ["Vector", "Matrix", "Block", "Columns", "Integers", "IntegerMatrix", "ComplexVector"]
)
def test_a_layout_has_the_type_of_its_array(name: str) -> None:
    array, layout = get_args(getattr(arrays, name))
    assert f"numpy.{layout.dtype}]" in str(array)
