"""Comparison of adhesion, phase angle and THETA for the same car over damper wear, tyre, load and friction."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from itertools import pairwise
from multiprocessing import get_context
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.operation import Count, File, operation
from jounce.core.phrases import Phrase
from jounce.core.processes import check_workers, starting_workers
from jounce.core.serialise import plain_table
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.waiting import Stage
from jounce.inspection.evaluation import evaluate
from jounce.inspection.limits import Limits, load_limits
from jounce.inspection.methods import METHODS as EVALUATED
from jounce.parts import QuarterCar, as_rig
from jounce.parts.options import AnyRig
from jounce.parts.testers import load_tester
from jounce.parts.variants import wear_dampers
from jounce.testers.plate_response import wheel_mode
from jounce.testers.testing import simulate_test
from jounce.variants.threads import processors

if TYPE_CHECKING:
    import xarray as xr

Progress = Callable[[float], None]
METHODS = {key: EVALUATED[key].numbers[0] for key in ("eusama", "egea", "theta")}
"""Compared methods and the quantity that each of them grades."""
SOUND, WORN = 0.2, 0.7
"""Loss of damping up to which a damper is sound, and from which it is worn (estimated)."""
_RIGID, _SPRUNG = "egea-specsus2018", "theta-msd3000"
_MOST_POINTS = 200  # of each varied quantity: 14 400 tests
_TESTS_OF_A_PROCESS = 200  # as many as can run in the time it takes to start a process


@dataclass(frozen=True)
class Factor:
    """A property other than the damper's that may influence a test."""

    name: str
    label: str  # axis label with unit
    scale: float  # displayed value per SI unit
    values: tuple[float, ...]  # SI, ascending
    changes: Callable[[QuarterCar, float], dict[str, Any]]  # changes of the rig for a value


def usual_factors(points: int = 28) -> tuple[Factor, ...]:
    """Tyre stiffness 140 to 300 kN/m, sprung mass 0.5 to 1.5 times the nominal one, strut friction up to 200 N."""
    rates, shares, forces = (
        _space_evenly(*ends, points) for ends in ((140e3, 300e3), (0.5, 1.5), (0.0, 200.0))
    )
    return (
        Factor("tyre_stiffness", "tyre stiffness [kN/m]", 1e-3, rates, _of_tyre),
        Factor("load", "sprung mass / nominal sprung mass [–]", 1.0, shares, _of_load),
        Factor("friction", "strut friction [N]", 1.0, forces, _of_friction),
    )


def _of_tyre(_: QuarterCar, rate: float) -> dict[str, Any]:
    return {"tyre.stiffness": rate}


def _of_load(rig: QuarterCar, share: float) -> dict[str, Any]:
    return {"sprung.mass": share * rig.sprung.mass}


def _of_friction(_: QuarterCar, force: float) -> dict[str, Any]:
    return {"strut.friction": {"force": force}} if force > 0.0 else {}


@dataclass(frozen=True)
class Disagreement:
    """Cars that a method misjudges, within one plane of the study."""

    factor: str
    method: str
    sound: int  # cars with a sound damper
    worn: int  # cars with a worn damper
    rejected_sound: int  # sound cars that the method rejects
    passed_worn: int  # worn cars that it passes
    rejected_at: (
        tuple[float, float] | None
    )  # range of the factor (SI) in which sound cars are rejected
    passed_at: tuple[float, float] | None  # range of the factor (SI) in which worn cars pass


