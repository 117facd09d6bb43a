"""Effective roads for a tyre of finite size: the equivalent height for a point follower.

Moving average, rolling circle, and rolling elliptical cams, as closed-form pieces.
"""

from __future__ import annotations

import hashlib
import math
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import model_validator

from jounce.core.errors import DescriptionError
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments
from jounce.core.types import Array
from jounce.core.units import Length, PositiveLength, PositiveNumber
from jounce.roads.profile import Profile, hermite_pieces, lay_out
from jounce.roads.road import RoadOf

_NEEDED = {
    "moving-average": ("contact_length",),
    "rigid-circle": ("radius",),
    "tandem-cam": ("radius", "contact_length"),
}


class Enveloped(RoadOf):
    """Effective height of the road ``of`` under a tyre of finite size.

    ``start`` and ``recurrence`` are those of ``of``. The effective height extends beyond the obstacle by up to `reach`:
    a rigid circle of radius R starts to rise sqrt(2 R h - h^2) before a step of height h.

    Attributes
    ----------
    of : Road
        The original road.
    method : {"moving-average", "rigid-circle", "tandem-cam"}
        Mean over the contact length; height of the centre of a rigid circle rolling over the road, minus its radius;
        mean height of two elliptical cams in tandem.
    contact_length : float or None
        Length in m of the contact patch, for the mean and the distance of the cams; `contact_length` computes it from
        the load.
    radius : float or None
        Undeformed radius of the tyre in m, for the circle and the cams.
    cam_length, cam_height : float
        Half axes of a cam over the radius (1): 1.471 along the road, 0.9622 upwards.
    cam_exponent : float
        Exponent (1) of a cam's superellipse, 1.5174.
    cam_distance : float
        Distance of the cams over the contact length (1), 0.8335.
    step : float or None
        Maximum length in m of pieces without a closed form; by default a twentieth of the contact length for the mean,
        an eighth of the radius for circle and cams.
    tolerance : float
        Maximum error of the pieces in m, 1 micrometre by default; pieces with larger errors are split.

    Notes
    -----
    The mean is exact for roads of lines and parabolas. Otherwise the pieces are cubics with exact heights and slopes at
    both ends, split until their error is below ``tolerance``; kinks are detected and preserved. On a smooth road the
    error is proportional to the fourth power of ``step``. Cams: Schmeitz (key schmeitz-2004).

    Examples
    --------
    >>> from jounce.roads import Step
    >>> kerb = Enveloped(of=Step(height="0.1 m", start="2 m"), method="rigid-circle", radius="0.3 m")
    >>> kerb.height_at([1.7, 2.0, 5.0]).round(9).tolist()
    [0.0, 0.1, 0.1]
    >>> bool(kerb.segments(5.0).edges[1] - (2.0 - (2 * 0.3 * 0.1 - 0.1**2) ** 0.5) < 1e-9)
    True
    """

    kind: Literal["enveloped"] = "enveloped"
    start: Length = 0.0
    method: Literal["moving-average", "rigid-circle", "tandem-cam"]
    contact_length: PositiveLength | None = None
    radius: PositiveLength | None = None
    cam_length: PositiveNumber = 1.471
    cam_height: PositiveNumber = 0.9622
    cam_exponent: PositiveNumber = 1.5174
    cam_distance: PositiveNumber = 0.8335
    step: PositiveLength | None = None
    tolerance: PositiveLength = 1e-6

    def check(self) -> None:
        """Reject missing and superfluous fields; copy ``start`` and ``recurrence`` from the inner road."""
        for name in ("start", "recurrence"):
            if name in self.model_fields_set and getattr(self, name) != getattr(self.of, name):
                raise ValueError(
                    Phrase("{name} belongs to the inner road; write it in the table of", name=name)
                )
            object.__setattr__(self, name, getattr(self.of, name))
        needed = _NEEDED[self.method]
        for name in ("contact_length", "radius"):
            if (getattr(self, name) is None) == (name in needed):
                word = "needs" if name in needed else "does not use"
                raise ValueError(
                    Phrase(
                        "the method {method!r} {word} {name}",
                        method=self.method,
                        word=word,
                        name=name,
                    )
                )
        if self.cam_exponent <= 1.0:
            what = Phrase(
                "cam_exponent {exponent:g} produces a cam with sharp corners",
                exponent=self.cam_exponent,
            )
            raise error_at((), what, allowed=Phrase("above {bound:g}", bound=1.0))

    @model_validator(mode="after")
    def _check_fields(self) -> Self:
        self.check()
        return self  # the inner road has already checked the loop

    def reach(self) -> float:
        """Return the distance in m ahead of and behind the wheel centre within which the road has an effect."""
        if self.method == "moving-average":
            return 0.5 * _require(self.contact_length)
        cam = self._cam()
        return cam.a if self.method == "rigid-circle" else cam.a + 0.5 * self._cam_distance()

    def profile(self) -> Profile:
        """Effective height of one pass."""
        inner, reach = self.of.profile(), self.reach()
        low, high = float(inner.edges[0]) - reach, float(inner.edges[-1]) + reach
        road = lay_out(inner, [(0.0, 0.0)], low - reach, high + reach)
        felt = self._filter(road, low, high)[0]
        return Profile(felt.edges, felt.kind, felt.coefficients, inner.before, inner.after)

    def end(self) -> float:
        """Return the distance in m at which the tyre finally leaves the inner road."""
        return self.of.end() + self.reach()

    def effective_slope_at(self, x: ArrayLike) -> Array:
        """Return the effective slope (1) of the road under the tyre at the distances ``x`` in m, any shape.

        For tandem cams it is the difference of their heights divided by their distance, not the derivative of the
        effective height (`slope_at`); for the other methods both are equal.
        """
        if self.method != "tandem-cam":
            return self.slope_at(x)
        at = as_samples(x, "m", where="x", error=DescriptionError)
        low, high = float(at.min()) - 1.0, float(at.max()) + 1.0
        return self._window(low, high)[1].evaluate(at.ravel())[0].reshape(at.shape)

    def _between(self, low: float, high: float) -> Segments:
        return self._window(low, high)[0]

    def _window(self, low: float, high: float) -> tuple[Segments, Segments]:
        margin = 1.01 * self.reach()
        return self._filter(self.of._between(low - margin, high + margin), low, high)

    def _filter(self, road: Segments, low: float, high: float) -> tuple[Segments, Segments]:
        """Return effective height and slope from ``low`` to ``high``; the road must extend beyond by the reach."""
        method = (
            self.method,
            self.contact_length,
            self.radius,
            self.cam_length,
            self.cam_height,
            self.cam_exponent,
        )
        key = _digest(road, *method, self.cam_distance, self.step, self.tolerance, low, high)
        return _RESULTS.get(key, lambda: self._compute(road, low, high))

    def _compute(self, road: Segments, low: float, high: float) -> tuple[Segments, Segments]:
        if self.method == "moving-average":
            length = _require(self.contact_length)
            mean = average(
                road, 0.5 * length, (low, high), self.step or length / 20.0, self.tolerance
            )
            return mean, mean
        step = self.step or _require(self.radius) / 8.0
        if self.method == "rigid-circle":
            height = roll_cam(road, self._cam(), (low, high), step, self.tolerance)
            return height, height
        half = 0.5 * self._cam_distance()
        each = roll_cam(road, self._cam(), (low - half, high + half), step, self.tolerance)
        return combine(each, 2.0 * half, low, high)

    def _cam(self) -> Cam:
        radius = _require(self.radius)
        if self.method == "rigid-circle":
            return Cam(radius, radius)
        return Cam(self.cam_length * radius, self.cam_height * radius, self.cam_exponent)

    def _cam_distance(self) -> float:
        return self.cam_distance * _require(self.contact_length)


