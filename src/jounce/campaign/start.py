"""Text of a campaign around a rig and an obstacle, before its measured files are added."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import tomlkit

from jounce.campaign.from_folder import usual_update
from jounce.core.units import to_si
from jounce.parts import Rig


def campaign_to_fill(
    rig: Rig, name: str, obstacle: Mapping[str, str], roads: Mapping[str, Any], title: str
) -> str:
    """Write a campaign without trials: its rig, its obstacle as road ``A``, and one update of all usual parameters.

    Parameters
    ----------
    rig : Rig
        The rig whose parameters are updated.
    name : str
        Its name in the campaign: a file relative to it, or a rig of the library.
    obstacle : mapping
        ``kind``, ``height`` and ``length`` of the obstacle, sizes with their units.
    roads : mapping
        Further roads, such as trains of that obstacle.
    title : str
        Title of the report.

    Returns
    -------
    str
        The text.

    Raises
    ------
    DescriptionError
        If a size of the obstacle is no length.

    Examples
    --------
    >>> from jounce.parts import load
    >>> sizes = {"kind": "half-sine", "height": "10 mm", "length": "60 mm"}
    >>> text = campaign_to_fill(load("kart-quarter-car"), "kart-quarter-car", sizes, {}, "Bench")
    >>> text.splitlines()[:3]
    ['schema = "jounce.campaign/1"', 'title = "Bench"', 'rig = "kart-quarter-car"']
    """
    for key in ("height", "length"):
        to_si(obstacle.get(key, ""), "m", where=f"obstacle {key}")
    document = tomlkit.document()
    document["schema"] = "jounce.campaign/1"
    document["title"] = title
    document["rig"] = name
    document["roads"] = {"A": dict(obstacle), **roads}
    updates = tomlkit.aot()
    updates.append(tomlkit.item(usual_update(rig.parameters())))
    document["update"] = updates
    return tomlkit.dumps(document)
