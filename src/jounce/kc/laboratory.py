"""Tests on the K&C rig: the body held, pads under the wheels moved or loaded, equilibrium at every sample."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np

from jounce.axles.builder import SIDES
from jounce.axles.dependent import build_axle
from jounce.core.datasets import dataset
from jounce.core.errors import DescriptionError, SimulationError, show_value, unknown
from jounce.core.findings import Finding, finding, finding_attributes
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kc.quantities import Poses, quantities, table_deflections
from jounce.kc.tests import TESTS, KCTest
from jounce.kernel import equilibrium as eq
from jounce.kinematics.model import check_corner
from jounce.parts import Corner, FullCar3D, Rig
from jounce.parts.axles import DependentAxle

if TYPE_CHECKING:
    import xarray as xr

_APPROACH = 5e-3  # m: step of pads and rack on the way to the state of a test
_FEWEST, _MOST = 5, 100_001  # samples of a loop
_TILTED = 0.09  # rad: tilt of an anti-roll bar's halves from which its law is not exact
_BEYOND = 1e-9  # of a table's range: rounding
_NO_SEEDS = eq.Seeds(np.zeros((0, 2), dtype=np.int64), np.zeros((0, eq.WIDTH)))
Held = Literal["load", "height"]
Handwheel = Literal["locked", "free"]
HELD: tuple[str, ...] = get_args(Held)
HANDWHEEL: tuple[str, ...] = get_args(Handwheel)


@dataclass(frozen=True)
class State:
    """The axle before a test: pose, multipliers and slipped deflections, and each control's value and force."""

    start: tuple[Array, Array, Array]
    heights: Array
    rack: float
    forces: Array