def contact_length(
    load: float, stiffness: float, radius: float, *, linear: float = 0.733, root: float = 0.671
) -> float:
    """Compute the length of a tyre's contact patch on a level road.

    Parameters
    ----------
    load : float
        Vertical force in N, above 0.
    stiffness : float
        Radial stiffness in N/m.
    radius : float
        Undeformed radius in m.
    linear, root : float
        Coefficients (1) of the relative deflection and of its square root.

    Returns
    -------
    float
        2 R0 (root sqrt(F / (c R0)) + linear F / (c R0)) in m.

    Examples
    --------
    >>> round(contact_length(4000.0, 200e3, 0.32), 4)
    0.1367
    """
    if min(load, stiffness, radius) <= 0.0:
        raise DescriptionError(
            "a loaded tyre needs positive values",
            found=f"{load} N, {stiffness} N/m, {radius} m",
            allowed="values above 0",
        )
    share = load / (stiffness * radius)
    return 2.0 * radius * (root * math.sqrt(share) + linear * share)


def _require(value: float | None) -> float:
    if value is None:
        raise AssertionError("a field that the method needs is missing")
    return value


def _digest(road: Segments, *values: object) -> bytes:
    digest = hashlib.blake2b(repr(values).encode())
    for array in (road.edges, road.kind, road.coefficients):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.digest()


