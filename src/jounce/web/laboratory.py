"""K&C tests for the page: curves of one test, as changed, as saved and as measured, and the overview of all tests."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.core.commands import command_line
from jounce.core.display import display_unit
from jounce.core.errors import JounceError, unknown
from jounce.core.files import only_below, state_of
from jounce.core.findings import Finding, findings_of, with_german
from jounce.core.remembered import Recent
from jounce.core.serialise import to_plain
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.operations.index import operations
from jounce.operations.request import Request
from jounce.web.answers import (
    ONE,
    Changes,
    CurvesAnswer,
    differences_of,
    digest_of,
    key_of,
    variants,
    word,
)
from jounce.web.project import Project

if TYPE_CHECKING:
    import xarray as xr

    from jounce.kc.measured import KcSheet
    from jounce.kc.overview import OverviewRow
    from jounce.kc.quantities import Poses
    from jounce.parts import Rig
    from jounce.report.live import Pane, PosedRig, Viewer

Side = Literal["left", "right"]
_PATIENCE = 0.15
"""Seconds of tests in one answer beyond the open one: the page asks for the others afterwards."""
_ROLES: Mapping[tuple[str, Side], str] = {
    ("now", "left"): "after",
    ("now", "right"): "other-5",
    ("saved", "left"): "other-4",
    ("saved", "right"): "before",
    ("measured", "left"): "measured",
    ("measured", "right"): "other-6",
}
"""Curves as the rig is now, as it was saved, and as it was measured."""
_ALWAYS = ("toe", "camber", "caster", "steer", "spin")
_FIRST = (
    *_ALWAYS, "camber_to_ground", "mean_steer", "toe_out", "half_track", "vertical_force", "roll_moment",
    "rack_force", "handwheel_torque",
)  # fmt: skip
_OPEN = 2e-3
"""Least opening of a loop, as a share of the curve's range, that is drawn as two branches."""
_STILL = {"rad": 1e-7, "m": 1e-8, "N": 1e-3, "N*m": 1e-4}
"""Ranges, SI, below which a quantity does not move in a test."""


@dataclass(frozen=True)
class Question:
    """Tests of ``rig``: the open ``test``, and the ``overview`` if wanted.

    ``to`` and ``within`` are ends of ranges and ranges of fits by test, ``travel`` and ``steer`` the state before the
    tests, ``measured`` files of the project; with ``loads``, the curves include forces of links and bushings.
    """

    rig: str
    changes: Changes
    test: str = "bounce"
    text: str | None = None
    axle: Literal["", "front", "rear"] = ""
    to: Mapping[str, str] = field(default_factory=dict)
    within: Mapping[str, str] = field(default_factory=dict)
    travel: str = ""
    steer: str = ""
    held: Literal["load", "height"] = "load"
    handwheel: Literal["locked", "free"] = "locked"
    measured: Sequence[str] = ()
    overview: bool = False
    loads: bool = False


