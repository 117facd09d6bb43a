"""Drawings of the pages that explain: axes, models with their free bodies, testers, bench, block diagrams.

Each drawing has its own coordinates; hardpoints and signals come from jounce.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import drawn
import numpy as np

from jounce.plots import new_figure, style

INK, GREY, FILL = "#22262b", "#666d75", "#dbe4ec"
BLUE, ORANGE, GREEN, PURPLE = "#0067a8", "#d55e00", "#00896b", "#a64d8f"
Point = Sequence[float]
DRAWINGS: dict[str, Callable[[], Any]] = {}


def drawing(
    width: float, height: float, *, parts: int = 1, rows: int = 1, size: float = 3.0
) -> Callable[[Any], Any]:
    """Register a function of one or more axes as a drawing."""

    def made(draw: Callable[..., None]) -> Callable[..., None]:
        def figure() -> Any:
            with style():
                page = new_figure(size)
                panels = np.ravel(page.subplots(rows, parts // rows))
                for axes in panels:
                    axes.set_axis_off()
                    axes.set_aspect("equal")
                    axes.set_xlim(0.0, width)
                    axes.set_ylim(0.0, height)
                draw(*panels)
            return page

        DRAWINGS[draw.__name__.replace("_", "-")] = figure
        return draw

    return made


# --- what drawings are made of ---------------------------------------------------------------------------------------


def line(
    axes: Any, *points: Point, color: str = INK, width: float = 1.3, dashed: bool = False
) -> None:
    x, y = np.array(points).T
    axes.plot(x, y, color=color, linewidth=width, linestyle=(0, (4, 3)) if dashed else "-")


def arrow(
    axes: Any, start: Point, end: Point, label: str = "", color: str = BLUE, at: Point = (0.1, 0.0)
) -> None:
    """An arrow with its name beside the head."""
    how = {"arrowstyle": "-|>,head_width=0.22,head_length=0.45", "color": color, "linewidth": 1.4}
    axes.annotate("", xy=end, xytext=start, arrowprops={**how, "shrinkA": 0, "shrinkB": 0})
    if label:
        word(
            axes,
            (end[0] + at[0], end[1] + at[1]),
            label,
            color=color,
            ha="left" if at[0] >= 0 else "right",
        )


def turn(
    axes: Any,
    centre: Point,
    radius: float,
    degrees: tuple[float, float],
    label: str,
    color: str = BLUE,
) -> None:
    """An arc with a head, from the first angle to the second."""
    angle = np.radians(np.linspace(*degrees, 40))
    x, y = centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)
    line(axes, *zip(x, y, strict=True), color=color, width=1.4)
    arrow(axes, (x[-2], y[-2]), (x[-1], y[-1]), color=color)
    middle = np.radians(np.mean(degrees))
    place = (centre[0] + 1.25 * radius * np.cos(middle), centre[1] + 1.25 * radius * np.sin(middle))
    word(axes, place, label, color=color)


def size(axes: Any, start: Point, end: Point, label: str, at: Point = (0.0, 0.15)) -> None:
    """A dimension: a thin line with two heads."""
    how = {"arrowstyle": "<->", "color": GREY, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", xy=end, xytext=start, arrowprops=how)
    word(
        axes, ((start[0] + end[0]) / 2 + at[0], (start[1] + end[1]) / 2 + at[1]), label, color=GREY
    )


def word(
    axes: Any, place: Point, text: str, color: str = INK, ha: str = "center", bold: bool = False
) -> None:
    weight = "bold" if bold else "normal"
    axes.text(
        *place,
        text,
        color=color,
        ha=ha,
        va="center",
        fontsize=9,
        fontweight=weight,
        linespacing=1.25,
    )


def box(
    axes: Any, corner: Point, width: float, height: float, text: str = "", fill: str = FILL
) -> None:
    from matplotlib.patches import FancyBboxPatch

    rounded = FancyBboxPatch(
        corner,
        width,
        height,
        boxstyle="round,pad=0,rounding_size=0.08",
        facecolor=fill,
        edgecolor=INK,
        linewidth=1.3,
    )
    axes.add_patch(rounded)
    word(axes, (corner[0] + width / 2, corner[1] + height / 2), text)


def circle(axes: Any, centre: Point, radius: float, fill: str = FILL, width: float = 1.3) -> None:
    from matplotlib.patches import Circle

    axes.add_patch(Circle(centre, radius, facecolor=fill, edgecolor=INK, linewidth=width))


def spring(
    axes: Any, foot: Point, head: Point, label: str = "", side: float = -1.0, coils: int = 5
) -> None:
    a, b = np.array(foot, dtype=float), np.array(head, dtype=float)
    along = b - a
    across = 0.16 * np.array([along[1], -along[0]]) / np.linalg.norm(along)
    share = np.linspace(0.2, 0.8, 2 * coils + 1)
    zigzag = [
        a + s * along + (0 if i in {0, 2 * coils} else (-1) ** i) * across
        for i, s in enumerate(share)
    ]
    line(axes, a, *zigzag, b)
    if label:
        word(axes, (a + b) / 2 + side * np.array([0.38, 0.0]), label)


def damper(axes: Any, foot: Point, head: Point, label: str = "", side: float = 1.0) -> None:
    a, b = np.array(foot, dtype=float), np.array(head, dtype=float)
    along = (b - a) / np.linalg.norm(b - a)
    across = 0.15 * np.array([along[1], -along[0]])
    low, high, piston = a + 0.3 * (b - a), a + 0.66 * (b - a), a + 0.5 * (b - a)
    line(axes, a, low)
    line(axes, high + across, low + across, low - across, high - across)
    line(axes, piston + 0.85 * across, piston - 0.85 * across, width=2.0)
    line(axes, piston, b)
    if label:
        word(axes, (a + b) / 2 + side * np.array([0.4, 0.0]), label)


def ground(axes: Any, left: float, right: float, height: float, label: str = "") -> None:
    line(axes, (left, height), (right, height), width=1.6)
    for x in np.arange(left + 0.1, right, 0.2):
        line(axes, (x, height), (x - 0.12, height - 0.12), color=GREY, width=0.7)
    if label:
        word(axes, (right + 0.15, height), label, ha="left", color=GREY)


# --- the drawings ----------------------------------------------------------------------------------------------------


@drawing(5.0, 3.6, parts=3, size=2.6)
def axes_of_the_vehicle(side: Any, rear: Any, top: Any) -> None:
    """Forward x, left y, up z, and the senses of roll, pitch and yaw."""
    word(side, (2.5, 3.4), "from the right", bold=True)
    line(
        side,
        (0.4, 0.9),
        (0.4, 1.5),
        (1.2, 1.6),
        (1.7, 2.2),
        (3.1, 2.2),
        (3.7, 1.6),
        (4.6, 1.45),
        (4.6, 0.9),
        (0.4, 0.9),
    )
    for x in (1.2, 3.8):
        circle(side, (x, 0.8), 0.42)
    ground(side, 0.2, 4.8, 0.38)
    arrow(side, (2.5, 1.35), (3.9, 1.35), "x", at=(0.1, 0.12))
    arrow(side, (2.5, 1.35), (2.5, 2.9), "z")
    turn(side, (2.5, 1.35), 0.75, (75.0, 10.0), "pitch", color=ORANGE)
    word(rear, (2.5, 3.4), "from behind", bold=True)
    line(rear, (1.2, 0.9), (1.2, 1.6), (1.6, 2.2), (3.4, 2.2), (3.8, 1.6), (3.8, 0.9), (1.2, 0.9))
    for x in (0.95, 3.65):
        box(rear, (x, 0.4), 0.4, 0.85)
    ground(rear, 0.5, 4.5, 0.38)
    arrow(rear, (2.5, 1.35), (0.75, 1.35), "y", at=(-0.1, 0.15))
    arrow(rear, (2.5, 1.35), (2.5, 2.9), "z")
    turn(rear, (2.5, 1.35), 0.75, (80.0, 15.0), "roll", color=ORANGE)
    word(top, (2.5, 3.4), "from above", bold=True)
    line(top, (0.4, 0.9), (4.2, 0.9), (4.6, 1.2), (4.6, 2.2), (4.2, 2.5), (0.4, 2.5), (0.4, 0.9))
    for x in (1.0, 3.5):
        for y in (0.55, 2.6):
            box(top, (x, y), 0.75, 0.26)
    arrow(top, (2.5, 1.7), (4.0, 1.7), "x", at=(0.1, 0.16))
    arrow(top, (2.5, 1.7), (2.5, 3.05), "y")
    turn(top, (2.5, 1.7), 0.75, (10.0, 75.0), "yaw", color=ORANGE)


def _quarter(axes: Any, x: float) -> None:
    box(axes, (x - 0.9, 3.3), 1.8, 0.7, "mₛ")
    box(axes, (x - 0.6, 1.6), 1.2, 0.5, "mᵤ")
    spring(axes, (x - 0.4, 2.1), (x - 0.4, 3.3), "k")
    damper(axes, (x + 0.4, 2.1), (x + 0.4, 3.3), "c")
    spring(axes, (x - 0.2, 0.6), (x - 0.2, 1.6), "kₜ")
    damper(axes, (x + 0.3, 0.6), (x + 0.3, 1.6), "cₜ")


@drawing(7.6, 4.6, parts=2, size=3.6)
def quarter_car(model: Any, free: Any) -> None:
    """Draw the two masses, and the free-body diagram of each."""
    _quarter(model, 3.0)
    line(model, *[(x, 0.5 + 0.1 * np.sin(2.2 * x)) for x in np.linspace(1.6, 4.6, 60)], width=1.6)
    for height, name in ((3.65, "zₛ  sprung.z"), (1.85, "zᵤ  unsprung.z"), (0.45, "z_r  road.z")):
        line(model, (4.1, height), (5.0, height), color=GREY, width=0.8)
        arrow(model, (4.8, height), (4.8, height + 0.6), name, at=(0.12, -0.1))
    word(model, (3.0, 4.35), "model", bold=True)
    word(free, (3.0, 4.35), "free bodies", bold=True)
    box(free, (2.1, 3.0), 1.8, 0.7, "mₛ")
    box(free, (2.4, 1.3), 1.2, 0.5, "mᵤ")
    arrow(free, (3.0, 2.3), (3.0, 3.0), "F", color=ORANGE, at=(0.15, -0.3))
    arrow(free, (3.0, 2.5), (3.0, 1.8), "F", color=ORANGE, at=(-0.15, 0.3))
    arrow(free, (3.0, 0.4), (3.0, 1.3), "Fₜ", color=GREEN, at=(0.15, -0.5))
    arrow(free, (3.9, 3.35), (3.9, 2.6), "mₛ g", color=GREY, at=(0.12, 0.1))
    arrow(free, (3.6, 1.55), (3.6, 0.8), "mᵤ g", color=GREY, at=(0.12, 0.1))
    word(free, (5.2, 3.6), "F = k d + c ḋ", ha="left", color=ORANGE)
    word(free, (5.2, 3.2), "d = zᵤ − zₛ", ha="left", color=GREY)
    word(free, (5.2, 1.9), "Fₜ = kₜ e + cₜ ė ≥ 0", ha="left", color=GREEN)
    word(free, (5.2, 1.5), "e = z_r − zᵤ", ha="left", color=GREY)


@drawing(10.0, 5.0, size=3.3)
def half_car(axes: Any) -> None:
    """A body on two axles, its heights and its pitch."""
    box(axes, (1.4, 2.6), 7.0, 0.7)
    circle(axes, (5.0, 2.95), 0.09, fill=INK)
    for x, name in ((2.2, "rear"), (7.8, "front")):
        spring(axes, (x - 0.25, 1.0), (x - 0.25, 2.6), "k", coils=6)
        damper(axes, (x + 0.25, 1.0), (x + 0.25, 2.6), "c")
        ground(axes, x - 0.7, x + 0.7, 1.0)
        word(axes, (x, 0.6), name, color=GREY)
        arrow(axes, (x + 0.95, 1.0), (x + 0.95, 1.6), "h", color=GREEN)
    size(axes, (2.2, 4.5), (5.0, 4.5), "L_r  rear.distance", at=(0.0, 0.2))
    size(axes, (5.0, 4.5), (7.8, 4.5), "L_f  front.distance", at=(0.0, 0.2))
    arrow(axes, (5.0, 2.95), (5.0, 2.1), "m g", color=GREY, at=(0.15, 0.1))
    arrow(axes, (9.0, 2.6), (9.0, 3.6), "z  body.z", at=(0.12, 0.0))
    turn(axes, (5.0, 2.95), 0.85, (130.0, 60.0), "", color=ORANGE)
    word(axes, (6.9, 3.7), "θ  body.pitch, nose down positive", color=ORANGE)
    arrow(axes, (5.4, 0.75), (6.6, 0.75), "x, direction of travel", at=(-1.3, -0.3))


def _hardpoints() -> dict[str, np.ndarray]:
    import jounce as jn

    points = jn.load("reference-double-wishbone").hardpoints
    found = {name: getattr(points, name) for name in type(points).model_fields}
    return {name: 10.0 * np.array(point) for name, point in found.items() if point is not None}


@drawing(10.0, 7.6, parts=2, size=4.2)
def double_wishbone(front: Any, side: Any) -> None:
    """The shipped reference mechanism from behind and from the left, with its steering axis."""
    p = _hardpoints()
    for axes, title, at in (
        (front, "left wheel, from behind", _from_behind),
        (side, "left wheel, from the left", _from_left),
    ):
        word(axes, (5.0, 7.3), title, bold=True)
        q = {name: at(point) for name, point in p.items()}
        for arm, color in (("lower", BLUE), ("upper", GREEN)):
            line(
                axes,
                q[f"{arm}_arm_front"],
                q[f"{arm}_ball_joint"],
                q[f"{arm}_arm_rear"],
                color=color,
                width=2.2,
            )
        line(axes, q["tie_rod_inner"], q["tie_rod_outer"], color=ORANGE, width=2.0)
        line(
            axes,
            q["lower_ball_joint"],
            q["upper_ball_joint"],
            q["wheel_centre"],
            q["lower_ball_joint"],
            width=1.8,
        )
        spring(axes, q["strut_bottom"], q["strut_top"], coils=6)
        reach = q["lower_ball_joint"] - q["upper_ball_joint"]
        foot = q["lower_ball_joint"] + reach * (q["lower_ball_joint"][1] - _GROUND) / -reach[1]
        line(axes, q["upper_ball_joint"] - 0.35 * reach, foot, color=PURPLE, dashed=True)
        for point in q.values():
            circle(axes, point, 0.07, fill="#ffffff", width=1.0)
        ground(axes, 0.6, 9.4, _GROUND)
        axes.plot(*foot, "o", color=PURPLE, markersize=4)
        contact = np.array([q["wheel_centre"][0], _GROUND])
        axes.plot(*contact, "^", color=INK, markersize=6)
        if axes is front:
            box(axes, contact + np.array([-0.85, 0.0]), 1.7, 6.0, fill="none")
            size(axes, (foot[0], 0.5), (contact[0], 0.5), "scrub radius", at=(0.0, -0.28))
            word(axes, (7.7, 6.5), "kingpin inclination:\nits top leans inboard", color=PURPLE)
            arrow(axes, (9.2, 1.6), (8.0, 1.6), "y", at=(-0.1, 0.2))
            arrow(axes, (9.2, 1.6), (9.2, 2.8), "z", at=(-0.1, 0.1))
        else:
            circle(axes, q["wheel_centre"], 3.0, fill="none")
            size(axes, (contact[0], 0.5), (foot[0], 0.5), "caster trail", at=(0.0, -0.28))
            word(axes, (8.7, 6.3), "caster: its\ntop leans\nrearward", color=PURPLE)
            arrow(axes, (1.6, 1.5), (0.5, 1.5), "x", at=(0.0, 0.25))
            arrow(axes, (1.6, 1.5), (1.6, 2.7), "z", at=(0.1, 0.1))


_GROUND = 1.0


def _from_behind(point: np.ndarray) -> np.ndarray:
    """Seen along +x: y points to the left."""
    return np.array([11.6 - point[1], _GROUND + point[2]]) * np.array([1.0, 1.0])


def _from_left(point: np.ndarray) -> np.ndarray:
    """Seen along −y: x points to the left."""
    return np.array([5.0 - point[0], _GROUND + point[2]])


@drawing(6.0, 3.8, parts=4, rows=2, size=4.6)
def signs_of_a_wheel(camber: Any, toe: Any, caster: Any, travel: Any) -> None:
    """Positive camber, toe, steer and bump travel of the left front wheel."""
    word(camber, (2.2, 3.6), "camber > 0", bold=True)
    lean = np.radians(12.0)
    middle, half, width = np.array([1.5, 1.75]), 1.15, 0.32
    up, out = np.array([-np.sin(lean), np.cos(lean)]), np.array([np.cos(lean), np.sin(lean)])
    corners = [
        middle + a * half * up + b * width * out
        for a, b in ((1, 1), (1, -1), (-1, -1), (-1, 1), (1, 1))
    ]
    line(camber, *corners)
    line(camber, (middle[0] + 0.24, 0.6), (middle[0] + 0.24, 3.2), color=GREY, dashed=True)
    ground(camber, 0.5, 3.6, 0.55)
    arrow(camber, (2.5, 1.5), (3.5, 1.5), "to the car", color=GREY)
    word(
        camber, (4.0, 2.9), "left wheel, from behind:\nits top leans outward", ha="left", color=GREY
    )
    word(toe, (2.2, 3.6), "toe > 0", bold=True)
    for y, sense in ((2.6, -1.0), (1.2, 1.0)):
        a = np.radians(9.0) * sense
        line(
            toe,
            (2.2 - 0.8 * np.cos(a), y - 0.8 * np.sin(a)),
            (2.2 + 0.8 * np.cos(a), y + 0.8 * np.sin(a)),
            width=7.0,
        )
        line(toe, (1.1, y), (3.4, y), color=GREY, width=0.8, dashed=True)
    arrow(toe, (2.9, 1.9), (3.8, 1.9), "x", at=(-0.2, 0.2))
    word(
        toe,
        (4.0, 2.9),
        "from above:\nin at the front.\nsteer counts to the\nleft on both sides",
        ha="left",
        color=GREY,
    )
    word(caster, (2.2, 3.6), "bump > 0", bold=True)
    box(caster, (1.2, 2.6), 2.0, 0.5, "body")
    circle(caster, (2.2, 1.35), 0.75)
    ground(caster, 0.8, 3.6, 0.6)
    arrow(caster, (3.3, 1.1), (3.3, 2.1), "wheel\ntravel", at=(0.1, -0.2))
    word(
        caster,
        (4.0, 2.6),
        "towards the body;\ncompression and its\nforce are positive",
        ha="left",
        color=GREY,
    )
    word(travel, (2.2, 3.6), "sizes of a strut", bold=True)
    spring(travel, (1.2, 0.7), (1.2, 2.9), coils=6)
    damper(travel, (2.0, 0.7), (2.0, 2.9))
    line(travel, (0.9, 0.7), (2.3, 0.7), width=2.0)
    line(travel, (0.9, 2.9), (2.3, 2.9), width=2.0)
    size(travel, (2.7, 0.7), (2.7, 2.9), "length", at=(0.6, -0.6))
    word(travel, (4.0, 2.6), "deflection =\ndesign length\n− length", ha="left", color=GREY)


@drawing(6.4, 5.0, parts=2, size=3.7)
def testers(eusama: Any, theta: Any) -> None:
    """Draw a rigidly driven plate (EUSAMA, EGEA) and a plate on a spring (THETA)."""
    for axes, title in (
        (eusama, "EUSAMA, EGEA: a rigid plate"),
        (theta, "THETA: a plate on a spring"),
    ):
        word(axes, (3.2, 4.8), title, bold=True)
        box(axes, (2.3, 3.95), 1.8, 0.55, "body")
        spring(axes, (2.9, 3.0), (2.9, 3.95), "")
        damper(axes, (3.5, 3.0), (3.5, 3.95), "")
        box(axes, (2.6, 2.6), 1.2, 0.4, "wheel")
        spring(axes, (3.2, 1.95), (3.2, 2.6), "", coils=4)
        box(axes, (2.0, 1.6), 2.4, 0.35, "plate")
        arrow(axes, (4.7, 1.5), (4.7, 2.2), "z_p", at=(0.1, 0.0))
        ground(axes, 1.2, 5.2, 0.35)
    line(eusama, (3.2, 1.6), (3.2, 1.0))
    box(eusama, (2.95, 1.2), 0.5, 0.22, fill=ORANGE)
    word(eusama, (2.75, 1.3), "force F_p", ha="right", color=ORANGE)
    circle(eusama, (3.2, 0.72), 0.3)
    eusama.plot([3.2, 3.35], [0.72, 0.85], color=INK, linewidth=2.0)
    word(eusama, (3.75, 0.75), "eccentric,\n3 mm, 25 Hz and down", ha="left", color=GREY)
    spring(theta, (2.5, 0.95), (2.5, 1.6), "k_p", coils=4)
    box(theta, (2.1, 0.75), 0.8, 0.2)
    arrow(theta, (1.5, 0.55), (1.5, 1.15), "e(t)", color=GREEN, at=(-0.1, 0.0))
    word(
        theta,
        (3.1, 0.9),
        "the plate's own motion\nis measured: its decay\ntells the damping ratio",
        ha="left",
        color=GREY,
    )
    line(theta, (2.5, 0.75), (2.5, 0.35), width=2.0)


@drawing(10.0, 10.0, parts=1, size=3.0)
def tester_signals(axes: Any) -> None:
    """Show adhesion and phase angle in a simulated cycle of a plate."""
    import jounce as jn
    from jounce.parts.testers import load_tester
    from jounce.testers.plate_response import steady_response

    rig, tester, frequency = jn.load("audi-a6-quarter-car"), load_tester("eusama"), 12.0
    answer = complex(np.ravel(steady_response(rig, tester, [frequency]).force_response)[0])
    static = (rig.sprung.mass + rig.unsprung.mass) * 9.81
    time = np.linspace(0.0, 0.16, 600)
    wave = np.exp(2j * np.pi * frequency * time)
    height, force = 3.0 * wave.imag, (static + tester.amplitude * (answer * wave).imag) / static
    axes.set_axis_on()
    axes.set_aspect("auto")
    axes.set_xlim(0.0, 160.0)
    axes.set_ylim(0.0, 2.0)
    axes.plot(1e3 * time, force, color=ORANGE, label="contact force over static")
    axes.plot(1e3 * time, 1.0 + height / 10.0, color=BLUE, label="plate, ten times 1/mm, about 1")
    axes.axhline(1.0, color=GREY, linewidth=0.8)
    least = int(np.argmin(force))
    axes.annotate(
        "", xy=(1e3 * time[least], force[least]), xytext=(1e3 * time[least], 0.0),
        arrowprops={"arrowstyle": "<->", "color": GREEN},
    )  # fmt: skip
    axes.text(1e3 * time[least] + 2.0, 0.12, f"adhesion {100 * force[least]:.0f} %", color=GREEN)
    top = int(np.argmax(height[: len(time) // 2]))
    low = top + int(np.argmin(force[top : top + 300]))
    axes.annotate(
        "",
        xy=(1e3 * time[low], 1.5),
        xytext=(1e3 * time[top], 1.5),
        arrowprops={"arrowstyle": "->", "color": PURPLE},
    )
    for place in (top, low):
        axes.plot([1e3 * time[place]] * 2, [0.6, 1.55], color=PURPLE, linewidth=0.8)
    angle = 360.0 * frequency * (time[low] - time[top])
    axes.text(1e3 * time[low] + 2.0, 1.5, f"phase angle {angle:.0f}°", color=PURPLE, va="center")
    axes.set_xlabel("time [ms], at 12 Hz")
    axes.legend(loc="upper right", ncols=2)


@drawing(10.0, 4.6, size=3.4)
def bench(axes: Any) -> None:
    """The prototype's bench: a belt that runs under a quarter of a car."""
    for x in (1.6, 6.4):
        circle(axes, (x, 1.2), 0.6)
    line(axes, (1.6, 1.8), (6.4, 1.8), width=2.0)
    line(axes, (1.6, 0.6), (6.4, 0.6), width=2.0)
    box(axes, (2.6, 1.5), 2.8, 0.18, fill=GREY)
    line(
        axes,
        *[(5.2 + 0.01 * i, 1.8 + 0.22 * np.sin(np.pi * i / 60)) for i in range(61)],
        color=ORANGE,
        width=2.4,
    )
    arrow(axes, (3.4, 0.85), (2.4, 0.85), "")
    word(axes, (3.4, 1.1), "belt, 1.97 m round", color=GREY)
    arrow(axes, (5.6, 2.25), (4.9, 2.25), "obstacle", color=ORANGE, at=(0.75, 0.2))
    circle(axes, (4.0, 2.3), 0.5)
    spring(axes, (4.0, 2.3), (4.5, 3.5), coils=6)
    line(axes, (4.0, 2.3), (6.0, 2.7), width=2.0)
    box(axes, (3.8, 3.5), 2.4, 0.5, "sprung mass")
    line(axes, (6.0, 2.7), (6.0, 3.5), width=2.0)
    for x in (4.2, 5.8):
        line(axes, (x, 4.0), (x, 4.5), width=2.4)
    word(axes, (6.3, 4.3), "vertical guide, with friction", ha="left", color=GREY)
    size(axes, (1.6, 1.2), (2.2, 1.2), "R", at=(0.0, 0.18))
    box(axes, (8.0, 0.8), 1.3, 0.8, "motor,\ninverter")
    line(axes, (7.0, 1.2), (8.0, 1.2), dashed=True)
    word(axes, (8.65, 0.45), "2 : 1 to the cylinder", color=GREY)
    word(axes, (2.0, 3.6), "strut at 26°\nto the vertical", color=GREY)


