"""Events: the points within a step at which a switching function leaves the side of its mode, and their effects.

The modes are held during a step, so every step integrates a smooth equation, even if its solution passes the switch.
The switching functions are evaluated afterwards, at a small fraction of the cost of a step. Each method provides the
evaluation of one function inside its step (``switch_at(problem, work, t, h, share, i)``); the search is shared.
"""

from __future__ import annotations

from typing import Any

from jounce.kernel.engine import PROBES, RATES, STATE
from jounce.kernel.loops.compiling import call_native, call_step, part
from jounce.kernel.loops.signals import fill

_VERTICES = 3  # parabolas followed into a dip: each shrinks the bracket to a quarter
_NEAR = 0.3  # a dip is followed where its parabola comes within this share of the nearest probe's distance
_HALVINGS = 16  # the way back to the start of a bracket: 4^-16 of it is the rounding of a share
_ITERATIONS = (
    60  # regula falsi needs 5 to 10; a jump that is no root is halved down to rounding in so many
)
_LAST_PROBE = len(PROBES)


def locator(switch_at: Any) -> Any:
    """Create the search for events from a method's evaluation of one switching function inside its step."""

    @part()
    def root(problem: Any, work: Any, t: float, h: float, i: int, low: float, high: float) -> float:
        """Locate the zero of switch ``i`` between two shares of a step (Illinois variant of regula falsi).

        The value at ``high`` is beyond the dead band. The value at ``low`` should have the opposite sign, but right
        after an event it is rounding error of either sign. In that case the search looks for a nearby point on the
        right side, at decreasing distances. If there is none, the function turned at once, and the event is at
        ``low``.
        """
        g_low = switch_at(problem, work, t, h, low, i)
        g_high = switch_at(problem, work, t, h, high, i)
        start = low
        for _ in range(_HALVINGS):
            if g_low * g_high < 0.0:
                break
            low = start + 0.25 * (high - start)
            g_low = switch_at(problem, work, t, h, low, i)
            if g_low * g_high >= 0.0:
                high, g_high = low, g_low
        if g_low * g_high >= 0.0:
            return start
        for _ in range(_ITERATIONS):
            share = (low * g_high - high * g_low) / (g_high - g_low)
            g = switch_at(problem, work, t, h, share, i)
            # Shares are numbers of size one: closer than that they are the same time.
            if g == 0.0 or abs(high - low) < 1e-13 or abs(share - high) < 1e-14:
                return float(share)
            if g * g_high < 0.0:
                low, g_low = high, g_high
            else:  # the same end was kept twice: count it for half, else it would stay for ever
                g_low *= 0.5
            high, g_high = share, g
        return high

    @part(forceinline=True)  # asked in every step, and a call copies all that it is given
    def dip(
        problem: Any,
        work: Any,
        t: float,
        h: float,
        g: Any,
        band: float,
        i: int,
        probe: int,
        width: float,
    ) -> float:
        """Find where switch ``i`` is on the wrong side between three probes on the right side; return -1 if nowhere.

        A short contact may begin and end between two probes. Follows the vertices of parabolas, starting with the one
        through the probes: a smooth function that dips below zero there is nearly one.
        """
        side, middle = 1.0 if problem.m[i] > 0.5 else -1.0, probe * width - width
        low, mid, high = side * g[probe - 2, i], side * g[probe - 1, i], side * g[probe, i]
        for _ in range(_VERTICES):
            bend = low - 2.0 * mid + high
            if bend <= 0.0:  # a hill has no dip
                return -1.0
            move = 0.5 * (low - high) / bend
            depth = mid - 0.125 * (low - high) * (low - high) / bend
            # The vertex must lie between the outer probes, and low enough that the error of the parabola may hide a
            # dip.
            if abs(move) > 1.0 or depth > _NEAR * min(low, mid, high):
                return -1.0
            vertex = middle + move * width
            if side * switch_at(problem, work, t, h, vertex, i) < -band:
                return float(vertex)
            width *= 0.25
            middle = min(max(vertex, width), 1.0 - width)
            low = side * switch_at(problem, work, t, h, middle - width, i)
            mid = side * switch_at(problem, work, t, h, middle, i)
            high = side * switch_at(problem, work, t, h, middle + width, i)
            if min(low, mid, high) < -band:
                return float(
                    middle - width if low < -band else middle if mid < -band else middle + width
                )
        return -1.0

    @part(forceinline=True)
    def crossing(
        problem: Any, work: Any, t: float, h: float, g: Any, band: Any, intervals: int, edge: bool
    ) -> tuple[float, int]:
        """Return the first fraction of a step at which a switch leaves its side, and the switch; (2, -1) if none does.

        ``g`` contains the switching functions at equal distances over the step, from its start on; ``band`` is the
        distance by which each may be on the wrong side. On a step that starts at an ``edge`` of the input, the
        fraction is -1 for a switch that was flipped by the edge.
        """
        modes = problem.m
        before, first, which = 0.0, 2.0, -1
        width = 1.0 / intervals
        for probe in range(intervals + 1):
            here = probe * width
            for i in range(len(modes)):
                side = 1.0 if modes[i] > 0.5 else -1.0
                share = 2.0
                if probe == 0:
                    # At the start only an edge can have put a switch on the wrong side. After an event the function is
                    # zero but for rounding there, and the mode just flipped is right.
                    share = -1.0 if edge and side * g[probe, i] < -band[i] else 2.0
                elif side * g[probe, i] < -band[i]:
                    share = root(problem, work, t, h, i, before, here)
                elif probe > 1:
                    touched = dip(problem, work, t, h, g, band[i], i, probe, width)
                    if (
                        touched > 0.0
                    ):  # in this interval or, as parabolas span two, in the one before
                        low = before if touched > before else 2.0 * before - here
                        share = root(problem, work, t, h, i, low, touched)
                if share < first:
                    first, which = share, i
            # What is behind the first interval with an event counts for nothing: the laws are others from there on.
            if which >= 0:
                break
            before = here
        return first, which

    return crossing


