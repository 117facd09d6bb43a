"""The numbers of both pages on the prototype paper: its strategies on benches with known values, and the whole vehicle.

``python docs/make_prototype.py`` runs the benches (half an hour on one core) and stores the results in
``explanation/quarter-car-prototype.json``; with names of benches it runs only these. The page reads tables and numbers
from there.
"""

from __future__ import annotations

import json
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

FILE = Path(__file__).parent / "explanation" / "quarter-car-prototype.json"
PROTOTYPE, LOW = "kart-prototype", "kart-low-friction"
REPRESENTED = 0.95
BODY, WHEEL = "sprung.az", "unsprung.az"
ALL = tuple(range(1, 17))


@dataclass(frozen=True)
class Bench:
    """A truth with changes, and the options of its campaign."""

    truth: str
    what: str = ""  # is changed, in the words of the table of causes; empty where it is not there
    changes: dict[str, Any] = field(default_factory=dict)
    file: str = "campaign.toml"
    weights: str = "printed"
    decay: str = "viscous-and-coulomb"
    seed: int = 2008
    strategies: int = 3
    trials: tuple[int, ...] = (1, 9)


def _friction(strut: str, guide: str) -> dict[str, Any]:
    return {"rig.strut.friction.force": strut, "rig.guide_friction.force": guide}


def _settling(way: str, force: str) -> dict[str, Any]:
    return {"standing_tyre.settling": way, "standing_tyre.settling_force": force}


_DEGRESSIVE = {
    "velocity": [-1.2, -0.5, -0.15, 0.0, 0.15, 0.5, 1.2],
    "force": [-190.0, -92.0, -32.0, 0.0, 23.0, 66.0, 136.0],
}
BENCHES = {
    "prototype": Bench(PROTOTYPE, "nothing", strategies=4, trials=ALL),
    "little friction": Bench(
        PROTOTYPE, "dry friction 1 N and 1.5 N in place of 5 N and 9 N", _friction("1 N", "1.5 N")
    ),
    "viscous": Bench(
        PROTOTYPE, "viscous damper, 85 N s/m", {"rig.strut.damper": {"coefficient": "85 N*s/m"}}
    ),
    "two masses": Bench(
        PROTOTYPE, "two masses in place of the linkage (`quick-look.toml`)", file="quick-look.toml"
    ),
    "low": Bench(LOW, "nothing", trials=ALL),
    "low, friction": Bench(LOW, "dry friction back to 5 N and 9 N", _friction("5 N", "9 N")),
    "low, degressive": Bench(LOW, "degressive damper back", {"rig.strut.damper": _DEGRESSIVE}),
    "low, settles": Bench(LOW, "settling back to 0.45 mm", _settling("0.45 mm", "50 N")),
    "low, weighted": Bench(LOW, "every channel weighted by its variance", weights="normalised"),
    "low, two masses": Bench(LOW, "two masses in place of the linkage", file="quick-look.toml"),
    "low, decrement": Bench(
        LOW, "damping by the logarithmic decrement", decay="logarithmic-decrement"
    ),
}
Numbers = dict[str, Any]


def run(bench: Bench) -> Numbers:
    """Run a campaign as `jounce campaign synthesise` and `run` do, without later strategies."""
    import jounce as jn
    from jounce.papers.virtual_bench import virtual_bench

    with tempfile.TemporaryDirectory() as folder:
        file = virtual_bench(
            Path(folder) / "bench", bench.truth, changes=bench.changes, seed=bench.seed
        )
        file = file.with_name(bench.file)
        head, *updates = file.read_text(encoding="utf-8").split("[[update]]")
        head, *trials = head.split("[[trial]]")
        head = "[[trial]]".join(
            [head, *(one for i, one in enumerate(trials, 1) if i in bench.trials)]
        )
        head = head.replace("[bench.decay] ", f'[bench.decay]\nmethod = "{bench.decay}" ')
        chosen = [
            one.replace('method = "bfgs"', f'method = "bfgs"\nweights = "{bench.weights}"')
            for one in updates[: bench.strategies]
        ]
        file.write_text("[[update]]".join([head, *chosen]), encoding="utf-8")
        found = jn.run_campaign(file)
    tyre = found.characterisation.tyre["0.31 MPa"]
    strategies = []
    for one in found.strategies:
        split = one.objective_by_channel()
        strategies.append(
            {
                "reduction_percent": one.update.reduction_percent,
                "iterations": one.update.iterations,
                "fitted_on": one.fitted_on[0],
                "share_of_wheel": split[WHEEL][0] / (split[WHEEL][0] + split[BODY][0]),
                "r2": {
                    trial.number: [trial.after.channels[name].r2 for name in (BODY, WHEEL)]
                    for trial in one.trials
                },
                "nrmse": {trial.number: trial.after.channels[WHEEL].nrmse for trial in one.trials},
            }
        )
    return {
        "strategies": strategies,
        "damping": {one.method: one.seen.value for one in found.characterisation.damping_choices},
        "coulomb_force": found.characterisation.decay.coulomb_force.value,
        "tyre_stiffness": tyre.stiffness.value,
        "tyre_under_load": tyre.tangent_stiffness.value,
    }


