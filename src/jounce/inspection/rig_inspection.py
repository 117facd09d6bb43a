"""Simulated test of a rig or vehicle: one wheel, one wheel over damper wear, or both wheels of an axle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from jounce.core.errors import DescriptionError, OutputError
from jounce.core.operation import Count, File, MadeBy, Mark, Number, Switch, operation
from jounce.core.shown import Shown
from jounce.core.waiting import progress_through
from jounce.inspection.grading import GradedInspection
from jounce.inspection.methods import METHODS
from jounce.inspection.simulated import (
    SimulatedInspection,
    simulate_axle,
    simulate_inspection,
    sweep_wear,
    tester_for,
)
from jounce.parts.files import load
from jounce.parts.options import CHANGES, rig_in_python
from jounce.parts.rig import Rig
from jounce.parts.testers import Tester, as_tester, load_tester
from jounce.parts.variants import wear_dampers

if TYPE_CHECKING:
    import xarray as xr

_OF_TESTER = "tester."
_WHEELS, _AXLES = ("left", "right", "both"), ("front", "rear")
_LONGEST_STROKE = 1.0  # m, limit for bare numbers: larger ones probably lack a unit
_METHOD = Mark("eusama, egea, theta or boge; by default the method of the tester.")


def rig_under_test(
    rig: Annotated[str, File("A rig or vehicle file, or a name of `jounce library`.")],
    changes: Annotated[Mapping[str, Any] | None, CHANGES] = None,
) -> Rig:
    """Load a rig and apply changes to its values; changes of the tester are ignored."""
    loaded, wanted = load(rig), _of_rig(changes)
    return loaded.with_changes(wanted) if wanted else loaded


def rig_under_test_in_python(rig: str, changes: Mapping[str, Any] | None = None) -> str:
    """Return the equivalent Python code of `rig_under_test`."""
    return rig_in_python(rig, _of_rig(changes))


def chosen_tester(
    method: Annotated[str | None, _METHOD] = None,
    tester: Annotated[
        str | None,
        Mark("A tester file, or the name of a shipped one; by default one for the method."),
    ] = None,
    stroke: Annotated[
        float | None,
        Number(
            'Stroke of the exciter, peak to peak: "6 mm".',
            unit="m",
            is_positive=True,
            most=_LONGEST_STROKE,
        ),
    ] = None,
    sweep_rate: Annotated[
        float | None, Number('Rate of the sweep: "2.5 Hz/s".', unit="Hz/s", is_positive=True)
    ] = None,
    changes: Annotated[Mapping[str, Any] | None, CHANGES] = None,
) -> Tester:
    """Load a tester, or the default one of a method, and apply changes to its values.

    Raises
    ------
    DescriptionError
        If neither is given, or one of them is unknown.
    """
    if tester is None and method is None:
        allowed = "eusama, egea, theta, boge; or --tester with a file or a name"
        raise DescriptionError("no method is given", where="method", allowed=allowed)
    found = tester_for(method) if method is not None else None
    found = load_tester(tester) if tester is not None else found
    assert found is not None
    wanted = _of_tester(stroke, sweep_rate, changes)
    return found.with_changes(wanted) if wanted else found


def python_of_tester(
    method: str | None = None,
    tester: str | None = None,
    stroke: float | None = None,
    sweep_rate: float | None = None,
    changes: Mapping[str, Any] | None = None,
) -> str:
    """Return the equivalent Python code of `chosen_tester`.

    >>> python_of_tester(method="egea", stroke=0.006)
    "jn.load_tester('egea-specsus2018').with_changes({'stroke': 0.006})"
    """
    name = METHODS[method].tester if tester is None and method is not None else tester
    wanted = _of_tester(stroke, sweep_rate, changes)
    return f"jn.load_tester({name!r})" + (f".with_changes({wanted!r})" if wanted else "")


def _of_rig(changes: Mapping[str, Any] | None) -> dict[str, Any]:
    return {
        path: value for path, value in (changes or {}).items() if not path.startswith(_OF_TESTER)
    }


def _of_tester(
    stroke: float | None, sweep_rate: float | None, changes: Mapping[str, Any] | None
) -> dict[str, Any]:
    given = {"stroke": stroke, "programme.sweep_rate": sweep_rate}
    more = {
        path.removeprefix(_OF_TESTER): value
        for path, value in (changes or {}).items()
        if path not in _of_rig(changes)
    }
    return {**more, **{path: value for path, value in given.items() if value is not None}}


def check_record(*, out: Path | None, steady: bool, wear: str | None, **_: Any) -> None:
    """Raise an error for an output file unless the test yields exactly one record."""
    if out is not None and (steady or _is_range(wear)):
        what = "steady states have no record" if steady else "a record file holds only one test"
        raise OutputError(
            what, where=f"--out {out}", hint="Leave out --steady, and give a single --wear."
        )


def _is_range(wear: str | float | None) -> bool:
    return isinstance(wear, str) and ":" in wear


@dataclass(frozen=True)
class InspectedRig(Shown):
    """Result of a simulated test of a rig.

    Attributes
    ----------
    tester : Tester
        Tester used.
    method : str
        Method whose grade decides.
    steady : bool
        Whether steady states were computed instead of a sweep.
    wear : tuple of float
        Loss of damping of each test (1).
    tests : tuple of SimulatedInspection
        Tests of one wheel, one per wear; empty if both wheels were tested.
    axle : GradedInspection or None
        Result of both wheels, if both were tested.
    record : xarray.Dataset or None
        Record of the test; None for steady states and for a range of wear.
    is_range : bool
        Whether a range of wear was requested.
    """

    tester: Tester
    method: str
    steady: bool
    wear: tuple[float, ...]
    tests: tuple[SimulatedInspection, ...]
    axle: GradedInspection | None = None
    record: xr.Dataset | None = None
    is_range: bool = False

    @property
    def title(self) -> str:
        """Tester and kind of test."""
        kind = "sweep of both wheels" if self.axle else "steady states" if self.steady else "sweep"
        return f"{self.tester.name}, {kind}"

    def to_dict(self) -> dict[str, Any]:
        """Return a single wheel, a list of wheels for a range of wear, or both wheels as in `inspect evaluate`."""
        about = {"tester": self.tester.name, "method": self.method, "steady": self.steady}
        if self.axle is not None:
            return {**self.axle.to_dict(), **about}
        wheels = [self._wheel(test) for test in self.tests]
        if not self.is_range:
            return {**wheels[0], **about}
        worn_wheels = [
            {"wear": lost, **wheel} for lost, wheel in zip(self.wear, wheels, strict=True)
        ]
        return {**about, "wear": list(self.wear), "wheels": worn_wheels}

    def _wheel(self, test: SimulatedInspection) -> dict[str, Any]:
        truth = {"truth": {"theta_road": test.theta_road, "theta_rig": test.theta_rig}}
        return {**test.wheel.to_dict(), **({} if self.steady else truth)}


@operation(
    "inspect simulate",
    named={"changes": "set", "vehicle": "rig"},
    faces={"noise": "0"},
    echo={"rig": "rig"},
    offers=("test_record",),
    check="jounce.inspection.rig_inspection:check_record",
    page="jounce.report.inspection:inspected_rig_page",
    title="{rig} on {result.title}",
    doing="testing",
    example="jounce inspect simulate audi-a6-quarter-car --method egea --wear 0:1:0.1",
    note=(
        '--set changes the rig, and with `tester.` before the path the tester: --set tester.plate_mass="25 kg". With '
        "--json one wheel is one object; both wheels are {wheels: [...], axle: {...}}, as of `inspect evaluate`."
    ),
)
def inspect_rig(  # noqa: PLR0913 - each is an option
    rig: Annotated[
        Rig | str | Path,
        MadeBy(
            "jounce.inspection.rig_inspection:rig_under_test",
            "jounce.inspection.rig_inspection:rig_under_test_in_python",
        ),
    ],
    tester: Annotated[
        Tester | str | Path,
        MadeBy(
            "jounce.inspection.rig_inspection:chosen_tester",
            "jounce.inspection.rig_inspection:python_of_tester",
        ),
    ],
    *,
    method: Annotated[str | None, _METHOD] = None,
    steady: Annotated[bool, Switch("Steady states instead of a sweep.")] = False,
    wear: Annotated[
        str | float | None, Mark("Loss of damping, as a share: one number, or FIRST:LAST:STEP.")
    ] = None,
    wheel: Annotated[
        Literal["left", "right", "both"],
        Mark(
            "left or right: the wheel to test, and its plate; both: both wheels of an axle in turn."
        ),
    ] = "left",
    axle: Annotated[Literal["front", "rear"], Mark("Axle of a vehicle: front or rear.")] = "front",
    noise: Annotated[
        float, Number('Standard deviation of the force noise, relative to the static load: "1 %".')
    ] = 0.0,
    seed: Annotated[int, Count("Seed of the noise.", least=0)] = 0,
    truth: Annotated[
        bool, Switch("Include channels in the record that no tester measures (truth.*).")
    ] = False,
    vehicle: Annotated[str, File("Its name in the record.")] = "",
    progress: Callable[[str], None] = lambda _: None,
) -> InspectedRig:
    """Simulate a test, evaluate the record like a measured one, and grade it.

    The result has the same form as that of :func:`jounce.evaluate_inspection` for a record of a real tester.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig under test; of a vehicle one axle is tested.
    tester : Tester, str or Path
        Plates, programme and limits.
    method : {"eusama", "egea", "theta", "boge"}, optional
        Method whose grade decides; by default the method of the tester.
    steady : bool
        Whether to compute steady states instead of a sweep.
    wear : str or float, optional
        Loss of damping, as a share (1); ``first:last:step`` gives several values.
    wheel : {"left", "right", "both"}
        Wheel to test and its plate, or both wheels of an axle one after the other.
    axle : {"front", "rear"}
        Axle of a vehicle.
    noise : float
        Standard deviation of the force noise relative to the static load (1).
    seed : int
        Seed of the noise.
    truth : bool
        Whether to keep unmeasured channels (``truth.*``) in the record.
    vehicle : str
        Name or file of the vehicle, for the record.
    progress : callable
        Called with a progress text of one line.

    Returns
    -------
    InspectedRig
        Values, grades and the record.

    Raises
    ------
    JounceError
        As :func:`jounce.simulate_inspection` and :func:`jounce.simulate_axle`; for both wheels in steady states, or
        over a range of wear.

    Examples
    --------
    >>> import jounce as jn
    >>> found = inspect_rig("audi-a6-quarter-car", "eusama", steady=True, wear="0:1:0.5")
    >>> [test.wheel.verdict for test in found.tests]
    ['pass', 'pass', 'fail']
    """
    for where, value, allowed in (("wheel", wheel, _WHEELS), ("axle", axle, _AXLES)):
        if value not in allowed:
            raise DescriptionError("unknown", where=where, found=value, allowed=", ".join(allowed))
    if seed < 0:
        raise DescriptionError("out of range", where="seed", found=seed, allowed="0 or more")
    stood, plates = load(rig) if isinstance(rig, str | Path) else rig, as_tester(tester)
    wears = [0.0] if wear is None else sweep_wear(str(wear))
    if wheel == "both" and (steady or len(wears) > 1):
        what = (
            "steady states need a single wheel"
            if steady
            else "a range of wear needs a single wheel"
        )
        raise DescriptionError(what, where="wheel", found=wheel, allowed="left, right")
    name = Path(vehicle).stem if vehicle.endswith(".toml") else vehicle
    more: dict[str, Any] = {
        "method": method,
        "axle": axle,
        "noise": noise,
        "seed": seed,
        "vehicle": name,
    }
    decides = method or plates.method
    if wheel == "both":
        graded, measured = simulate_axle(
            wear_dampers(stood, wears[0]) if wears[0] else stood, plates, **more
        )
        return InspectedRig(
            plates, decides, steady, (wears[0],), (), graded, measurable(measured, truth=truth)
        )
    tests = []
    for number, lost in enumerate(wears, 1):
        progress(
            progress_through("testing {which} of {count}", number, len(wears))
            if len(wears) > 1
            else "testing"
        )
        changed = wear_dampers(stood, lost) if lost else stood
        tests.append(simulate_inspection(changed, plates, steady=steady, wheel=wheel, **more))
    first = None if _is_range(wear) else tests[0].record
    record = None if first is None else measurable(first, truth=truth)
    return InspectedRig(
        plates, decides, steady, tuple(wears), tuple(tests), None, record, _is_range(wear)
    )


def measurable(record: xr.Dataset, *, truth: bool) -> xr.Dataset:
    """Return the channels of a record that a tester measures; with ``truth`` all channels."""
    names = [name for name in record.data_vars if truth or not str(name).startswith("truth.")]
    return record if truth else record[names]