class _Results:
    """Cache of recent results, because a run uses the same road several times."""

    def __init__(self, most: int) -> None:
        self.most = most
        self.results: OrderedDict[bytes, tuple[Segments, Segments]] = OrderedDict()

    def get(
        self, key: bytes, make: Callable[[], tuple[Segments, Segments]]
    ) -> tuple[Segments, Segments]:
        if key not in self.results:
            self.results[key] = make()
            while len(self.results) > self.most:
                self.results.popitem(last=False)
        self.results.move_to_end(key)
        return self.results[key]


_RESULTS = _Results(4)


Numbers = NDArray[np.int64]
_SHARES = (
    0.2928932188134524,
    0.7071067811865476,
)  # test points in a cubic: no wave is zero at both
SHORTEST = 1e-9  # m; borders closer than this are merged
_STEEPEST = 50.0  # slope (89 degrees) above which an edge is a wall
_GRADED = [side * 4.0**-k for k in (1, 2, 3) for side in (-1.0, 1.0)]
"""Shares of a step at which borders are added near a point of infinite curvature."""
_SHARP = 0.02  # jump of the contact point, relative to a, above which a border is an edge
_BENT = 0.03  # jump of curvature times a^2 that changes a cam's height by more than a micrometre
_PAIRS = 1_000_000  # nodes times pieces processed at once: 8 MB


@dataclass(frozen=True)
class Cam:
    """Lower half of a superellipse ``|u/a|^c + |w/b|^c = 1`` that rolls over the road without turning.

    Attributes
    ----------
    a, b : float
        Half axes along the road and upwards in m; a circle has both equal to its radius and ``c`` 2.
    c : float
        Exponent (1), above 1.
    """

    a: float
    b: float
    c: float = 2.0

    def drop(self, u: Array) -> Array:
        """Return minus the height (m) of the outline above its lowest point at the offsets ``u`` in m."""
        share = np.minimum(np.abs(u) / self.a, 1.0) ** self.c
        return np.asarray(self.b * ((1.0 - share) ** (1.0 / self.c) - 1.0))

    def slope(self, u: Array) -> Array:
        """Return the slope (1) of a road that touches the outline at the offsets ``u`` in m."""
        share = np.minimum(np.abs(u) / self.a, 1.0) ** self.c
        with np.errstate(divide="ignore"):
            ratio = share / (1.0 - share)
        return np.asarray(np.sign(u) * (self.b / self.a) * ratio ** (1.0 - 1.0 / self.c))

    def offset(self, slope: Array) -> Array:
        """Return the offset u in m at which a road of this slope (1) touches: the inverse of `slope`."""
        steep = np.minimum(np.abs(slope), 1e9)
        ratio = (steep * self.a / self.b) ** (self.c / (self.c - 1.0))
        return np.asarray(np.sign(slope) * self.a * (ratio / (1.0 + ratio)) ** (1.0 / self.c))


