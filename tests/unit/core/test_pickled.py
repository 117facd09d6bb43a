"""What is pickled has the same bytes in every process, so that stores of results find it again."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys

import jounce as jn
from jounce.campaign.characterise import _interpolate, _nearest
from jounce.inspection.equivalence import usual_factors
from jounce.parts.files import library

DIGESTS = """import hashlib, pickle, sys
import jounce as jn
from jounce.parts.files import library
rigs = [jn.load(name) for name in library()]
rigs += [rigs[0].with_changes({}), jn.load("kart-quarter-car").model_copy(update={"gravity": "9.8 m/s^2"})]
things = [*rigs, jn.load_tester("egea-specsus2018"), jn.controller("skyhook"), jn.Sensor(noise="0.1 m/s^2"), jn.Doubt()]
things += [jn.iso_trial(rigs[-1], "C", "20 m/s", duration="1 s"), jn.sobol({"sprung.mass": "10 %"}, 8)]
things += [jn.modes(rigs[-1]), jn.linearise(rigs[-1]), jn.Finding("a", "note", "b")]
print([hashlib.sha1(pickle.dumps(thing)).hexdigest() for thing in things])
"""


def test_pickled_bytes_do_not_depend_on_the_seed_of_hashes() -> None:
    found = {
        subprocess.run(
            [sys.executable, "-c", DIGESTS],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "1", "2")
    }
    assert len(found) == 1


def test_what_was_asked_of_a_rig_is_not_pickled_with_it() -> None:
    for name in library():
        rig = jn.load(name)
        before = pickle.dumps(rig)
        jn.equilibrium(rig) if isinstance(rig, jn.QuarterCar) else rig.parameters()
        repr(rig), hash(type(rig)), rig.model_dump()
        assert pickle.dumps(rig) == before
        again = pickle.loads(before)
        assert again == rig
        assert again.model_fields_set == rig.model_fields_set
        assert pickle.dumps(again) == before


def test_functions_within_results_are_pickled() -> None:
    for function in (_nearest, _interpolate, usual_factors()):
        assert pickle.loads(pickle.dumps(function)) == function
