"""``jounce design``: springs for a frequency, best numbers within bounds, the trade of comfort and road holding."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.design_tables import draw_front, draw_optimisation, draw_springs
from jounce.cli.options import (
    AsJson,
    Changes,
    Force,
    VehicleName,
    bare_number,
    changes,
    optional_positive,
    optional_quantity,
    pairs,
    positive_quantity,
    quantity,
)
from jounce.cli.outputs import FigureFile, check_outputs, write_picture
from jounce.cli.reply import Reply, progress
from jounce.cli.rigs import chosen_rig
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    from jounce.parts import Rig

app = typer.Typer(no_args_is_help=True, help="Springs, dampers and best designs.")
FreeNumbers = Annotated[
    list[str],
    typer.Option(
        "--free",
        metavar="PATH=BOUNDS",
        help='What may vary: front.spring_rate="±30 %" or "20..40 N/mm". Repeat it.',
    ),
]
Limits = Annotated[
    list[str] | None,
    typer.Option(
        "--limit",
        metavar="METRIC=LIMIT",
        help='What must hold: strut.deflection="20 mm" (at most), "mode 1 frequency"="1.2..1.5 Hz". Repeat it.',
    ),
]
DesignRoad = Annotated[
    str, typer.Option(help="A class of ISO 8608 (iso:A to iso:H), or its roughness G_d(0.1 1/m), e.g. 256e-6 m^3.")
]
DesignSpeed = Annotated[str, typer.Option(help='Speed over the road, e.g. "20 m/s".')]
RoadBand = Annotated[
    str | None,
    typer.Option(
        "--band", help='Waves of the road: iso (0.011 to 2.83 1/m) or "0.02..3"; by default all where that is finite.'
    ),
]
RigFile = Annotated[Path | None, typer.Option(help="Write the design as a rig file, RIG.toml.")]


@app.command("springs")
def springs(
    vehicle: VehicleName,
    frequency: Annotated[
        str, typer.Option(help='Natural frequency of the body, e.g. "1.2 Hz"; front, if both are given.')
    ],
    damping_ratio: Annotated[str, typer.Option(help="Of critical, e.g. 0.3 or 30 %.")],
    rear_frequency: Annotated[str | None, typer.Option(help="Of the rear axle, if another one.")] = None,
    rear_damping_ratio: Annotated[str | None, typer.Option(help="Of the rear axle, if another one.")] = None,
    with_tyre: Annotated[bool, typer.Option(help="The frequency is that of spring and tyre in series.")] = False,
    set_: Changes = None,
    out: RigFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Give springs and dampers for a natural frequency and a damping ratio, beside those that the vehicle has.

    Example: jounce design springs audi-a6-full-car --frequency "1.2 Hz" --rear-frequency "1.35 Hz" --damping-ratio 0.3
    """
    check_outputs(rig=out, force=force)
    target = positive_quantity(frequency, "Hz", "--frequency")
    share = quantity(damping_ratio, "1", "--damping-ratio")
    rear = [
        optional_positive(rear_frequency, "Hz", "--rear-frequency"),
        optional_quantity(rear_damping_ratio, "1", "--rear-damping-ratio"),
    ]
    from jounce.design.first_designs import design_springs

    wanted = changes(set_)
    design = design_springs(
        chosen_rig(vehicle, wanted),
        target if rear[0] is None else (target, rear[0]),
        share if rear[1] is None else (share, rear[1]),
        with_tyre=with_tyre,
    )
    comment = f"Springs and dampers of {vehicle} for {frequency} and a damping ratio of {damping_ratio}."
    _write_rig(design.rig, out, comment, force=force)
    plain = {"rig": vehicle, "set": wanted, **design.to_dict(), "out": out and str(out)}
    return Reply(plain, lambda console: draw_springs(console, plain, design), as_json)