SPEEDS_OF_VEHICLE = (1.95, 2.86, 3.79)


def whole_vehicle() -> Numbers:
    """Run the whole vehicle over an obstacle under its left wheels, and for comparison a guide alone and a quarter."""
    import numpy as np

    import jounce as jn

    vehicle = jn.load("kart-whole-vehicle")
    guided = vehicle.with_changes({"body.pitch_inertia": 1e6, "body.roll_inertia": 1e6})
    bump = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")

    def largest(run: Any, channel: str) -> float:
        return float(np.abs(run[channel] - run[channel][0]).max())

    def without_contact(run: Any) -> float:
        force = run["front_left.tyre.force"].to_numpy()
        return float(np.count_nonzero(force <= 0.0) * float(run["time"][1] - run["time"][0]))

    rows: Numbers = {
        name: [] for name in ("joint", "guide", "quarter", "joint_off", "guide_off", "roll", "y")
    }
    for speed in SPEEDS_OF_VEHICLE:
        one_side = jn.Trial(road=bump, right=jn.Flat(), speed=speed, duration=1.5)
        turning, sliding = jn.simulate(vehicle, one_side), jn.simulate(guided, one_side)
        quarter = jn.simulate(
            jn.load("kart-double-wishbone"), jn.Trial(road=bump, speed=speed, duration=1.5)
        )
        rows["joint"].append(largest(turning, "front_left.sprung.az"))
        rows["guide"].append(largest(sliding, "front_left.sprung.az"))
        rows["quarter"].append(largest(quarter, "sprung.az"))
        rows["joint_off"].append(without_contact(turning))
        rows["guide_off"].append(without_contact(sliding))
        rows["roll"].append(float(np.degrees(largest(turning, "body.roll"))))
        rows["y"].append(largest(turning, "body.y"))
    body, wheel = vehicle.body, vehicle.front.corner.hardpoints.wheel_centre
    arm = body.joint[2] - body.height
    turns = wheel[1] ** 2 / (body.roll_inertia + body.mass * arm**2)
    turns += vehicle.front.distance**2 / (body.pitch_inertia + body.mass * arm**2)
    return {**rows, "mass": 1.0 / (1.0 / body.mass + turns)}


def table_of_vehicle() -> str:
    """Effect of the joint at each speed."""
    rows = results()["whole vehicle"]
    lines = [
        (
            "acceleration of the body over the front left wheel, guide and joint",
            "joint",
            "{:.1f} m/s²",
            1.0,
        ),
        ("the same, guide alone", "guide", "{:.1f} m/s²", 1.0),
        ("quarter vehicle on its guide (`kart-double-wishbone`)", "quarter", "{:.1f} m/s²", 1.0),
        ("front left wheel without contact, guide and joint", "joint_off", "{:.0f} ms", 1e3),
        ("the same, guide alone", "guide_off", "{:.0f} ms", 1e3),
        ("roll", "roll", "{:.2f}°", 1.0),
        ("centre of gravity to the side", "y", "{:.1f} mm", 1e3),
    ]
    head = [
        "| speed | " + " | ".join(f"{speed:g} m/s" for speed in SPEEDS_OF_VEHICLE) + " |",
        "|---|---:|---:|---:|",
    ]
    body = [
        f"| {what} | " + " | ".join(shown.format(factor * one) for one in rows[key]) + " |"
        for what, key, shown, factor in lines
    ]
    return "\n".join(head + body) + "\n"


def results() -> dict[str, Numbers]:
    """Results of each bench, by its name."""
    found: dict[str, Numbers] = json.loads(FILE.read_text(encoding="utf-8"))
    return found


