"""Load cases of an axle for commands and pages: one line per named case, forces as plain data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.operation import Described, MadeBy, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_plain
from jounce.core.typed import bare_number, pairs
from jounce.kinematics.load_cases import LoadCase, LoadedAxle, load_case_table, solved_cases
from jounce.kinematics.model import check_corner
from jounce.parts import Corner, as_rig
from jounce.parts.options import AnyRig

if TYPE_CHECKING:
    import xarray as xr

_CASE = '"braking 1.2 g: longitudinal=-1.2"'


@dataclass(frozen=True)
class AxleLoads(Plain):
    """Forces of an axle in load cases.

    Attributes
    ----------
    rig : Corner
        The corner; the other side is its mirror image.
    data : xarray.Dataset
        Every force by case and wheel, SI.
    findings : tuple of Finding
        Findings that limit the validity of the results.
    """

    rig: Corner
    data: xr.Dataset
    findings: tuple[Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return every force with its unit, by case and wheel, SI."""
        forces = {
            str(name): {
                "units": str(variable.attrs["units"]),
                "values": variable.to_numpy().tolist(),
            }
            for name, variable in self.data.data_vars.items()
        }
        names = {
            f"{name}s": list(map(str, self.data[name].to_numpy())) for name in ("case", "wheel")
        }
        return {**names, "forces": forces, "findings": to_plain(self.findings)}

    def table(self) -> str:
        """Return every force as CSV, a row for each case and wheel, SI."""
        return load_case_table(self.data)


def named_cases(
    case: Annotated[
        Sequence[str] | None,
        Texts(
            "A case, accelerations in g: "
            + _CASE
            + ", lateral=1.5 (to the left), vertical=3 (times the weight). "
            "Repeat it. By default: static, 1 g of braking, 1 g of cornering, a bump of 3 g, 0.7 g of both.",
            "NAME: NAME=G ...",
        ),
    ] = None,
) -> dict[str, LoadCase] | None:
    """Read load cases by name; None if none is given."""
    cases: dict[str, LoadCase] = {}
    for text in case or ():
        name, colon, rest = text.partition(":")
        name = name.strip()
        if not (colon and name and rest.strip()):
            raise DescriptionError(
                "invalid load case",
                where="--case",
                found=text,
                allowed=Phrase("NAME: NAME=G, e.g. {case}", case=_CASE),
            )
        if name in cases:
            raise DescriptionError(
                Phrase("{name!r} is given twice", name=name), where="--case", found=text
            )
        given = pairs(rest.replace(",", " ").split(), "--case", _CASE)
        cases[name] = LoadCase.from_table({key: bare_number(value) for key, value in given.items()},
                                          where=f"--case {name}")  # fmt: skip
    return cases or None


def cases_in_python(case: Sequence[str] | None = None) -> str:
    """Write load cases as Python.

    >>> cases_in_python(["braking: longitudinal=-1.2"])
    "{'braking': {'longitudinal': -1.2}}"
    """
    cases = named_cases(case)
    return repr(
        cases
        and {name: load_case.model_dump(exclude_unset=True) for name, load_case in cases.items()}
    )


@operation(
    "load-cases",
    named={"changes": "set"},
    offers=("table", "figures", "report"),
    figure="jounce.plots.mechanisms.load_cases:write_loaded",
    page="jounce.report.load_cases:axle_loads_page",
    title="Load cases of {rig}",
    doing="loads",
    example='jounce load-cases formula-student-front --car axle=front --car mass="280 kg" --car wheelbase="1.55 m" '
    '--car centre_of_mass_height="300 mm" --car weight_share=0.48 --car brake_share=0.65 --out cases.csv',
)
def load_axle(
    rig: AnyRig,
    car: Annotated[
        LoadedAxle,
        Described(
            'The car around the axle: axle=front, mass="280 kg", wheelbase="1.55 m", centre_of_mass_height="300 mm", '
            "weight_share=0.48, brake_share=0.65; drive_share, roll_share. Repeat it.",
            "NAME=VALUE",
            'wheelbase="1.55 m"',
            "jounce.kinematics.load_cases:LoadedAxle",
        ),
    ],
    cases: Annotated[
        Mapping[str, LoadCase | Mapping[str, float]] | None,
        MadeBy(
            "jounce.kinematics.axle_loads:named_cases",
            "jounce.kinematics.axle_loads:cases_in_python",
        ),
    ] = None,
) -> AxleLoads:
    """Compute forces in links, joints and pickup points of both wheels of an axle for load cases of the car.

    Parameters
    ----------
    rig : Rig, str or Path
        The corner, its file or its name in the library; the other side is its mirror image.
    car : LoadedAxle
        Vehicle data of the axle.
    cases : mapping, optional
        Accelerations of the car in g, as for :func:`jounce.load_cases`; common cases by default.

    Returns
    -------
    AxleLoads
        Forces as returned by :func:`jounce.load_cases`, with rig and findings.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.LoadedAxle(
    ...     axle="front", mass=280.0, wheelbase=1.55, centre_of_mass_height=0.3, weight_share=0.48, brake_share=0.65
    ... )
    >>> load_axle("formula-student-front", car, {"braking": {"longitudinal": -1.2}}).data.sizes["case"]
    1
    """
    corner = check_corner(as_rig(rig))
    data, findings = solved_cases(corner, car, cases)
    return AxleLoads(corner, data, tuple(findings))
