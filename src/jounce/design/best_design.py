"""The best design for commands and pages: from a rig with bounds and an objective, or from a study file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from jounce.core.description import schema_named_in
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.old_names import old_property
from jounce.core.operation import Count, File, MadeBy, Mark, Number, Texts, operation
from jounce.core.serialise import Plain
from jounce.core.typed import quantity
from jounce.design.goal_front import DesignFront
from jounce.design.optimisation_study import read_optimisation, run_optimisation
from jounce.design.optimise import Optimisation, optimise
from jounce.design.options import FREE, LIMITS, ROAD_BAND, ROAD_SPEED
from jounce.design.pareto import ParetoFront
from jounce.design.problem import LimitGiven
from jounce.identify.fit_problem import Bounds
from jounce.parts import Rig, as_rig
from jounce.parts.options import CHANGES, rig_in_python, rig_of_options
from jounce.ride.drives import trial_over

_SCHEMA = "jounce.optimisation/"
_BESIDE = ("free", "objective", "limit", "set", "duration", "band")
"""Options that a study file replaces."""


@dataclass(frozen=True)
class BestDesign(Plain):
    """Result of a search for the best design.

    Attributes
    ----------
    outcome : Optimisation, ParetoFront or DesignFront
        Result in SI; a front if the study requests one.
    study : str
        The study file; empty without one.
    of : str
        The rig named in the study.
    """

    outcome: Optimisation | ParetoFront | DesignFront
    study: str = ""
    of: str = ""
    found = old_property("BestDesign.found", "outcome")

    @property
    def rig(self) -> Rig:
        """The best rig."""
        assert isinstance(
            self.outcome, Optimisation
        )  # a front is rejected before the search if a rig is requested
        return self.outcome.rig

    @property
    def aim(self) -> str:
        """Objective in words."""
        return ", ".join(self.outcome.objective) if isinstance(self.outcome, Optimisation) else ""

    @property
    def driven(self) -> str:
        """Road or cases in words."""
        return self.outcome.driven

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings of the search."""
        return self.outcome.findings

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        named = {"rig": self.of, "set": {}, "study": self.study} if self.study else {}
        return {**named, **self.outcome.to_dict()}


def rig_or_study(
    vehicle: Annotated[
        str,
        File(
            'A rig or vehicle; or a study file, schema = "jounce.optimisation/1", which describes the whole task.',
            "NAME|FILE|STUDY.toml",
            shipped=("parts",),
        ),
    ],
    changes: Annotated[Mapping[str, Any] | None, CHANGES] = None,
) -> Rig | Path:
    """Load a rig and change its values; return the path of a study file."""
    return Path(vehicle) if _is_study(vehicle) else rig_of_options(vehicle, changes)


def rig_or_study_in_python(vehicle: str, changes: Mapping[str, Any] | None = None) -> str:
    """Write the rig or study as Python."""
    return repr(vehicle) if _is_study(vehicle) else rig_in_python(vehicle, changes)


def _is_study(vehicle: str) -> bool:
    return schema_named_in(Path(vehicle)).startswith(_SCHEMA)


def check_task(vehicle: str, out: Path | None, **given: Any) -> None:
    """Reject options alongside a study, a rig file for a front, and a task without variables or objective."""
    options = {name: given["set_" if name == "set" else name] for name in _BESIDE}
    if not _is_study(vehicle):
        for name in ("free", "objective"):
            if not options[name]:
                raise DescriptionError(
                    "nothing is given",
                    where=f"--{name}",
                    hint="Or give a study file that defines it.",
                )
        return
    for name, value in options.items():
        if value:
            raise DescriptionError(
                "a study file defines the whole task",
                where=f"--{name}",
                hint="Write the option into the file.",
            )
    if out is not None and read_optimisation(vehicle)[0].front is not None:
        raise DescriptionError(
            "a Pareto front has many designs, which one file cannot hold",
            where="--out",
            hint="Apply one of its designs with --set.",
        )