class Bench:
    """An axle in the laboratory, with the tests that were run."""

    def __init__(self, rig: Rig, asked: Question) -> None:
        from jounce.kc.laboratory import Laboratory, axle_of
        from jounce.kc.tests import TESTS

        steer = to_si(asked.steer, "m", where="steer") if asked.steer else None
        travel = to_si(asked.travel or 0.0, "m", where="travel")
        self._laboratory = Laboratory(axle_of(rig, asked.axle or None), travel, steer)
        self._done: dict[Any, xr.Dataset | JounceError] = {}
        self._poses: dict[Any, Poses] = {}
        self._rows: dict[Any, list[OverviewRow]] = {}
        self._centres: xr.Dataset | None = None
        is_steered = self._laboratory.axle.steered
        self.names = [name for name, test in TESTS.items() if is_steered or test.kind != "rack"]

    def test(self, name: str, asked: Question) -> xr.Dataset | JounceError:
        """Return a test, or why it has no result."""
        from jounce.kc.laboratory import run_test
        from jounce.kc.overview import with_derived
        from jounce.kc.tests import TESTS

        key = self._key(name, asked)
        if key not in self._done:
            end = asked.to.get(name) or None
            try:
                run, self._poses[key] = run_test(
                    self._laboratory, TESTS[name], end, held=asked.held, handwheel=asked.handwheel
                )
                self._done[key] = with_derived(run)
            except JounceError as error:
                self._done[key] = error
        return self._done[key]

    def poses(self, name: str, asked: Question) -> Poses:
        """Return the poses of a completed test."""
        return self._poses[self._key(name, asked)]

    def completed(self, asked: Question) -> dict[str, xr.Dataset]:
        """Return the tests that have results."""
        done = {name: self._done.get(self._key(name, asked)) for name in self.names}
        return {
            name: run
            for name, run in done.items()
            if run is not None and not isinstance(run, JounceError)
        }

    def failed(self, asked: Question) -> dict[str, JounceError]:
        """Return the tests that failed."""
        done = {name: self._done.get(self._key(name, asked)) for name in self.names}
        return {name: run for name, run in done.items() if isinstance(run, JounceError)}

    def missing(self, asked: Question) -> list[str]:
        """Return the tests that were not run yet."""
        return [name for name in self.names if self._key(name, asked) not in self._done]

    def rows(self, asked: Question) -> list[OverviewRow]:
        """Return the rows of the overview of all completed tests."""
        from jounce.kc.centres import centres_of
        from jounce.kc.overview import kc_overview

        rows: list[OverviewRow] = []
        for name, run in self.completed(asked).items():
            within = asked.within.get(name, "")
            key = (*self._key(name, asked), within)
            if key not in self._rows:
                if self._centres is None:
                    self._centres = centres_of(self._laboratory)
                main = run[[each for each in run.data_vars if _is_main(str(each))]]
                ranges = {name: within} if within else None
                self._rows[key] = list(kc_overview({name: main}, self._centres, within=ranges))
            rows += self._rows[key]
        return rows

    @staticmethod
    def _key(name: str, asked: Question) -> tuple[str, ...]:
        return name, asked.to.get(name, ""), asked.held, asked.handwheel


_BENCHES: Recent[Bench] = Recent(4)
_SHEETS: Recent[KcSheet] = Recent(2)


def run_tests(project: Project, asked: Question) -> CurvesAnswer:
    """Run the open test and, within limits of time, the others; return curves, overview and equivalent code."""
    from jounce.kc.tests import TESTS

    for where, given in (
        ("test", [asked.test]),
        ("to", [*asked.to]),
        ("within", [*asked.within]),
    ):
        for name in given:
            if name not in TESTS:
                raise unknown(name, TESTS, what="test", where=where)
    rigs = variants(project, asked.rig, asked.changes, asked.text)
    sheet = _measured(project, asked)
    with ONE:
        benches = {label: _bench(rig, asked) for label, rig in rigs.items()}
        now = next(iter(benches.values()))
        name = asked.test if asked.test in now.names else now.names[0]
        runs = {label: bench.test(name, asked) for label, bench in benches.items()}
        if asked.overview:
            _run_others(benches, asked)
        rows = _rows([bench.rows(asked) for bench in benches.values()]) if asked.overview else None
        compared = _compared(now, sheet, asked) if asked.overview else None
        axle = _posed(runs["as it is"], now, name, asked)
    good = {label: run for label, run in runs.items() if not isinstance(run, JounceError)}
    first = runs[next(iter(runs))]
    own = sheet.get(name)
    viewer = _viewer(name, good, own, asked, axle) if good else None
    judged = _judged(name, runs["as it is"], own)
    more = {
        "digest": digest_of(rigs["as it is"]),
        "differences": differences_of(rigs),
        "test": name,
        "tests": now.names,
        "is_steered": "steer" in now.names,
        "missing": sum(len(bench.missing(asked)) for bench in benches.values()),
        "overview": rows,
        "failed": {name: _plain(error) for name, error in now.failed(asked).items()},
        "findings": []
        if isinstance(first, JounceError)
        else with_german(to_plain(findings_of(first.attrs))),
        "bands": [] if viewer is None or judged is None else list(_bands(viewer, judged)),
        "compared": None if compared is None else _verdicts(compared),
        "measured": sorted(sheet),
        "remarks": _remarks(project, [*getattr(sheet, "findings", ()), *_findings_of(compared)]),
    }
    return CurvesAnswer(viewer, more | _ways(asked))


def _bench(rig: Rig, asked: Question) -> Bench:
    key = f"{asked.axle} {asked.travel} {asked.steer} {key_of(rig)}"
    return _BENCHES.of(key, partial(Bench, rig, asked))


def _run_others(benches: Mapping[str, Bench], asked: Question) -> None:
    """Run missing tests until the patience of a page is over, at least one."""
    end = time.perf_counter() + _PATIENCE
    for bench in benches.values():
        for name in bench.missing(asked):
            bench.test(name, asked)
            if time.perf_counter() > end:
                return