@app.command("optimise")
def optimise(
    vehicle: VehicleName,
    free: FreeNumbers,
    objective: Annotated[
        list[str],
        typer.Option(
            metavar="METRIC[=WEIGHT]",
            help='What is to be small: sprung.az, "sprung.az weighted", "worst tyre.force coefficient". Repeat it.',
        ),
    ],
    road: Annotated[
        str, typer.Option(help="A class (iso:A to iso:H) or roughness; with --duration any road file.")
    ] = "iso:C",
    speed: DesignSpeed = "20 m/s",
    limit: Limits = None,
    duration: Annotated[
        str | None, typer.Option(help="Simulate the road for this long instead of the random response in closed form.")
    ] = None,
    band: RoadBand = None,
    starts: Annotated[int, typer.Option(help="Searches, the first from the vehicle as it is.")] = 1,
    set_: Changes = None,
    out: RigFile = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Find the numbers of a vehicle that make an objective least, within bounds and limits, with exact slopes.

    Example: jounce design optimise kart-quarter-car --free strut.damper.coefficient="50..500" --objective sprung.az
    """
    check_outputs(rig=out, figure=figure, force=force)
    bounds = {path: _bounds(text) for path, text in pairs(free, "--free", 'front.spring_rate="±30 %"').items()}
    limits = {name: _limit(text) for name, text in pairs(limit, "--limit", 'strut.deflection="20 mm"').items()}
    weights = _weights(objective)
    wanted = changes(set_)
    with progress() as say:
        say("loading")
        from jounce.design.optimise import optimise as find_best

        rig = chosen_rig(vehicle, wanted)
        driven = _driven(rig, road, speed, duration, band)
        say("searching")
        found = find_best(rig, bounds, weights, limits, **driven, starts=starts)
    _write_rig(found.rig, out, f"{vehicle}, best for {', '.join(weights)} over {found.driven}.", force=force)
    write_picture(found, figure, force=force)
    plain = {"rig": vehicle, "set": wanted, **found.to_dict(), **_written(out, figure)}
    return Reply(plain, lambda console: draw_optimisation(console, plain, found), as_json)


@app.command("pareto")
def pareto(
    vehicle: VehicleName,
    free: FreeNumbers,
    road: DesignRoad = "iso:C",
    speed: DesignSpeed = "20 m/s",
    comfort: Annotated[str, typer.Option(help="Metric of comfort.")] = "sprung.az",
    holding: Annotated[str, typer.Option(help="Metric of road holding.")] = "tyre.force coefficient",
    travel: Annotated[str, typer.Option(help="Metric that is shown beside them.")] = "strut.deflection",
    limit: Limits = None,
    points: Annotated[int, typer.Option(help="Number of designs.")] = 25,
    band: RoadBand = None,
    set_: Changes = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Give the best designs between comfort and road holding, with the best dampers by closed form and by search.

    Example: jounce design pareto audi-a6-quarter-car --free strut.damper.coefficient="300..6000" --figure front.png
    """
    check_outputs(figure=figure, force=force)
    bounds = {path: _bounds(text) for path, text in pairs(free, "--free", 'front.spring_rate="±30 %"').items()}
    limits = {name: _limit(text) for name, text in pairs(limit, "--limit", 'strut.deflection="20 mm"').items()}
    velocity, waves = positive_quantity(speed, "m/s", "--speed"), _band(band)
    wanted = changes(set_)
    with progress() as say:
        say("loading")
        from jounce.design.pareto import pareto as find_front

        say("searching")
        front = find_front(
            chosen_rig(vehicle, wanted), bounds, road, velocity,
            comfort=comfort, holding=holding, travel=travel, constraints=limits, points=points, band=waves,
        )  # fmt: skip
    write_picture(front, figure, force=force)
    plain = {"rig": vehicle, "set": wanted, **front.to_dict(), "figure": figure and str(figure)}
    return Reply(plain, lambda console: draw_front(console, plain, front), as_json)


def _driven(rig: Rig, road: str, speed: str, duration: str | None, band: str | None) -> dict[str, Any]:
    """Road and speed of a stationary response, or the trial to simulate."""
    velocity = positive_quantity(speed, "m/s", "--speed")
    if duration is None:
        return {"road": road, "speed": velocity, "band": _band(band)}
    if band is not None:
        raise DescriptionError("a simulated road has its own waves", where="--band", hint="Leave out the band.")
    from jounce.ride.study import iso_trial, road_trial
    from jounce.roads import load_road
    from jounce.roads.loading import class_and_seed, is_class

    lasting = positive_quantity(duration, "s", "--duration")
    if is_class(road):
        class_, seed = class_and_seed(road)
        return {"trial": iso_trial(rig, class_, velocity, duration=lasting, seed=seed or 0).trial}
    return {"trial": road_trial(rig, load_road(road), velocity, duration=lasting).trial}


def _pair(text: str) -> tuple[str | float, str | float] | None:
    """Both ends of ``LOW..HIGH UNIT``; a unit behind the second is that of both. None where the text is no range."""
    low, dots, high = text.partition("..")
    if not dots:
        return None
    first, second = bare_number(low.strip()), bare_number(high.strip())
    if isinstance(first, float) and isinstance(second, str):
        unit = second.lstrip("+-0123456789.eE ")
        return f"{low.strip()} {unit}", second
    return first, second


def _bounds(text: str) -> Any:
    return _pair(text) or text


def _limit(text: str) -> Any:
    return _pair(text) or text


def _band(text: str | None) -> Any:
    if text is None or text == "iso":
        return text
    ends = _pair(text)
    if ends is None:
        raise DescriptionError(
            "not a band of spatial frequencies", where="--band", found=text, allowed="iso, LOW..HIGH"
        )
    return tuple(quantity(str(end), "1/m", "--band") for end in ends)


def _weights(texts: list[str]) -> dict[str, float]:
    """Weights by metric; 1 where none is given."""
    found: dict[str, float] = {}
    for text in texts:
        name, equals, weight = text.partition("=")
        if name.strip() in found:
            raise DescriptionError("given twice", where="--objective", found=name.strip())
        found[name.strip()] = quantity(weight, "1", f"--objective {name.strip()}") if equals else 1.0
    return found


def _write_rig(rig: Rig, out: Path | None, comment: str, *, force: bool) -> None:
    if out is not None:
        from jounce.core.serialise import write_atomically
        from jounce.parts.files import rig_text

        write_atomically(out, rig_text(rig, [comment]), force=force)


def _written(out: Path | None, figure: Path | None) -> dict[str, str | None]:
    return {name: None if file is None else str(file) for name, file in (("out", out), ("figure", figure))}
