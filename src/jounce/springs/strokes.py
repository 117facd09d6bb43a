"""Strokes of a press record: loading and unloading, their contact with the part, and the force along them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import numpy as np

from jounce.core.types import Array
from jounce.identify.signals import noise_of, zigzag

_TURN = 0.1  # share of the stroke of the press that makes a turn
_WHOLE = 0.9  # share of the longest stroke from which a stroke counts
_STARTS = (
    0.01,
    0.02,
    0.04,
    0.08,
    0.15,
    0.25,
)  # shares of the range up to which contact is searched
_CLEAR = 15.0  # standard deviations of noise that a search reaches at least
_LACKS = 2.0  # standard errors of a cubic term from which a parabola no longer holds
_FLAT = 8  # samples of free travel at least
_FREE = 0.01  # share of the stroke: shorter free travel does not show the zero of the force
_STEPS = 60  # places that are tried for a contact
_LEAST = 6  # samples of a local fit
_SINGULAR = 1e10  # condition from which samples do not determine a parabola
_BEYOND = 0.01  # share of the stroke after contact, in which friction turns round
_ENOUGH = 40  # samples of an extrapolation


@dataclass(frozen=True)
class Contact:
    """Where a stroke meets the part: place (m) and zero of the force (N) of the record, with standard errors."""

    place: float
    place_error: float
    zero: float
    zero_error: float


@dataclass(frozen=True)
class Stroke:
    """One loading or unloading.

    Attributes
    ----------
    is_loading : bool
        Whether the part is compressed.
    deflection, force : array (n,)
        As recorded, compression positive, sorted by deflection, m and N.
    speed : float
        Speed in the middle of the stroke, m/s; NaN without time.
    contact : Contact or None
        None if the stroke has no free travel.
    """

    is_loading: bool
    deflection: Array
    force: Array
    speed: float
    contact: Contact | None


def strokes_of(deflection: Array, force: Array, time: Array | None) -> list[Stroke]:
    """Split a record (m, N, s; compression positive) into its whole strokes."""
    turns = [*zigzag(deflection, _TURN * float(np.ptp(deflection))), len(deflection) - 1]
    turns = sorted(set(turns))
    spans = [float(np.ptp(deflection[a : b + 1])) for a, b in pairwise(turns)]
    noise = noise_of(force)
    strokes = []
    for (begin, end), span in zip(pairwise(turns), spans, strict=True):
        if span < _WHOLE * max(spans):
            continue
        part = slice(begin, end + 1)
        x, f = deflection[part], force[part]
        order = np.argsort(x, kind="stable")
        speed = math.nan if time is None else _speed(x, time[part])
        x, f = x[order], f[order]
        strokes.append(
            Stroke(bool(deflection[end] > deflection[begin]), x, f, speed, contact_of(x, f, noise))
        )
    return strokes


def _speed(deflection: Array, time: Array) -> float:
    """Return the speed (m/s) over the middle of a stroke."""
    low, high = float(deflection.min()), float(deflection.max())
    inside = np.flatnonzero(
        (deflection > low + 0.2 * (high - low)) & (deflection < high - 0.2 * (high - low))
    )
    if len(inside) < 2 or time[inside[-1]] <= time[inside[0]]:
        return math.nan
    return abs(
        float(deflection[inside[-1]] - deflection[inside[0]])
        / float(time[inside[-1]] - time[inside[0]])
    )


def contact_of(deflection: Array, force: Array, noise: float) -> Contact | None:
    """Find where the force leaves its zero: a flat, then a parabola; None without free travel.

    ``noise`` (N) is the standard deviation of the force. The force is followed as far as the parabola holds.
    """
    base = float(np.median(force[: max(_LEAST, len(force) // 50)]))
    rise = float(force.max()) - base
    found = None
    for limit in (share * rise for share in _STARTS):
        if found is None and limit < _CLEAR * noise:
            continue
        above = np.flatnonzero(force > base + limit)
        last = int(above[0]) if len(above) else len(force)
        fitted = _contact_within(deflection[:last], force[:last], float(np.ptp(deflection)), noise)
        if fitted is None:
            continue
        contact, lacking = fitted
        if found is not None:
            if lacking > _LACKS:
                break
            shift = contact.place - found.place  # what the parabola does not follow
            contact = replace(contact, place_error=math.hypot(contact.place_error, shift))
        found = contact
    return found


def _contact_within(
    x: Array, f: Array, stroke: float, noise: float
) -> tuple[Contact, float] | None:
    """Find the contact in the first samples of a stroke, and how clearly the fit lacks a cubic term."""
    count = len(x)
    if count < 2 * _FLAT:
        return None
    places = np.linspace(float(x[_FLAT]), float(x[-_FLAT // 2]), _STEPS)
    misfits = _hinge_misfits(x, f, places)
    k = int(np.argmin(misfits))
    if k in (0, len(places) - 1):
        return None
    fine = np.linspace(places[k - 1], places[k + 1], 25)
    place = float(fine[int(np.argmin(_hinge_misfits(x, f, fine)))])
    misfit, zero, slope, bend = _hinge(x, f, place)
    flat = int(np.searchsorted(x, place))
    if flat < _FLAT or place - float(x[0]) < _FREE * stroke or (slope <= 0.0 and bend <= 0.0):
        return None
    spread = max(math.sqrt(misfit / max(count - 4, 1)), noise, 1e-12)
    # The place moves the fit by -slope in all samples beyond it; zero, slope and bend move along.
    beyond = np.maximum(x - place, 0.0)
    motion = np.where(x > place, -(slope + 2.0 * bend * beyond), 0.0)
    columns = np.column_stack([np.ones_like(x), beyond, beyond**2, motion])
    scale = np.where(np.linalg.norm(columns, axis=0) > 0.0, np.linalg.norm(columns, axis=0), 1.0)
    covariance = np.linalg.pinv((columns / scale).T @ (columns / scale)) * spread**2
    errors = np.sqrt(np.diag(covariance)) / scale
    error = min(float(errors[3]), float(np.ptp(x)))
    rest = f - columns[:, :3] @ np.array([zero, slope, bend])
    return Contact(place, error, zero, float(errors[0])), _cubic_in(columns, beyond, rest)


def _hinge_misfits(x: Array, f: Array, places: Array) -> Array:
    """Return the sums of squares of :func:`_hinge` at many places."""
    u = np.maximum(x[None, :] - places[:, None], 0.0)
    u /= np.maximum(u[:, -1:], 1e-12)
    centred = f - f.mean()

    def misfit(*columns: Array) -> tuple[Array, Array]:
        matrix = np.stack(columns, axis=2)
        matrix -= matrix.mean(axis=1, keepdims=True)  # a constant is fitted, too
        normal = np.einsum("kni,knj->kij", matrix, matrix) + 1e-12 * np.eye(len(columns))
        right = np.einsum("kni,n->ki", matrix, centred)
        factors = np.linalg.solve(normal, right[..., None])[..., 0]
        return float(centred @ centred) - np.einsum("ki,ki->k", factors, right), factors

    both, factors = misfit(u, u * u)
    bend_only, _ = misfit(u * u)
    return np.where(factors[:, 0] < 0.0, bend_only, both)


def _hinge(x: Array, f: Array, place: float) -> tuple[float, float, float, float]:
    """Fit a constant up to a place and a parabola that leaves it there; sum of squares and coefficients."""
    beyond = np.maximum(x - place, 0.0)
    scale = max(float(beyond[-1]), 1e-12)
    u = beyond / scale
    columns = np.column_stack([np.ones_like(x), u, u * u])
    factors = np.linalg.lstsq(columns, f, rcond=None)[0]
    if factors[1] < 0.0:
        factors = np.insert(np.linalg.lstsq(columns[:, [0, 2]], f, rcond=None)[0], 1, 0.0)
    elif factors[2] < 0.0 and factors[1] + 2.0 * factors[2] < 0.0:
        factors = np.append(np.linalg.lstsq(columns[:, :2], f, rcond=None)[0], 0.0)
    rest = f - columns @ factors
    return (
        float(rest @ rest),
        float(factors[0]),
        float(factors[1]) / scale,
        float(factors[2]) / scale**2,
    )


def force_at(stroke: Stroke, places: Array, width: float) -> tuple[Array, Array]:
    """Return force and standard error (N) at places (m, as recorded), by parabolas within ``width`` (m) of each.

    NaN where a stroke has too few samples.
    """
    x, f = stroke.deflection, stroke.force
    begin, end = np.searchsorted(x, places - width), np.searchsorted(x, places + width)
    most = max(int((end - begin).max()), _LEAST)
    index = np.minimum(begin[:, None] + np.arange(most), len(x) - 1)
    inside = begin[:, None] + np.arange(most) < end[:, None]
    u = np.where(inside, (x[index] - places[:, None]) / width, 0.0)
    columns = np.stack([inside.astype(float), u, u * u], axis=2)
    measured = np.where(inside, f[index], 0.0)
    normal = np.einsum("kni,knj->kij", columns, columns)
    known = end - begin >= _LEAST
    known &= (x[np.minimum(begin, len(x) - 1)] <= places) & (places <= x[np.maximum(end - 1, 0)])
    known &= np.linalg.cond(np.where(np.isfinite(normal), normal, 0.0)) < _SINGULAR
    normal[~known] = np.eye(3)
    inverse = np.linalg.inv(normal)
    factors = np.einsum("kij,knj,kn->ki", inverse, columns, measured)
    rest = measured - np.einsum("kni,ki->kn", columns, factors) * inside
    variance = (rest**2).sum(axis=1) / np.maximum(end - begin - 3, 1)
    value = np.where(known, factors[:, 0], np.nan)
    error = np.where(known, np.sqrt(variance * inverse[:, 0, 0]), np.nan)
    return value, error


Part = Literal["spring", "bump-stop"]


def zero_of(strokes: Sequence[Stroke], part: Part) -> Contact | None:
    """Return the contact of a record: of a spring the middle of loading and unloading, of a stop the first loading's.

    Backlash of the press and friction move loading and unloading apart by equal amounts; a stop that has
    been compressed recovers late, so that only its first contact is that of the part at rest.
    """
    sides = [
        [stroke.contact for stroke in strokes if stroke.contact and stroke.is_loading is side]
        for side in (True, False)
    ]
    loading, unloading = (_mean_contact(side) for side in sides)
    if part == "bump-stop":
        return next((s.contact for s in strokes if s.contact and s.is_loading), unloading)
    if loading is None or unloading is None:
        return loading or unloading
    return _between(strokes, loading, unloading) or Contact(
        0.5 * (loading.place + unloading.place),
        0.5 * math.hypot(loading.place_error, unloading.place_error),
        0.5 * (loading.zero + unloading.zero),
        0.5 * math.hypot(loading.zero_error, unloading.zero_error),
    )


def _cubic_in(columns: Array, u: Array, rest: Array) -> float:
    """Return a cubic term of ``u`` in the residuals of a fit, in standard errors; ``columns`` were fitted."""
    cube = (u / max(float(u.max()), 1e-12)) ** 3
    scale = np.where(np.linalg.norm(columns, axis=0) > 0.0, np.linalg.norm(columns, axis=0), 1.0)
    own = cube - (columns / scale) @ (np.linalg.pinv(columns / scale) @ cube)
    power = float(own @ own)
    if power < 1e-9 * float(cube @ cube):
        return 0.0
    factor = float(own @ rest) / power
    left = rest - factor * own
    variance = float(left @ left) / max(len(u) - columns.shape[1] - 1, 1)
    return abs(factor) * math.sqrt(power / max(variance, 1e-300))


def _between(strokes: Sequence[Stroke], loading: Contact, unloading: Contact) -> Contact | None:
    """Extrapolate the middle of loading and unloading to zero force: friction jumps at contact; the middle does not."""
    zero = 0.5 * (loading.zero + unloading.zero)
    zero_error = 0.5 * math.hypot(loading.zero_error, unloading.zero_error)
    x = np.concatenate([stroke.deflection for stroke in strokes])
    f = np.concatenate([stroke.force for stroke in strokes]) - zero
    side = np.concatenate(
        [np.full(len(stroke.force), 1.0 if stroke.is_loading else -1.0) for stroke in strokes]
    )
    begin = max(loading.place, unloading.place) + _BEYOND * float(np.ptp(x))
    found = None
    for share in _STARTS:
        used = (x > begin) & (f < share * float(f.max()))
        if np.count_nonzero(used) < _ENOUGH or np.unique(side[used]).size < 2:
            continue
        scale = float(np.ptp(x[used]))
        u = (x[used] - begin) / scale
        columns = np.column_stack([np.ones_like(u), u, u * u, side[used]])
        inverse = np.linalg.pinv(columns)
        factors = inverse @ f[used]
        rest = f[used] - columns @ factors
        variance = float(rest @ rest) / (len(u) - 4)
        if found is not None and _cubic_in(columns, u, rest) > _LACKS:
            break
        roots = np.roots(factors[2::-1])
        near = [float(r.real) for r in roots if abs(r.imag) < 1e-9 and r.real < 1.0]
        if not near:
            continue
        root = max(near)
        powers = np.array([1.0, root, root * root, 0.0])
        slope = (factors[1] + 2.0 * factors[2] * root) / scale
        error = math.sqrt(variance * float(np.sum((powers @ inverse) ** 2))) / abs(slope)
        place = begin + root * scale
        shift = 0.0 if found is None else place - found.place
        found = Contact(place, math.hypot(error, zero_error / abs(slope), shift), zero, zero_error)
    return found


def _mean_contact(contacts: Sequence[Contact]) -> Contact | None:
    """Return the mean of contacts; its errors contain their scatter."""
    if not contacts:
        return None
    count = len(contacts)
    means, errors = [], []
    for name in ("place", "zero"):
        values = np.array([getattr(item, name) for item in contacts])
        own = np.array([getattr(item, f"{name}_error") for item in contacts])
        within = float(np.mean(own**2)) / count
        between = float(np.var(values, ddof=1)) / count if count > 1 else 0.0
        means.append(float(values.mean()))
        errors.append(math.sqrt(max(within, between)))
    return Contact(means[0], errors[0], means[1], errors[1])


def lost_motion(strokes: Sequence[Stroke]) -> tuple[float, float] | None:
    """Return by how much loading meets the part later than unloading leaves it (m), and its error; None if unknown."""
    sides = [
        _mean_contact([s.contact for s in strokes if s.contact and s.is_loading is side])
        for side in (True, False)
    ]
    if sides[0] is None or sides[1] is None:
        return None
    return (
        sides[0].place - sides[1].place,
        math.hypot(sides[0].place_error, sides[1].place_error),
    )