def _plain(error: JounceError) -> dict[str, str | None]:
    return {"text": str(error), "german": error.message().german()}


# curves ---------------------------------------------------------------------------------------------------------------


def _is_main(name: str) -> bool:
    """Whether a quantity is one of a wheel or of the axle, not of a spring, link or bushing."""
    side, _, rest = name.partition(".")
    return "." not in (rest if side in ("left", "right") else name)


def _viewer(
    test: str,
    runs: Mapping[str, xr.Dataset],
    measured: xr.Dataset | None,
    asked: Question,
    axle: PosedRig | None,
) -> Viewer:
    """Return the curves of a test over its input: both wheels, and both branches of loops that open."""
    from jounce.kc.compared import same_inputs
    from jounce.report.live import Motion, Viewer, ViewerScene

    first = next(iter(runs.values()))
    states = ["now", *(["saved"] if len(runs) > 1 else [])]
    beside = dict(zip(states, runs.values(), strict=True))
    sweeps = {state: np.asarray(run["input"].values) for state, run in beside.items()}
    coordinate = first["input"]
    if measured is not None:
        own = {state: same_inputs(run, measured) for state, run in beside.items()}
        for state, pair in own.items():
            if pair is not None:
                sweeps[state], sweeps["measured"] = pair
        if "measured" in sweeps:
            beside, coordinate = {**beside, "measured": measured}, measured["input"]
    x = np.unique(np.concatenate([_grid(sweep) for sweep in sweeps.values()]))
    unit = display_unit(str(coordinate.attrs["units"]), float(np.abs(x).max()))
    panes = tuple(_panes(beside, sweeps, x, loads=asked.loads))
    used = {curve.role for pane in panes for curve in pane.curves}
    roles = tuple(
        (role, f"{side}{_STATES[state]}", True)
        for (state, side), role in _ROLES.items()
        if role in used
    )
    words = first["input"].attrs["long_name"]
    motion = None
    if axle is not None:
        over, ground = axle.poses.over, np.interp(x, axle.poses.over, axle.poses.ground)
        still = np.zeros_like(x)
        motion = Motion(axle, still, np.clip(x, over[0], over[-1]), ground, np.ones_like(x))
    scene = ViewerScene(test, test, x * unit.factor, panes, motion=motion)
    return Viewer(test, (scene,), roles, words=str(words), unit=unit.name)


def _posed(
    run: xr.Dataset | JounceError, bench: Bench, name: str, asked: Question
) -> PosedRig | None:
    """Return both sides of the axle over the input of a test."""
    if isinstance(run, JounceError):
        return None
    from jounce.plots.mechanisms.axle import sides_on_rig
    from jounce.report.live import PosedRig

    inputs = run["input"]
    words, unit = str(inputs.attrs["long_name"]), str(inputs.attrs["units"])
    sides = sides_on_rig(bench.poses(name, asked), np.asarray(inputs.values), words, unit)
    posed: PosedRig | None = None
    for scene, poses in reversed(sides):
        posed = PosedRig(scene, poses, rolls=False, other=posed)
    return posed


_STATES = {"now": "", "saved": ", as saved", "measured": ", measured"}


def _grid(sweep: Array) -> Array:
    """Return the inputs at which curves are drawn: those of the samples, evenly spaced if there are many."""
    known = np.unique(np.round(sweep[np.isfinite(sweep)], 12))
    return known if known.size <= 101 else np.linspace(known[0], known[-1], 101)


def _panes(
    runs: Mapping[str, xr.Dataset], sweeps: Mapping[str, Array], x: Array, *, loads: bool
) -> Iterator[Pane]:
    """Yield the quantities that move, angles first; forces of links and bushings only with ``loads``."""
    from jounce.report.live import Pane, named_words

    first = runs["now"]
    names: dict[str, list[str]] = {}
    for each in map(str, first.data_vars):
        if loads or _is_main(each):
            side, _, rest = each.partition(".")
            names.setdefault(rest if side in ("left", "right") else each, []).append(each)
    order = {name: k for k, name in enumerate(_FIRST)}
    for name in sorted(names, key=lambda name: (not _is_main(name), order.get(name, len(order)))):
        data = [run.variables[each] for run in runs.values() for each in names[name] if each in run]
        si = str(data[0].attrs.get("units", "1"))
        ranges = [_range(np.asarray(part.values)) for part in data]
        if name not in _ALWAYS and max(ranges) < _STILL.get(si, 0.0):
            continue
        largest = max(float(np.nanmax(np.abs(part.values), initial=0.0)) for part in data)
        unit = display_unit(si, largest)
        curves = [
            curve
            for state, run in runs.items()
            for each in names[name]
            if each in run
            for curve in _curves(
                run.variables[each], (state, each), sweeps[state], x, si, unit.factor
            )
        ]
        offsets = _offsets(curves, x) if "measured" in runs else {}
        moved = tuple(_shifted(curve, offsets) for curve in curves)
        words = named_words(name, str(data[0].attrs.get("long_name", "")))
        yield Pane(name, words, unit.name, moved)


