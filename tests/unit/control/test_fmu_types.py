"""Component FMUs whose inputs, outputs and parameters are whole numbers, Booleans and arrays."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu import FmuControl
from jounce.core.errors import DescriptionError, JounceError, SimulationError

fmu_component = pytest.importorskip("fmu_component")
SOURCE = fmu_component.SOURCE.with_name("arrays.c")
REFERENCE = Path(__file__).parents[2] / "files" / "fmu" / "reference_fmus"
TRIAL = jn.Trial(
    road=jn.HalfSine(height="30 mm", length="1 m", start="0.1 m"), speed="10 m/s", duration="0.2 s"
)
ACTUATOR = jn.ActiveActuator(lag=0.0, force_limit=1e5)
RIG = jn.load("audi-a6-quarter-car")
ARRAYS = (  # name, type in FMI 3.0 and 2.0, causality, dimensions, start
    ("u", "Float64", "Real", "input", (3,), "1 2 3"),
    ("K", "Float64", "Real", "parameter", (2, 3), "0"),
    ("f", "Float32", "Real", "input", (2,), "0 0"),
    ("i", "Int16", "Integer", "input", (2,), "0 4"),
    ("on", "Boolean", "Boolean", "input", (2,), "false true"),
    ("y", "Float64", "Real", "output", (2,), ""),
    ("n", "Int32", "Integer", "output", (2,), ""),
    ("hot", "Boolean", "Boolean", "output", (2,), ""),
)


def description(version):
    """Of the arrays; in FMI 2.0 each element is a variable of its own, and FMI 3.0 has the size of u elsewhere."""
    rows = []
    for reference, (name, new, old, causality, sizes, start) in enumerate(ARRAYS, start=1):
        if version == 3:
            begin = f' start="{start}"' if start else ""
            rows.append(
                f'<{new} name="{name}" valueReference="{reference}" causality="{causality}"{begin}>'
            )
            rows += [
                '<Dimension valueReference="9"/>' if size == 3 else f'<Dimension start="{size}"/>'
                for size in sizes
            ]
            rows.append(f"</{new}>")
            continue
        starts = start.split()
        for at, index in enumerate(np.ndindex(sizes)):
            begin = f' start="{starts[at if len(starts) > 1 else 0]}"' if start else ""
            words = f'name="{name}[{",".join(str(k + 1) for k in index)}]" valueReference="{16 * reference + at}"'
            rows.append(
                f'<ScalarVariable {words} causality="{causality}"><{old}{begin}/></ScalarVariable>'
            )
    if version == 3:
        rows.append(
            '<UInt64 name="count" valueReference="9" causality="structuralParameter" start="3"/>'
        )
    token = "guid" if version == 2 else "instantiationToken"
    return (
        f'<fmiModelDescription fmiVersion="{version}.0" modelName="arrays" {token}="a">'
        '<CoSimulation modelIdentifier="component"/>'
        f"<ModelVariables>{''.join(rows)}</ModelVariables></fmiModelDescription>"
    )


@pytest.fixture(scope="module", params=[2, 3])
def arrays(request, tmp_path_factory):
    if not fmu_component.can_be_made():
        pytest.skip("no compiler")
    folder = tmp_path_factory.mktemp("arrays")
    library = fmu_component.binary(request.param, folder, SOURCE)
    return fmu_component.write(folder / "a.fmu", request.param, library, description(request.param))


@pytest.fixture(scope="module")
def described(tmp_path_factory):
    """The arrays of FMI 3.0 without a binary that runs."""
    return fmu_component.write(
        tmp_path_factory.mktemp("said") / "a.fmu", 3, b"none", description(3)
    )


def drive(file, **changes):
    return jn.simulate(
        RIG,
        TRIAL,
        control=FmuControl(file=str(file), **{"actuator": ACTUATOR, "rate": 100.0, **changes}),
    )


def asked(function, **changes):
    return jn.simulate(
        RIG,
        TRIAL,
        control=jn.PythonControl(
            function=function, **{"actuator": ACTUATOR, "rate": 100.0, **changes}
        ),
    )


@pytest.mark.parametrize("trusted", [False, True])
def test_elements_of_arrays_are_connected_one_by_one(arrays, trusted) -> None:
    """What nothing is connected to keeps its start, and its neighbour is not touched."""
    run = drive(
        arrays, inputs={"u[2]": "strut.velocity", "f[2]": "sprung.vz", "i[2]": "tyre.force"}, output="y[2]",
        parameters={"K[2,2]": 70.0, "K[2,3]": -5.0, "u[3]": 2.0, "on[2]": True}, counts={"i[2]": "1 kN"},
        trusted=trusted,
    )  # fmt: skip
    single = np.float32 if jn.read_fmu(arrays).version == 3 else float
    same = asked(
        lambda m, _: (
            10.0 * round(m["tyre.force"] * 1e-3)
            + 0.5 * float(single(m["sprung.vz"]))
            + 70.0 * m["strut.velocity"]
            - 5.0 * 2.0
        )
    )
    assert np.ptp(same["command"].values) > 20.0
    np.testing.assert_allclose(run["command"], same["command"], rtol=0.0, atol=1e-9)
    (left,) = (text for text in run.attrs["findings"] if "keep their start" in text)
    assert all(name in left for name in ("u[1]", "f[1]", "i[1]", "on[1]"))
    assert not any(name in left for name in ("u[2]", "u[3]", "on[2]"))


def test_whole_numbers_and_truths_are_commands(arrays) -> None:
    """The count of an output is what one of it is; a Boolean is 0 or 1 SI."""
    given = {"inputs": {"u[1]": "strut.velocity"}, "parameters": {"K[1,1]": 100.0}, "trusted": True}
    whole = drive(arrays, output="n[1]", counts={"n[1]": "0.5 daN"}, **given)
    same = asked(lambda m, _: 5.0 * np.floor(200.0 * m["strut.velocity"] + 0.5))
    np.testing.assert_array_equal(whole["command"], same["command"])
    assert np.unique(whole["command"].values).size > 5
    truth = drive(arrays, output="hot[1]", **given)["command"].values
    assert set(truth[10:]) == {0.0, 1.0}


def test_a_truth_takes_0_and_1_and_nothing_else(arrays) -> None:
    still = {"inputs": {"on[1]": "strut.velocity"}, "output": "y[1]", "from_rest": True}
    with pytest.raises(
        SimulationError,
        match=r"t = 0.0\d+ s: the input on\[1\] requires whole numbers.*allowed: 0 and 1",
    ):
        drive(arrays, **still)
    flat = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="0.05 s")
    law = FmuControl(file=str(arrays), actuator=ACTUATOR, rate=100.0, **still)
    assert not jn.simulate(RIG, flat, control=law)["command"].values.any()


def test_arrays_are_given_in_lists(described) -> None:
    for given, what in (
        ({"K": 1.0}, r"not a list of array values.*2 x 3 values in a list, or K\[1,1\] to \[2,3\]"),
        ({"K": [1.0, 2.0]}, "not a list of array values"),
        ({"K": [[1.0, 2.0, 3.0], [4.0]]}, "not a list of array values"),
        ({"K": [[1.0, 2.0, 3.0], [4.0, 5.0, "x"]]}, "K"),
        (
            {"K[3,1]": 1.0},
            r"no such element; found 'Float64\[2, 3\]'; allowed: K\[1,1\] to \[2,3\]",
        ),
        ({"K[1]": 1.0}, "no such element"),
        (
            {"i[1]": 40000},
            "out of the range of its type; found 40000; allowed: Int16, -32768 to 32767",
        ),
        ({"i[1]": 1.5}, "the value has the wrong type; found 1.5"),
        ({"on": [True, 2]}, "the value has the wrong type; found 2; allowed: true, false, 0, 1"),
        ({"count": 4}, "count: a structural parameter defines array sizes"),
        ({"kount": 4}, "unknown parameter 'kount'"),
    ):
        with pytest.raises(JounceError, match=what):
            drive(described, output="y[1]", parameters=given)


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        (
            {"inputs": {"u": "strut.velocity"}},
            r"found 'Float64\[3\]'; allowed: an element: u\[1\] to \[3\]",
        ),
        ({"inputs": {"u[0]": "strut.velocity"}}, "no such element"),
        ({"inputs": {"u[4]": "strut.velocity"}}, "no such element"),
        ({"inputs": {"v[1]": "strut.velocity"}}, r"unknown input 'v\[1\]'"),
        ({"inputs": {"count": "strut.velocity"}}, "a structural parameter"),
        ({"output": "y"}, "no number|an element"),
        ({"output": "y[3]"}, "no such element"),
        ({"output": None}, "no output or several"),
        ({"counts": {"u[1]": 1.0}}, r"counts apply only to connected.*allowed: none"),
        ({"inputs": {"i[1]": "strut.velocity"}, "counts": {"i[1]": "1 mm"}}, "counts: i"),
        (
            {"inputs": {"i[1]": "strut.velocity"}, "counts": {"i[1]": 0.0}},
            "invalid size of a count",
        ),
        ({"inputs": {"on[1]": "strut.velocity"}, "counts": {"on[1]": 1.0}}, "counts"),
    ],
)
def test_elements_and_counts_that_do_not_fit(described, changes, what) -> None:
    with pytest.raises(JounceError, match=what):
        drive(described, **{"output": "y[1]", **changes})


def test_what_an_fmu_says_of_its_arrays(described, tmp_path) -> None:
    found = jn.read_fmu(described)
    assert {v.name: v.dimensions for v in found.inputs} == {
        "u": (3,),
        "f": (2,),
        "i": (2,),
        "on": (2,),
    }
    assert [v.name for v in found.structural_parameters] == ["count"]
    assert found.to_dict()["parameters"][0]["dimensions"] == [2, 3]
    none = description(3).replace('valueReference="9" causality', 'valueReference="10" causality')
    with pytest.raises(DescriptionError, match="u: an array without a size"):
        jn.read_fmu(fmu_component.write(tmp_path / "a.fmu", 3, b"", none))
    large = description(3).replace('<Dimension start="2"/>', '<Dimension start="2000000"/>')
    with pytest.raises(DescriptionError, match="the array is too large"):
        drive(fmu_component.write(tmp_path / "b.fmu", 3, b"none", large), output="y[1]")
    open_ = description(3).replace('start="1 2 3"', 'start="1 2"')
    with pytest.raises(DescriptionError, match="elements of an array without start values"):
        drive(
            fmu_component.write(tmp_path / "c.fmu", 3, b"none", open_),
            output="y[1]",
            inputs={"u[1]": "strut.velocity"},
        )


def test_a_structural_parameter_cannot_be_set_by_name() -> None:
    """The Reference FMU whose arrays have sizes of their own."""
    file = REFERENCE / "StateSpace-3.fmu"
    with pytest.raises(DescriptionError, match=r"StateSpace-3.fmu: m: a structural parameter"):
        drive(file, output="y[1]", parameters={"m": 2}, rate=1.0)
