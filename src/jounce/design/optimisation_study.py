"""A design task as a file: free parameters and objectives over cases and spread, for the best design or a front."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from jounce.core.description import Description, Seed, Whole, line_of, read_description
from jounce.core.errors import JounceError, at_line, below
from jounce.core.misplaced import error_at
from jounce.core.units import Unit
from jounce.design.cases import Case, cases_problem
from jounce.design.goal_front import DesignFront, design_front
from jounce.design.mixtures import MOST_GOALS
from jounce.design.optimise import Optimisation, optimise
from jounce.design.pareto import ParetoFront, pareto
from jounce.design.problem import DesignProblem
from jounce.parts import Rig, load
from jounce.parts.files import rig_named_in
from jounce.variants.study import read_trial

Weight = Annotated[float, Unit("1", above=0.0)]
_PAIR = 2  # goals: a front of two has its own method (`pareto`)
SCHEMA: Literal["jounce.optimisation/1"] = "jounce.optimisation/1"


class OptimisationStudy(Description):
    """A study of the best design or, with ``front``, of the Pareto front of several metrics.

    ``rig`` is a file or a shipped rig; ``free`` has the bounds of the free parameters. ``objective`` has metrics with
    their weights, or ``front`` has two to eight metrics; for a front of two, one more metric can be ``shown``.
    ``constraints`` are limits of any metric. ``cases`` are evaluated together, by name: the keys of a trial, ``road``
    and ``speed`` of a random road, or ``travel`` of kinematics; metrics are prefixed with the name of the case.
    ``spread`` is the scatter of parameters in production or use, over ``samples`` drawn with ``seed``. ``starts`` is
    the number of searches, ``points`` the number of designs on a front.
    """

    schema_: Literal["jounce.optimisation/1"] = Field(default=SCHEMA, alias="schema")
    rig: str
    free: dict[str, Any] = Field(min_length=1)
    objective: dict[str, Weight] | str | None = None
    front: tuple[str, ...] | None = Field(default=None, min_length=2, max_length=MOST_GOALS)
    shown: str | None = None
    constraints: dict[str, Any] = {}
    cases: dict[str, dict[str, Any]] = Field(min_length=1)
    spread: dict[str, Any] = {}
    samples: Annotated[Whole, Field(ge=2, le=4096)] = 32
    seed: Seed = 1
    starts: Annotated[Whole, Field(ge=1, le=1000)] = 1
    points: Annotated[Whole, Field(ge=3, le=500)] = 15

    @model_validator(mode="after")
    def _wants_one_thing(self) -> OptimisationStudy:
        if (self.objective is None) == (self.front is None):
            raise error_at(
                ("objective",), "give either objective, or front = [two metrics or more]"
            )
        if self.shown is not None and len(self.front or ()) != _PAIR:
            raise error_at(
                ("shown",),
                "applies only to fronts of two metrics; larger fronts show all their metrics",
            )
        return self


def read_optimisation(path: Path | str) -> tuple[OptimisationStudy, Rig, dict[str, Any]]:
    """Read a study, its rig, and the arguments of :func:`optimise` or :func:`pareto`; errors name file and line."""
    study, text = read_description(OptimisationStudy, path, SCHEMA)
    file = Path(path)
    rig = load(rig_named_in(study.rig, file))
    cases: dict[str, Case] = {}
    for name, table in study.cases.items():
        is_trial = "duration" in table or "excitation" in table
        cases[name] = read_trial(table, file, text, ("cases", name)) if is_trial else table
    given: dict[str, Any] = {
        "constraints": {metric: tuple(v) if isinstance(v, list) else v for metric, v in study.constraints.items()},
        "cases": cases, "spread": study.spread or None, "samples": study.samples, "seed": study.seed,
    }  # fmt: skip
    return study, rig, given


def check_optimisation(path: Path | str) -> tuple[OptimisationStudy, DesignProblem]:
    """Read a study and everything it refers to, without searching."""
    study, rig, given = read_optimisation(path)
    objective = study.objective if study.objective is not None else (study.front or ("",))[0]
    more = [*(study.front or ())[1:], *([study.shown] if study.shown is not None else [])]
    with _placed(path):
        return study, cases_problem(rig, study.free, objective, more=more, **given)


def run_optimisation(path: Path | str) -> Optimisation | ParetoFront | DesignFront:
    """Run the search of a study file.

    Parameters
    ----------
    path : path
        A file of the schema ``jounce.optimisation/1``; files it names are relative to its folder.

    Returns
    -------
    Optimisation, ParetoFront or DesignFront
        Result in SI; a front if the study requests one, a ``DesignFront`` for three or more metrics.

    Raises
    ------
    DescriptionError, FitError
        As for :func:`optimise`, with the file name.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "study.toml"
    >>> text = '''
    ... schema = "jounce.optimisation/1"
    ... rig = "audi-a6-quarter-car"
    ... free = {"strut.damper.coefficient" = ["500 N*s/m", "5000 N*s/m"]}
    ... objective = {"rough: sprung.az" = 1.0}
    ... cases = {rough = {road = "C", speed = "20 m/s"}}
    ... spread = {"sprung.mass" = "10 %"}
    ... samples = 4
    ... '''
    >>> _ = file.write_text(text)
    >>> run_optimisation(file).converged
    True
    """
    study, rig, given = read_optimisation(path)
    with _placed(path):
        if study.front is None:
            assert study.objective is not None
            return optimise(rig, study.free, study.objective, starts=study.starts, **given)
        if len(study.front) > _PAIR:
            return design_front(rig, study.free, study.front, points=study.points, **given)
        first, second = study.front
        shown = study.shown or first
        return pareto(
            rig,
            study.free,
            comfort=first,
            holding=second,
            travel=shown,
            points=study.points,
            **given,
        )


class _placed:  # noqa: N801 - used as a verb
    """Adds file and line to errors that refer to keys of the study."""

    def __init__(self, path: Path | str) -> None:
        self.path = Path(path)

    def __enter__(self) -> None:
        """Enter the context; nothing is opened."""

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        """Raise the error again with file and line."""
        if not isinstance(error, JounceError):
            return
        head, _, rest = error.where.partition(": ")
        key, *inside = head.split(".")
        if key not in (*OptimisationStudy.model_fields, "metrics") or str(self.path) in error.where:
            return
        text = self.path.read_text(encoding="utf-8")
        if key == "metrics" or (
            key == "objective" and line_of(text, ("front",))
        ):  # the first metric of a front is read as the objective
            key = "front"
        line = line_of(text, (key, *inside, rest))
        place = ".".join([key, *inside]) + (f": {rest}" if rest else "")
        where = below(at_line(self.path, line), place)
        raise type(error)(
            error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
        ) from None