def average(
    road: Segments, half: float, window: tuple[float, float], step: float, tolerance: float
) -> Segments:
    """Compute the mean height over ``half`` metres to either side, over a window (m, m).

    Exact for roads of lines and parabolas. Otherwise the pieces are cubics of at most ``step`` metres with exact
    heights and slopes at their ends, split until their error is below ``tolerance`` (m).
    """
    upright = road.edges[:-1][road.kind == CIRCLE], road.edges[1:][road.kind == CIRCLE]
    near = [
        feet + by + step * share for feet in upright for by in (-half, half) for share in _GRADED
    ]
    borders = _borders([road.edges - half, road.edges + half, *near], *window)
    behind, ahead = _pieces(road, borders, -half), _pieces(road, borders, half)
    simple = (road.kind == POLYNOMIAL) & (road.coefficients[:, 3] == 0.0)
    borders = _subdivide(borders, np.where(simple[behind] & simple[ahead], np.inf, step))
    whole = np.concatenate(
        [[0.0], np.cumsum(_area(road, np.arange(len(road.kind)), road.edges[1:]))]
    )

    def mean(x: Array) -> tuple[Array, Array]:
        """Return height and slope at one point of each interval between borders."""
        area = (
            whole[ahead]
            - whole[behind]
            + _area(road, ahead, x + half)
            - _area(road, behind, x - half)
        )
        slope = road.on_pieces(ahead, x + half)[0] - road.on_pieces(behind, x - half)[0]
        return area / (2.0 * half), slope / (2.0 * half)

    while True:
        behind, ahead = _pieces(road, borders, -half), _pieces(road, borders, half)
        span, begin, end = np.diff(borders), mean(borders[:-1]), mean(borders[1:])
        errors = [
            _cubic(span, begin, end, share) - mean(borders[:-1] + share * span)[0]
            for share in _SHARES
        ]
        off = np.flatnonzero((np.max(np.abs(errors), axis=0) > tolerance) & (span > 1e3 * SHORTEST))
        if not len(off):
            return _join(borders, begin, end)
        borders = np.insert(borders, off + 1, borders[off] + 0.5 * span[off])


def combine(road: Segments, apart: float, low: float, high: float) -> tuple[Segments, Segments]:
    """Return the mean (m) of the heights ``apart / 2`` (m) ahead and behind, and the slope between them (1)."""
    half = 0.5 * apart
    borders = _borders([road.edges - half, road.edges + half], low, high)
    behind, ahead = _pieces(road, borders, -half), _pieces(road, borders, half)
    ends: tuple[list[Array], list[Array]] = ([], [])
    for x in (borders[:-1], borders[1:]):
        front, rear = (
            np.array(road.on_pieces(ahead, x + half)),
            np.array(road.on_pieces(behind, x - half)),
        )
        ends[0].append(0.5 * (front + rear))
        ends[1].append((front - rear) / apart)
    mean, slope = ([(left[0], left[1]), (right[0], right[1])] for left, right in ends)
    return _join(borders, *mean), _join(borders, *slope)


