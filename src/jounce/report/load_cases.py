"""Page of the forces in an axle's links, joints and pickup points in load cases of the car."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.old_names import old_argument
from jounce.core.text import slug
from jounce.plots.display import number
from jounce.report.page import Block, Findings, Page, PageTable, Picture, Section, Subsection

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr

    from jounce.core.findings import Finding
    from jounce.kinematics.axle_loads import AxleLoads
    from jounce.parts.corners import Corner


@old_argument("found", "loads")
def load_cases_page(
    rig: Corner, loads: xr.Dataset, findings: Sequence[Finding], *, title: str
) -> Page:
    """Create a page of load cases: forces by case and wheel, then a figure of each case.

    Parameters
    ----------
    rig : Corner
        Corner to which the cases apply.
    loads : xarray.Dataset
        Result of :func:`jounce.load_cases`.
    findings : sequence of Finding
        Findings that limit the reliability of the results.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48, brake_share=0.65
    ... )
    >>> rig = jn.load("formula-student-front")
    >>> found = jn.load_cases(rig, car, {"braking 1.2 g": {"longitudinal": -1.2}})
    >>> [section.title for section in load_cases_page(rig, found, (), title="Front axle").sections]
    ['Answer', 'Drawn']
    """
    cases = [str(name) for name in loads["case"].to_numpy()]
    names = [str(name) for name in loads.data_vars]
    points = [name[:-3] for name in names if name.endswith(".fx")]
    sizes = {
        point: np.sqrt(sum(loads[f"{point}.f{axis}"].to_numpy() ** 2 for axis in "xyz"))
        for point in points
    }
    wheels = _table("Loads and travel of the wheels", cases, loads, {
        name.replace("_", " "): (loads[name].to_numpy(), str(loads[name].attrs["units"]))
        for name in ("vertical_force", "lateral_force", "longitudinal_force", "wheel_travel")
    })  # fmt: skip
    links = _table("Forces of links and springs, compression positive", cases, loads, {
        name.replace("_", " ").replace(".", ", "): (loads[name].to_numpy(), str(loads[name].attrs["units"]))
        for name in names if name.endswith((".axial_force", ".force", ".torque"))
    })  # fmt: skip
    pickups = _table("Magnitudes of forces at hardpoints", cases, loads, {
        point.replace("_", " "): (values, "N") for point, values in sizes.items()
    })  # fmt: skip
    answer: list[Block] = [Findings(tuple(findings))] if findings else []
    answer += [wheels, links, pickups]
    drawn = Section("Drawn", lambda: tuple(_draw_case(rig, loads, case) for case in cases))
    return Page(title, (Section("Answer", tuple(answer)), drawn), "Load cases")


def axle_loads_page(axle_loads: AxleLoads, *, title: str) -> Page:
    """Create a page of the loads of an axle, as :func:`load_cases_page` does."""
    return load_cases_page(axle_loads.rig, axle_loads.data, axle_loads.findings, title=title)


def _draw_case(rig: Corner, loads: xr.Dataset, case: str) -> Subsection:
    from jounce.plots.mechanisms.load_cases import load_case

    words = "Forces of the road on the wheels (red) and of the suspension on the body (blue), front and top view."
    return Subsection(
        case[:1].upper() + case[1:],
        (Picture(load_case(rig, loads, case), slug(case), words, words),),
    )


def _table(
    caption: str, cases: Sequence[str], loads: xr.Dataset, values: dict[str, tuple[np.ndarray, str]]
) -> PageTable:
    """Return a table with a row per quantity and wheel and a column per case."""
    rows = []
    for words, (numbers, si) in values.items():
        unit = display_unit(si, float(np.nanmax(np.abs(numbers), initial=0.0)))
        for k, wheel in enumerate(map(str, loads["wheel"].to_numpy())):
            cells = (number(float(value) * unit.factor) for value in numbers[:, k])
            rows.append((words, unit.name, wheel, *cells))
    return PageTable(caption, ("", "unit", "wheel", *cases), tuple(rows), "lll" + "r" * len(cases))
