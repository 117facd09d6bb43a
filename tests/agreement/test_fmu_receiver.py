"""Exported FMUs called as a stranger's importer calls them: in the wrong order, twice at once, from any start time."""

from __future__ import annotations

import ctypes
import subprocess
import threading
import zipfile
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu.component import unpack
from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.exchange.fmu import build
from jounce.exchange.fmu.description import FILE

HERE = this_platform()
COMPILER = build.compiler_for((HERE,))
if COMPILER is None:
    pytest.skip("no compiler", allow_module_level=True)

OK, WARNING, ERROR = 0, 1, 3
LOG_2 = ctypes.CFUNCTYPE(
    None,
    ctypes.c_void_p,
    ctypes.c_char_p,
    ctypes.c_int,
    ctypes.c_char_p,
    ctypes.c_char_p,
    ctypes.c_char_p,
)
LOG_3 = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = (
        ("logger", LOG_2),
        *((name, ctypes.c_void_p) for name in ("allocate", "free", "finished", "of")),
    )


class Called:
    """An instance for co-simulation by its C functions, and what it logged."""

    def __init__(self, path: Path) -> None:
        self.about = jn.read_fmu(path)
        folder = unpack(self.about)
        self.library = ctypes.CDLL(str(folder / self.about.binary()))
        self.two, self.log = self.about.version == 2, []
        self.references = {
            v.name: v.reference
            for v in (*self.about.inputs, *self.about.outputs, *self.about.parameters)
        }
        token = self.about.token.encode()
        if self.two:
            self.logger = LOG_2(
                lambda _, _name, status, _category, _text, said: self.log.append(
                    (status, said.decode())
                )
            )
            self.callbacks = Callbacks(self.logger, None, None, None, None)
            given = (b"one", 1, token, b"", ctypes.byref(self.callbacks), 0, 0)
        else:
            self.logger = LOG_3(
                lambda _, status, _category, said: self.log.append((status, said.decode()))
            )
            given = (
                b"one",
                token,
                b"",
                False,
                False,
                False,
                False,
                None,
                ctypes.c_size_t(0),
                None,
                self.logger,
            )
        make = self.library[
            f"fmi{self.about.version}Instantiate{'' if self.two else 'CoSimulation'}"
        ]
        make.restype = ctypes.c_void_p
        self.it = ctypes.c_void_p(make(*given) if self.two else make(*given, None))

    def call(self, name: str, *given) -> int:
        return self.library[f"fmi{self.about.version}{name}"](self.it, *given)

    def begin(self, start: float = 0.0, stop: float | None = None) -> int:
        told = (
            False,
            ctypes.c_double(0.0),
            ctypes.c_double(start),
            stop is not None,
            ctypes.c_double(stop or 0.0),
        )
        if self.two:
            status = self.call("SetupExperiment", *told)
            return (
                status
                or self.call("EnterInitializationMode")
                or self.call("ExitInitializationMode")
            )
        return self.call("EnterInitializationMode", *told) or self.call("ExitInitializationMode")

    def step(self, t: float, h: float) -> int:
        flags, reached = (ctypes.c_bool * 3)(), ctypes.c_double()
        at = ctypes.addressof(flags)
        more = (
            ()
            if self.two
            else (*(ctypes.c_void_p(at + i) for i in range(3)), ctypes.byref(reached))
        )
        return self.call("DoStep", ctypes.c_double(t), ctypes.c_double(h), True, *more)

    def _numbers(self, names, values):
        many = ctypes.c_size_t(len(names))
        references = (ctypes.c_uint32 * len(names))(*(self.references[name] for name in names))
        return references, many, values, *(() if self.two else (many,))

    def put(self, **values: float) -> int:
        held = (ctypes.c_double * len(values))(*values.values())
        return self.call("SetReal" if self.two else "SetFloat64", *self._numbers([*values], held))

    def get(self, *names: str) -> list[float]:
        held = (ctypes.c_double * len(names))()
        assert self.call("GetReal" if self.two else "GetFloat64", *self._numbers(names, held)) == OK
        return held[:]

    def drive(self, start: float, count: int, first: int = 0) -> list[float]:
        """Over a bump that the wheel leaves; the last values of some channels."""
        for i in range(first, first + count):
            t = 2e-3 * i
            self.put(**{"road.z": 0.02 * np.sin(50.0 * t), "road.vz": 1.0 * np.cos(50.0 * t)})
            assert self.step(start + t, 2e-3) == OK
        return self.get("sprung.z", "tyre.force", "strut.force")

    def close(self) -> None:
        self.call("FreeInstance")