class Laboratory:
    """An axle ready for tests: its arrays, and the state in which a test begins."""

    def __init__(
        self, rig: Corner | DependentAxle, travel: float = 0.0, rack: float | None = None
    ) -> None:
        self.rig = rig
        self.axle = build_axle(rig)
        self.arrays, self.multipliers = self.axle.assembly.arrays()
        self.bodies = len(self.axle.assembly.bodies)
        self.controls = [name for name, *_ in self.axle.assembly.controls]
        self.design = np.array([_lowest(row) for row in self.arrays.wheels])
        steering = getattr(rig, "steering", None)
        rack = getattr(steering, "rack_travel", 0.0) if rack is None else rack
        if rack and not self.axle.steered:
            raise DescriptionError(
                "this axle has no rack", where="steer", found=Phrase(f"{rack:g} m")
            )
        self.state = self._approach(travel, rack)

    @property
    def track(self) -> float:
        """Distance of the contact points at design, m."""
        left, right = self.axle.assembly.wheels
        return float(left.centre[1, 0].real - right.centre[1, 0].real)

    def approach(self, travel: Array, rack: float) -> eq.Path:
        """Return the path of pads and rack from the design position to where tests begin."""
        steps = 1 + int(np.ceil(max(float(np.abs(travel).max()), abs(rack)) / _APPROACH))
        share = np.linspace(0.0, 1.0, steps) if steps > 1 else np.ones(1)
        targets = np.zeros((steps, len(self.controls)))
        for k, name in enumerate(self.controls):
            if name == "rack":
                targets[:, k] = share * rack
            else:
                wheel = self._wheel(name)
                targets[:, k] = self.design[wheel] + share * travel[wheel]
        return eq.Path(*self._prescribed(steps), targets, self._no_loads(steps))

    def at_design(self) -> tuple[Array, Array, Array]:
        """Return pose, multipliers and slipped deflections at design: friction along a line carries nothing there."""
        pose = np.zeros((self.bodies, 12))
        pose[:, 3] = pose[:, 7] = pose[:, 11] = 1.0
        slipped = np.zeros((len(self.arrays.kinds), 6))
        reach = self.arrays.data[:, eq.Q : eq.Q + 3] - self.arrays.data[:, eq.P : eq.P + 3]
        lines = self.arrays.kinds[:, 0] == eq.LINE
        slipped[lines, 0] = np.sqrt((reach[lines] ** 2).sum(axis=1))
        return pose, np.zeros(self.multipliers + len(self.controls)), slipped

    def _approach(self, travel: float, rack: float) -> State:
        """Move pads and rack from the design position to where tests begin."""
        path = self.approach(np.full(len(SIDES), travel), rack)
        settled, space = self._follow(*path, self.at_design())
        if settled.outcome[-1] != eq.SETTLED:
            raise self._failure("the body at ride height")
        values = path.targets[-1]
        start = self._reached(space)
        heights = np.array([values[self.controls.index(f"{side}.contact")] for side in SIDES])
        return State(start, heights, rack, settled.multipliers[-1, self.multipliers :])

    def _reached(self, space: eq.Space) -> tuple[Array, Array, Array]:
        """Return pose, multipliers and slipped deflections at the end of a path."""
        n = self.bodies
        return space.pose[n : 2 * n].copy(), space.multipliers[1].copy(), space.slipped.copy()

    @property
    def has_friction(self) -> bool:
        """Whether any part of the axle has dry friction."""
        kinds, data = self.arrays.kinds[:, 0], self.arrays.data
        held = data[kinds == eq.BUSHING, eq.B : eq.B + 6], data[kinds == eq.LINE, eq.HOLD]
        return any(bool((part > 0.0).any()) for part in held)

    # paths -----------------------------------------------------------------------------------------------------------

    def names(self, tests: Sequence[str] | None) -> list[str]:
        """Return the names of tests, all that the axle can do by default; refuse unknown ones."""
        for name in tests or ():
            if name not in TESTS:
                raise unknown(name, TESTS, what="test", where="tests")
        if tests is not None:
            return list(tests)
        return [name for name, test in TESTS.items() if self.axle.steered or test.kind != "rack"]

    def inputs(self, test: KCTest, to: float | str | None, points: int) -> Array:
        """Return the inputs of a test, SI: from zero to the end of its range, to its opposite, and back."""
        if test.kind == "rack" and not self.axle.steered:
            raise DescriptionError(
                "this axle has no rack, so it cannot be steered",
                where=test.name,
                allowed="an axle with a tie rod or toe link",
            )
        end = test.range if to is None else to_si(to, test.unit, where="to")
        if end == 0.0:
            raise DescriptionError(
                "a test without a range", where="to", found=Phrase("0"), allowed="any other end"
            )
        if not _FEWEST <= points <= _MOST or points % 4 != 1:
            raise DescriptionError(
                "not a number of samples of a loop, whose four quarters are equal",
                where="points",
                found=Phrase(str(points)),
                allowed=Phrase(
                    "{fewest} to {most} in steps of 4: 5, 9, 13, ... 41", fewest=_FEWEST, most=_MOST
                ),
            )
        return loop(end, points, one_sided=test.one_sided)

    def _check_settings(self, held: str, handwheel: str) -> None:
        for given, known, where in ((held, HELD, "held"), (handwheel, HANDWHEEL, "handwheel")):
            if given not in known:
                raise unknown(given, known, what="setting", where=where)
        if handwheel == "free" and getattr(self.rig, "steering", None) is None:
            raise DescriptionError(
                "this axle has no handwheel",
                where="handwheel",
                found=handwheel,
                allowed="locked, or a description with a table [steering]",
            )

    def _wheel(self, control: str) -> int:
        return SIDES.index(control.split(".", maxsplit=1)[0])

    def _prescribed(self, steps: int) -> tuple[Array, Array]:
        """Mixtures that prescribe the value of every control."""
        n = len(self.controls)
        return np.tile(np.eye(n).ravel(), (steps, 1)), np.zeros((steps, n * n))

    def _no_loads(self, steps: int) -> Array:
        return np.zeros((steps, len(SIDES) * eq.LOADS))

    def path(
        self, test: KCTest, inputs: Array, held: Held, handwheel: Handwheel, trail: float
    ) -> eq.Path:
        """Return mixtures, targets and loads of a test at its inputs."""
        self._check_settings(held, handwheel)
        steps, n = len(inputs), len(self.controls)
        values, forces = (part.reshape(steps, n, n) for part in self._prescribed(steps))
        values, forces = values.copy(), forces.copy()
        targets, loads = np.zeros((steps, n)), self._no_loads(steps).reshape(steps, len(SIDES), -1)
        at = [self.controls.index(f"{side}.contact") for side in SIDES]
        targets[:, at] = self.state.heights
        if self.axle.steered:
            rack = self.controls.index("rack")
            targets[:, rack] = self.state.rack
            if handwheel == "free" and test.kind != "rack":
                values[:, rack, rack], forces[:, rack, rack] = 0.0, 1.0
                targets[:, rack] = self.state.forces[rack]
        if test.kind == "heights":
            targets[:, at] += inputs[:, None]
        elif test.kind == "roll":
            left, right = at
            values[:, left, right] = -1.0
            targets[:, left] = self.state.heights[0] - self.state.heights[1]
            targets[:, left] += np.tan(inputs) * self.track
            values[:, right, right], forces[:, right, left], forces[:, right, right] = 0.0, 1.0, 1.0
            targets[:, right] = self.state.forces[at].sum()
        elif held == "load":
            for k in at:
                values[:, k, k], forces[:, k, k] = 0.0, 1.0
                targets[:, k] = self.state.forces[k]
        if test.kind == "rack":
            targets[:, self.controls.index("rack")] += inputs
        for side, share in enumerate(test.shares):
            load = test.direction * share * inputs
            if test.kind == "lateral":
                loads[:, side, 1], loads[:, side, 6] = load, trail
            elif test.kind == "aligning":
                loads[:, side, 2] = load
            elif test.kind == "longitudinal":
                loads[:, side, 0 if test.through == "contact_point" else 3] = load
        return eq.Path(
            values.reshape(steps, -1), forces.reshape(steps, -1), targets, loads.reshape(steps, -1)
        )

    def _follow(
        self,
        values: Array,
        forces: Array,
        targets: Array,
        loads: Array,
        start: tuple[Array, Array, Array] | None,
    ) -> tuple[eq.Settled, eq.Space]:
        path = eq.Path(values, forces, targets, loads)
        return eq.settle(self.arrays, path, _NO_SEEDS, self.bodies, self.multipliers, 0, start)

    def run(
        self, test: KCTest, inputs: Array, held: Held, handwheel: Handwheel, trail: float
    ) -> tuple[Poses, list[Finding]]:
        """Run a test; return its poses and findings.

        With friction the first loop starts in the middle, where nothing has slipped; as in a laboratory, the second one
        is kept, which closes to within some thousandths of its range.
        """
        path = self.path(test, inputs, held, handwheel, trail)
        settled, space = self._follow(*path, self.state.start)
        if self.has_friction and (settled.outcome == eq.SETTLED).all():
            settled, _ = self._follow(*path, self._reached(space))
        tilt = self.axle.bar_tilt
        findings = [finding("kc.bar_tilted", "anti_roll_bar", tilt, angle=tilt)]
        findings = findings if tilt > _TILTED else []
        reached = settled.outcome == eq.SETTLED
        if not reached.all():
            if reached.sum() < 2:
                raise self._failure(f"the test {test.name}")
            last = inputs[reached][-1]
            findings.append(
                finding("kc.no_equilibrium_beyond", test.name, last, last=f"{last:.4g} {test.unit}")
            )
        poses = Poses(self.axle, settled, path)
        return poses, [*findings, *self._pulling(test, poses), *_beyond_tables(poses)]

    def _pulling(self, test: KCTest, poses: Poses) -> Iterator[Finding]:
        """Yield a finding for each wheel that its pad would have to hold down."""
        for side in SIDES:
            least = float(np.nanmin(poses.control_force(f"{side}.contact")))
            if least < 0.0:
                yield finding("kc.pad_pulls", test.name, least, wheel=side, force=f"{-least:.4g}")

    def _failure(self, what: str) -> SimulationError:
        """Return the error for a state without equilibrium; it names a motion that nothing holds."""
        loose = self._loose()
        if loose:
            return SimulationError(
                Phrase("a motion of the axle is not held: {motion}", motion=loose),
                where="bushings",
                hint="Give its bushings stiffness in all directions that the joint held.",
            )
        return SimulationError(
            Phrase("no equilibrium was found for {what}", what=what),
            where="axle",
            hint="Check springs, stops and bushings, or move less far.",
        )

    def _loose(self) -> str:
        """Return the largest motion at design that nothing holds, all forces being zero, or nothing."""
        data = self.arrays.data.copy()
        for row, element in zip(data, self.axle.assembly.elements, strict=True):
            if element.kind == eq.LINE:
                reach = row[eq.Q : eq.Q + 3] - row[eq.P : eq.P + 3]
                row[eq.LENGTH], row[eq.PRELOAD] = np.sqrt(reach @ reach), 0.0
            elif element.kind == eq.BUSHING:
                row[eq.F : eq.F + 6] = 0.0
            elif element.kind == eq.TWIST:
                row[eq.PRELOAD] = 0.0
        targets = np.zeros((1, len(self.controls)))
        targets[0, [self.controls.index(f"{side}.contact") for side in SIDES]] = self.design
        path = eq.Path(*self._prescribed(1), targets, self._no_loads(1))
        arrays = self.arrays._replace(data=data)
        settled, space = eq.settle(arrays, path, _NO_SEEDS, self.bodies, self.multipliers, 0)
        if settled.outcome[0] != eq.SINGULAR:
            return ""
        rows = 1.0 / np.maximum(np.abs(space.matrix).max(axis=1), 1e-300)
        scaled = space.matrix * rows[:, None]
        columns = 1.0 / np.maximum(np.abs(scaled).max(axis=0), 1e-300)
        motion = np.abs(np.linalg.svd(scaled * columns)[2][-1] * columns)[: 6 * self.bodies]
        return str(self.axle.assembly.names()[int(np.argmax(motion))])


