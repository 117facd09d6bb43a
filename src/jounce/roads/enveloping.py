"""Roads as a tyre of finite size feels them: the height that a point follower would have to be given instead."""

from __future__ import annotations

import hashlib
import math
from collections import OrderedDict
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal, Self

import numpy as np
from numpy.typing import ArrayLike
from pydantic import model_validator

from jounce.core.errors import DescriptionError
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import Length, PositiveLength, PositiveNumber
from jounce.roads.cams import Cam, averaged, combined, rolled
from jounce.roads.profile import Profile, laid_out
from jounce.roads.road import Road

if TYPE_CHECKING:
    from jounce.roads.train import AnyRoad

_NEEDED = {
    "moving-average": ("contact_length",),
    "rigid-circle": ("radius",),
    "tandem-cam": ("radius", "contact_length"),
}


class Enveloped(Road):
    """Effective height of another road under a tyre of finite size.

    ``start`` and ``recurrence`` are those of ``of``. The effective height begins and ends beyond the obstacle, by up to
    `reach`: a wheel that rolls over a step of height h as a circle of radius R begins to rise sqrt(2 R h - h^2) before
    it.

    Attributes
    ----------
    of : Road
        The road itself.
    method : {"moving-average", "rigid-circle", "tandem-cam"}
        Mean over the contact length; height of the centre of a rigid circle that rolls over the road, less its radius;
        mean height of two elliptical cams, one behind the other.
    contact_length : float or None
        Length in m of the contact patch, for the mean and for the distance of the cams; `contact_length` of a tyre
        gives it from the load.
    radius : float or None
        Undeformed radius of the tyre in m, for the circle and the cams.
    cam_length, cam_height : float
        Half axes of a cam over the radius (1): 1.471 along the road, 0.9622 upwards.
    cam_exponent : float
        Exponent (1) of a cam's superellipse, 1.5174.
    cam_distance : float
        Distance of the cams over the contact length (1), 0.8335.
    step : float or None
        Longest piece in m where there is no closed form; a twentieth of the contact length for the mean, an eighth
        of the radius for circle and cams.
    tolerance : float
        How far in m the pieces under circle and cams may be off, 1 micrometre: longer ones are cut.

    Notes
    -----
    The mean is exact for roads of lines and parabolas. All else is cubics whose heights and slopes are exact at both
    ends and which are cut where they would be off by more than ``tolerance``; kinks are found and kept. On a smooth
    road the error falls with the fourth power of ``step``. Cams: Schmeitz (key schmeitz-2004).

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
    of: AnyRoad
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
        """Refuse what the method lacks or does not use; take over what belongs to the road."""
        for name in ("start", "recurrence"):
            if name in self.model_fields_set and getattr(self, name) != getattr(self.of, name):
                raise ValueError(f"{name} belongs to the road inside; write it in the table of")
            object.__setattr__(self, name, getattr(self.of, name))
        needed = _NEEDED[self.method]
        for name in ("contact_length", "radius"):
            if (getattr(self, name) is None) == (name in needed):
                word = "needs" if name in needed else "does not use"
                raise ValueError(f"the method {self.method!r} {word} {name}")
        if self.cam_exponent <= 1.0:
            raise ValueError(f"cam_exponent {self.cam_exponent:g} gives a cam with corners; allowed: above 1")

    @model_validator(mode="after")
    def _checked(self) -> Self:
        self.check()
        return self  # the loop is that of the road inside, which has checked it

    def reach(self) -> float:
        """Distance in m to which the road is felt ahead of the wheel's centre and behind it."""
        if self.method == "moving-average":
            return 0.5 * _given(self.contact_length)
        cam = self._cam()
        return cam.a if self.method == "rigid-circle" else cam.a + 0.5 * self._apart()

    def profile(self) -> Profile:
        """Effective height of one pass."""
        inner, reach = self.of.profile(), self.reach()
        low, high = float(inner.edges[0]) - reach, float(inner.edges[-1]) + reach
        road = laid_out(inner, [(0.0, 0.0)], low - reach, high + reach)
        felt = self._felt(road, low, high)[0]
        return Profile(felt.edges, felt.kind, felt.coefficients, inner.before, inner.after)

    def end(self) -> float:
        """Distance in m at which the wheel has left the road inside for good."""
        return self.of.end() + self.reach()

    def effective_slope_at(self, x: ArrayLike) -> Array:
        """Slope (1) of the road that the tyre feels at the distances ``x`` in m, any shape.

        Of two cams it is the difference of their heights over their distance, not the derivative of the effective
        height, which `slope_at` gives; of the other methods both are the same.
        """
        if self.method != "tandem-cam":
            return self.slope_at(x)
        at = np.asarray(x, dtype=float)
        low, high = float(at.min()) - 1.0, float(at.max()) + 1.0
        return self._window(low, high)[1].evaluate(at.ravel())[0].reshape(at.shape)

    def _between(self, low: float, high: float) -> Segments:
        return self._window(low, high)[0]

    def _window(self, low: float, high: float) -> tuple[Segments, Segments]:
        margin = 1.01 * self.reach()
        return self._felt(self.of._between(low - margin, high + margin), low, high)

    def _felt(self, road: Segments, low: float, high: float) -> tuple[Segments, Segments]:
        """Effective height and slope from ``low`` to ``high`` of a road that is given wide enough."""
        method = (self.method, self.contact_length, self.radius, self.cam_length, self.cam_height, self.cam_exponent)
        key = _digest(road, *method, self.cam_distance, self.step, self.tolerance, low, high)
        return _REMEMBERED.get(key, lambda: self._computed(road, low, high))

    def _computed(self, road: Segments, low: float, high: float) -> tuple[Segments, Segments]:
        if self.method == "moving-average":
            length = _given(self.contact_length)
            mean = averaged(road, 0.5 * length, low, high, self.step or length / 20.0)
            return mean, mean
        step = self.step or _given(self.radius) / 8.0
        if self.method == "rigid-circle":
            height = rolled(road, self._cam(), (low, high), step, self.tolerance)
            return height, height
        half = 0.5 * self._apart()
        each = rolled(road, self._cam(), (low - half, high + half), step, self.tolerance)
        return combined(each, 2.0 * half, low, high)

    def _cam(self) -> Cam:
        radius = _given(self.radius)
        if self.method == "rigid-circle":
            return Cam(radius, radius)
        return Cam(self.cam_length * radius, self.cam_height * radius, self.cam_exponent)

    def _apart(self) -> float:
        return self.cam_distance * _given(self.contact_length)


