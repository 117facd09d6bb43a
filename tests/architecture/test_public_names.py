"""The public namespace: every name resolves, loads lazily, and a misspelt one says what was meant."""

from __future__ import annotations

import contextlib
import importlib
import inspect
import subprocess
import sys
import types
from pathlib import Path
from types import SimpleNamespace

import pytest

import jounce
from jounce.core.findings import Finding
from jounce.design.best_design import BestDesign
from jounce.identify.discrepancy import NuisanceEstimate
from jounce.recordings.sensors import Sensor
from rules import ROOT, modules, packages_below

HEAVY = [
    "casadi",
    "h5py",
    "jinja2",
    "llvmlite",
    "matplotlib",
    "numba",
    "numpy",
    "pandas",
    "pint",
    "pydantic",
    "rich",
]
HEAVY += ["scipy", "typer", "xarray"]
FACES = ["click", "jinja2", "matplotlib", "rich", "typer", "typst"]


def run_python(code: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, cwd=ROOT
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def loaded_after(statement: str) -> set[str]:
    names = run_python(f"import sys\n{statement}\nprint(*sys.modules)").splitlines()[-1].split()
    return {name.partition(".")[0] for name in names}


@pytest.mark.parametrize("name", [*jounce.__all__, "__version__"])
def test_public_name_resolves(name: str) -> None:
    value = getattr(jounce, name)
    assert value is not None
    if not isinstance(value, (types.ModuleType, str)):
        assert value.__name__ == name
    assert name in dir(jounce)


def test_unknown_name_names_the_nearest() -> None:
    with pytest.raises(
        AttributeError, match=r"no attribute 'JounceErorr'\. Did you mean 'JounceError'\?"
    ):
        jounce.JounceErorr  # noqa: B018


def test_import_loads_nothing_heavy() -> None:
    assert loaded_after("import jounce") & set(HEAVY) == set()
    assert "numpy" in loaded_after("import jounce, numpy"), "the check itself sees what is loaded"


def test_core_needs_no_faces() -> None:
    code = f"import sys, importlib\nsys.modules.update(dict.fromkeys({FACES}))\n"
    core = [name for name in modules() if name.startswith("jounce.core")]
    assert (
        run_python(code + f"for name in {core}: importlib.import_module(name)\nprint('done')")
        == "done"
    )
    with pytest.raises(AssertionError, match="ModuleNotFoundError"):
        run_python(code + "import rich.table")


def test_everything_below_the_plots_needs_no_faces() -> None:
    below = set(packages_below("plots"))
    names = [name for name in modules() if name.count(".") and name.split(".")[1] in below]
    assert names
    code = f"import sys, importlib\nsys.modules.update(dict.fromkeys({FACES}))\n"
    assert (
        run_python(code + f"for name in {names}: importlib.import_module(name)\nprint('done')")
        == "done"
    )


@pytest.mark.parametrize(
    ("package", "old", "new"),
    [
        ("inspection", "Corner", "LinearQuarterCar"),
        ("mechanics", "Facts", "ModelFacts"),
        ("report", "Table", "PageTable"),
        ("notebook", "Cell", "EmbeddedPage"),
        ("control.controller", "DamperLaw", "TwoStateLaw"),
        ("mechanics", "combined", "combine_solids"),
        ("plots", "integrated", "integrated_motion"),
        ("plots", "rendered", "render_figure"),
        ("plots", "styled", "in_style"),
        ("ride.weighting", "weighted", "weight"),
    ],
)
def test_old_names_work_and_say_the_new_one(package: str, old: str, new: str) -> None:
    module = importlib.import_module(f"jounce.{package}")
    with pytest.warns(DeprecationWarning, match=f"{old} is called {new} now"):
        value = getattr(module, old)
    assert value is getattr(module, new)
    assert old not in dir(module)


def test_old_methods_work_and_say_the_new_one() -> None:
    finding = Finding("a", "note", "as it was")
    with pytest.warns(DeprecationWarning, match="Finding.said is called sentence now"):
        assert finding.said("de") == "as it was"
    with pytest.warns(DeprecationWarning, match="Description.changed is called with_fields now"):
        assert Sensor(gain=2.0).changed(gain=3.0) == Sensor(gain=3.0)
    with pytest.warns(DeprecationWarning, match="NuisanceEstimate.moved is called deviations now"):
        assert NuisanceEstimate("speed", "1", 1.0, 0.5, 2.0, 0.1).moved == 2.0


def test_an_old_name_of_the_package_works_and_says_the_new_one() -> None:
    with pytest.warns(DeprecationWarning, match="jounce.adjusted is called apply_adjustments now"):
        value = jounce.adjusted
    assert value is jounce.apply_adjustments


def test_old_names_of_methods_work_and_say_the_new_one() -> None:
    control = jounce.controller("skyhook")
    with pytest.warns(DeprecationWarning, match="Controller.paced is called with_rate_for now"):
        assert control.paced(10.0) == control.with_rate_for(10.0)
    corner = SimpleNamespace(reference_damping=500.0)
    with pytest.warns(DeprecationWarning, match="Controller.resolved is called complete_for now"):
        assert control.resolved(corner) == control.complete_for(corner)
    with pytest.warns(DeprecationWarning, match="Controller.beside is called resolve_paths now"):
        assert control.beside(Path()) == control.resolve_paths(Path())
    actuator = jounce.SemiActiveDamper(minimum=100.0, maximum=1000.0)
    with pytest.warns(DeprecationWarning, match="Actuator.resolved is called complete_for now"):
        assert actuator.resolved(corner) == actuator
    study = BestDesign(None)  # type: ignore[arg-type]
    with pytest.warns(DeprecationWarning, match="BestDesign.found is called outcome now"):
        assert study.found is study.outcome


OLD_ARGUMENTS = {
    "plots": ("channel_spectra", "channel_statistics", "measured_modes", "modes", "posterior_bands",
              "posterior_draws", "profile_likelihood", "transfer_estimate"),
    "report": ("damper_page", "decay_page", "hardpoints_page", "integration_page", "kinematic_design_page",
               "load_cases_page", "measured_modes_page", "model_comparison_page", "modes_page", "optimisation_page",
               "posterior_page", "roughness_page", "spectra_page", "statistics_page", "stiffness_page", "sweep_page",
               "transfer_page"),
    "kinematics": ("load_case_table",),
}  # fmt: skip
"""Functions whose first result was called ``found`` until version 0.1."""


@pytest.mark.parametrize(
    ("package", "name"),
    [(package, name) for package, names in OLD_ARGUMENTS.items() for name in names],
)
def test_arguments_keep_their_old_names(package: str, name: str) -> None:
    function = getattr(importlib.import_module(f"jounce.{package}"), name)
    parameters = inspect.signature(function).parameters
    given = {p.name: object() for p in parameters.values() if p.default is p.empty}
    assert "found" not in given
    with (
        pytest.warns(DeprecationWarning, match=f"the argument found of {name} is called") as told,
        contextlib.suppress(Exception),  # of the nonsense that it is given
    ):
        function(found=object(), **given)
    new = str(told[0].message).split()[-2]
    assert new in given
    assert parameters[new].kind is inspect.Parameter.POSITIONAL_OR_KEYWORD