@drawing(7.0, 5.4, parts=1, size=3.4)
def free_upright(axes: Any) -> None:
    """Free-body diagram of an upright: forces of rods and spring along their lines, road force at the contact point."""
    upper, lower, rod, centre = (
        np.array([2.9, 4.2]),
        np.array([2.6, 2.0]),
        np.array([2.9, 2.5]),
        np.array([2.0, 3.1]),
    )
    contact = np.array([1.9, 0.6])
    box(axes, centre + np.array([-0.75, -2.5]), 1.3, 4.8, fill="none")
    line(axes, lower, upper, centre, lower, width=1.8)
    line(axes, rod, centre, width=1.8)
    for point in (upper, lower, rod, centre):
        circle(axes, point, 0.07, fill="#ffffff")
    arrow(axes, upper, upper + np.array([1.4, -0.1]), "upper arm", color=GREEN)
    arrow(axes, lower + np.array([1.5, -0.05]), lower + np.array([0.1, 0.0]), "", color=BLUE)
    word(axes, lower + np.array([1.6, -0.05]), "lower arm", color=BLUE, ha="left")
    arrow(axes, rod + np.array([1.3, 0.02]), rod + np.array([0.1, 0.0]), "", color=ORANGE)
    word(axes, rod + np.array([1.4, 0.02]), "tie rod", color=ORANGE, ha="left")
    arrow(axes, lower + np.array([0.25, 1.2]), lower + np.array([0.05, 0.1]), "", color=PURPLE)
    word(
        axes,
        lower + np.array([0.5, 1.1]),
        "spring and damper, by the lower arm",
        color=PURPLE,
        ha="left",
    )
    arrow(axes, contact + np.array([0.0, -0.6]), contact, "F_z", color=INK, at=(0.1, -0.45))
    arrow(axes, contact, contact + np.array([0.9, 0.0]), "F_y", color=INK, at=(0.1, 0.0))
    ground(axes, 0.6, 6.0, 0.6)
    word(axes, (4.6, 5.1), "left wheel, from behind", bold=True)


