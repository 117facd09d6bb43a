"""Variables of an FMU in one list, in the order of the value references in ``c/core.h``."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import OutputError
from jounce.core.types import Array
from jounce.core.units import Unit
from jounce.mechanics.facts import is_road, speed_of
from jounce.mechanics.model import Model

LOAD_UNITS = {
    "pitch_moment": "N*m",
    "deceleration": "m/s^2",
    "lateral_acceleration": "m/s^2",
    "angle": "rad",
}
"""Units of inputs other than roads, by the last word of their name; all others are commands of unknown unit."""


@dataclass(frozen=True)
class ModelVariable:
    """One variable of an FMU.

    Attributes
    ----------
    reference : int
        Value reference.
    name, text : str
        Structured name, and description.
    causality, variability, initial, unit : str
        As in FMI; the unit is SI, or empty.
    start, least, most : float or bool, optional
        Start value and range.
    derivative : int, optional
        Reference of the variable of which this is the derivative.
    depends : tuple of int, optional
        References of states and inputs on which it depends; None if not required.
    """

    reference: int
    name: str
    causality: str
    variability: str
    initial: str = ""
    unit: str = ""
    text: str = ""
    start: float | bool | None = None
    least: float | None = None
    most: float | None = None
    derivative: int | None = None
    depends: tuple[int, ...] | None = None

    @property
    def is_boolean(self) -> bool:
        """Whether it is a Boolean."""
        return isinstance(self.start, bool) or self.name.startswith("mode.")


@dataclass(frozen=True)
class Variables:
    """All variables, and those listed in the model structure."""

    everything: tuple[ModelVariable, ...]
    derivatives: tuple[ModelVariable, ...]
    outputs: tuple[ModelVariable, ...]
    indicators: tuple[ModelVariable, ...]
    unknown_at_start: tuple[ModelVariable, ...]
    terminals: dict[str, tuple[ModelVariable, ...]]

    def reference(self, name: str) -> int:
        """Return the value reference of a variable."""
        return next(variable.reference for variable in self.everything if variable.name == name)


def structured_name(name: str) -> str:
    """Convert a name to FMI's structured naming convention: blanks and special characters become underscores.

    >>> structured_name("lower_arm.angle rate"), structured_name("control.F[0][1]")
    ('lower_arm.angle_rate', 'control.F[0,1]')
    """
    return re.sub(r"[^\w.\[\],]", "_", name.replace("][", ","), flags=re.ASCII)


def list_variables(
    model: Model,
    start: Mapping[str, Array],
    quantities: Mapping[str, Unit],
    commands: Sequence[str] = (),
    gains: Mapping[str, float] | None = None,
    *,
    names: Mapping[str, str],
    at_rest: bool = True,
    units: Mapping[str, str] | None = None,
    sampled: bool = False,
) -> Variables:
    """List the variables of a model.

    ``start`` contains start values of states, inputs and parameters (x, u, p), ``quantities`` unit and range of
    parameters by path, ``names`` their names in the FMU. ``commands`` are inputs set by a built-in controller,
    ``gains`` its parameters. ``at_rest``: whether it starts in equilibrium. ``units`` are SI units of some inputs.
    Rates of ``sampled`` inputs are not listed.
    """
    gains, order = gains or {}, model.track_order
    blocks = {
        "x": model.x,
        "dx": model.x,
        "u": model.u,
        "p": model.p,
        "g": ca.SX(len(gains), 1),
        "y": model.output,
    }
    first, at = {}, 1
    for block, part in (*blocks.items(), ("z", model.switch)):
        first[block], at = at, at + part.shape[0]
    depends = _dependencies(model, first)
    outputs = {output.name: output for output in model.outputs}
    # A channel that is a state is listed once, as that state.
    same = {
        name
        for i, name in enumerate(outputs)
        if name in model.states
        and ca.is_equal(model.output[i], model.x[model.states.index(name)], 0)
    }
    known_units = units or {}
    ins = [row for track in model.tracks for row in _inputs(track, order, known_units.get(track))]
    taken = {name for name, _, _ in ins} | set(
        outputs
    )  # includes unlisted rates: names must be unique
    own = [name if name in same or name not in taken else f"state.{name}" for name in model.states]
    state_units = [
        *model.units,
        *(outputs[name].unit if name in same else "" for name in model.internal),
    ]
    states = [
        ModelVariable(
            first["x"] + i, structured_name(name), "output" if name in same else "local", "continuous", "approx",
            state_units[i], outputs[name].long_name if name in same else "", float(start["x"][i]),
            depends=(first["x"] + i,),
        )
        for i, name in enumerate(own)
    ]  # fmt: skip
    rates = [
        ModelVariable(
            first["dx"] + i, f"der({state.name})", "local", "continuous", "calculated", _per_second(state.unit),
            derivative=state.reference, depends=depends["dx"][i],
        )
        for i, state in enumerate(states)
    ]  # fmt: skip
    tracks = []
    for i, (name, unit, meaning) in enumerate(ins):
        track, place = model.tracks[i // order], i % order
        if sampled and place:
            continue
        if track in commands:
            text = "always zero: a command holds" if place else "command of the controller inside"
            causality = "local" if place else "output"
            tracks.append(
                ModelVariable(
                    first["u"] + i,
                    structured_name(name),
                    causality,
                    "discrete",
                    "calculated",
                    unit,
                    text,
                )
            )
            continue
        tracks.append(
            ModelVariable(
                first["u"] + i, structured_name(name), "input", "continuous", "", unit, meaning, float(start["u"][i]),
                derivative=first["u"] + i - 1 if place else None,
            )
        )  # fmt: skip
    numbers = [
        ModelVariable(
            first["p"] + i, structured_name(names[path]), "parameter", "tunable", "exact", quantities[path].si,
            start=float(start["p"][i]), least=_at_least(quantities[path]), most=quantities[path].at_most,
        )
        for i, path in enumerate(model.parameters)
    ] + [
        ModelVariable(first["g"] + i, structured_name(f"control.{name}"), "parameter", "tunable", "exact", start=value)
        for i, (name, value) in enumerate(gains.items())
    ]  # fmt: skip
    hidden = {name for i, (name, _, _) in enumerate(ins) if not (sampled and i % order)} | same
    outs = [
        ModelVariable(
            first["y"] + i, structured_name(name), "output", "continuous", "calculated", output.unit, output.long_name,
            depends=depends["y"][i],
        )
        for i, (name, output) in enumerate(outputs.items())
        if name not in hidden
    ]  # fmt: skip
    indicators = [
        ModelVariable(
            first["z"] + i, structured_name(f"switch.{name}"), "local", "continuous", "calculated", "1",
            "event indicator, above zero where the mode is on", depends=depends["z"][i],
        )
        for i, name in enumerate(model.switches)
    ]  # fmt: skip
    settings = [
        ModelVariable(
            at, "settings.tolerance", "parameter", "tunable", "exact", "1",
            "co-simulation: relative error of displacements in one step", 1e-5, least=1e-14,
        ),
        *(
            ModelVariable(at + 1 + i, structured_name(f"mode.{name}"), "local", "discrete", "calculated")
            for i, name in enumerate(model.switches)
        ),
        ModelVariable(
            at + 1 + len(model.switches), "settings.start_at_rest", "parameter", "fixed", "exact",
            text="start in static equilibrium under the inputs at the start", start=at_rest,
        ),
    ]  # fmt: skip
    time = ModelVariable(0, "time", "independent", "continuous", unit="s", text="time")
    everything = (time, *states, *rates, *tracks, *numbers, *outs, *indicators, *settings)
    _refuse_collisions(everything, [*own, *(name for name, _, _ in ins), *outputs])
    shown = tuple(variable for variable in everything if variable.causality == "output")
    terminals = {
        structured_name(track.rpartition(".")[0] if is_road(track) else track): tuple(
            tracks[order * i : order * i + order]
        )
        for i, track in enumerate(model.tracks)
        if track not in commands and not sampled
    }
    unknown = (*states, *rates, *(variable for variable in shown if variable not in states))
    return Variables(everything, tuple(rates), shown, tuple(indicators), unknown, terminals)


def _inputs(track: str, order: int, given: str | None = None) -> list[tuple[str, str, str]]:
    """Return (name, unit, description) of an input and its rates; ``given`` is its unit if known."""
    unit = given or ("m" if is_road(track) else LOAD_UNITS.get(track.rpartition(".")[2], ""))
    rate = speed_of(track)
    second = re.sub(r"\.v(\w)$", r".a\1", rate) if is_road(track) else f"{rate}_rate"
    text = {
        "m": "height of the road under the wheel, up",
        "rad": "angle of the exciter: at 0 at mean height, rising",
    }
    rate_text = "its rate; where it stays zero, co-simulation takes it from the values"
    rows = [
        (track, unit, "" if given else text.get(unit, "")),
        (rate, _per_second(unit), rate_text),
        (second, _per_second(_per_second(unit)), "its second rate"),
    ]
    return rows[:order]


def _per_second(unit: str) -> str:
    """Return the SI unit of a rate.

    >>> [_per_second(unit) for unit in ("m", "m/s", "m/s^2", "1", "N*m")]
    ['m/s', 'm/s^2', 'm/s^3', '1/s', 'N*m/s']
    """
    known = {
        "m": "m/s",
        "m/s": "m/s^2",
        "rad": "rad/s",
        "rad/s": "rad/s^2",
        "1": "1/s",
        "m/s^2": "m/s^3",
        "m/s^3": "m/s^4",
    }
    return known.get(unit, f"{unit}/s" if unit else "")


def _at_least(quantity: Unit) -> float | None:
    """Return the lower limit; FMI has no exclusive limits."""
    return quantity.at_least if quantity.above is None else quantity.above


def _dependencies(model: Model, first: Mapping[str, int]) -> dict[str, list[tuple[int, ...]]]:
    """Return the references of states and inputs on which each rate, output and indicator depends."""
    known = [first["x"] + i for i in range(model.x.shape[0])] + [
        first["u"] + i for i in range(model.u.shape[0])
    ]
    rate = (
        model.rate + model.projection[: model.x.shape[0]]
        if model.projection.shape[0]
        else model.rate
    )
    dependencies = {}
    for name, part in (("dx", rate), ("y", model.output), ("z", model.switch)):
        rows: list[set[int]] = [set() for _ in range(part.shape[0])]
        for row, column in zip(
            *ca.jacobian_sparsity(part, ca.vertcat(model.x, model.u)).get_triplet(), strict=True
        ):
            rows[row].add(known[column])
        dependencies[name] = [tuple(sorted(row)) for row in rows]
    return dependencies


def _refuse_collisions(everything: Sequence[ModelVariable], names: Sequence[str]) -> None:
    seen: set[str] = set()
    for variable in everything:
        if variable.name in seen:
            both = sorted({name for name in names if structured_name(name) == variable.name})
            raise OutputError(
                "two signals have the same name in an FMU",
                where=variable.name,
                found=", ".join(both),
                hint="Rename one of them: blanks and special characters become underscores.",
            )
        seen.add(variable.name)