def roll_cam(
    road: Segments, cam: Cam, window: tuple[float, float], step: float, tolerance: float
) -> Segments:
    """Compute the height in m of a cam resting on the road, minus its height on a level road, over a window (m, m).

    The pieces are cubics of at most ``step`` metres with exact heights and slopes at their ends, split until their
    error is below ``tolerance`` (m). Borders are set wherever two points of the road touch at once, and where an edge
    starts or ceases to touch.
    """
    parts = _Parts.of(road, cam)
    nodes = _subdivide(np.array(window), np.array([step]))
    nodes = _borders([nodes, parts.transitions()], *window)
    nodes, left, right = _add_kinks(parts, nodes, parts.contact(nodes), tolerance)
    steep = max(np.abs(left[1]).max(), np.abs(right[1]).max())
    if steep > _STEEPEST:
        raise DescriptionError(
            "the wheel meets a wall: an edge of the road is as high as the wheel's cam",
            allowed=Phrase("edges well below {b:g} m", b=cam.b),
            hint="Use a larger wheel or a lower obstacle.",
        )
    return _join(nodes, (right[0][:-1], right[1][:-1]), (left[0][1:], left[1][1:]))


@dataclass(frozen=True)
class _Parts:
    """The road split into parts that a cam touches at most once each, and the corners between them."""

    road: Segments
    cam: Cam
    border: Array  # (n + 1,), m
    piece: Numbers  # (n,): index of the road's piece that contains the part
    corner: Array  # (n + 1,): height of the borders in m, the upper height at a jump
    offset: Array  # (2, n): offset in m from the cam's centre at which it touches the slope at either end of a part
    edge: NDArray[np.bool_]  # (n - 1,): inner borders at which height, slope or curvature jump

    @classmethod
    def of(cls, road: Segments, cam: Cam) -> _Parts:
        length = np.diff(road.edges)
        longest = np.full(len(length), np.inf)
        longest[_is_curved(road)] = cam.a / 16.0
        waves, arcs = road.kind == SINE, road.kind == CIRCLE
        longest[waves] = np.minimum(
            longest[waves], np.pi / 8.0 / np.maximum(road.coefficients[waves, 2], 1e-9)
        )
        longest[arcs] = np.minimum(longest[arcs], road.coefficients[arcs, 1] / 16.0)
        border = _subdivide(road.edges, longest)
        piece = road.piece_at(0.5 * (border[:-1] + border[1:]))
        nudge = 1e-7 * np.diff(border)  # an arc has an infinite slope at its foot
        left, right = road.on_pieces(piece, border[:-1])[0], road.on_pieces(piece, border[1:])[0]
        slopes = [road.on_pieces(piece, x)[1] for x in (border[:-1] + nudge, border[1:] - nudge)]
        corner = np.maximum(np.append(left, right[-1]), np.insert(right, 0, left[0]))
        offset = np.array([cam.offset(slope) for slope in slopes])
        edge = (np.abs(offset[1, :-1] - offset[0, 1:]) > _SHARP * cam.a) | (
            np.abs(left[1:] - right[:-1]) > 1e-12
        )
        bend = np.abs(
            _curvature(road, piece[1:], border[1:-1]) - _curvature(road, piece[:-1], border[1:-1])
        )
        edge |= (np.diff(piece) > 0) & (bend * cam.a**2 > _BENT)
        return cls(road, cam, border, piece, corner, offset, edge)

    def transitions(self) -> Array:
        """Return cam positions in m at which a significant edge may start or cease to touch."""
        corner = self.border[1:-1][self.edge]
        return np.concatenate(
            [corner - self.offset[1, :-1][self.edge], corner - self.offset[0, 1:][self.edge]]
        )

    def contact(self, x: Array) -> tuple[Array, Array]:
        """Return the height of the cam at the positions ``x`` and the distance of the contact point, in m."""
        first = np.searchsorted(self.border, x - self.cam.a, side="right") - 1
        last = np.searchsorted(self.border, x + self.cam.a, side="left")
        count = np.minimum(last, len(self.piece)) - np.maximum(first, 0) + 1
        stops = np.searchsorted(
            np.cumsum(count), np.arange(_PAIRS, int(count.sum()) + _PAIRS, _PAIRS), side="right"
        )
        height, at = np.empty_like(x), np.empty_like(x)
        begin = 0
        for end in sorted({*(int(stop) for stop in np.maximum(stops, 1)), len(x)}):
            if end > begin:
                chosen = slice(begin, end)
                height[chosen], at[chosen] = self._contact(
                    x[chosen], np.maximum(first[chosen], 0), count[chosen]
                )
                begin = end
        return height, at

    def _contact(self, x: Array, first: Numbers, count: Numbers) -> tuple[Array, Array]:
        starts = np.concatenate([[0], np.cumsum(count)[:-1]])
        owner = np.repeat(np.arange(len(x)), count)
        number = np.arange(len(owner)) - starts[owner] + first[owner]
        here = x[owner]
        at = self.border[number]
        near = np.abs(at - here) < self.cam.a
        height = np.where(near, self.corner[number] + self.cam.drop(at - here), -np.inf)
        part = np.minimum(number, len(self.piece) - 1)
        left, right = self.border[part], self.border[part + 1]
        a = self.cam.a
        rises = (here + self.offset[0, part] > left) | (here - a > left)
        falls = (here + self.offset[1, part] < right) | (here + a < right)
        inside = np.flatnonzero(
            rises & falls & (number < len(self.piece)) & (here + a > left) & (here - a < right)
        )
        touch = self._inside(part[inside], here[inside])
        level = self.road.on_pieces(self.piece[part[inside]], touch)[0] + self.cam.drop(
            touch - here[inside]
        )
        better = level > height[inside]
        height[inside[better]], at[inside[better]] = level[better], touch[better]
        best = np.maximum.reduceat(height, starts)
        winner = np.flatnonzero(height == best[owner])
        chosen = winner[np.unique(owner[winner], return_index=True)[1]]
        return np.asarray(best), np.asarray(at[chosen])

    def _inside(self, part: Numbers, x: Array) -> Array:
        """Return the contact point inside a part: in closed form on a line, by bisection on a curve."""
        low, high = (
            np.maximum(self.border[part], x - self.cam.a),
            np.minimum(self.border[part + 1], x + self.cam.a),
        )
        ends = self.offset[:, part]
        touch = np.clip(x + ends[0], low, high)
        curved = np.flatnonzero(_is_curved(self.road)[self.piece[part]])
        piece, x, low, high = self.piece[part[curved]], x[curved], low[curved], high[curved]
        for _ in range(45):
            middle = 0.5 * (low + high)
            ahead = x + self.cam.offset(self.road.on_pieces(piece, middle)[1]) > middle
            low, high = np.where(ahead, middle, low), np.where(ahead, high, middle)
        touch[curved] = 0.5 * (low + high)
        return np.asarray(touch)