@drawing(8.2, 6.4, parts=2, size=4.2)
def contact_point(leaning: Any, guided: Any) -> None:
    """Inclined wheel: the lowest point of its disc, and the vertical spring of a corner on a guide."""
    lean, loaded, free, road = np.radians(14.0), 2.0, 2.4, 1.2
    down, out = np.array([np.sin(lean), -np.cos(lean)]), np.array([np.cos(lean), np.sin(lean)])
    contact = np.array([3.4, road])
    centre = contact - loaded * down
    for axes, title in (
        (leaning, "cars; a corner on a radial tyre"),
        (guided, "a corner on its guide, vertical tyre"),
    ):
        word(axes, (4.1, 6.1), title, bold=True)
        ends = [
            centre + a * free * down + 0.4 * b * out
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))
        ]
        line(axes, *(end for end in ends), color=GREY, width=1.0)
        ground(axes, 0.5, 7.8, road)
        circle(axes, centre, 0.09, fill="#ffffff")
        arrow(axes, centre, centre - 1.3 * out, "a", color=GREEN, at=(-0.1, 0.15))
        line(axes, centre, centre + free * down, color=GREY, dashed=True)
        size(axes, (6.4, road), (6.4, centre[1]), "h", at=(0.25, 0.0))
        line(axes, (centre[0] + 0.3, centre[1]), (6.6, centre[1]), color=GREY, width=0.7)
    leaning.plot(*contact, "^", color=INK, markersize=6)
    arrow(leaning, centre, centre + 1.1 * down, "d", color=GREEN, at=(0.2, 0.35))
    arrow(leaning, contact - [0.0, 1.0], contact, "N", color=BLUE, at=(-0.15, -0.7))
    arrow(leaning, contact, contact - [1.3, 0.0], "F_y", color=ORANGE, at=(-0.1, 0.25))
    word(leaning, (5.0, 1.75), "contact point")
    line(leaning, (contact[0] + 0.12, road + 0.08), (4.1, 1.6), color=GREY, width=0.7)
    word(leaning, (5.6, 5.0), "deflection R − h / cos γ", color=GREY)
    spring(guided, (centre[0], road), centre, coils=5)
    arrow(guided, (centre[0], road - 1.0), (centre[0], road), "N", color=BLUE, at=(-0.15, -0.7))
    word(guided, (5.6, 5.0), "deflection R − h", color=GREY)


