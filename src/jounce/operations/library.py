"""The files that jounce ships: rigs, vehicles, roads, testers, limits, and truths of virtual benches."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from jounce.core.description import read_toml
from jounce.core.errors import unknown
from jounce.core.operation import Mark, operation
from jounce.core.shown import Shown
from jounce.report.page import Page, Paragraph, Section, TableColumn, table_of


@dataclass(frozen=True)
class ShippedFiles(Shown):
    """The shipped files, or one of them.

    Attributes
    ----------
    groups : dict of str to list of dict
        Name, kind, source and file of each, by group: rigs, vehicles, roads, testers, limits, truths. Empty if a
        single file was requested.
    file : dict, optional
        The same fields of the requested file, with its ``text``; a road has its length and heights (m) instead.
    """

    groups: Mapping[str, list[dict[str, Any]]]
    file: Mapping[str, Any] | None = None

    @property
    def printed(self) -> str:
        """Return the text of a file, or the description of a road."""
        if self.file is None:
            return ""
        about = "{name}: {what}\nfile: {file}\n\n{source}\n".format_map(self.file)
        return str(self.file.get("text", about))

    def to_dict(self) -> dict[str, Any]:
        """Return the list, or the fields of the requested file."""
        return dict(self.groups if self.file is None else self.file)


@operation(
    "library",
    page="jounce.operations.library:library_page",
    title="Library",
    doing="reading the library",
    example="jounce library kart-quarter-car > my-rig.toml",
)
def shipped_files(
    name: Annotated[str | None, Mark("File to print, or road to describe.")] = None,
) -> ShippedFiles:
    """List the shipped rigs, vehicles, roads, testers, limits and truths of virtual benches, or print one of them.

    Parameters
    ----------
    name : str, optional
        Name of a single file or road.

    Returns
    -------
    ShippedFiles
        Kind, source and file of each; for a named file also its text.

    Raises
    ------
    DescriptionError
        If the name is not in the library.

    Examples
    --------
    >>> shipped_files("kart-quarter-car").file["kind"], shipped_files("egea-specsus2018").file["what"]
    ('rig', 'rigid-plate, egea')
    >>> [found["name"] for found in shipped_files().groups["limits"]]
    ['jounce']
    """
    groups = _groups()
    if name is None:
        found = {
            group: [describe(*item) for item in files.items()]
            for group, (files, describe) in groups.items()
        }
        vehicles = [item for item in found["rigs"] if item["kind"] == "vehicle"]
        rigs = [item for item in found["rigs"] if item["kind"] == "rig"]
        return ShippedFiles({**found, "rigs": rigs, "vehicles": vehicles})
    for files, describe in groups.values():
        if name in files:
            about = describe(name, files[name])
            is_text = about["kind"] != "road"
            return ShippedFiles(
                {}, {**about, **({"text": files[name].read_text("utf-8")} if is_text else {})}
            )
    raise unknown(
        name, [item for files, _ in groups.values() for item in files], what="name", where="name"
    )


def _groups() -> dict[str, tuple[Mapping[str, Path], Callable[[str, Path], dict[str, Any]]]]:
    """Return files by group, each with a function that describes it; a rig precedes a road of the same name."""
    from jounce.campaign.shipped import truth_library
    from jounce.inspection.shipped import SHIPPED, shipped_limits
    from jounce.parts import library
    from jounce.parts.testers import library as testers
    from jounce.roads import road_library

    return {
        "rigs": (library(), _rig),
        "roads": (road_library(), _road),
        "testers": (testers(), _tester),
        "limits": ({SHIPPED: shipped_limits()}, _limits),
        "truths": (truth_library(), _truth),
    }


# Shipped files are parsed but not validated: they are known to be correct, and validating all of them is slow.
def _rig(name: str, file: Path) -> dict[str, Any]:
    table = read_toml(file)[0]
    kind = "vehicle" if table["schema"].startswith("jounce.vehicle/") else "rig"
    return _described(name, kind, table["model"], table, file)


def _tester(name: str, file: Path) -> dict[str, Any]:
    table = read_toml(file)[0]
    return _described(name, "tester", f"{table['kind']}, {table['method']}", table, file)


def _limits(name: str, file: Path) -> dict[str, Any]:
    table = read_toml(file)[0]
    what = f"limits {table['version']} of {', '.join(table['methods'])}"
    return {
        "name": name,
        "kind": "limits",
        "what": what,
        "source": table["source"],
        "file": str(file),
    }


def _truth(name: str, file: Path) -> dict[str, Any]:
    from jounce.parts.files import rig_path

    table = read_toml(file)[0]
    model = read_toml(rig_path(table["rig"]))[0]["model"]
    return _described(name, "truth", f"of a virtual bench, {model}", table, file)


def _described(
    name: str, kind: str, what: str, table: Mapping[str, Any], file: Path
) -> dict[str, Any]:
    about = {"name": name, "kind": kind, "what": what}
    return {
        **about,
        "source": table.get("source", ""),
        "estimated": table.get("estimated", []),
        "file": str(file),
    }


def _road(name: str, file: Path) -> dict[str, Any]:
    from jounce.roads import load_road, source_of_course

    road = load_road(file)
    points = road.segments(road.end()).evaluate(road.segments(road.end()).edges)[0]
    return {
        "name": name,
        "kind": "road",
        "what": f"measured course of {road.end():g} m, heights {1e3 * points.min():.3g} to {1e3 * points.max():.3g} mm",
        "length": road.end(),
        "lowest": float(points.min()),
        "highest": float(points.max()),
        "source": source_of_course(file),
        "file": str(file),
    }


def library_page(found: ShippedFiles, *, title: str) -> Page:
    """Create a page that lists the shipped files."""
    tables = tuple(
        table_of(
            group.capitalize(),
            [TableColumn(key, [item[key] for item in rows]) for key in ("name", "what", "source")],
        )
        for group, rows in ((group, found.groups[group]) for group in _ORDER)
    )
    use = Paragraph(
        "`jounce library NAME` prints one of them; the names are accepted wherever a file is."
    )
    return Page(title, (Section("Files", (*tables, use)),))


_ORDER = ("rigs", "vehicles", "roads", "testers", "limits", "truths")