def _beyond_tables(poses: Poses) -> Iterator[Finding]:
    """Yield a finding for each part that leaves the range of its table, which goes on straight there."""
    for element, k, moves in table_deflections(poses):
        law = element.laws[k]
        assert law is not None
        low, high = law.numbers[0], law.numbers[law.count - 1]
        for end, value, sign in ((low, np.nanmin(moves), -1.0), (high, np.nanmax(moves), 1.0)):
            if sign * value > sign * end + _BEYOND * (high - low):
                path = element.name.partition(".")[2] if "." in element.name else element.name
                unit = "rad" if k > 2 else "m"
                yield finding(
                    "kc.beyond_table",
                    path,
                    float(value),
                    at=f"{value:.4g} {unit}",
                    end=f"{end:.4g} {unit}",
                )


def _lowest(wheel: Array) -> float:
    return float(wheel[2] - wheel[6] * np.sqrt(1.0 - wheel[5] ** 2))


def axle_of(axle: Rig, which: str | None) -> Corner | DependentAxle:
    """Return what describes an axle: a corner, a dependent axle, or an axle of a car."""
    if which not in (None, "front", "rear"):
        raise DescriptionError(
            "unknown axle", where="on", found=show_value(which), allowed="front, rear"
        )
    if isinstance(axle, DependentAxle):
        return axle
    if isinstance(axle, FullCar3D):
        if which is None:
            raise DescriptionError(
                "which axle of the car is to be tested?",
                where="axle",
                found=Phrase(str(which)),
                allowed="front, rear",
            )
        return (axle.front if which == "front" else axle.rear).suspension
    return check_corner(axle)