def _curvature(road: Segments, piece: Numbers, x: Array) -> Array:
    """Return the second derivative in 1/m of pieces at ``x``; for arcs a large, distinct number."""
    s = x - road.edges[piece]
    _, c1, c2, c3 = np.moveaxis(road.coefficients[piece], -1, 0)
    kind = road.kind[piece]
    waves = np.where(kind == SINE, -c1 * c2**2 * np.sin(c2 * s + c3), 2.0 * c2 + 6.0 * c3 * s)
    return np.asarray(np.where(kind == CIRCLE, 1e9 * (1.0 + piece), waves))


def _is_curved(road: Segments) -> NDArray[np.bool_]:
    return np.asarray((road.kind != POLYNOMIAL) | (road.coefficients[:, 2:] != 0.0).any(axis=1))


def _add_kinks(
    parts: _Parts, nodes: Array, contact: tuple[Array, Array], tolerance: float
) -> tuple[Array, tuple[Array, Array], tuple[Array, Array]]:
    """Add nodes at the kinks; return all nodes, and heights (m) and slopes (1) on the left and right of each."""
    height, at = contact
    slope = parts.cam.slope(at - nodes)
    left = right = np.array([nodes, height, slope, at])
    for _ in range(6):
        apart = right[0, 1:] - right[0, :-1]
        jump = left[3, 1:] - right[3, :-1]
        # At a kink the contact point jumps by more than the node spacing and the bisection's resolution.
        wide = np.flatnonzero((jump > 1.1 * apart + 1e-4 * parts.cam.a) & (apart > 4.0 * SHORTEST))
        before, after = _bisect_kink(parts, right[:, wide], left[:, wide + 1])
        kink = (
            after[3] - before[3] > 1e-4 * parts.cam.a
        )  # otherwise the contact moves quickly along a hollow
        if not kink.any():
            break
        left = np.insert(left, wide[kink] + 1, before[:, kink], axis=1)
        right = np.insert(right, wide[kink] + 1, after[:, kink], axis=1)
    left, right = _refine(parts, left, right, tolerance)
    again = np.diff(left[0]) < SHORTEST  # a kink at a node
    left, right = left[:, np.append(True, ~again)], right[:, np.append(~again, True)]
    left[0, 0], left[0, -1] = nodes[0], nodes[-1]
    return left[0], (left[1], left[2]), (right[1], right[2])