@operation(
    "design optimise",
    named={"changes": "set", "constraints": "limit"},
    echo={"rig": "vehicle", "set": "set"},
    offers=("rig", "figure", "report"),
    check="jounce.design.best_design:check_task",
    page="jounce.report.decisions:best_design_page",
    title="{vehicle}",
    comment="{vehicle}, best for {result.aim} over {result.driven}.",
    doing="searching",
    example='jounce design optimise kart-quarter-car --free strut.damper.coefficient="50..500" --objective sprung.az',
)
def find_best_design(
    rig: Annotated[
        Rig | str | Path,
        MadeBy(
            "jounce.design.best_design:rig_or_study",
            "jounce.design.best_design:rig_or_study_in_python",
        ),
    ],
    free: Annotated[Mapping[str, Bounds] | None, FREE] = None,
    objective: Annotated[
        Sequence[str] | None,
        Texts(
            'Metric to minimise: sprung.az, "sprung.az weighted", "worst tyre.force coefficient". Repeat it.',
            "METRIC[=WEIGHT]",
        ),
    ] = None,
    *,
    road: Annotated[
        str, Mark("A class (iso:A to iso:H) or roughness; with --duration any road file.", "ROAD")
    ] = "iso:C",
    speed: Annotated[float | str, ROAD_SPEED] = "20 m/s",
    constraints: Annotated[Mapping[str, LimitGiven] | None, LIMITS] = None,
    duration: Annotated[
        float | str | None,
        Number(
            "Simulate the road for this time instead of using the closed-form random response.",
            "TIME",
            "s",
            is_positive=True,
        ),
    ] = None,
    band: Annotated[tuple[float, float] | Literal["iso"] | None, ROAD_BAND] = None,
    starts: Annotated[
        int, Count("Number of searches; the first starts from the present design.")
    ] = 1,
) -> BestDesign:
    """Find the parameters of a vehicle that minimise an objective within bounds and limits, using exact gradients.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library; or a study file (``jounce.optimisation/1``) without further
        arguments.
    free : mapping, optional
        Path to its bounds, as for :func:`jounce.optimise`.
    objective : sequence of str, optional
        Metrics to minimise, each with a weight: ``"sprung.az=2"`` (1 by default).
    road : str
        Class of ISO 8608 or roughness; with ``duration`` any road file or name of the library.
    speed : float or str
        m/s.
    constraints : mapping, optional
        Limits, as for :func:`jounce.optimise`.
    duration : float or str, optional
        Simulated time, s; by default the random response is computed in closed form.
    band : tuple of float or "iso", optional
        Spatial frequencies of the road, 1/m.
    starts : int
        Number of searches; the first starts from the present design.

    Returns
    -------
    BestDesign
        SI.

    Raises
    ------
    DescriptionError, FitError
        As for :func:`jounce.optimise`.

    Examples
    --------
    >>> free = {"strut.damper.coefficient": (500, 5000)}
    >>> best = find_best_design("audi-a6-quarter-car", free, ["sprung.az"], road="iso:C", speed="20 m/s", band="iso")
    >>> best.outcome.converged
    True
    """
    if isinstance(rig, str | Path) and _is_study(str(rig)):
        return BestDesign(run_optimisation(rig), str(rig), read_optimisation(rig)[0].rig)
    chosen, weights = as_rig(rig), _weights(objective or ())
    driven: dict[str, Any] = {"road": road, "speed": speed, "band": band}
    if duration is not None:
        if band is not None:
            raise DescriptionError(
                "a simulated road is not limited to a band", where="band", hint="Leave it out."
            )
        driven = {"trial": trial_over(chosen, road, speed, duration).trial}
    return BestDesign(optimise(chosen, free or {}, weights, constraints, **driven, starts=starts))


def _weights(texts: Sequence[str]) -> dict[str, float]:
    """Parse weights by metric; 1 by default."""
    weights: dict[str, float] = {}
    for text in texts:
        name, equals, weight = text.partition("=")
        if name.strip() in weights:
            raise DescriptionError("given twice", where="objective", found=name.strip())
        weights[name.strip()] = (
            quantity(weight, "1", f"--objective {name.strip()}") if equals else 1.0
        )
    return weights