def loop(end: float, points: int, *, one_sided: bool) -> Array:
    """Return inputs from zero to the end of the range and back, through its opposite unless it is one-sided."""
    if one_sided:
        half = points // 2
        up = end * np.arange(half + 1) / half
        return np.concatenate([up, up[:-1][::-1]])
    quarter = (points - 1) // 4
    ahead = end * np.arange(quarter + 1) / quarter
    return np.concatenate([ahead, ahead[:-1][::-1], -ahead[1:], -ahead[:-1][::-1]])


def kc_test(
    axle: Rig,
    test: str,
    *,
    to: float | str | None = None,
    points: int = 41,
    travel: float | str = 0.0,
    steer: float | str | None = None,
    held: Held = "load",
    handwheel: Handwheel = "locked",
    trail: float | str | None = None,
    on: Literal["front", "rear"] | None = None,
) -> xr.Dataset:
    """Run a test of a kinematics-and-compliance laboratory on an axle: the body held, its pads moved or loaded.

    The axle is a corner and its mirror image, with all bushings, mounts and springs of the description. Each sample is
    an exact static equilibrium with large motions; the input runs from zero to the end of the range, to its opposite
    and back. Dry friction opens the curves to loops; the loop is then run twice, and the second is kept, which closes
    to within some thousandths of its range.

    Parameters
    ----------
    axle : Rig
        A corner with hardpoints, or a 3-D car.
    test : str
        A name of ``jounce.kc.TESTS``: ``"bounce"``, ``"roll"``, ``"steer"``, ``"lateral-in-phase"``,
        ``"lateral-opposed"``, ``"braking"``, ``"aligning-opposed"``, ...
    to : float or str, optional
        End of the range (m, rad, N or N m, or with a unit); by default the usual one of the test.
    points : int
        Number of samples of the loop: 4 k + 1, so that its quarters are equal.
    travel : float or str
        Height of both pads above the design position before the test, m.
    steer : float or str, optional
        Rack travel before the test, m, to the left; by default that of the description.
    held : {"load", "height"}
        What tests with horizontal forces and moments keep: each wheel's vertical load, or the height of its pad.
    handwheel : {"locked", "free"}
        Whether the handwheel holds the rack.
    trail : float or str, optional
        Distance behind the contact point, along the wheel's heading, at which lateral forces act, m; by default that
        of the test.
    on : {"front", "rear"}, optional
        Axle of a car.

    Returns
    -------
    xarray.Dataset
        On ``sample``, with ``input`` (SI): for ``left.`` and ``right.`` the angles toe, camber, steer and spin (rad),
        displacements of wheel centre and contact point (m), forces of road, springs, links and bushings (N, N m), and
        for the axle rack travel and force. ISO 8855 axes: x forward, y left, z up. Not a number where there is no
        equilibrium.

    Raises
    ------
    DescriptionError
        If the test is unknown, or the axle cannot do it.
    SimulationError
        If there is no equilibrium at ride height, or a motion that nothing holds.

    Examples
    --------
    >>> import jounce as jn
    >>> sheet = jn.kc_test(jn.load("generic-mcpherson"), "bounce", to="40 mm")
    >>> bool(sheet["left.camber"].max() > sheet["left.camber"].min())
    True
    """
    return kc_tests(
        axle, (test,), to=to, points=points, travel=travel, steer=steer, held=held, handwheel=handwheel,
        trail=trail, on=on,
    )[test]  # fmt: skip