def _range(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if known.size else 0.0


def _curves(
    data: xr.Variable,
    of: tuple[str, str],
    sweep: Array,
    x: Array,
    si: str,
    factor: float,
) -> Iterator[Any]:
    """Yield the branches of a loop over its input, or their mean if they are one line."""
    from jounce.kc.loops import lines_of
    from jounce.plots.display import settle
    from jounce.report.live import Curve

    state, name = of
    side: Side = "right" if name.startswith("right.") else "left"
    whose = name.partition(".")[0] if name.startswith(("left.", "right.")) else "axle"
    known = np.isfinite(sweep)
    lines = lines_of(sweep[known], np.asarray(data.values, dtype=float)[known], x)
    is_open = lines.opening > _OPEN * max(_range(lines.mean), _STILL.get(si, 0.0))
    for values, way in (
        ((lines.up, ", rising"), (lines.down, ", falling")) if is_open else ((lines.mean, ""),)
    ):
        label = f"{whose}{_STATES[state]}{way}"
        yield Curve(label, _ROLES[state, side], settle(values, si) * factor)


def _offsets(curves: Sequence[Any], x: Array) -> dict[str, float]:
    """Return by how much measured curves are moved: by their distance from the model at zero input."""
    zero = int(np.argmin(np.abs(x)))
    offsets = {}
    for side in ("left", "right"):
        ours, theirs = (
            [curve.values[zero] for curve in curves if curve.role == _ROLES[state, side]]
            for state in ("now", "measured")
        )
        if ours and theirs:
            offset = float(np.mean(ours) - np.mean(theirs))
            offsets[_ROLES["measured", side]] = offset if np.isfinite(offset) else 0.0
    return offsets


def _shifted(curve: Any, offsets: Mapping[str, float]) -> Any:
    by = offsets.get(curve.role)
    return curve if by is None else replace(curve, values=curve.values + by)


# tables ---------------------------------------------------------------------------------------------------------------


def _rows(whole: Sequence[Sequence[OverviewRow]]) -> list[dict[str, Any]]:
    """Return rows as cells: values as the rig is now, and as it was saved if that differs."""
    from jounce.kc.overview import usual_text

    listed = []
    now, *others = whole
    before = {(row.test, row.name): row for other in others for row in other}
    for row in now:
        unit = row.usual()
        was = before.get((row.test, row.name))
        cells = {
            "test": row.test,
            "label": row.label,
            "positive": row.positive,
            "unit": unit.name,
            "now": [usual_text(value, unit) for value in row.values()],
            "was": [] if was is None else [usual_text(value, unit) for value in was.values()],
        }
        listed.append(cells)
    return listed


def _measured(project: Project, asked: Question) -> Mapping[str, xr.Dataset]:
    """Return the measured tests of files of the project."""
    if not asked.measured:
        return {}
    from jounce.kc.measured import read_kc

    files = [project.inside(path) for path in asked.measured]
    axle = asked.axle or None
    with only_below(project.root):
        return _SHEETS.of(
            (axle, *((file, state_of(file)) for file in files)),
            lambda: read_kc(files, axle=axle),
        )


def _compared(now: Bench, sheet: Mapping[str, xr.Dataset], asked: Question) -> xr.Dataset | None:
    """Compare what was run so far with what was measured."""
    if not sheet:
        return None
    from jounce.kc.compared import compare_kc

    done = {name: run for name, run in now.completed(asked).items() if name in sheet}
    return compare_kc(done, {name: sheet[name] for name in done}) if done else None


def _judged(
    name: str, run: xr.Dataset | JounceError, measured: xr.Dataset | None
) -> xr.Dataset | None:
    """Compare the open test with what was measured."""
    if measured is None or isinstance(run, JounceError):
        return None
    from jounce.kc.compared import compare_kc

    return compare_kc({name: run}, {name: measured})


def _bands(viewer: Viewer, compared: xr.Dataset) -> Iterator[dict[str, Any]]:
    """Yield the tolerances about measured curves in the units of their panes, with verdicts."""
    from jounce.kc.vocabulary import quantity_name

    scene = viewer.scenes[0]
    panes = {pane.name: pane for pane in scene.panes}
    for row in _each_row(compared):
        name, verdict = str(row["quantity"]), str(row["verdict"])
        pane = panes.get(quantity_name(name))
        if pane is None or verdict == "not judged":
            continue
        side: Side = "right" if name.startswith("right.") else "left"
        role = _ROLES["measured", side]
        lines = [curve.values for curve in pane.curves if curve.role == role]
        along = 1.0 / to_si(f"1 {viewer.unit}", str(row["input_unit"]))
        low, high = (float(row[end]) * along for end in ("low", "high"))
        margin = 1e-6 * (high - low)
        at = np.flatnonzero((scene.x >= low - margin) & (scene.x <= high + margin))
        middle = np.mean(lines, axis=0)[at]
        up = float(row["tolerance"]) / to_si(f"1 {pane.unit}", str(row["unit"]))
        leaves = float(row["leaves_at"]) * along
        yield {
            "quantity": pane.name,
            "at": scene.x[at].tolist(),
            "low": _numbers(middle - up),
            "high": _numbers(middle + up),
            "measured": {
                "role": role,
                "model": _ROLES["now", side],
                "side": side if name != pane.name else "",
                "verdict": verdict,
                "leaves": leaves if np.isfinite(leaves) else None,
            },
        }


def _each_row(compared: xr.Dataset) -> Iterator[dict[str, Any]]:
    columns = {str(name): compared.variables[name].values for name in compared.variables}
    for cells in zip(*columns.values(), strict=True):
        yield dict(zip(columns, cells, strict=True))


def _numbers(values: Array) -> list[float | None]:
    return [float(value) if np.isfinite(value) else None for value in values]


def _remarks(project: Project, findings: Sequence[Finding]) -> Any:
    """Return findings with the names of files relative to the project."""
    here = f"{project.root}/"
    own = [replace(item, place=item.place.replace(here, "")) for item in findings]
    return with_german(to_plain(own))


def _findings_of(compared: xr.Dataset | None) -> Sequence[Any]:
    return () if compared is None else findings_of(compared.attrs)


def _verdicts(compared: xr.Dataset) -> list[dict[str, Any]]:
    """Return the rows of a comparison as cells in usual units."""
    from jounce.kc.overview import usual_text, usual_unit
    from jounce.kc.tests import TESTS

    listed = []
    for row in _each_row(compared):
        test, si, over = (str(row[name]) for name in ("test", "unit", "input_unit"))
        own, at = usual_unit(si), usual_unit(over)
        slope = usual_unit(si, over, per_mm=TESTS[test].kind == "rack" or si == "N")
        number = {
            name: usual_text(float(row[name]), unit)
            for name, unit in (
                ("slope_simulated", slope), ("slope_measured", slope), ("difference", own),
                ("tolerance", own), ("leaves_at", at), ("offset", own),
            )
        }  # fmt: skip
        listed.append(
            {
                "test": test,
                "quantity": str(row["quantity"]),
                "slope_unit": slope.name,
                "unit": own.name,
                "input_unit": at.name,
                "verdict": str(row["verdict"]),
                **number,
            }
        )
    return listed


def _ways(asked: Question) -> dict[str, Any]:
    given = {
        "to": {name: value for name, value in asked.to.items() if value},
        "within": {name: value for name, value in asked.within.items() if value},
        "travel": asked.travel,
        "steer": asked.steer,
        "held": asked.held if asked.held != "load" else "",
        "handwheel": asked.handwheel if asked.handwheel != "locked" else "",
        "on": asked.axle,
        "measured": list(asked.measured),
    }
    request = Request(
        operations()["kc"],
        {
            "rig": word(asked.rig),
            "set": asked.changes,
            **{name: value for name, value in given.items() if value},
        },
    )
    python = f"import jounce as jn\n\nsheet = {request.expression()}\n"
    command = command_line(["jounce", *request.words(), "--out", "sheet"])
    return {"python": python, "command": command, "files": {}}
