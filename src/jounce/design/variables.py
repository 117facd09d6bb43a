"""The parameters of a rig that a designer chooses."""

from __future__ import annotations

import re
from pathlib import Path

from jounce.parts import Rig, as_rig

CONSTANT = "gravity"
"""Last word of the parameters that no design and no study changes."""
_PARTS = frozenset(
    [
        "spring",
        "damper",
        "bump_stop",
        "rebound_stop",
        "anti_roll_bar",
        "torsion_bar",
        "bushings",
        "subframe",
        "housing",
        "hardpoints",
    ]
)
_RATES = frozenset(("spring_rate", "damping_coefficient", "anti_roll_bar_rate"))
_GIVEN = re.compile(r"\.(deflection|angle|velocity|length)\[\d+\]$|\.youngs_modulus$")
"""Abscissas of tables, and the material of a blade."""
_WORD = re.compile(r"\[\d+\]|\.")


def design_variables(rig: Rig | str | Path) -> dict[str, float]:
    """Return the parameters that a designer chooses: springs, dampers, stops, anti-roll bars, bushings, hardpoints.

    Gravity, masses, inertias, tyres and the size of the vehicle are given to a designer and are not among them. A
    search accepts every parameter of the model but gravity as design variable; this is the list to choose from.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library.

    Returns
    -------
    dict of str to float
        Path to present value, SI: single numbers first, then points of curves, hardpoints last.

    Raises
    ------
    DescriptionError
        If the rig is unknown or invalid.

    Examples
    --------
    >>> import jounce as jn
    >>> list(jn.design_variables("audi-a6-half-car"))
    ['front.spring_rate', 'front.damping_coefficient', 'rear.spring_rate', 'rear.damping_coefficient']
    """
    chosen = {path: value for path, value in as_rig(rig).parameters().items() if _is_chosen(path)}
    return dict(sorted(chosen.items(), key=lambda item: _rank(item[0])))


def is_constant(path: str) -> bool:
    """Whether a parameter is a constant of nature, which no design or study changes."""
    return path.rpartition(".")[2] == CONSTANT


def _rank(path: str) -> int:
    return 2 if "hardpoints" in _words(path) else int("[" in path)


def _words(path: str) -> list[str]:
    return _WORD.split(path)


def _is_chosen(path: str) -> bool:
    words = _words(path)
    if "tyre" in words or _GIVEN.search(path):
        return False
    return bool(_PARTS.intersection(words)) or words[-1] in _RATES