def run_test(
    laboratory: Laboratory,
    test: KCTest,
    to: float | str | None = None,
    points: int = 41,
    held: Held = "load",
    handwheel: Handwheel = "locked",
    trail: float | str | None = None,
) -> tuple[xr.Dataset, Poses]:
    """Run a test in a laboratory; return its rows, and the poses of all bodies."""
    inputs = laboratory.inputs(test, to, points)
    behind = test.trail if trail is None else to_si(trail, "m", where="trail")
    poses, findings = laboratory.run(test, inputs, held, handwheel, behind)
    variables = quantities(poses)
    findings += _steers_opposite(test, inputs, variables)
    label = {"units": test.unit, "long_name": test.what, "positive": test.positive}
    import xarray as xr

    axes = xr.Dataset(coords={"input": ("sample", inputs, label)})
    attributes = {
        "test": test.name,
        "model": str(getattr(laboratory.rig, "model", "")),
        "held": held,
        "handwheel": handwheel,
        "track": laboratory.track,
        **finding_attributes(findings),
        "convention": "ISO 8855 axes: x forward, y left, z up; toe-in and top outward positive",
    }
    return dataset(variables, axes, attributes), poses


def _steers_opposite(
    test: KCTest, inputs: Array, variables: Mapping[str, xr.Variable]
) -> Iterator[Finding]:
    """Yield a finding if the wheels steer to the right when the handwheel turns to the left."""
    if test.kind == "rack" and "handwheel_angle" in variables:
        last = int(np.argmax(inputs))
        wheels = sum(float(variables[f"{side}.steer"].values[last]) for side in SIDES)
        if float(variables["handwheel_angle"].values[last]) * wheels < 0.0:
            yield finding("kc.steers_opposite", "steering.rack_ratio")


def kc_tests(
    axle: Rig,
    tests: Sequence[str] | None = None,
    *,
    to: float | str | None = None,
    points: int = 41,
    travel: float | str = 0.0,
    steer: float | str | None = None,
    held: Held = "load",
    handwheel: Handwheel = "locked",
    trail: float | str | None = None,
    on: Literal["front", "rear"] | None = None,
) -> dict[str, xr.Dataset]:
    """Run all tests of a sheet that the axle can do, or those given.

    Parameters
    ----------
    axle : Rig
        A corner with hardpoints, a dependent axle, or a 3-D car.
    tests : sequence of str, optional
        Tests by name; all by default.
    to : float or str, optional
        End of the range of every test, as for `kc_test` (SI or with a unit that suits all).
    points, held, handwheel, on
        As for `kc_test`.
    travel, steer, trail : float or str
        Height of both pads and rack travel before the tests, and trail of lateral forces, m.

    Returns
    -------
    dict of str to xarray.Dataset
        Tests by name, SI.

    Raises
    ------
    DescriptionError
        If a test is unknown, or the axle cannot do it.
    SimulationError
        If there is no equilibrium.

    Examples
    --------
    >>> import jounce as jn
    >>> list(jn.kc_tests(jn.load("semi-trailing-arm"), ("bounce", "braking")))
    ['bounce', 'braking']
    """
    rack = None if steer is None else to_si(steer, "m", where="steer")
    laboratory = Laboratory(axle_of(axle, on), to_si(travel, "m", where="travel"), rack)
    return {
        name: run_test(laboratory, TESTS[name], to, points, held, handwheel, trail)[0]
        for name in laboratory.names(tests)
    }