def _chain(
    axes: Any, boxes: Sequence[tuple[float, float, str]], width: float = 1.9, height: float = 0.75
) -> None:
    for x, y, text in boxes:
        box(axes, (x, y), width, height, text)


@drawing(12.0, 4.4, size=3.0)
def update_loop(axes: Any) -> None:
    """Draw the loop from measurements to a validated or rejected model."""
    _chain(
        axes,
        [
            (0.2, 3.0, "bench tables,\ndecays"),
            (2.9, 3.0, "stiffness,\ndamping"),
            (5.6, 3.0, "model"),
            (8.3, 3.0, "computed\nsignals"),
        ],
    )
    _chain(
        axes,
        [
            (0.2, 0.9, "trials"),
            (8.3, 0.9, "difference"),
            (5.6, 0.9, "parameters\nand intervals"),
            (2.9, 0.9, "verdict on\nheld-out trials"),
        ],
    )
    for a, b in (
        ((2.1, 3.37), (2.9, 3.37)),
        ((4.8, 3.37), (5.6, 3.37)),
        ((7.5, 3.37), (8.3, 3.37)),
        ((9.25, 3.0), (9.25, 1.65)),
        ((8.3, 1.27), (7.5, 1.27)),
        ((6.55, 1.65), (6.55, 3.0)),
        ((5.6, 1.27), (4.8, 1.27)),
    ):
        arrow(axes, a, b)
    line(axes, (1.15, 0.9), (1.15, 0.3), (9.25, 0.3), color=BLUE, width=1.4)
    arrow(axes, (9.25, 0.3), (9.25, 0.9))
    word(axes, (5.2, 0.1), "measured signals", color=GREY)
    word(axes, (7.35, 2.3), "until no step helps", color=GREY, ha="left")