@dataclass(frozen=True)
class Equivalence(Shown):
    """Results of the study.

    Attributes
    ----------
    planes : dict
        Factor to a Dataset over ``wear`` (1) and the factor (SI): ``adhesion`` (1), ``phase_angle_min_deg`` (deg),
        ``theta_road`` (1), NaN where a test gives no value, and ``<method>_verdict``.
    disagreements : tuple of Disagreement
        One per factor and method.
    factors : tuple of Factor
        Varied factors.
    limits : str
        Label of the limits.
    tests : int
        Number of simulated sweeps.
    edges : dict
        Rejection threshold of each method, in the unit of its quantity.
    """

    planes: dict[str, xr.Dataset]
    disagreements: tuple[Disagreement, ...]
    factors: tuple[Factor, ...]
    limits: str
    tests: int
    edges: dict[str, float] = field(default_factory=dict)

    def rejecting_wear(self, factor: str, method: str) -> Array:
        """Return the minimum wear at which a method rejects, over a factor, interpolated between wears.

        Shares of damping lost (1) for each value of the factor (n,); NaN where the method never rejects.

        Examples
        --------
        >>> import xarray as xr
        >>> values = {"adhesion": (("wear", "load"), [[0.6], [0.3]])}
        >>> verdicts = {"eusama_verdict": (("wear", "load"), [["pass"], ["fail"]])}
        >>> plane = xr.Dataset(values | verdicts, {"wear": [0.0, 0.9], "load": [1.0]})
        >>> study = Equivalence({"load": plane}, (), (), "", 2, {"eusama": 0.4})
        >>> study.rejecting_wear("load", "eusama").round(6).tolist()
        [0.6]
        """
        plane = self.planes[factor]
        wear, values = plane["wear"].to_numpy(), plane[METHODS[method]].to_numpy()
        fails = plane[f"{method}_verdict"].to_numpy() == "fail"
        edge = self.edges.get(method, np.nan)
        columns = zip(fails.T, values.T, strict=True)
        return np.array([_first_rejected(wear, fail, value, edge) for fail, value in columns])

    def to_dict(self) -> dict[str, Any]:
        """Return plain values: tables over wear (rows) and factor, in SI and degrees."""
        planes = {
            name: {
                "wear": plane["wear"].to_numpy(),
                name: plane[name].to_numpy(),
                **{
                    str(quantity): values.to_numpy() for quantity, values in plane.data_vars.items()
                },
            }
            for name, plane in self.planes.items()
        }
        plain = {
            "limits": self.limits,
            "tests": self.tests,
            "sound_up_to": SOUND,
            "worn_from": WORN,
        }
        plain |= {"rejected_below": self.edges}
        return plain_table({**plain, "planes": planes, "disagreements": self.disagreements})


@operation(
    "study inspection-equivalence",
    named={"changes": "set"},
    echo={"rig": "rig", "changes": "set"},
    offers=("figure", "report"),
    page="jounce.report.equivalence:equivalence_page",
    title="{rig}, simulated tests",
    doing="testing",
    example="jounce study inspection-equivalence audi-a6-quarter-car --figure tests.png",
)
def study_equivalence(
    rig: AnyRig,
    *,
    points: Annotated[
        int, Count("Number of values of each varied quantity.", least=2, most=200)
    ] = 28,
    limits: Annotated[str | None, File("A limits file in place of the shipped limits.")] = None,
    progress: Callable[[str], None] = lambda _: None,
) -> Equivalence:
    """Compare adhesion, phase angle and THETA of one wheel over damper wear, tyre stiffness, load and friction.

    Parameters
    ----------
    rig : Rig, str or Path
        Quarter car with a sound damper.
    points : int
        Number of values of each varied quantity, 2 to 200.
    limits : str, optional
        A limits file in place of the shipped limits.
    progress : callable
        Called with a progress text.

    Returns
    -------
    Equivalence
        As returned by :func:`jounce.compare_tests`.

    Raises
    ------
    DescriptionError
        If the number of points is out of range.

    Examples
    --------
    >>> study_equivalence("audi-a6-quarter-car", points=2).tests
    144
    """
    if not 2 <= points <= _MOST_POINTS:
        raise DescriptionError(
            "out of range",
            where="points",
            found=points,
            allowed=Phrase("2 to {most_points}", most_points=_MOST_POINTS),
        )
    return compare_tests(
        as_rig(rig),  # type: ignore[arg-type]
        factors=usual_factors(points),
        limits=load_limits(limits),
        workers=processors(),
        progress=lambda share: progress(
            Stage("testing: {percent:.0f} %", share=share, percent=100.0 * share)
        ),
    )


