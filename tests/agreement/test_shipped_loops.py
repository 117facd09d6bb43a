"""Machine code of the loops as built, of their bitcode made here, and of Numba: the same results, bit for bit."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

from jounce.kernel.loops import BUILT

SCRIPT = """
import pickle
import sys

import numpy as np

import jounce as jn
from jounce.kernel import cache, call
from jounce.kernel.call import BUILT, SOURCES, digest_of, key_of

way, file = sys.argv[1:]
asked = []
def by_bitcode(name, platform):
    asked.append(name)
    return call.object_for(cache.read_sealed(BUILT / f"{name}.bc", key_of(name, digest_of(*SOURCES))))
def as_shipped(name, platform, shipped=call._shipped):
    asked.append(name)
    return shipped(name, platform)
if way == "numba":
    call.objects_are_known = lambda: asked.append("all") or False
else:
    call._shipped = by_bitcode if way == "bitcode" else as_shipped
    call._compiled = None

rig = jn.load("kart-quarter-car")
bump = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"), speed="1.95 m/s", duration="1 s")
rough = jn.Trial(road=jn.Iso8608(**{"class": "C"}, length="40 m", seed=1), speed="10 m/s", duration="3 s")
found = {}
for where, trial in {"bump": bump, "rough": rough}.items():
    for method in ("auto", "explicit", "implicit"):
        run = jn.simulate(rig, trial, method=method)
        found |= {(where, method, name): values.to_numpy() for name, values in run.data_vars.items()}
run = jn.simulate(rig, bump, control="skyhook")
found |= {("skyhook", name): values.to_numpy() for name, values in run.data_vars.items()}
wishbone, travel = jn.load("reference-double-wishbone"), np.linspace(-0.08, 0.08, 17)
sweep = jn.sweep_travel(wishbone, travel)
found |= {("sweep", name): values.to_numpy() for name, values in sweep.data_vars.items()}
sweep = jn.sweep_variants(wishbone, {"hardpoints.tie_rod_inner[2]": [0.180, 0.185, 0.190]}, travel)
found |= {("variants", name): values.to_numpy() for name, values in sweep.data_vars.items()}
with open(file, "wb") as stream:
    pickle.dump((set(asked), found), stream)
"""
USED = {"evaluate", "exact", "rate_bound", "explicit", "implicit", "poses", "pose_variants"}


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("loops")

    def by(way):
        file = folder / way
        environment = {
            **os.environ,
            "JOUNCE_CACHE_DIR": str(folder / "cache"),
        }  # one: the models are the same
        subprocess.run([sys.executable, "-c", SCRIPT, way, str(file)], env=environment, check=True)
        return pickle.loads(file.read_bytes())

    return by


def assert_same(one, other):
    assert one.keys() == other.keys()
    assert len(one) > 100
    for name, values in one.items():
        assert values.tobytes() == other[name].tobytes(), name
        assert np.isfinite(values).any(), name


@pytest.fixture(scope="module")
def shipped(results):
    asked, found = results("shipped")
    assert asked == USED
    return found


@pytest.mark.slow
@pytest.mark.skipif(not BUILT.exists(), reason="make loops")
def test_bitcode_compiled_for_this_processor(results, shipped) -> None:
    asked, found = results("bitcode")
    assert asked == USED
    assert_same(shipped, found)


@pytest.mark.slow
@pytest.mark.skipif(not BUILT.exists(), reason="make loops")
def test_numba(results, shipped) -> None:
    asked, found = results("numba")
    assert asked == {"all"}
    assert_same(shipped, found)
