"""Overlay of rides of several rigs, vehicles and controllers: over time, and as spectra."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from jounce.core.errors import DescriptionError, JounceError
from jounce.core.phrases import Phrase

if TYPE_CHECKING:
    import xarray as xr

    from jounce.ride.study import Ride

ISO_DURATION = "20 s"
"""Default duration of a ride over a random road, as for the command that compares rides."""
_SHORTEST = 8.0  # s, shortest segment of a spectrum, as in the report of a ride
_FIRST = (("body.az", "sprung.az"), ("strut.deflection",), ("tyre.force",))


def overlaid(asked: Mapping[str, Any]) -> dict[str, Any]:
    """Simulate all requested rides; return curves, notes on corner mapping, and failed rides."""
    from jounce.report.live import live_data
    from jounce.report.recordings import curve_viewer
    from jounce.web.spectra import spectra_of

    rides: dict[str, Ride] = {}
    failed: dict[str, str] = {}
    for ride, label in zip(asked["rides"], labels(asked["rides"]), strict=True):
        try:
            rides[label] = _simulate_ride(ride)
        except JounceError as error:
            failed[label] = error.message()
    if not rides:
        raise DescriptionError(
            Phrase(
                "none of the rides could be simulated: {values}", values="; ".join(failed.values())
            ),
            where="rides",
        )
    runs, notes = alike({label: ride.evaluated_run for label, ride in rides.items()})
    spectra = spectra_of(runs, shortest=_SHORTEST)
    viewers = [
        curve_viewer({"": curves}, _first(curves), name=name)
        for name, curves in (("time", runs), ("spectra", spectra))
    ]
    return {"content": live_data(viewers), "notes": notes, "failed": failed}


def _simulate_ride(asked: Mapping[str, Any]) -> Ride:
    import jounce as jn
    from jounce.ride.study import iso_trial, road_trial
    from jounce.roads.loading import class_and_seed, is_class

    rig = jn.load(asked["vehicle"])
    if asked["changes"]:
        rig = rig.with_changes(dict(asked["changes"]))
    road, speed, duration = (asked[name] for name in ("road", "speed", "duration"))
    if is_class(road):
        name, seed = class_and_seed(road)
        trial = iso_trial(
            rig,
            name,
            speed,
            duration=duration or ISO_DURATION,
            seed=asked["seed"] if seed is None else seed,
        )
    else:
        trial = road_trial(rig, jn.load_road(road), speed, duration=duration or None)
    return jn.compare_rides(rig, trial, [asked["control"]]).rides[0]


def labels(rides: Sequence[Mapping[str, Any]]) -> list[str]:
    """Label rides by vehicle, controller, and any other settings that differ.

    Examples
    --------
    >>> one = {"vehicle": "a.toml", "road": "iso:C", "speed": "20 m/s", "control": "passive", "changes": {}}
    >>> labels([one, one | {"control": "skyhook", "speed": "30 m/s"}])
    ['a, passive, 20 m/s', 'a, skyhook, 30 m/s']
    """
    apart = [
        name
        for name in ("road", "speed", "duration", "seed")
        if len({str(ride.get(name)) for ride in rides}) > 1
    ]
    texts: list[str] = []
    for ride in rides:
        changes = (f"{path} = {value}" for path, value in ride["changes"].items())
        words = [
            ride["vehicle"].removesuffix(".toml"),
            ride["control"],
            *(str(ride[name]) for name in apart if ride[name]),
            *changes,
        ]
        text = ", ".join(words)
        texts.append(text if text not in texts else f"{text} ({len(texts) + 1})")
    return texts


def alike(runs: Mapping[str, xr.Dataset]) -> tuple[dict[str, xr.Dataset], list[str]]:
    """Rename corners to those of the most detailed run, and return notes on the mapping.

    A rig with one corner is shown as the front (left) corner and its sprung mass also as the body. Axles are shown as
    their left corners.
    """
    kinds = {label: _corners(run) for label, run in runs.items()}
    if len(set(kinds.values())) == 1:
        return dict(runs), []
    place = "front_left" if max(kinds.values()) == 4 else "front"
    aligned, notes = {}, []
    for label, run in runs.items():
        names = [str(name) for name in run.data_vars]
        if kinds[label] == 1:
            body = {
                f"body.{name[7:]}": run[name].assign_attrs(long_name="")
                for name in names
                if name[:7] == "sprung."
            }
            aligned[label] = run.rename({name: f"{place}.{name}" for name in names}).assign(body)
            notes.append(
                f"{label}: it has one corner, which is drawn as {place}, its sprung mass as the body, too."
            )
        elif kinds[label] == 2 and place == "front_left":
            sides = {"front": "front_left", "rear": "rear_left"}
            parts = {name: name.partition(".") for name in names}
            aligned[label] = run.rename(
                {name: f"{sides.get(a, a)}{dot}{b}" for name, (a, dot, b) in parts.items()}
            )
            notes.append(f"{label}: its axles are drawn as left corners.")
        else:
            aligned[label] = run
    return aligned, notes


def _corners(run: xr.Dataset) -> int:
    names = [str(name) for name in run.data_vars]
    if any(name.startswith("front_left.") for name in names):
        return 4
    return 2 if any(name.startswith(("front.", "rear.", "body.")) for name in names) else 1


def _first(runs: Mapping[str, xr.Dataset]) -> list[str]:
    """Return the initially shown channels, among those that all runs contain."""
    held = [
        name
        for name in map(str, next(iter(runs.values())).data_vars)
        if all(name in run for run in runs.values())
    ]
    candidates = [
        next((name for end in ends for name in held if name.endswith(end)), "") for ends in _FIRST
    ]
    return [name for name in candidates if name] or held[:1]
