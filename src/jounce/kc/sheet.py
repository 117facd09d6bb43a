"""The sheet of an axle: all tests of the laboratory, their overview, and measured tests beside them."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np

from jounce.core.errors import DescriptionError, JounceError, unknown
from jounce.core.findings import Finding, finding, findings_of
from jounce.core.operation import Count, File, Mark, Number, Pairs, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_plain
from jounce.core.units import to_si
from jounce.core.waiting import progress_through
from jounce.kc.centres import centres_of
from jounce.kc.laboratory import Laboratory, axle_of, run_test
from jounce.kc.overview import CSV_HEADER, KcOverview, Within, kc_overview
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import QUANTITIES, quantity_name
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class KcTests(Plain):
    """All tests of an axle on the K&C rig.

    Attributes
    ----------
    rig : Rig
        The axle.
    tests : mapping of str to xarray.Dataset
        Completed tests by name, SI.
    overview : KcOverview
        Characteristic rows.
    failed : tuple of Finding
        Tests that were not completed, and why.
    settings : mapping
        Settings that differ from the defaults, as texts.
    measured : mapping of str to xarray.Dataset
        Measured tests, if given.
    compared : xarray.Dataset or None
        Model beside measurement; see :func:`jounce.compare_kc`.
    findings : tuple of Finding
        Findings of all tests and of the measured sheet.
    """

    rig: Rig
    tests: Mapping[str, xr.Dataset]
    overview: KcOverview
    failed: tuple[Finding, ...] = ()
    settings: Mapping[str, str] = field(default_factory=dict)
    measured: Mapping[str, xr.Dataset] = field(default_factory=dict)
    compared: xr.Dataset | None = None
    findings: tuple[Finding, ...] = ()

    @property
    def problems(self) -> tuple[str, ...]:
        """Messages of tests that were not completed."""
        return tuple(str(item) for item in self.failed)

    @property
    def with_pdf(self) -> bool:
        """Whether the folder has the sheet as PDF, too."""
        return find_spec("typst") is not None

    def to_dict(self) -> dict[str, Any]:
        """Return overview, comparison, settings and findings as plain data, SI."""
        return {
            "tests": list(self.tests),
            "settings": dict(self.settings),
            "overview": [row.to_dict() for row in self.overview],
            "compared": _plain_comparison(self.compared),
            "findings": to_plain(self.findings),
        }

    def files(self) -> dict[str, bytes | str]:
        """Return overview, curves and workbook by file name; the workbook needs the extra ``io``."""
        from jounce.recordings.writers import netcdf_of

        made: dict[str, bytes | str] = {"overview.csv": self.overview.table()}
        made["kc.nc"] = netcdf_of(together(self.tests))
        for name, dataset in self.tests.items():
            made[f"tests/{name}.csv"] = _csv(dataset)
        if find_spec("openpyxl") is not None:
            made["kc.xlsx"] = self._workbook()
        return made

    def _workbook(self) -> bytes:
        from jounce.core.workbooks import workbook_of

        rows: list[Sequence[float | str]] = [CSV_HEADER, *self.overview.cells()]
        sheets: dict[str, list[Sequence[float | str]]] = {"overview": rows}
        for name, dataset in self.tests.items():
            header, values = _columns(dataset, only=QUANTITIES)
            known = np.isfinite(values)
            sheets[name] = [header]
            sheets[name] += [
                [float(v) if k else "" for v, k in zip(row, mask, strict=True)]
                for row, mask in zip(values, known, strict=True)
            ]
        return workbook_of(sheets)


def together(tests: Mapping[str, xr.Dataset]) -> xr.Dataset:
    """Return all tests as one dataset on ``test`` and ``sample``, with NaN where a test has no such quantity."""
    import xarray as xr

    longest = max(dataset.sizes["sample"] for dataset in tests.values())
    columns: dict[str, np.ndarray] = {}
    attributes: dict[str, dict[str, Any]] = {}
    for k, dataset in enumerate(tests.values()):
        variables = dataset.variables  # each item of a dataset is made anew
        for name in map(str, ("input", *dataset.data_vars)):
            values = np.asarray(variables[name].values, dtype=float)
            column = columns.setdefault(name, np.full((len(tests), longest), np.nan))
            column[k, : len(values)] = values
            attributes.setdefault(name, dict(variables[name].attrs))
    units = [str(dataset["input"].attrs["units"]) for dataset in tests.values()]
    axes = {
        "test": list(tests),
        "input": (("test", "sample"), columns.pop("input"), {"long_name": "input of the test"}),
        "input_unit": ("test", units),
    }
    both = {
        name: (("test", "sample"), column, attributes[name]) for name, column in columns.items()
    }
    first = next(iter(tests.values())).attrs
    kept = {
        key: first[key]
        for key in ("model", "held", "handwheel", "track", "convention")
        if key in first
    }
    return xr.Dataset(both, axes, kept)


def _columns(
    dataset: xr.Dataset, only: Mapping[str, object] | None = None
) -> tuple[list[str], np.ndarray]:
    """Return headers with SI units and values (samples, columns) of a test; of some quantities ``only``."""
    variables = dataset.variables
    names = [
        str(name)
        for name in dataset.data_vars
        if variables[name].dims == ("sample",)
        and (only is None or quantity_name(str(name)) in only)
    ]
    columns = [variables["input"], *(variables[name] for name in names)]
    header = [
        f"{name} [{column.attrs.get('units', '1')}]"
        for name, column in zip(("input", *names), columns, strict=True)
    ]
    return header, np.column_stack([np.asarray(column.values, dtype=float) for column in columns])


def _csv(dataset: xr.Dataset) -> str:
    header, values = _columns(dataset)
    stream = io.StringIO()
    stream.write(f"{','.join(header)}\n")
    for row in values.tolist():
        stream.write(",".join(f"{v:.12g}" if math.isfinite(v) else "" for v in row) + "\n")
    return stream.getvalue()


def _plain_comparison(compared: xr.Dataset | None) -> list[dict[str, Any]]:
    if compared is None:
        return []
    names = [str(name) for name in (*compared.coords, *compared.data_vars) if name != "row"]
    columns = {name: to_plain(compared[name].values.tolist()) for name in names}
    return [
        {name: values[k] for name, values in columns.items()} for k in range(compared.sizes["row"])
    ]


@operation(
    "kc",
    named={"changes": "set", "tests": "test", "channels": "map", "tolerances": "tolerance"},
    offers=("folder", "report"),
    page="jounce.report.kc:kc_page",
    terminal="jounce.report.kc:kc_summary",
    title="K&C of {rig}",
    doing="testing",
    example="jounce kc reference-double-wishbone --out sheet",
)
def kc_sheet(  # noqa: PLR0913 - each is a setting of the laboratory
    rig: AnyRig,
    tests: Annotated[
        Sequence[str] | None,
        Texts(f"A test: {', '.join(TESTS)}; repeat for several. Default: all.", "TEST"),
    ] = None,
    *,
    to: Annotated[
        Mapping[str, float | str] | None,
        Pairs(
            'End of the range of a test: bounce="40 mm". Repeat it.', "TEST=VALUE", 'bounce="40 mm"'
        ),
    ] = None,
    within: Annotated[
        Mapping[str, Within] | None,
        Pairs(
            'Range of the fit about zero: bounce="20 mm"; by default half of the test\'s. Repeat it.',
            "TEST=VALUE",
            'bounce="20 mm"',
        ),
    ] = None,
    points: Annotated[int, Count("Samples of each loop.", least=5, most=2001)] = 41,
    travel: Annotated[
        float | str,
        Number('Height of both pads before the tests, bump positive: "20 mm".', "LENGTH", "m"),
    ] = 0.0,
    steer: Annotated[
        float | str | None,
        Number('Rack travel before the tests, to the left: "10 mm".', "LENGTH", "m"),
    ] = None,
    held: Annotated[
        Literal["load", "height"],
        Mark("What tests with forces keep: load (of each wheel) or height (of its pad).", "WHAT"),
    ] = "load",
    handwheel: Annotated[
        Literal["locked", "free"],
        Mark("Whether the handwheel holds the rack: locked or free.", "HOW"),
    ] = "locked",
    trail: Annotated[
        float | str | None,
        Number(
            "Distance behind the contact point at which lateral forces act; by default 30 mm in the "
            "test lateral-trail only.",
            "LENGTH",
            "m",
        ),
    ] = None,
    on: Annotated[
        Literal["front", "rear"] | None, Mark("Axle of a car: front or rear.", "AXLE")
    ] = None,
    measured: Annotated[
        Sequence[Path | str] | None,
        Texts(
            "A measured sheet to lay over the model: a file of the rig; repeat for several.", "FILE"
        ),
    ] = None,
    channels: Annotated[
        Path | str | None, File("Channel map of the measured files.", "MAP.toml")
    ] = None,
    tolerances: Annotated[
        Mapping[str, float | str] | None,
        Pairs(
            'Allowed difference of a quantity from the measured one: toe="0.05 deg", or camber="10 %". Repeat it.',
            "QUANTITY=VALUE",
            'toe="0.05 deg"',
        ),
    ] = None,
    progress: Callable[[str], None] = lambda _: None,
) -> KcTests:
    """Run the tests of a kinematics-and-compliance laboratory and make its sheet: overview, curves, fitted slopes.

    Parameters
    ----------
    rig : Rig, str or Path
        Axle: a corner with hardpoints, a dependent axle, or a 3-D car with ``on``; its file or name in the library.
    tests : sequence of str, optional
        Tests by name, see :func:`jounce.kc_test`; by default all that the axle can do.
    to : mapping, optional
        End of the range by test, in its SI unit or as text with a unit.
    within : mapping, optional
        Range of the fit by test, as for :func:`jounce.kc_overview`.
    points : int
        Samples of each loop.
    travel : float or str
        Height of both pads above the design position before the tests, m.
    steer : float or str, optional
        Rack travel before the tests, m, to the left.
    held : {"load", "height"}
        What tests with forces keep: each wheel's load, or the height of its pad.
    handwheel : {"locked", "free"}
        Whether the handwheel holds the rack.
    trail : float or str, optional
        Distance behind the contact point at which lateral forces act, m.
    on : {"front", "rear"}, optional
        Axle of a car.
    measured : sequence of Path or str, optional
        Files of a measured sheet, as for :func:`jounce.read_kc`.
    channels : Path or str, optional
        Their channel map.
    tolerances : mapping, optional
        Allowed differences, SI or as text with a unit, as for :func:`jounce.compare_kc`.
    progress : callable
        Called with a line of text for each test.

    Returns
    -------
    KcTests
        Completed tests, overview and comparison, SI. A test that fails is a finding; the others are kept.

    Raises
    ------
    DescriptionError
        If a test, setting or range is unknown or invalid, or the rig is no axle.
    SimulationError
        If there is no equilibrium at ride height, or no test could be completed.
    RecordingError
        If no measured test can be read.

    Examples
    --------
    >>> sheet = kc_sheet("semi-trailing-arm", ["bounce", "lateral-in-phase"])
    >>> list(sheet.tests), sheet.overview.row("lateral-in-phase", "roll_centre_height").usual().name
    (['bounce', 'lateral-in-phase'], 'mm')
    """
    described = as_rig(rig)
    axle = axle_of(described, on)
    rack = None if steer is None else to_si(steer, "m", where="steer")
    ends = _ends(to)
    names = _names(tests, ends, within)
    if channels is not None and not measured:
        raise DescriptionError(
            "there is no measured sheet to read with it",
            where="channels",
            found=str(channels),
            hint="Give measured files.",
        )
    sheet = {} if not measured else _read(measured, channels, on)
    laboratory = Laboratory(axle, to_si(travel, "m", where="travel"), rack)
    names = names if tests else laboratory.names(None)
    done: dict[str, xr.Dataset] = {}
    failed: list[tuple[Finding, JounceError]] = []
    for k, name in enumerate(names, 1):
        progress(progress_through("test {which} of {count}: {name}", k, len(names), name=name))
        try:
            done[name], _ = run_test(
                laboratory, TESTS[name], ends.get(name), points, held, handwheel, trail
            )
        except JounceError as error:
            failed.append((finding("kc.test_failed", name, error=error), error))
    if not done:
        raise failed[0][1]
    overview = kc_overview(
        done, centres_of(laboratory), within={k: v for k, v in (within or {}).items() if k in done}
    )
    compared = _compared(done, sheet, tolerances)
    findings = [item for item, _ in failed]
    findings += [item for dataset in done.values() for item in findings_of(dataset.attrs)]
    findings += getattr(sheet, "findings", ())
    findings += [] if compared is None else findings_of(compared.attrs)
    settings = {
        "travel": travel, "steer": steer, "held": held, "handwheel": handwheel, "trail": trail,
        "on": on, "points": points,
    }  # fmt: skip
    return KcTests(
        axle,
        done,
        overview,
        tuple(item for item, _ in failed),
        {name: str(value) for name, value in settings.items() if value is not None},
        sheet,
        compared,
        tuple(dict.fromkeys(findings)),
    )


def _names(tests: Sequence[str] | None, *by_test: Mapping[str, Any] | None) -> list[str]:
    """Return the tests in the order of the sheet; refuse unknown ones, and settings of tests that are not run."""
    for name in tests or ():
        if name not in TESTS:
            raise unknown(name, TESTS, what="test", where="tests")
    names = [name for name in TESTS if tests is None or name in tests]
    for where, given in zip(("to", "within"), by_test, strict=True):
        for name in given or {}:
            if name not in names:
                raise unknown(name, names, what="test", where=where)
    return names


def _ends(to: Mapping[str, float | str] | None) -> dict[str, float]:
    """Return ends of ranges, SI; what is wrong with one is wrong before any test is run."""
    ends = {}
    for name, value in (to or {}).items():
        if name not in TESTS:
            raise unknown(name, TESTS, what="test", where="to")
        ends[name] = to_si(value, TESTS[name].unit, where="to")
        if not ends[name] or not np.isfinite(ends[name]):
            raise DescriptionError(
                "a range of no extent", where="to", found=Phrase(f"{name}={value}")
            )
    return ends


def _read(
    measured: Sequence[Path | str], channels: Path | str | None, on: Literal["front", "rear"] | None
) -> Mapping[str, xr.Dataset]:
    from jounce.kc.measured import read_kc

    return read_kc([Path(file) for file in measured], channels, axle=on)


def _compared(
    tests: Mapping[str, xr.Dataset],
    measured: Mapping[str, xr.Dataset],
    tolerances: Mapping[str, float | str] | None,
) -> xr.Dataset | None:
    if not measured:
        if tolerances:
            raise DescriptionError(
                "there is nothing to compare with", where="tolerances", hint="Give measured files."
            )
        return None
    from jounce.kc.compared import compare_kc

    return compare_kc(tests, measured, tolerances)
