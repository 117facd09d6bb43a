"""``jounce load-cases``: forces in links, joints and pickup points of an axle for accelerations of the car."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    AsJson,
    Changes,
    Force,
    ReportFile,
    RigName,
    bare_numbers,
    changes,
    check_outputs,
    chosen_rig,
    write_report,
)
from jounce.cli.reply import Reply, progress, show_findings, show_written, table
from jounce.core.errors import DescriptionError
from jounce.core.findings import not_drawn
from jounce.core.typed import pairs

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.kinematics import LoadCase, LoadedAxle
    from jounce.parts import Rig
    from jounce.report import Page

_CAR = 'axle=front, mass="280 kg", wheelbase="1.55 m"'
_CASE = '"braking 1.2 g: longitudinal=-1.2"'


def load_cases(
    rig: RigName,
    car: Annotated[
        list[str],
        typer.Option(
            metavar="NAME=VALUE",
            help='The car around the axle: axle=front, mass="280 kg", wheelbase="1.55 m", '
            'centre_of_mass_height="300 mm", weight_share=0.48, brake_share=0.65; drive_share, roll_share. Repeat it.',
        ),
    ],
    case: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME: NAME=G ...",
            help="A case, accelerations in g: " + _CASE + ", lateral=1.5 (to the left), vertical=3 (times the weight). "
            "Repeat it. By default: static, 1 g of braking, 1 g of cornering, a bump of 3 g, 0.7 g of both.",
        ),
    ] = None,
    set_: Changes = None,
    out: Annotated[Path | None, typer.Option(help="Write every force: CASES.csv, SI.")] = None,
    figure: Annotated[Path | None, typer.Option(metavar="DIR", help="Draw every case into this folder.")] = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Give the forces in links, joints and pickup points of both wheels of an axle for load cases of the car.

    Example: jounce load-cases formula-student-front --car axle=front --car mass="280 kg" --car wheelbase="1.55 m"
    --car centre_of_mass_height="300 mm" --car weight_share=0.48 --car brake_share=0.65 --out cases.csv
    """
    from jounce.core.writing import check_writable, write_atomically
    from jounce.kinematics.load_cases import load_case_table, solved_cases

    if out is not None:
        check_writable(out, what="load cases", suffixes=(".csv",), force=force)
    check_outputs(folder=figure, report=report, force=force)
    with progress() as say:
        say("loading")
        chosen = chosen_rig(rig, changes(set_))
        say("loads")
        found, findings = solved_cases(chosen, _car(car), _cases(case))
        if out is not None:
            write_atomically(out, load_case_table(found), force=force)
        missing = []
        if figure is not None:
            say("drawing")
            try:
                from jounce.kinematics.model import check_corner
                from jounce.plots.mechanisms.load_cases import write_load_cases

                write_load_cases(check_corner(chosen), found, figure, force=force)
            except Exception as error:  # noqa: BLE001 - whatever it is, the forces are told
                missing, figure = [not_drawn(str(figure), error)], None
        document, undrawn = write_report(lambda: _page(chosen, found, findings, rig), report, force=force)
    missing = [*missing, *undrawn]
    plain: dict[str, Any] = {**_plain(found), "findings": findings, "report": document}
    plain["out"], plain["figure"] = (None if path is None else str(path) for path in (out, figure))
    return Reply(plain, lambda console: _draw(console, rig, found, plain), as_json, missing=missing)


def _page(chosen: Rig, found: xr.Dataset, findings: Sequence[Finding], rig: str) -> Page:
    from jounce.kinematics.model import check_corner
    from jounce.report import load_cases_page

    return load_cases_page(check_corner(chosen), found, findings, title=f"Load cases of {Path(rig).stem}")


def _car(texts: list[str]) -> LoadedAxle:
    from jounce.kinematics import LoadedAxle

    given = pairs(texts, "--car", 'wheelbase="1.55 m"')
    table = bare_numbers(LoadedAxle, given, lambda name: f"--car {name}")
    return LoadedAxle.from_table(table, where="--car")


def _cases(texts: list[str] | None) -> dict[str, LoadCase] | None:
    from jounce.core.typed import bare_number
    from jounce.kinematics import LoadCase

    if not texts:
        return None
    found: dict[str, LoadCase] = {}
    for text in texts:
        name, colon, rest = text.partition(":")
        name = name.strip()
        if not (colon and name and rest.strip()):
            raise DescriptionError("not a load case", where="--case", found=text, allowed=f"NAME: NAME=G, e.g. {_CASE}")
        if name in found:
            raise DescriptionError(f"{name!r} is given twice", where="--case", found=text)
        given = pairs(rest.replace(",", " ").split(), "--case", _CASE)
        table = {key: bare_number(value) for key, value in given.items()}
        found[name] = LoadCase.from_table(table, where=f"--case {name}")
    return found


def _plain(found: xr.Dataset) -> dict[str, Any]:
    """Every force with its unit, by case and wheel, SI."""
    cases = [str(name) for name in found["case"].to_numpy()]
    wheels = [str(name) for name in found["wheel"].to_numpy()]
    forces = {
        str(name): {"units": str(variable.attrs["units"]), "values": variable.to_numpy().tolist()}
        for name, variable in found.data_vars.items()
    }
    return {"cases": cases, "wheels": wheels, "forces": forces}


def _draw(console: Console, rig: str, found: xr.Dataset, plain: dict[str, Any]) -> None:
    """Sizes of forces at hardpoints, forces of links and springs, wheel travel: a row for each and wheel."""
    import numpy as np

    points = [str(name)[:-3] for name in found.data_vars if str(name).endswith(".fx")]
    rows: list[tuple[object, ...]] = []
    for name in ("vertical_force", "lateral_force", "longitudinal_force", "wheel_travel"):
        factor, unit = (1e3, "mm") if name == "wheel_travel" else (1.0, "N")
        rows += _rows(name.replace("_", " "), unit, found[name].to_numpy() * factor)
    singles = [str(name) for name in found.data_vars if str(name).endswith((".axial_force", ".force", ".torque"))]
    for name in singles:
        text = name.replace("_", " ").replace(".", ", ")
        rows += _rows(text, str(found[name].attrs["units"]).replace("*", " "), found[name].to_numpy())
    for point in points:
        size = np.sqrt(sum(found[f"{point}.f{axis}"] ** 2 for axis in "xyz"))
        rows += _rows(f"{point.replace('_', ' ')}, size", "N", np.asarray(size))
    console.print(table(f"Load cases of {rig}", ("force", "unit", "wheel", *plain["cases"]), rows, text=(0, 1, 2)))
    show_findings(console, plain["findings"])
    show_written(console, plain)


def _rows(text: str, unit: str, values: Any) -> list[tuple[object, ...]]:
    pair = zip((text, ""), (unit, ""), ("left", "right"), values.T, strict=True)
    return [(label, of, wheel, *column.tolist()) for label, of, wheel, column in pair]