@drawing(12.0, 4.4, size=3.0)
def control_loop(axes: Any) -> None:
    """A sampled controller around a suspension."""
    _chain(
        axes,
        [
            (0.3, 2.8, "road"),
            (3.6, 2.8, "suspension"),
            (8.6, 2.8, "sensors"),
            (3.6, 0.6, "actuator:\nlag, limits"),
            (8.6, 0.6, "law, every\nperiod"),
        ],
    )
    for a, b, text in (
        ((2.2, 3.17), (3.6, 3.17), "height"), ((5.5, 3.17), (8.6, 3.17), "accelerations, deflection"),
        ((9.55, 2.8), (9.55, 1.35), ""), ((8.6, 0.97), (5.5, 0.97), "wanted force or damping"),
        ((4.55, 1.35), (4.55, 2.8), ""),
    ):  # fmt: skip
        arrow(axes, a, b)
        word(axes, ((a[0] + b[0]) / 2, a[1] + 0.22), text, color=GREY)
    word(axes, (9.7, 2.1), "sampled, noise", color=GREY, ha="left")
    word(axes, (4.7, 2.1), "force, held in between", color=GREY, ha="left")


def write() -> None:
    """Write all drawings to the documentation."""
    source = Path(__file__).read_text(encoding="utf-8")
    for name, make in DRAWINGS.items():
        drawn.write(f"drawing-{name}", make, source)


if __name__ == "__main__":
    write()