def _refine(parts: _Parts, left: Array, right: Array, tolerance: float) -> tuple[Array, Array]:
    """Add nodes where a cubic deviates from the cam's height by more than the tolerance (m)."""
    unsure = np.ones(left.shape[1] - 1, dtype=bool)
    for _ in range(8):
        which = np.flatnonzero(unsure)
        begin, end = right[:, which], left[:, which + 1]
        (point, error), second = (_error(parts, begin, end, share) for share in _SHARES)
        point, error = np.where(second[1] > error, second[0], point), np.maximum(second[1], error)
        off = (error > tolerance) & (end[0] - begin[0] > 1e3 * SHORTEST)
        if not off.any():
            break
        left = np.insert(left, which[off] + 1, point[:, off], axis=1)
        right = np.insert(right, which[off] + 1, point[:, off], axis=1)
        unsure = np.zeros(left.shape[1] - 1, dtype=bool)
        added = which[off] + np.arange(int(off.sum()))
        unsure[added] = unsure[added + 1] = True
    return left, right


def _error(parts: _Parts, begin: Array, end: Array, share: float) -> tuple[Array, Array]:
    """Return nodes at a share of the intervals, and the errors (m) of the cubics there."""
    span = end[0] - begin[0]
    x = begin[0] + share * span
    height, at = parts.contact(x)
    difference = _cubic(span, (begin[1], begin[2]), (end[1], end[2]), share) - height
    return np.array([x, height, parts.cam.slope(at - x), at]), np.abs(difference)


def _cubic(
    span: Array, begin: tuple[Array, Array], end: tuple[Array, Array], share: float
) -> Array:
    """Return heights in m at a share of intervals of a span (m), of cubics with these end heights and slopes."""
    rise = share**2 * (3.0 - 2.0 * share) * (end[0] - begin[0])
    lean = span * share * (1.0 - share) * ((1.0 - share) * begin[1] - share * end[1])
    return np.asarray(begin[0] + rise + lean)


def _bisect_kink(parts: _Parts, begin: Array, end: Array) -> tuple[Array, Array]:
    """Bisect for the largest jump of the contact between two nodes; return x, height, slope, contact on either side."""
    begin, end = begin.copy(), end.copy()
    for _ in range(22):
        x = 0.5 * (begin[0] + end[0])
        height, at = parts.contact(x)
        middle = np.array([x, height, parts.cam.slope(at - x), at])
        later = end[3] - at > at - begin[3]
        begin = np.where(later, middle, begin)
        end = np.where(later, end, middle)
    return _move_to_crossing(begin, end)


def _move_to_crossing(begin: Array, end: Array) -> tuple[Array, Array]:
    """Move both sides of a kink, which are close together, to the intersection of their tangents."""
    turn = begin[2] - end[2]
    gap = end[1] - end[2] * (end[0] - begin[0]) - begin[1]
    with np.errstate(divide="ignore", invalid="ignore"):
        by = np.where(np.abs(turn) > 1e-6, gap / turn, 0.5 * (end[0] - begin[0]))
    x = np.clip(begin[0] + by, begin[0], end[0])
    before, after = begin.copy(), end.copy()
    before[1] += begin[2] * (x - begin[0])
    after[1] += end[2] * (x - end[0])
    before[0] = after[0] = x
    return before, after