@pytest.fixture(scope="module", params=[2, 3])
def made(request, tmp_path_factory):
    """The kart with a controller, exported."""
    folder = tmp_path_factory.mktemp("receiver")
    file, version = folder / "kart.fmu", request.param
    jn.export_fmu(
        jn.load("kart-quarter-car"), file, version=version, control="skyhook", platforms=()
    )
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder)
    parts = [str(folder / "sources" / name) for name in ("model.c", "core.c", f"fmi{version}.c")]
    library = folder / "library"
    words = [*COMPILER[1], "-std=c99", "-O0", "-fPIC", "-shared", *parts, "-o", str(library), "-lm"]
    subprocess.run(
        words, check=True, capture_output=True
    )  # nothing is optimised: that takes seconds
    kind = PLATFORMS[HERE]
    with zipfile.ZipFile(file, "a") as archive:
        archive.write(
            library, f"binaries/{HERE if version == 3 else kind.fmi2}/{FILE}{kind.suffix}"
        )
    return file


def test_steps_that_cannot_be_are_refused_in_words(made) -> None:
    """A negative step moved the time back and said that all was well; so did one without a length in numbers."""
    fmu = Called(made)
    assert fmu.step(0.0, 1e-3) == ERROR
    assert fmu.begin(stop=0.01) == OK
    before = fmu.drive(0.0, 2)
    for t, h, status, text in (
        (0.004, -0.002, ERROR, "negative"), (0.004, float("nan"), ERROR, "no finite number"),
        (0.004, float("inf"), ERROR, "no finite number"), (float("nan"), 0.002, ERROR, "where the last ended"),
        (0.002, 0.002, ERROR, "where the last ended"), (0.004, 0.007, ERROR, "beyond the stop time"),
        (0.004, 0.0, WARNING, "without length"),
    ):  # fmt: skip
        assert fmu.step(t, h) == status
        assert fmu.log[-1][0] == status
        assert text in fmu.log[-1][1]
    assert fmu.get("sprung.z", "tyre.force", "strut.force") == before
    count = len(fmu.log)
    assert fmu.step(0.004, 0.006) == OK  # to the stop time itself
    assert fmu.call("Terminate") == OK
    assert len(fmu.log) == count
    assert fmu.step(0.01, 1e-3) == ERROR
    assert "after the end" in fmu.log[-1][1]
    fmu.close()


def test_a_reset_instance_is_a_new_one(made) -> None:
    """Parameters, stop time and what the controller remembers go, too."""
    fmu = Called(made)
    fmu.begin(stop=0.5)
    first = fmu.drive(0.0, 100)
    assert fmu.call("Reset") == OK
    fmu.put(**{"rig.sprung.mass": 99.0})
    fmu.begin(start=3.0, stop=3.1)
    assert fmu.drive(3.0, 40) != first
    assert fmu.call("Reset") == OK
    assert fmu.begin() == OK
    assert fmu.drive(0.0, 100) == first
    fmu.close()


@pytest.mark.parametrize("start", [-2.0, 1000.0])
def test_time_begins_anywhere(made, start) -> None:
    """Control instants count from the start."""
    ends = []
    for begin in (0.0, start):
        fmu = Called(made)
        assert fmu.begin(begin) == OK
        ends.append(fmu.drive(begin, 100))
        fmu.close()
    np.testing.assert_allclose(ends[1], ends[0], rtol=1e-5)
    fmu = Called(made)
    assert fmu.begin(float("nan")) == ERROR
    fmu.close()


def test_a_state_between_two_instants_goes_into_another_instance(made) -> None:
    """Saved off the road and in the middle of a control period, given to one that was never begun."""
    one, other = Called(made), Called(made)
    one.begin()
    one.drive(0.0, 57)
    assert one.step(0.114, 0.0007) == OK
    state = ctypes.c_void_p()
    word = "state" if one.two else "State"
    assert one.call(f"GetFMU{word}", ctypes.byref(state)) == OK
    assert other.call(f"SetFMU{word}", state) == OK
    ends = []
    for fmu in (one, other):
        assert fmu.step(0.1147, 0.0013) == OK
        ends.append(fmu.drive(0.0, 40, first=58))
    assert ends[0] == ends[1]
    assert one.call(f"FreeFMU{word}", ctypes.byref(state)) == OK
    assert one.call(f"FreeFMU{word}", ctypes.byref(state)) == OK  # a second time: ignored
    one.close(), other.close()


def test_instances_in_threads_do_not_meet(made) -> None:
    """One car after another, and both at once, each in a thread of its own."""

    def run(mass: float, ends: dict) -> None:
        fmu = Called(made)
        fmu.put(**{"rig.sprung.mass": mass})
        fmu.begin()
        ends[mass] = fmu.drive(0.0, 150)
        fmu.close()

    alone, together = {}, {}
    for mass in (30.0, 60.0):
        run(mass, alone)
    threads = [threading.Thread(target=run, args=(mass, together)) for mass in alone]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone
    assert alone[30.0] != alone[60.0]
