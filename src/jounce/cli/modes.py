"""``jounce modes``: natural frequencies and damping of a rig or vehicle about static equilibrium."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from jounce.cli.options import AsJson, Changes, RigName, changes
from jounce.cli.reply import Reply
from jounce.cli.rigs import chosen_rig
from jounce.cli.tables import table

if TYPE_CHECKING:
    from rich.console import Console

_MOST_BESIDE = 4  # amplitudes in the rows of the modes; more of them are a table of their own
_NUMBERS = ("frequency_hz", "damped_frequency_hz", "damping_ratio")


def modes(rig: RigName, set_: Changes = None, as_json: AsJson = False) -> Reply:
    """List the oscillating modes of a rig or vehicle, and its static equilibrium.

    Example: jounce modes kart-quarter-car --set strut.angle="16 deg"
    """
    from jounce.core.serialise import to_plain
    from jounce.simulation import equilibrium
    from jounce.simulation import modes as find_modes

    wanted = changes(set_)
    chosen = chosen_rig(rig, wanted)
    plain = {
        "rig": rig,
        "changes": wanted,
        "modes": to_plain(list(find_modes(chosen))),
        "equilibrium": equilibrium(chosen),
    }
    return Reply(plain, lambda out: _draw(out, plain), as_json)


def _draw(out: Console, plain: dict[str, Any]) -> None:
    found = plain["modes"]
    names = list(found[0]["shape"]) if found else []
    beside = names if len(names) <= _MOST_BESIDE else []
    rows = [
        [i, *(mode[key] for key in _NUMBERS), *(_amplitude(mode["shape"][name]) for name in beside)]
        for i, mode in enumerate(found, 1)
    ]
    header = ("mode", "natural Hz", "damped Hz", "damping ratio", *(f"|{name}|" for name in beside))
    out.print(table(f"Modes of {plain['rig']}", header, rows))
    if names and not beside:
        shapes = [[f"|{name}|", *(_amplitude(mode["shape"][name]) for mode in found)] for name in names]
        out.print(table("Shapes", ("mode", *map(str, range(1, len(found) + 1))), shapes))
    if not found:
        out.print("no mode oscillates: all motions are overdamped")
    out.print(table("Static equilibrium (SI)", ("quantity", "value"), plain["equilibrium"].items()))


def _amplitude(shape: list[float]) -> float:
    return abs(complex(*shape))
