"""Mechanisms in motion: a page for the browser, a GIF, an MP4."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.serialise import check_writable, replacing, write_atomically
from jounce.plots.films import FRAMES_A_SECOND, ffmpeg, film_length, gif, mp4
from jounce.plots.poses import Poses, poses_of
from jounce.plots.roadways import Roadway, roadway_of
from jounce.plots.scenes import Scene, scene_of
from jounce.plots.viewer import viewer_page

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts.corners import Corner
    from jounce.roads import Trial

ANIMATIONS = (".html", ".gif", ".mp4")
_MOST_IN_PAGE, _MOST_IN_FILM = 1000, 300
_SAME_HEIGHT = 1e-4  # m
_AT_JUMPS = 0.02  # share of the samples


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
    """Show a sweep or a run of a 3-D rig in motion; the suffix chooses how.

    Parameters
    ----------
    rig : Corner
        What moves.
    poses : xarray.Dataset
        A sweep (``jn.sweep_travel(rig, ..., points=True)``) or a run (``jn.simulate(rig, trial, detail=True)``).
    path : Path or str
        ``.html`` (one page that opens anywhere without a network: turn, play, read values), ``.gif``, or ``.mp4``
        (through ffmpeg).
    trial : Trial, optional
        What the run was driven over: its road then passes under the wheel; otherwise a plate lifts the wheel.
    between : tuple, optional
        First and last travel (m) or time (s), or texts with units, to show only a part.
    slow : float
        How many times slower than in reality a run is played [1].
    frames : int, optional
        The most poses to show; by default 1000 in a page and 300 in a film. A film of a run takes no more than it needs
        for 25 pictures a second.
    title : str
        Heading; model and side by default.
    force : bool
        Overwrite an existing file.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    Path
        The file written; the same input gives the same page.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or another suffix.
    MissingPackageError
        For ``.mp4`` without ffmpeg.
    DescriptionError
        When the poses are not of this trial, or for a part that they do not reach.
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
    if not (np.isfinite(slow) and slow > 0.0):
        raise DescriptionError("out of range", where="slow", found=slow, allowed="above 0")
    if frames is not None and frames < 1:
        raise DescriptionError("out of range", where="frames", found=frames, allowed="at least 1")
    scene = scene_of(rig)
    tracks = _part(poses_of(rig, scene, poses), between)
    kept = _thinned(tracks, file.suffix.lower(), slow, frames)
    road = _road(trial, tracks, kept, scene)
    heading = title or scene.title[0].upper() + scene.title[1:]
    if file.suffix.lower() == ".html":
        return write_atomically(file, viewer_page(scene, kept, road, heading, slow), force=force)
    length = film_length(kept, slow)
    if file.suffix.lower() == ".gif":
        return write_atomically(file, gif(scene, kept, road, heading, length, progress), force=force)
    with replacing(file) as temporary:
        mp4(scene, kept, road, heading, length, progress, temporary)
    return file


def check_animation(path: Path | str, *, force: bool = False) -> Path:
    """Refuse, before the work, a file that could not be written: its suffix, its folder, what stands there, ffmpeg."""
    file = check_writable(path, what="animations", suffixes=ANIMATIONS, force=force)
    if file.suffix.lower() == ".mp4":
        ffmpeg()
    return file


def _part(poses: Poses, between: tuple[float | str, float | str] | None) -> Poses:
    from jounce.core.units import to_si

    if between is None:
        return poses
    first, last = sorted(poses.nearest(to_si(value, poses.unit, where="between"), "between") for value in between)
    return poses.taken(slice(first, last + 1))


def _thinned(poses: Poses, suffix: str, slow: float, frames: int | None) -> Poses:
    """No more poses than can be shown, evenly chosen."""
    most = frames or (_MOST_IN_PAGE if suffix == ".html" else _MOST_IN_FILM)
    if suffix != ".html" and poses.in_time:
        most = min(most, max(2, round(FRAMES_A_SECOND * film_length(poses, slow)) + 1))
    if len(poses) <= most:
        return poses
    return poses.taken(np.unique(np.round(np.linspace(0, len(poses) - 1, most)).astype(int)))


def _road(trial: Trial | None, poses: Poses, kept: Poses, scene: Scene) -> Roadway | None:
    if trial is None:
        return None
    if not poses.in_time:
        raise DescriptionError("a sweep is not driven; leave out the trial", where="trial")
    expected = trial.segments().evaluate(np.minimum(poses.over, trial.duration))[0]
    if np.mean(np.abs(expected - poses.ground) > _SAME_HEIGHT) > _AT_JUMPS:
        raise DescriptionError(
            "the poses are not of this trial; its road has other heights",
            where="trial",
            hint="Give the trial that the run was simulated with.",
        )
    return roadway_of(trial, kept.over, scene.undeformed_radius)