def compare_tests(
    rig: QuarterCar,
    *,
    wear: Sequence[float] | None = None,
    factors: Sequence[Factor] | None = None,
    limits: Limits | None = None,
    workers: int = 1,
    progress: Progress = lambda _: None,
) -> Equivalence:
    """Compute adhesion, phase angle and damping ratio on the road of a wheel over damper wear and other factors.

    Adhesion and phase angle come from simulated sweeps of an EGEA tester, THETA from the poles of the model without
    friction: THETA does not include the damping that friction adds at a tester's amplitude.

    Parameters
    ----------
    rig : QuarterCar
        Quarter car with a sound damper.
    wear : sequence of float, optional
        Lost shares of damping, 1; 24 values from 0 to 0.95 by default.
    factors : sequence of Factor, optional
        Other varied quantities, one plane each; :func:`usual_factors` by default.
    limits : Limits, optional
        Limits with the grading bands; the shipped ones by default.
    workers : int
        Number of processes (1: this one), at most one per 200 tests; a script that uses several needs
        ``if __name__ == "__main__":``.
    progress : callable
        Called with the completed share, 1.

    Returns
    -------
    Equivalence
        Values and verdicts over each plane, and the misjudged cars.

    Raises
    ------
    JounceError
        If the rig cannot be tested.

    Examples
    --------
    >>> from jounce.parts import load
    >>> found = compare_tests(load("audi-a6-quarter-car"), wear=[0.0, 0.8], factors=usual_factors(2)[:1])
    >>> found.tests, found.planes["tyre_stiffness"].sizes["wear"]
    (4, 2)
    """
    if not isinstance(rig, QuarterCar):
        raise SimulationError(
            "the study varies quarter cars", where="rig", found=type(rig).__name__
        )
    shares = np.asarray(_space_evenly(0.0, 0.95, 24) if wear is None else wear, dtype=float)
    chosen = tuple(usual_factors() if factors is None else factors)
    if not shares.size:
        raise DescriptionError(
            "no wear is given", where="wear", allowed="lost shares of the damping, 0 to 1"
        )
    used = limits or load_limits()
    places = [(factor, j) for factor in chosen for j in range(len(factor.values))]
    columns = [
        (rig.with_changes(factor.changes(rig, factor.values[j])), shares) for factor, j in places
    ]
    size = {factor.name: (len(shares), len(factor.values)) for factor in chosen}
    tables = {
        name: {quantity: np.full(shape, np.nan) for quantity in METHODS.values()}
        for name, shape in size.items()
    }
    for done, ((factor, j), column) in enumerate(
        zip(places, _test_columns(columns, workers), strict=True), 1
    ):
        for quantity, values in column.items():
            tables[factor.name][quantity][:, j] = values
        progress(done / len(places))
    planes = {factor.name: _plane(factor, shares, tables[factor.name], used) for factor in chosen}
    disagreements = tuple(
        row for factor in chosen for row in _disagreements(factor, planes[factor.name])
    )
    return Equivalence(
        planes, disagreements, chosen, used.label, len(columns) * len(shares), _edges(used)
    )


def _first_rejected(wear: Array, fails: NDArray[np.bool_], values: Array, edge: float) -> float:
    """Return the minimum failing wear (1), interpolated linearly to where the value equals the edge."""
    if not fails.any():
        return float("nan")
    i = int(fails.argmax())
    drop = values[i - 1] - values[i] if i else np.nan
    share = (values[i - 1] - edge) / drop if drop > 0.0 else np.nan
    return float(wear[i - 1] + share * (wear[i] - wear[i - 1]) if 0.0 <= share <= 1.0 else wear[i])


