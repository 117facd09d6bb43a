"""Docstrings of everything public, and the truth of their examples."""

from __future__ import annotations

import doctest
import importlib
import inspect
import tempfile
import types
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from pydantic import BaseModel

import jounce
from jounce.core.description import Description
from jounce.core.units import Length
from rules import modules
from rules.docstrings import Level, docstring_problems, field_problems

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
MODULES = [
    name for name in modules() if name != "jounce"
]  # what that one exports is judged by its public names


def own_things(module: types.ModuleType) -> dict[str, Any]:
    """Public functions and classes that a module defines or, if it is a package, exports."""
    is_package = hasattr(module, "__path__")
    exported = getattr(module, "__all__", None)
    things = (
        {name: getattr(module, name) for name in exported}
        if is_package and exported
        else vars(module)
    )
    return {
        name: value
        for name, value in things.items()
        if inspect.isfunction(value) or inspect.isclass(value)
        if not name.startswith("_")
        if value.__module__ == module.__name__
        or (is_package and value.__module__.startswith(f"{module.__name__}."))
    }


def methods(kind: type) -> dict[str, Any]:
    found = {}
    for name, value in list(
        vars(kind).items()
    ):  # descriptions get their validators when they are looked at
        function = (
            value.fget
            if isinstance(value, property)
            else inspect.unwrap(getattr(value, "__func__", value))
        )
        if inspect.isfunction(function) and not name.startswith("_"):
            found[name] = function
    return found


@pytest.mark.parametrize("name", jounce.__all__)
def test_public_name_is_documented(name: str) -> None:
    value = getattr(jounce, name)
    if isinstance(value, types.ModuleType):
        assert value.__doc__
    else:
        assert docstring_problems(f"jounce.{name}", value, Level.PUBLIC) == []


@pytest.mark.parametrize("name", MODULES)
def test_module_documents_what_it_offers(name: str) -> None:
    module = importlib.import_module(name)
    assert module.__doc__, f"{name}: no docstring"
    level = Level.PACKAGE if hasattr(module, "__path__") else Level.INSIDE
    problems = []
    for key, value in own_things(module).items():
        problems += docstring_problems(f"{name}.{key}", value, level)
        if inspect.isclass(value):
            problems += [
                problem
                for method, function in methods(value).items()
                for problem in docstring_problems(f"{name}.{key}.{method}", function, level)
            ]
            if issubclass(value, BaseModel):
                problems += field_problems(f"{name}.{key}", value)
    assert problems == []


@pytest.mark.examples
@pytest.mark.parametrize("name", modules())
def test_examples_are_true(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    module = importlib.import_module(name)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))  # examples leave their folders there
    runner = doctest.DocTestRunner(optionflags=OPTIONS)
    for test in doctest.DocTestFinder(recurse=module is not jounce).find(
        module
    ):  # which only guards those of others
        runner.run(test)
    assert runner.summarize(verbose=False).failed == 0


def untrue_example() -> None:
    """Say something wrong.

    >>> 1 + 1
    3
    """


def test_untrue_example_is_noticed(capsys: pytest.CaptureFixture[str]) -> None:
    test = doctest.DocTestFinder().find(untrue_example, globs={})[0]
    assert doctest.DocTestRunner(optionflags=OPTIONS).run(test).failed == 1
    assert "Expected:" in capsys.readouterr().out


def good(stiffness: float, deflection: NDArray[np.float64], label: str = "") -> NDArray[np.float64]:
    """Elastic force of a linear element.

    Parameters
    ----------
    stiffness : float
        Slope of the law, N/m.
    deflection : ndarray, shape (n,)
        Compression positive, m.
    label : str
        What messages call it.

    Returns
    -------
    ndarray, shape (n,)
        Force, N.

    Examples
    --------
    >>> 2.0 * 3.0
    6.0
    """


def no_docstring(x):
    pass


def missing_argument(rate: float, name: str) -> None:
    """Say.

    Parameters
    ----------
    rate : float
        Slope, N/m.
    """


def other_argument(rate: float) -> None:
    """Say.

    Parameters
    ----------
    rates : float
        Slope, N/m.
    """


def no_unit(rate: float, mass: Length) -> float:
    """Say.

    Parameters
    ----------
    rate : float
        How steep the law is.
    mass : float
        How heavy it is.

    Returns
    -------
    float
        How fast it swings.

    Examples
    --------
    >>> 1
    1
    """


def spring_rate(springs: list[str]) -> None:
    """Spring rates."""


def sentence(mass: float) -> float:
    """Static load (N) of a ``mass`` in kg."""


def vague_sentence(mass: float) -> float:
    """Load of a mass."""


@dataclass(frozen=True)
class Outcome:
    """What came out.

    Attributes
    ----------
    peak : float
        The largest one.
    """

    peak: float
    count: int


@dataclass(frozen=True)
class OutcomeInSi:
    """What came out, all in SI.

    Attributes
    ----------
    peak : float
        The largest one.
    """

    peak: float


@dataclass(frozen=True)
class Undocumented:
    peak: float


class Lump(Description):
    """A mass with a size."""

    mass: float
    sizes: tuple[float, ...]
    length: Length | None = None
    name: str = ""


@pytest.mark.parametrize(
    ("thing", "level", "expected"),
    [
        (good, Level.PUBLIC, []),
        (sentence, Level.PACKAGE, []),
        (no_docstring, Level.PACKAGE, ["no docstring"]),
        (Undocumented, Level.PACKAGE, ["no docstring"]),
        (missing_argument, Level.PACKAGE, ["'name' is not documented"]),
        (
            other_argument,
            Level.PACKAGE,
            ["documents 'rates'", "'rate' is not documented", "given for 'rate'"],
        ),
        (
            no_unit,
            Level.PUBLIC,
            ["given for 'rate'", "given for 'mass'", "given for what it returns"],
        ),
        (spring_rate, Level.PACKAGE, ["only repeats the name"]),
        (
            vague_sentence,
            Level.PACKAGE,
            ["no unit is given for 'mass'", "no unit is given for what it returns"],
        ),
        (sentence, Level.PUBLIC, ["'mass' is not documented", "no Returns section", "no example"]),
        (vague_sentence, Level.INSIDE, []),
        (other_argument, Level.INSIDE, ["documents 'rates', which", "'rate' is not documented"]),
        (OutcomeInSi, Level.PUBLIC, []),
        (Outcome, Level.PACKAGE, ["'count' is not documented", "no unit is given for 'peak'"]),
    ],
    ids=lambda value: getattr(value, "__name__", None),
)
def test_docstrings_are_judged(thing: Any, level: Level, expected: list[str]) -> None:
    problems = docstring_problems(thing.__name__, thing, level)
    assert len(problems) == len(expected), problems
    for problem, text in zip(problems, expected, strict=True):
        assert text in problem


def test_bare_numbers_of_descriptions_are_noticed() -> None:
    assert [problem.partition(":")[0] for problem in field_problems("Lump", Lump)] == [
        "Lump.mass",
        "Lump.sizes",
    ]