def _fits(numbers: list[float]) -> str:
    return " / ".join(f"**{one:.3f}**" if one > REPRESENTED else f"{one:.3f}" for one in numbers)


def _fit(strategy: Numbers) -> str:
    return _fits(strategy["r2"][str(strategy["fitted_on"])])


def reductions() -> str:
    """Rows of both benches: reductions in per cent, iterations, R² of body and wheel on the trial that was fitted."""
    rows = []
    for name, key in ((PROTOTYPE, "prototype"), (LOW, "low")):
        cells = [
            f"{one['reduction_percent']:.1f} ({one['iterations']}), {_fit(one)}"
            for one in results()[key]["strategies"][:3]
        ]
        rows.append(" | ".join([f"| ours, `{name}`", *cells]) + " |")
    paper = "| paper | 31.4 (4), body only | 65.5 (6), body and wheel | 52.0 (3), body and wheel |"
    return (
        "\n".join(["| | strategy 1 | strategy 2 | strategy 3 |", "|---|---|---|---|", paper, *rows])
        + "\n"
    )


def causes() -> str:
    """R² of body and wheel after strategies 1 and 2, for each single change."""
    lines, before = (
        ["| bench | what is changed | after strategy 1 | after strategy 2 |", "|---|---|---|---|"],
        "",
    )
    for name, bench in BENCHES.items():
        if bench.what:
            first, second, *_ = results()[name]["strategies"]
            shown, before = f"`{bench.truth}`" if bench.truth != before else "", bench.truth
            lines.append(f"| {shown} | {bench.what} | {_fit(first)} | {_fit(second)} |")
    return "\n".join(lines) + "\n"


def numbers() -> dict[str, str]:
    """Numbers in the page's sentences, by their placeholders."""
    kept = results()

    def wheel(name: str, number: int, strategy: int = 2) -> str:
        return f"{kept[name]['strategies'][strategy - 1]['r2'][str(number)][1]:.3f}"

    def trains(name: str, strategy: int) -> str:
        misfits = kept[name]["strategies"][strategy - 1]["nrmse"]
        return ", ".join(f"{misfits[str(number)]:.2f}" for number in (4, 5, 6))

    less = [f"{one['reduction_percent']:.0f}" for one in kept["little friction"]["strategies"]]
    paper = (4, 6, 3)
    more = [
        one["iterations"] / of
        for one, of in zip(kept["prototype"]["strategies"], paper, strict=False)
    ]
    return {
        "little_friction_reductions": f"{less[0]}, {less[1]} and {less[2]}",
        "iterations_least": f"{min(more):.1f}",
        "iterations_most": f"{max(more):.1f}",
        "wheel_share": f"{100.0 * kept['prototype']['strategies'][1]['share_of_wheel']:.0f}",
        "speeds": ", ".join(wheel("prototype", number) for number in (1, 2, 3)),
        "speeds_low": ", ".join(wheel("low", number) for number in (1, 2, 3)),
        "trains": trains("prototype", 2),
        "trains_4": trains("prototype", 4),
        "decrement": f"{kept['prototype']['damping']['logarithmic-decrement']:.0f}",
        "viscous": f"{kept['prototype']['damping']['viscous-and-coulomb']:.0f}",
        "coulomb": f"{kept['prototype']['coulomb_force']:.0f}",
        "whole_vehicle_mass": f"{kept['whole vehicle']['mass']:.0f}",
        "whole_vehicle_ratio": f"{kept['whole vehicle']['joint'][0] / kept['whole vehicle']['guide'][0]:.1f}",
        "tyre": f"{1e-3 * kept['prototype']['tyre_stiffness']:.1f}",
        "tyre_under_load": f"{1e-3 * kept['prototype']['tyre_under_load']:.1f}",
    }


def write(folder: Path) -> None:
    """Write the tables as pages to include."""
    folder.mkdir(exist_ok=True)
    (folder / "prototype-reductions.md").write_text(reductions(), encoding="utf-8")
    (folder / "prototype-causes.md").write_text(causes(), encoding="utf-8")
    (folder / "whole-vehicle.md").write_text(table_of_vehicle(), encoding="utf-8")


if __name__ == "__main__":
    kept = results() if FILE.is_file() else {}
    for name in sys.argv[1:] or [*BENCHES, "whole vehicle"]:
        sys.stderr.write(f"{name}\n")
        kept[name] = run(BENCHES[name]) if name in BENCHES else whole_vehicle()
        FILE.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