def _edges(limits: Limits) -> dict[str, float]:
    """Return the rejection threshold of each method for which higher values are better."""
    edges: dict[str, float] = {}
    for method in METHODS:
        bands = limits.methods[method].bands if method in limits.methods else ()
        ends = [
            low.end
            for low, high in pairwise(bands)
            if low.verdict == "fail" and high.verdict != "fail"
        ]
        edges |= {method: ends[0]} if ends else {}
    return edges


def _test_columns(
    columns: Sequence[tuple[QuarterCar, Array]], workers: int
) -> Iterator[dict[str, Array]]:
    """Test all columns in order."""
    workers = min(workers, sum(len(shares) for _, shares in columns) // _TESTS_OF_A_PROCESS)
    if workers <= 1:
        yield from map(_column, columns)
        return
    check_workers()
    with starting_workers():
        pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
    with pool:
        with starting_workers():
            results = pool.map(_column, columns)
        yield from results


def _column(column: tuple[QuarterCar, Array]) -> dict[str, Array]:
    """Compute the values of the three methods for one car over its wear; NaN where a test gives no value."""
    rig, shares = column
    rigid, sprung = load_tester(_RIGID), load_tester(_SPRUNG)
    results = {quantity: np.full(len(shares), np.nan) for quantity in METHODS.values()}
    for i, share in enumerate(shares):
        car = wear_dampers(rig, float(share))
        wheel = evaluate(
            simulate_test(car, rigid, truth=False), rigid, methods=["eusama", "egea"]
        ).wheels[0]
        mode = wheel_mode(_without_friction(car), sprung, on="road")
        values = (
            wheel.adhesion,
            wheel.phase_angle_min_deg,
            None if mode is None else mode.damping_ratio,
        )
        for quantity, value in zip(METHODS.values(), values, strict=True):
            results[quantity][i] = np.nan if value is None else value
    return results


def _without_friction(rig: QuarterCar) -> QuarterCar:
    """Return the rig without friction, which sticks near rest and has no damping ratio."""
    return rig.model_copy(update={"strut": rig.strut.model_copy(update={"friction": None})})


def _plane(factor: Factor, shares: Array, tables: dict[str, Array], limits: Limits) -> xr.Dataset:
    import xarray as xr

    variables: dict[str, Any] = {}
    for method, quantity in METHODS.items():
        variables[quantity] = (("wear", factor.name), tables[quantity])
        verdicts = [[_verdict(limits, method, value) for value in row] for row in tables[quantity]]
        variables[f"{method}_verdict"] = (("wear", factor.name), np.array(verdicts))
    return xr.Dataset(variables, {"wear": shares, factor.name: np.asarray(factor.values)})


def _verdict(limits: Limits, method: str, value: float) -> str:
    """Return a method's verdict; a value that is missing or in no band is not graded."""
    band = limits.methods[method].band_of(value) if np.isfinite(value) else None
    return "not graded" if band is None else band.verdict


def _disagreements(factor: Factor, plane: xr.Dataset) -> list[Disagreement]:
    """Count sound cars that are rejected and worn cars that pass, by method."""
    wear, values = plane["wear"].to_numpy(), plane[factor.name].to_numpy()
    sound, worn_out = wear <= SOUND, wear >= WORN
    rows = []
    for method in METHODS:
        verdict = plane[f"{method}_verdict"].to_numpy()
        rejected, passed = verdict[sound] == "fail", verdict[worn_out] == "pass"
        counts = (int(rejected.size), int(passed.size), int(rejected.sum()), int(passed.sum()))
        rows.append(
            Disagreement(
                factor.name, method, *counts, _range(values, rejected), _range(values, passed)
            )
        )
    return rows


def _range(values: Array, chosen: NDArray[np.bool_]) -> tuple[float, float] | None:
    there = values[chosen.any(axis=0)]
    return (float(there.min()), float(there.max())) if len(there) else None


def _space_evenly(low: float, high: float, points: int) -> tuple[float, ...]:
    return tuple(map(float, np.linspace(low, high, points)))
