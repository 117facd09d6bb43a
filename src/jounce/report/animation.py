"""Animation of a 3-D rig: an interactive page, or a film."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import size
from jounce.core.errors import DescriptionError
from jounce.core.writing import Formats
from jounce.plots.mechanisms.animation import FILMS, Animation, ffmpeg, film_poses, motion_of
from jounce.plots.mechanisms.drawing import mechanism
from jounce.report.live import Viewer
from jounce.report.page import Details, Page, Picture, Section
from jounce.report.recordings import curve_blocks
from jounce.report.render import REPORTS

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts.corners import Corner
    from jounce.roads import Trial


_MOST_IN_PAGE = 1000
_FIRST = (
    "tyre.force",
    "strut.force",
    "wheel.camber",
    "camber",
    "toe",
    "motion_ratio",
    "wheel_rate",
)
_MOST_CURVES = 3


def animate(
    rig: Corner,
    poses: xr.Dataset,
    path: Path | str,
    *,
    trial: Trial | None = None,
    between: tuple[float | str, float | str] | None = None,
    slow: float = 5.0,
    frames: int | None = None,
    title: str = "",
    force: bool = False,
    progress: Callable[[str], None] = lambda _text: None,
) -> Path:
    """Animate a sweep or a run of a 3-D rig; the suffix of the file selects the format.

    Parameters
    ----------
    rig : Corner
        Rig to animate.
    poses : xarray.Dataset
        A sweep (``jn.sweep_travel(rig, ..., points=True)``) or a run (``jn.simulate(rig, trial, detail=True)``).
    path : Path or str
        ``.html`` (a self-contained page to rotate, play and read values, usable offline), ``.gif``, or ``.mp4``
        (requires ffmpeg).
    trial : Trial, optional
        Trial of the run, whose road passes under the wheel; by default a plate moves the wheel.
    between : tuple, optional
        First and last travel (m) or time (s), or texts with units, to show only this range.
    slow : float
        Slow-motion factor of a run [1].
    frames : int, optional
        Maximum number of poses; by default 1000 in a page and 300 in a film. A film of a run uses at most 25 poses
        per second.
    title : str
        Heading; model and side by default.
    force : bool
        Overwrite an existing file.
    progress : callable
        Called with a one-line message at each stage.

    Returns
    -------
    Path
        The file written; the same input gives the same page.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or an unsupported suffix.
    MissingPackageError
        For ``.mp4`` without ffmpeg.
    DescriptionError
        If the poses do not belong to this trial, or do not cover the requested range.
    RecordingError
        For poses without hardpoints.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import jounce as jn
    >>> rig = jn.load("kart-double-wishbone")
    >>> sweep = jn.sweep_travel(rig, [-0.02, 0.0, 0.02], points=True)
    >>> animate(rig, sweep, pathlib.Path(tempfile.mkdtemp()) / "motion.html").name
    'motion.html'
    """
    file = check_animation(path, force=force)
    if frames is not None and frames < 1:
        raise DescriptionError("out of range", where="frames", found=frames, allowed="at least 1")
    is_page = file.suffix.lower() == ".html"
    most = (lambda _seconds: frames or _MOST_IN_PAGE) if is_page else film_poses(frames)
    motion = motion_of(
        rig, poses, trial=trial, between=between, slow=slow, most=most, title=title, say=progress
    )
    return ANIMATIONS.write(
        _page(motion, rig, poses, trial) if is_page else motion, file, force=force
    )


def check_animation(path: Path | str, *, force: bool = False) -> Path:
    """Check in advance that a file can be written: suffix, folder, existing file, ffmpeg."""
    file = ANIMATIONS.check(path, force=force)
    if file.suffix.lower() == ".mp4":
        ffmpeg()
    return file


def _page(motion: Animation, rig: Corner, poses: xr.Dataset, trial: Trial | None) -> Page:
    """Return a page with a large view of the mechanism next to its curves."""
    shown = motion.poses
    (dimension,) = map(str, poses["wheel_centre.z"].dims)
    over = shown.words.replace(" ", "_")
    data = poses if over == dimension else poses.swap_dims({dimension: over})
    data = data.isel({over: np.flatnonzero(np.isin(data[over].to_numpy(), shown.over))})
    first = [name for name in _FIRST if name in data and data[name].dims == (over,)][:_MOST_CURVES]
    viewer, still = curve_blocks({"": {motion.title: data}}, first or None, rig=rig, trial=trial)
    assert isinstance(viewer, Viewer)
    slower = motion.slow if shown.in_time else None
    ends = " to ".join(shown.label(k).removeprefix(f"{shown.words} ") for k in (0, -1))
    driven = (
        "" if trial is None or trial.speed is None else f" at {size(trial.speed, 'm/s', 'speed')}"
    )
    words = "The mechanism in its design position, in three views and in space."
    drawn = Picture(mechanism(rig), "mechanism", words, words)
    assert isinstance(still, Details)
    figures = replace(still, summary="The same as figures", blocks=(drawn, *still.blocks))
    section = Section("In motion", (replace(viewer, stage=True, slower=slower), figures))
    return Page(
        motion.title, (section,), f"{shown.words.capitalize()} {ends}{driven}".replace("Time ", "")
    )


ANIMATIONS = Formats("animations", {".html": REPORTS.writers[".html"], **FILMS.writers})
"""Writers of an animation: a page, or a film."""