@part()
def switch_on_interpolant(
    problem: Any, work: Any, t: float, h: float, share: float, i: int
) -> float:
    """Evaluate switching function ``i`` at a fraction of a step by its interpolant."""
    work.times[0] = t + share * h
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    call_step(problem.engine.switch_at, work.rows, work.u, problem.p, problem.m, work.g, share)
    return float(work.g[_LAST_PROBE, i])


crossing = locator(switch_on_interpolant)
"""The search on the interpolant of an adaptive step."""


@part(forceinline=True)
def rate(problem: Any, work: Any, t: float, into: int) -> None:
    """Evaluate the rate of the state at ``t``; the input there is stored in node 0."""
    work.times[0] = t
    fill(problem.tracks, problem.piece, work.times[:1], work.u[:, :1])
    call_native(
        problem.engine.rate, work.rows, STATE, work.u, problem.p, problem.m, work.rows, into
    )


@part()
def flip(problem: Any, work: Any, t: float, which: int, thrown: bool) -> None:
    """Flip one mode at an event, and apply the jump of the sensitivities.

    An event caused by an edge of the input has a fixed time that no parameter shifts, so the sensitivities do not jump.
    """
    n, size = len(work.widest), work.rows.shape[1]
    jumps = size > n and not thrown
    if jumps:
        rate(problem, work, t, RATES + 1)
        call_native(
            problem.engine.switch_slope,
            work.rows,
            STATE,
            work.u,
            problem.p,
            problem.m,
            work.slope,
            0,
        )
    problem.m[which] = 1.0 - problem.m[which]
    if jumps:
        rate(problem, work, t, RATES)
        _jump_sensitivities(work.rows, work.slope, which, n, (size - n) // n)


@part()
def _jump_sensitivities(rows: Any, slope: Any, which: int, n: int, columns: int) -> None:
    """Saltation: ``S+ = S- + (f+ - f-) (dg/dx S- + dg/dp) / (dg/dt)``, f- in the second rate and f+ in the first.

    ``slope`` contains the slopes of each switch along the states and time, followed by those along the sensitivities.
    """
    x, before, after = rows[STATE], rows[RATES + 1], rows[RATES]
    switches = slope.shape[1] // (n + 1 + columns)
    row = slope[0, which * (n + 1) : (which + 1) * (n + 1)]
    shift = slope[0, switches * (n + 1) + which * columns :]
    speed = row[n]
    for d in range(n):
        speed += row[d] * before[d]
    if (
        abs(speed) < 1e-300
    ):  # it only touches the switch: the time of such an event has no derivative
        return
    for d in range(n):
        jump = (after[d] - before[d]) / speed
        for c in range(columns):
            x[n + d * columns + c] += jump * shift[c]
