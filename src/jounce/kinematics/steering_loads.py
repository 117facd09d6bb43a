"""Steering effort for commands and pages: loads of the road on each wheel, and the sweep as plain data."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from jounce.core.errors import DescriptionError
from jounce.core.operation import MadeBy, Number, Pairs, operation
from jounce.core.phrases import Phrase
from jounce.core.typed import bare_numbers
from jounce.kinematics.effort import steering_effort
from jounce.kinematics.loads import ContactLoad
from jounce.kinematics.options import RACK
from jounce.kinematics.sweeps import Values, sweep_values
from jounce.kinematics.swept import Swept
from jounce.parts import as_rig
from jounce.parts.options import AnyRig

_LOAD = 'lateral_force="2 kN"'
BothLoads: TypeAlias = Annotated[
    tuple[ContactLoad, ContactLoad],
    MadeBy(
        "jounce.kinematics.steering_loads:both_loads",
        "jounce.kinematics.steering_loads:loads_in_python",
    ),
]
"""Loads of the road on the left and the right wheel."""


def both_loads(
    load: Annotated[
        dict[str, str] | None,
        Pairs(
            f"Load of the road on each wheel, ground axes: {_LOAD} (to the left), longitudinal_force (forward), "
            "vertical_force, aligning_torque (about +z), through=wheel_centre. Repeat it.",
            "NAME=VALUE",
            _LOAD,
        ),
    ] = None,
    left: Annotated[
        dict[str, str] | None,
        Pairs("What differs on the left wheel, as --load.", "NAME=VALUE", _LOAD),
    ] = None,
    right: Annotated[
        dict[str, str] | None,
        Pairs("What differs on the right wheel, as --load.", "NAME=VALUE", _LOAD),
    ] = None,
) -> tuple[ContactLoad, ContactLoad]:
    """Build the loads on both wheels."""
    shared = load or {}
    return _load({**shared, **(left or {})}, "--left"), _load(
        {**shared, **(right or {})}, "--right"
    )


def _load(given: dict[str, str], option: str) -> ContactLoad:
    if not given:
        raise DescriptionError(
            "no load from the road is given",
            where=option,
            allowed=Phrase("--load {load}, or --left and --right", load=_LOAD),
        )
    return ContactLoad.from_table(
        bare_numbers(ContactLoad, given, f"{option} {{}}".format), where=option
    )


def loads_in_python(**options: Any) -> str:
    """Write the loads as Python.

    >>> loads_in_python(load={"lateral_force": "1 kN"})
    "(jn.ContactLoad(lateral_force='1 kN'), jn.ContactLoad(lateral_force='1 kN'))"
    """
    both_loads(**options)
    sides = ({**options.get("load", {}), **options.get(side, {})} for side in ("left", "right"))
    texts = (", ".join(f"{name}={value!r}" for name, value in side.items()) for side in sides)
    return f"({', '.join(f'jn.ContactLoad({text})' for text in texts)})"


@operation(
    "steering-effort",
    named={"changes": "set"},
    faces={"rack": "0 mm", "travel": "0 mm"},
    offers=("sweep", "figure"),
    names_files=False,
    figure="jounce.plots.kinematics:steering_effort",
    page="jounce.report.swept:effort_page",
    title="Steering effort of {rig}",
    doing="sweeping",
    example='jounce steering-effort formula-student-front --rack "-20 mm:20 mm:5 mm" --load vertical_force="700 N" '
    """--left lateral_force="400 N" --right lateral_force="900 N" --set steering='{rack_ratio = "13 mm/rad"}'""",
)
def sweep_steering_effort(
    rig: AnyRig,
    loads: BothLoads,
    rack: Annotated[Values, RACK] = 0.0,
    travel: Annotated[
        float | str, Number("Travel of both wheels, bump positive.", "TRAVEL", "m")
    ] = 0.0,
) -> Swept:
    """Compute the rack force and handwheel torque for loads of the road on both wheels.

    Parameters
    ----------
    rig : Rig, str or Path
        A corner with a rack, its file or its name in the library; the other side is its mirror image.
    loads : tuple of ContactLoad
        Loads of the road on the left and the right wheel, N and N m, ground axes.
    rack : values
        Rack travel, m, positive to the left.
    travel : float or str
        Travel of both wheels, m, bump positive.

    Returns
    -------
    Swept
        The result of :func:`jounce.steering_effort`, with the rig.

    Examples
    --------
    >>> import jounce as jn
    >>> side = jn.ContactLoad(lateral_force="1 kN", vertical_force="1 kN")
    >>> sweep_steering_effort("formula-student-front", (side, side), "-10 mm:10 mm:10 mm").data.sizes["rack_travel"]
    3
    """
    rig, (left, right) = as_rig(rig), loads
    return Swept(rig, steering_effort(rig, left, right, sweep_values(rack, "rack"), travel))