def _borders(places: list[Array], low: float, high: float) -> Array:
    """Return ascending positions (m) from ``low`` to ``high``, merged within a nanometre."""
    inner = np.concatenate(places)
    inner = np.unique(inner[(inner > low + SHORTEST) & (inner < high - SHORTEST)])
    distinct = inner[np.diff(inner, prepend=-np.inf) > SHORTEST]
    return np.concatenate([[low], distinct, [high]])


def _subdivide(borders: Array, longest: Array) -> Array:
    """Split the intervals between borders into equal parts of at most ``longest`` (m, scalar or per interval)."""
    span = np.diff(borders)
    count = np.maximum(np.ceil(span / np.broadcast_to(longest, span.shape) - 1e-9), 1.0).astype(
        np.int64
    )
    owner = np.repeat(np.arange(len(span)), count)
    number = np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
    return np.append(borders[owner] + span[owner] * number / count[owner], borders[-1])


def _pieces(road: Segments, borders: Array, by: float) -> Numbers:
    """Return the road's piece ``by`` metres ahead of each interval between borders."""
    return road.piece_at(0.5 * (borders[:-1] + borders[1:]) + by)


def _area(road: Segments, piece: Numbers, x: Array) -> Array:
    """Integrate pieces from their start to ``x``, in m^2."""
    s = x - road.edges[piece]
    c0, c1, c2, c3 = np.moveaxis(road.coefficients[piece], -1, 0)
    kind = road.kind[piece]
    area = s * (c0 + s * (c1 / 2.0 + s * (c2 / 3.0 + s * c3 / 4.0)))
    wave, arc = kind == SINE, kind == CIRCLE
    rate, phase = c2[wave], c3[wave]
    area[wave] = c0[wave] * s[wave] + c1[wave] / rate * (
        np.cos(phase) - np.cos(rate * s[wave] + phase)
    )
    area[arc] = c0[arc] * s[arc] + c3[arc] * (
        _disc(s[arc] - c2[arc], c1[arc]) - _disc(-c2[arc], c1[arc])
    )
    return np.asarray(area)


def _disc(t: Array, radius: Array) -> Array:
    """Integrate sqrt(radius^2 - t^2) from 0, in m^2."""
    share = np.clip(t / radius, -1.0, 1.0)
    return np.asarray(0.5 * radius**2 * (share * np.sqrt(1.0 - share**2) + np.arcsin(share)))


def _join(borders: Array, left: tuple[Array, Array], right: tuple[Array, Array]) -> Segments:
    """Join cubics with these heights and slopes at the borders; collinear lines become one piece."""
    pieces = hermite_pieces(borders, left[0], right[0], left[1], right[1])
    c, span = pieces.coefficients, np.diff(borders)
    # Values below 1e-13 m are rounding of heights.
    bend = np.maximum(np.abs(c[:, 2]) * span**2, np.abs(c[:, 3]) * span**3) > 1e-13
    c[~bend, 2:] = 0.0
    c[~bend, 1] = ((right[0] - left[0]) / span)[~bend]
    ends_at = c[:-1, 0] + c[:-1, 1] * span[:-1]
    goes_on = (
        ~bend[1:]
        & ~bend[:-1]
        & (np.abs(c[1:, 1] - c[:-1, 1]) * np.minimum(span[1:], span[:-1]) < 1e-13)
        & (np.abs(c[1:, 0] - ends_at) < 1e-13)
    )
    is_start = np.concatenate([[True], ~goes_on])
    return Segments(
        np.append(borders[:-1][is_start], borders[-1]), pieces.kind[is_start], c[is_start]
    )