def contact_length(
    load: float, stiffness: float, radius: float, *, linear: float = 0.733, root: float = 0.671
) -> float:
    """Length of the contact patch of a tyre on a level road.

    Parameters
    ----------
    load : float
        Vertical force in N, above 0.
    stiffness : float
        Radial stiffness in N/m.
    radius : float
        Undeformed radius in m.
    linear, root : float
        Coefficients (1) of the deflection over the radius and of its root.

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
            "not a loaded tyre", found=f"{load} N, {stiffness} N/m, {radius} m", allowed="values above 0"
        )
    share = load / (stiffness * radius)
    return 2.0 * radius * (root * math.sqrt(share) + linear * share)


def _given(value: float | None) -> float:
    if value is None:
        raise AssertionError("a field that the method needs is missing")
    return value


def _digest(road: Segments, *values: object) -> bytes:
    digest = hashlib.blake2b(repr(values).encode())
    for array in (road.edges, road.kind, road.coefficients):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.digest()


class _Remembered:
    """The last few results, because a run asks for the same road several times."""

    def __init__(self, most: int) -> None:
        self.most = most
        self.results: OrderedDict[bytes, tuple[Segments, Segments]] = OrderedDict()

    def get(self, key: bytes, make: Callable[[], tuple[Segments, Segments]]) -> tuple[Segments, Segments]:
        if key not in self.results:
            self.results[key] = make()
            while len(self.results) > self.most:
                self.results.popitem(last=False)
        self.results.move_to_end(key)
        return self.results[key]


_REMEMBERED = _Remembered(4)
