"""Import of hardpoint tables of any program as 3-D rigs; detects names, unit, axes and side."""

from __future__ import annotations

import csv
import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any, Literal, cast, get_args

import numpy as np

from jounce.core.errors import DescriptionError, at_line, unknown
from jounce.core.files import content_of, existing_file
from jounce.core.findings import Finding, at_place, finding
from jounce.core.operation import File, Mark, Names, operation
from jounce.core.optional import MissingPackageError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import conversion_factor
from jounce.core.workbooks import sheets_of
from jounce.parts.bodies import distance_to_line
from jounce.parts.corners import Corner
from jounce.parts.files import RIGS, rig_from_table, rig_text
from jounce.parts.importers.drafts import ImportedRig, length_of_tyre
from jounce.parts.importers.points import (
    AXLE_END,
    LONGEST_LINE,
    PointRow,
    PointTable,
    from_nested,
    from_vsusp,
)

Side = Literal["left", "right"]
Axle = Literal["front", "rear"]
_NAMES = {
    "lower_arm_front": "lower arm front pivot|lower wishbone front|lca fwd|lca fore|lower a arm front|"
    "lower wishbone front pivot|lca front|chas low for|lower control arm front|lower front inner",
    "lower_arm_rear": "lower arm rear pivot|lower wishbone rear|lca aft|lower a arm rear|"
    "lower wishbone rear pivot|lca rear|chas low aft|lower control arm rear|lower rear inner",
    "lower_ball_joint": "lower wishbone outer ball joint|lca outer|upri low pnt|lower outer|lower outer ball joint|"
    "ball joint|ball joint lower|lower arm outer|lower control arm outer|lower control arm ball joint|lbj",
    "upper_arm_front": "upper arm front pivot|upper wishbone front|uca fwd|uca fore|upper a arm front|"
    "upper wishbone front pivot|uca front|chas upp for|upper control arm front|upper front inner",
    "upper_arm_rear": "upper arm rear pivot|upper wishbone rear|uca aft|upper a arm rear|"
    "upper wishbone rear pivot|uca rear|chas upp aft|upper control arm rear|upper rear inner",
    "upper_ball_joint": "upper wishbone outer ball joint|uca outer|upri upp pnt|upper outer|upper outer ball joint|"
    "ball joint upper|upper arm outer|upper control arm outer|upper control arm ball joint|ubj",
    "tie_rod_inner": "inner track rod ball joint|tierod inner|chas tie pnt|tie rod inboard|toe link inner|tie rod in|"
    "tri|track rod inner",
    "tie_rod_outer": "outer track rod ball joint|tierod outer|upri tie pnt|tie rod outboard|toe link outer|tie rod out|"
    "tro|track rod outer",
    "wheel_centre": "wheel centre point|wheel center point|wheel center|wc",
    "pushrod_outer": "push rod wishbone end|nsma ppatt pnt|nsma ppatt|pushrod outboard|push rod outer|prod outboard",
    "pushrod_inner": "push rod rocker end|rock rod pnt|pushrod inboard|push rod inner",
    "rocker_pivot": "rocker axis 1st point|chas roc piv",
    "rocker_axis": "rocker axis 2nd point|chas roc axi",
    "strut_bottom": "damper to rocker point|damper wishbone end|lwr strut mount|strut lwr mount|rock coi pnt|"
    "spring damper lower|damper lower|shock lower|lower strut mount|strut lower|strut lower mount|lower mount",
    "strut_top": "damper to body point|damper body end|top mount|chas att pnt|spring damper upper|damper upper|"
    "shock upper|strut upper mount|strut top point|upper strut mount|strut top mount|strut mount|upper mount|"
    "strut upper|damper top mount|shock top mount",
    "spring_bottom": "lower spring pivot point|spring lwr seat|spring lower seat",
    "spring_top": "upper spring pivot point|spring upr seat|spring upper seat",
}
"""Names of Lotus Shark, Adams Car, OptimumKinematics and of tables by hand; the names of rig files are known, too."""
_EXPLORER = {
    "lower_arm_front": "lower wishbone inboard front",
    "lower_arm_rear": "lower wishbone inboard rear",
    "lower_ball_joint": "lower wishbone outboard",
    "upper_arm_front": "upper wishbone inboard front",
    "upper_arm_rear": "upper wishbone inboard rear",
    "upper_ball_joint": "upper wishbone outboard",
    "tie_rod_inner": "trackrod inboard",
    "tie_rod_outer": "trackrod outboard",
    "rocker_pivot": "rocker axis a",
    "rocker_axis": "rocker axis b",
    "link_1_inner": "upper front link inboard",
    "link_1_outer": "upper front link outboard",
    "link_2_inner": "upper rear link inboard",
    "link_2_outer": "upper rear link outboard",
    "link_3_inner": "lower front link inboard",
    "link_3_outer": "lower front link outboard",
    "link_4_inner": "lower rear link inboard",
    "link_4_outer": "lower rear link outboard",
    "arm_inner": "trailing arm pivot a",
    "arm_outer": "trailing arm pivot b",
}
"""Names of suspension-explorer."""
_CONTACT = (
    "contact point",
    "contact patch",
    "tyre contact patch",
    "tyre contact",
    "tire contact patch",
    "cp",
)
_SIDES = {"l": "left", "lh": "left", "left": "left", "r": "right", "rh": "right", "right": "right"}
_CORNERS = {
    "fl": ("front", "left"),
    "fr": ("front", "right"),
    "rl": ("rear", "left"),
    "rr": ("rear", "right"),
}
_UNITS = {"mm": "mm", "millimeter": "mm", "millimetre": "mm", "cm": "cm", "m": "m", "meter": "m", "metre": "m",
          "in": "inch", "inch": "inch", "inches": "inch", "ft": "foot", "millimeters": "mm", "meters": "m"}  # fmt: skip
_UNIT_LINE = re.compile(r"(?i)\W*(?:length\s+)?units?\b[\s:=,;]*\W?([a-z]+)\W*")
_UNIT_IN = re.compile(r"[\[(]\s*([A-Za-z]+)\s*[\])]")
_LABEL = re.compile(r"(?i)^\W*(?:point\b)?\W*\d*\W*(?:point\s+\d+\s*:)?\s*")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?")
_HALF_TRACK = (0.15, 1.6)  # m: of anything from a kart to a lorry
_RADIUS = (
    0.08,
    0.8,
)  # m: from the small wheel of a kart (0.13) to that of a lorry (0.55), and half as much again
_NESTED = (".yaml", ".yml", ".json")
_LARGEST, _ROWS, _COLUMNS = (
    20_000_000,
    20_000,
    200,
)  # bytes, ...: a car has 100 points; more is no table of points
_STRUT = ("strut_bottom", "strut_top")
_ADVICE = "Map names with --name THEIRS=OURS."


@operation(
    "import hardpoints",
    named={"path": "file", "names": "name"},
    echo={"file": "file"},
    offers=("imported_rig",),
    page="jounce.report.exchange:imported_rig_page",
    title="{out}",
    doing="reading the file",
    example="jounce import hardpoints points.csv --out rig.toml",
    python_only=("source",),
)
def import_hardpoints(
    path: Annotated[
        Path | str,
        File("Text (name, x, y, z; Lotus; OptimumKinematics; VSUSP), YAML, JSON, .xlsx.", "TABLE"),
    ],
    *,
    unit: Annotated[
        str | None, Mark("Of the coordinates: mm, m, inch, cm. Default: what the file says.")
    ] = None,
    axes: Annotated[
        str | None,
        Mark('What in the table is forward, left and up, e.g. "-x,-y,z". Default: x,y,z.'),
    ] = None,
    side: Annotated[
        Side, Mark("Corner that is read where there are both: left or right.")
    ] = "left",
    axle: Annotated[
        Axle | None, Mark("Axle that is read where there are both: front or rear.")
    ] = None,
    model: Annotated[
        str | None, Mark("Suspension. Default: the one that has these points.")
    ] = None,
    names: Annotated[
        Mapping[str, str] | None,
        Names("A name in the table and the hardpoint it is.", "THEIRS=OURS"),
    ] = None,
    wheel_radius: Annotated[
        float | None, length_of_tyre("height of the wheel centre (estimated)")
    ] = None,
    source: str | None = None,
) -> ImportedRig:
    """Convert a table of hardpoints to the left corner of a 3-D rig, for its kinematics.

    Reads ``name, x, y, z`` with any separator, point lists of Lotus Shark, tables of OptimumKinematics and Adams, text
    or ``.xlsx`` (extra ``io``). Such tables have no masses, springs or dampers: the rig omits them.

    Parameters
    ----------
    path : Path or str
        The table.
    unit : str, optional
        Unit of the coordinates, such as ``"mm"``; by default that of the file, else metres or millimetres if the half
        track is plausible in only one of them.
    axes : str, optional
        Table axes that correspond to x (forward), y (left) and z (up), such as ``"-x,-y,z"``. By default x, y and z; x
        is reversed if the front point of an arm is behind its rear point.
    side : {"left", "right"}
        Corner to read if the table contains two sides. Right corners are mirrored.
    axle : {"front", "rear"}, optional
        Axle to read if the table contains two.
    model : str, optional
        Suspension model; by default the one with these points.
    names : mapping, optional
        jounce's name for each name in the table.
    wheel_radius : float, optional
        Undeformed radius of the tyre [m]; by default the height of the wheel centre.
    source : str, optional
        Text for ``source`` of the rig; by default the name of the file.

    Returns
    -------
    rig : Corner
        The left corner, without parts missing in the table.
    findings : list of Finding
        Assumptions, reversed axes and omissions.
    text : str
        Text of the rig file.

    Raises
    ------
    DescriptionError
        For a file that is not a table, unknown names, missing or duplicate points, an implausible unit, sides that are
        not opposite, or points that do not form a mechanism.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.parts import load
    >>> rig = load("formula-student-front")
    >>> lines = [f"{name},{x},{y},{z}" for name, (x, y, z) in rig.hardpoints.given().items()]
    >>> file = Path(tempfile.mkdtemp()) / "points.csv"
    >>> _ = file.write_text("name,x [m],y [m],z [m]" + chr(10) + chr(10).join(lines))
    >>> found, _, _ = import_hardpoints(file)
    >>> found.model, found.hardpoints == rig.hardpoints
    ('double-wishbone', True)
    """
    if side not in get_args(Side):
        raise unknown(side, get_args(Side), what="side", where="side")
    if axle is not None and axle not in get_args(Axle):
        raise unknown(axle, get_args(Axle), what="axle", where="axle")
    file = existing_file(path)
    reading = PointReading(_read(file), side, axle, {**(names or {})})
    return reading.rig(unit, axes, model, wheel_radius, source)


# --- the file


def _read(file: Path) -> PointTable:
    if file.stat().st_size > _LARGEST:
        raise DescriptionError(
            "too large for a table of hardpoints", where=str(file), allowed="up to 20 MB"
        )
    table = PointTable(file)
    if file.suffix.lower() != ".xlsx":
        text = _text(file)
        whole = from_vsusp(file, text) or (
            from_nested(file, text) if file.suffix.lower() in _NESTED else None
        )
        if whole is not None:
            whole.unit = _resolve_unit(whole.unit, str(file)) if whole.unit else ""
            return whole
    rows = _sheet(file) if file.suffix.lower() == ".xlsx" else _lines(file, _text(file))
    return _tabulate(table, rows)


def table_in(text: str, where: str) -> PointTable:
    """Read a table of points from a text, such as one copied from a spreadsheet; ``where`` names it in messages."""
    table = PointTable(Path(where))
    return _tabulate(table, _lines(table.file, text))


def _tabulate(table: PointTable, rows: Iterator[tuple[str, list[str]]]) -> PointTable:
    """Add rows, each with its place and cells, to a table."""
    file = table.file
    columns: list[int] = []
    width = 0
    for count, (where, cells) in enumerate(rows):
        if count > _ROWS:
            raise DescriptionError(
                "too many rows", where=str(file), allowed=Phrase("up to {rows}", rows=_ROWS)
            )
        header = _header(cells)
        if header is not None:
            (columns, unit), width = header, len(cells)
            _keep_unit(table, unit, where)
            continue
        is_laid = max(columns, default=len(cells)) < len(cells) and all(
            _is_number(cells[i]) for i in columns
        )
        if is_laid and any(map(_is_number, cells[width:])):
            raise DescriptionError(
                "a row has more numbers than the table has columns",
                where=where,
                found=" ".join(cells)[:80],
                allowed=Phrase("{width} cells, as in the header row", width=width),
                hint="Decimal commas need semicolons or tabs between the cells.",
            )
        row = _row(cells, columns, where)
        if row is not None:
            table.rows.append(row)
        elif unit_line := _UNIT_LINE.fullmatch(" ".join(cells).strip()):
            _keep_unit(table, _resolve_unit(unit_line[1], where), where)
        elif (
            columns
            and len(
                row_units := {unit for cell in cells if (unit := cell.strip("[]() ").lower())}
                & {*_UNITS}
            )
            == 1
        ):
            _keep_unit(table, _UNITS[row_units.pop()], where)  # a row of units under that of names
        elif any(map(_is_number, cells)):
            table.unread.append((where, cells))
    if not table.rows:
        raise DescriptionError(
            "the file contains no points",
            where=str(file),
            allowed="rows of a name and three coordinates: name, x, y, z",
        )
    return table


def _keep_unit(table: PointTable, unit: str, where: str) -> None:
    """Store the unit given on a line; refuse a second, different unit."""
    if unit and table.unit not in ("", unit):
        raise DescriptionError(
            "two units", where=where, found=f"{unit} after {table.unit}", allowed="one"
        )
    table.unit = unit or table.unit


def _text(file: Path) -> str:
    """Return the text of a file, in UTF-8 or in UTF-16 as spreadsheets export "Unicode text"."""
    content = content_of(file)
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", errors="replace")
    if b"\0" in content:
        raise DescriptionError("not a text file", where=str(file), allowed="text, or .xlsx")
    return content.decode("utf-8-sig", errors="replace")


def _lines(file: Path, text: str) -> Iterator[tuple[str, list[str]]]:
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > LONGEST_LINE:
            where, allowed = (
                at_line(file, number),
                Phrase("up to {longest_line} characters", longest_line=LONGEST_LINE),
            )
            raise DescriptionError(
                "a line is too long for a point", where=where, found=f"{len(line)}", allowed=allowed
            )
        bare = line.strip()
        if bare.startswith("#"):  # a comment, unless it names columns or the unit
            bare = bare.lstrip("# \t")
            if _header(_cells(bare)) is None and not _UNIT_LINE.fullmatch(
                " ".join(_cells(bare)).strip()
            ):
                continue
        if bare and not bare.startswith(("//", "%", "!", "$")):
            yield at_line(file, number), _cells(bare)


def _cells(line: str) -> list[str]:
    """Split a line into cells at semicolons, tabs or commas, else at blanks; decimal commas become points.

    >>> _cells("lca front; 1,5; 2; 3"), _cells("'a, b', 1, 2, 3"), _cells("1 2 3 POINT:1 Lower pivot")
    (['lca front', '1.5', '2', '3'], ['a, b', '1', '2', '3'], ['1', '2', '3', 'POINT:1', 'Lower', 'pivot'])
    >>> _cells("  top_mount: {x: 1, y: -2.5, z: 3}"), _cells('"top": [1, 2, 3],')
    (['top_mount', '1', '-2.5', '3'], ['top', '1', '2', '3'])
    """
    if entry := _entry(line):
        return [
            entry[0],
            *(re.sub(r"^\W*[xyz]\W*:", "", cell).strip() for cell in entry[1].split(",")),
        ]
    if ";" in line or "\t" in line:
        cells = line.split(";" if ";" in line else "\t")
        return [re.sub(r"^([+-]?\d+),(\d+)$", r"\1.\2", cell.strip(" \"'")) for cell in cells]
    if "," in line:
        quote = "'" if line.count("'") > line.count('"') else '"'
        try:
            return [
                cell.strip(" \"'")
                for cell in next(csv.reader([line], quotechar=quote, skipinitialspace=True))
            ]
        except csv.Error:
            return [cell.strip() for cell in line.split(",")]
    return [word.strip("\"'") for word in re.findall(r"'[^']*'|\"[^\"]*\"|\S+", line)]


def _entry(line: str) -> tuple[str, str] | None:
    """Return name and coordinates of a point in YAML or JSON: ``name: [1, 2, 3]`` or ``name: {x: 1, y: 2, z: 3}``."""
    name, _, rest = line.partition(":")
    name, rest = re.sub(r"^\W+", "", name).rstrip(" \t\"'"), rest.strip()
    end = max(rest.rfind("]"), rest.rfind("}"))
    if (
        rest[:1] not in ("[", "{")
        or end < 1
        or re.search(r"\w", rest[end:])
        or not re.search("[A-Za-z]", name)
    ):
        return None
    return name, rest[1:end]


def _sheet(file: Path) -> Iterator[tuple[str, list[str]]]:
    """Yield the rows of all sheets of an Excel file."""
    limits = {"most_bytes": 10 * _LARGEST, "most_rows": _ROWS, "most_columns": _COLUMNS}
    try:
        for title, rows in sheets_of(file, DescriptionError, **limits):
            for number, row in rows:
                cells = ["" if value is None else str(value).strip() for value in row]
                if any(cells):
                    yield f"{file}, {title}, row {number}", cells
    except (DescriptionError, MissingPackageError):
        raise
    except Exception as error:  # noqa: BLE001 - openpyxl raises whatever a damaged file leads to
        raise DescriptionError(
            Phrase("not an Excel file that can be read: {error}", error=str(error)), where=str(file)
        ) from None


def _is_number(text: str) -> bool:
    return _NUMBER.fullmatch(text) is not None


def _header(cells: list[str]) -> tuple[list[int], str] | None:
    """Return the columns of x, y and z and their unit, if the cells are a header."""
    columns: dict[str, int] = {}
    units = set()
    for index, cell in enumerate(cells):
        word = re.sub(r"[\[(].*", "", cell).strip(" {}").lower().replace("_", " ")
        axis = re.fullmatch(
            r"([xyz])(?: value| coord| coordinate| position| location)?(?: ([a-z]+))?", word
        )
        if axis and axis[1] not in columns and (not axis[2] or axis[2] in _UNITS):
            columns[axis[1]] = index
            inside = _UNIT_IN.search(cell)
            units |= {inside[1]} if inside else {axis[2]} if axis[2] else set()
    if set(columns) != {"x", "y", "z"}:
        return None
    if len(units) > 1:
        raise DescriptionError(
            "columns in different units", where="header", found=", ".join(sorted(units))
        )
    return [columns[axis] for axis in "xyz"], _resolve_unit(units.pop(), "header") if units else ""


def _resolve_unit(text: str, where: str) -> str:
    if text.lower() not in _UNITS:
        raise unknown(text, sorted({*_UNITS.values()}), what="unit", where=where)
    return _UNITS[text.lower()]


def _row(cells: list[str], columns: list[int], where: str) -> PointRow | None:
    """Return a name with three numbers, or None for other cells."""
    if columns and max(columns) < len(cells) and all(_is_number(cells[i]) for i in columns):
        words = [
            cell for i, cell in enumerate(cells[: min(columns)]) if cell and not _is_number(cell)
        ]
        words = words or [
            cell
            for i, cell in enumerate(cells)
            if i not in columns and cell and not _is_number(cell)
        ]
        places = [
            word for word in words if _plain(word) in (*_SIDES, *_CORNERS)
        ]  # a column beside that of names
        names = [word for word in words if word not in places]
        if not names:
            return None
        name = f"{names[0]} {places[0]}" if places and not _sort_out(names[0])[2] else names[0]
        return PointRow(name, _numbers([cells[i] for i in columns]), where)
    numeric = [_is_number(cell) for cell in cells]
    runs = [
        i for i in range(len(cells) - 2) if all(numeric[i : i + 3]) and not (i and numeric[i - 1])
    ]
    if not runs:
        return None
    first = runs[0]
    if numeric[first + 3 : first + 4] == [True]:
        raise DescriptionError(
            "more than three numbers in a row",
            where=where,
            found=" ".join(cells)[:80],
            allowed="a name and three coordinates, or a header that names the columns x, y and z",
        )
    before = " ".join(cell for cell in cells[:first] if cell and not _is_number(cell))
    name = before or _LABEL.sub("", " ".join(cells[first + 3 :]))
    return PointRow(name, _numbers(cells[first : first + 3]), where) if name else None


def _numbers(texts: list[str]) -> Array:
    return np.array([float(text.lower().replace("d", "e")) for text in texts])


# --- names, side, unit, axes


def _plain(name: str) -> str:
    """Return a name as lower-case words: ``LowerWishboneFrontPivot`` and ``lower_wishbone-front pivot`` are one.

    >>> _plain("CHAS_LowFor_L"), _plain("hpl_lca_front"), _plain("LowerWishboneFrontPivot FL")
    ('chas low for l', 'hpl lca front', 'lower wishbone front pivot fl')
    """
    return " ".join(re.findall(r"[a-z0-9]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).lower()))


def _sort_out(name: str) -> tuple[str, str, str]:
    """Separate axle and side from the plain name of a point.

    >>> _sort_out("CHAS_LowFor_L"), _sort_out("hpr_lca_front"), _sort_out("Left tie rod inner")
    (('chas low for', '', 'left'), ('lca front', '', 'right'), ('tie rod inner', '', 'left'))
    """
    words = _plain(name).split()
    if words and words[0] in ("hpl", "hpr", "hps"):
        return " ".join(words[1:]), "", {"hpl": "left", "hpr": "right"}.get(words[0], "")
    for end in (0, -1):
        if len(words) > 1 and words[end] in _CORNERS:
            axle, side = _CORNERS[words.pop(end)]
            return " ".join(words), axle, side
    side = ""
    for end in (-1, 0):
        if len(words) > 1 and words[end] in _SIDES:
            side = _SIDES[words.pop(end)]
            break
    axle = words.pop(0) if len(words) > 2 and words[0] in ("front", "rear") else ""
    return " ".join(words), axle, side


def names_of_points() -> dict[str, str]:
    """Return jounce's names by plain name, for rig files and other programs."""
    names: dict[str, str] = {}
    for kind in Corner.__subclasses__():
        points = kind.model_fields["hardpoints"].annotation
        names |= {name.replace("_", " "): name for name in getattr(points, "model_fields", {})}
    for ours, theirs in _NAMES.items():
        names |= dict.fromkeys(theirs.split("|"), ours)
    return names | {theirs: ours for ours, theirs in _EXPLORER.items()}


def _required_points(model: str) -> list[str]:
    """Return the required points of a suspension model."""
    points: Any = RIGS[model].model_fields["hardpoints"].annotation
    return [name for name, info in points.model_fields.items() if info.is_required()]


def _missing(model: str, points: Mapping[str, Array]) -> list[str]:
    """Return missing required points; a strut needs two ends or none."""
    needed = [*_required_points(model), *(_STRUT if any(end in points for end in _STRUT) else ())]
    return [name for name in dict.fromkeys(needed) if name not in points]


class PointReading:
    """Converts a table of points to a rig."""

    def __init__(
        self, table: PointTable, side: str, axle: str | None, names: dict[str, str]
    ) -> None:
        self.table, self.file = table, table.file
        self.findings: list[Finding] = []
        self.estimated: list[str] = []
        self.contact: Array | None = None
        self.axle_end: Array | None = None
        self._both: Mapping[str, Mapping[str, PointRow]] = {}
        self.radius = table.radius.get(axle or "", next(iter(table.radius.values()), None))
        self.points = self._choose(side, axle, names)

    def note(self, code: str, value: float | None = None, /, **numbers: Any) -> None:
        """Add a finding from the catalogue."""
        self.findings.append(finding(code, str(self.file), value, **numbers))

    def _choose(self, side: str, axle: str | None, names: dict[str, str]) -> dict[str, Array]:
        """Return the points of the requested corner by jounce's names."""
        own = {_plain(theirs): ours for theirs, ours in names.items()}
        known = names_of_points()
        for theirs, ours in names.items():
            if ours not in known.values():
                raise unknown(ours, set(known.values()), what="hardpoint", where=f"name {theirs}")
            if not any(
                _plain(theirs) in (_plain(row.name), _sort_out(row.name)[0])
                for row in self.table.rows
            ):
                raise unknown(
                    theirs, [row.name for row in self.table.rows], what="name", where=str(self.file)
                )
        sorted_out = [(row, *_sort_out(row.name)) for row in self.table.rows]
        axles = {of_axle for _, _, of_axle, _ in sorted_out if of_axle}
        if axle is None and len(axles) > 1:
            hint = "Choose the axle to read with --axle front or --axle rear."
            raise DescriptionError("the table contains two axles", where=str(self.file), hint=hint)
        has_both = {of_side for _, _, _, of_side in sorted_out if of_side} == {"left", "right"}
        corners: dict[str, dict[str, PointRow]] = {"left": {}, "right": {}}
        unused = []
        for row, plain, of_axle, of_side in sorted_out:
            if axle and of_axle and of_axle != axle:
                continue
            ours = own.get(_plain(row.name), own.get(plain, known.get(plain, "")))
            ours = "contact" if plain in _CONTACT and not ours else ours
            ours = AXLE_END if plain == AXLE_END and not ours else ours
            if not ours:
                unused.append(row.name)
                continue
            for name in (of_side,) if of_side and has_both else ("left", "right"):
                self._keep(corners[name], ours, row)
        if has_both:
            self._both = corners
        if unused:
            self.note("parts.import_names_unknown", names=", ".join(unused[:30]))
        self.findings += [at_place(str(self.file), item) for item in self.table.notes]
        self.estimated += self.table.estimated
        for where, cells in self.table.unread:
            meant = next(
                (
                    cell
                    for cell in cells
                    if _plain(cell) in own or _sort_out(cell)[0] in (*own, *known)
                ),
                None,
            )
            if meant is not None:
                text, three = "a hardpoint without three coordinates", "a name and three numbers"
                raise DescriptionError(
                    f"{meant}: {text}",
                    where=where,
                    found=", ".join(filter(None, cells)),
                    allowed=three,
                )
        if self.table.unread:
            first = self.table.unread[0][0]
            self.note("parts.import_lines_unread", count=len(self.table.unread), first=first)
        chosen = {name: row.place for name, row in corners[side].items()}
        self.contact, self.axle_end = chosen.pop("contact", None), chosen.pop(AXLE_END, None)
        return chosen

    @staticmethod
    def _keep(points: dict[str, PointRow], name: str, row: PointRow) -> None:
        before = points.setdefault(name, row)
        if not np.array_equal(before.place, row.place):
            raise DescriptionError(
                Phrase("{name} is given twice", name=name),
                where=row.where,
                found=f"{row.name!r} at {row.place.tolist()}, and {before.name!r} at {before.place.tolist()} "
                f"({before.where})",
                allowed="each point once",
                hint="Distinguish the sides of the car by a column with left and right, or by names ending in them.",
            )

    def _refuse_one_side(self, across: Array) -> None:
        """Refuse left and right points on one side of the car; ``across`` is jounce's y in table axes."""
        for name, row in self._both.get("left", {}).items():
            other = self._both["right"].get(name)
            if other is None or row is other:
                continue
            y, other_y = across @ row.place, across @ other.place
            if y * other_y > 0.0:
                raise DescriptionError(
                    "left and right points are on the same side",
                    where=other.where,
                    found=f"{row.name} with y = {y:g}, {other.name} with y = {other_y:g}",
                    allowed="opposite signs of y",
                )

    def rig(
        self,
        unit: str | None,
        axes: str | None,
        model: str | None,
        wheel_radius: float | None,
        source: str | None,
    ) -> ImportedRig:
        """Return the rig, its findings, and the text of its file."""
        if wheel_radius is not None and not wheel_radius > 0.0:
            raise DescriptionError(
                "out of range", where="wheel_radius", found=wheel_radius, allowed="above 0"
            )
        name = self.model_of(model)
        self.complete(name)
        self.turn(axes)
        self.scale(unit)
        angles = self._wheel_angles()
        radius = self._stand(wheel_radius)
        table: dict[str, Any] = {
            "schema": "jounce.rig/1",
            "model": name,
            "source": f"hardpoints of {self.file.name}" if source is None else source,
            "estimated": self.estimated,
            "side": "left",
            "guide": "fixed",
            "hardpoints": {key: np.round(point, 9).tolist() for key, point in self.points.items()},
            "wheel": {"radius": radius, **angles},
        }
        strut = self.strut(name)
        if strut:
            table["strut"] = strut
        rig = cast(Corner, rig_from_table(table, where=str(self.file)))
        comments = [
            f"Left corner from the hardpoints of {self.file.name}: enough for its kinematics. Masses, springs, dampers "
            "and tyres are to be added before it can be simulated.",
            *(finding.message for finding in self.findings),
        ]
        text = rig_text(rig, comments)
        rig = cast(Corner, rig_from_table(tomllib.loads(text), where=str(self.file)))
        return ImportedRig(rig, self.findings, text)

    def model_of(self, model: str | None) -> str:
        """Return the suspension model with these points, or the requested model."""
        corners = {name: kind for name, kind in RIGS.items() if issubclass(kind, Corner)}
        if model is not None:
            if model not in corners:
                raise unknown(model, corners, what="suspension", where="model")
            return model
        has = self.points
        signs = {"link_1_inner": "five-link", "arm_inner": "trailing-arm"}
        signs |= dict.fromkeys(
            ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"), "double-wishbone"
        )
        signs["lower_arm_front"] = "mcpherson"
        for sign, name in signs.items():
            if sign in has:
                return name
        lacks = {name: _missing(name, has) for name in (*dict.fromkeys(signs.values()),)}
        near = min(lacks, key=lambda name: len(lacks[name]) / len(_required_points(name)))
        known = (
            f"The nearest is a {near}, of which {', '.join(lacks[near])} are missing. "
            if has
            else ""
        )
        raise DescriptionError(
            "no suspension has these points",
            where=str(self.file),
            found=", ".join(row.name for row in self.table.rows[:10]),
            allowed="points of a double wishbone, McPherson strut, five links or trailing arm",
            hint=known + _ADVICE,
        )

    def complete(self, model: str) -> None:
        """Refuse missing points, and drop points that the suspension does not have."""
        points: Any = RIGS[model].model_fields["hardpoints"].annotation
        if model == "five-link":  # where the toe link is called as in other suspensions
            self.points |= {
                f"link_5_{end}": self.points.pop(f"tie_rod_{end}")
                for end in ("inner", "outer")
                if f"tie_rod_{end}" in self.points and f"link_5_{end}" not in self.points
            }
        for end in ("bottom", "top"):
            if f"strut_{end}" not in self.points and f"spring_{end}" in self.points:
                self.points[f"strut_{end}"] = self.points.pop(f"spring_{end}")
                self.note("parts.import_end_of_spring", name=f"strut_{end}")
        missing = _missing(model, self.points)
        if missing:
            raise DescriptionError(
                Phrase("points of a {model} are missing", model=model),
                where=str(self.file),
                found=", ".join(self.points),
                allowed=Phrase("these points and {missing}", missing=", ".join(missing)),
                hint=_ADVICE,
            )
        further = [name for name in self.points if name not in points.model_fields]
        if further:
            self.note("parts.import_points_left_out", model=model, names=", ".join(further))
            self.points = {
                name: point for name, point in self.points.items() if name not in further
            }
        if "strut_bottom" not in self.points:
            self.note("parts.import_no_strut")

    def turn(self, axes: str | None) -> None:
        """Rotate from table axes to jounce's axes."""
        turn = np.eye(3) if axes is None else rotation_of(axes)
        self._refuse_one_side(turn[1])
        if axes is not None:
            self._map(turn)
        elif self._is_backward():
            self.note("parts.import_turned_round")
            self._map(np.diag([-1.0, 1.0, 1.0]))
        if self._is_backward():
            raise DescriptionError(
                "the arm's front lies behind its rear",
                where=str(self.file),
                found=f"lower_arm_front at x = {self.points['lower_arm_front'][0]:g}, lower_arm_rear at "
                f"x = {self.points['lower_arm_rear'][0]:g}, after axes {axes}",
                allowed="x forward",
                hint='Reverse x: --axes "-x,y,z".',
            )
        if self.points["wheel_centre"][1] < 0.0:
            self.note("parts.import_mirrored")
            self._map(np.diag([1.0, -1.0, 1.0]))

    def _is_backward(self) -> bool:
        front, rear = (self.points.get(f"lower_arm_{end}") for end in ("front", "rear"))
        return front is not None and rear is not None and bool(front[0] < rear[0])

    def _map(self, matrix: Array) -> None:
        self.points = {name: matrix @ point + 0.0 for name, point in self.points.items()}
        self.contact = None if self.contact is None else matrix @ self.contact
        self.axle_end = None if self.axle_end is None else matrix @ self.axle_end

    def _outboard(self) -> Array:
        """Return the unit direction of the left wheel's axis; lateral if the table has none."""
        if self.axle_end is None:
            return np.array([0.0, 1.0, 0.0])
        along = self.axle_end - self.points["wheel_centre"]
        if not np.any(along):
            raise DescriptionError("the wheel's axis has no direction", where=str(self.file))
        return along / (np.linalg.norm(along) * (-1.0 if along[1] < 0.0 else 1.0))

    def _wheel_angles(self) -> dict[str, float]:
        """Return camber and toe (rad), if the table has the wheel's axis."""
        x, y, z = self._outboard()
        return (
            {}
            if self.axle_end is None
            else {"camber": float(-np.arcsin(z)), "toe": float(np.arctan2(x, y))}
        )

    def scale(self, unit: str | None) -> None:
        """Convert from the table's unit to metres."""
        said = self.table.unit
        if unit is not None:
            conversion_factor(unit, "m", where="unit")
            if said and conversion_factor(said, "m") != conversion_factor(unit, "m"):
                self.note("parts.import_other_unit", said=said, unit=unit)
        half = abs(float(self.points["wheel_centre"][1]))
        low, high = _HALF_TRACK
        chosen = unit or said
        meant = [
            name
            for name in ("m", "mm", "inch", "cm")
            if low <= half * conversion_factor(name, "m") <= high
        ]
        if not chosen:
            if meant[:1] not in (["m"], ["mm"]) or len(meant) > 1:
                raise DescriptionError(
                    "the file does not state the unit, and the points do not reveal it",
                    where=str(self.file),
                    found=f"a wheel centre {half:g} from the middle of the car",
                    allowed="--unit mm, m, inch or cm",
                    hint=Phrase("The table may be in {meant}.", meant=" or ".join(meant))
                    if meant
                    else "",
                )
            chosen = meant[0]
            self.note("parts.import_unit_guessed", unit=chosen, half=half)
        factor = conversion_factor(chosen, "m", where="unit")
        if not low <= half * factor <= high:
            raise DescriptionError(
                "an implausible half track width",
                where=str(self.file),
                found=f"a wheel centre {half:g} {chosen} = {half * factor:.4g} m from the middle of the car",
                allowed=Phrase("{low:g} m to {high:g} m", low=low, high=high),
                hint=Phrase("Is the table in {meant}? Then state --unit.", meant=" or ".join(meant))
                if meant
                else "",
            )
        self._map(factor * np.eye(3))

    def _stand(self, wheel_radius: float | None) -> float:
        """Move the points so that the wheel is on the road, z = 0; return its radius in m."""
        height = float(self.points["wheel_centre"][2])
        if self.contact is None and self.radius is not None:
            axle = self._outboard()
            down = axle * axle[2] - np.array([0.0, 0.0, 1.0])
            self.contact = self.points["wheel_centre"] + self.radius * down / np.linalg.norm(down)
        wheel_radius = self.radius if wheel_radius is None else wheel_radius
        if self.contact is not None:
            height -= float(self.contact[2])
            radius = height if wheel_radius is None else wheel_radius
            if abs(self.contact[2]) > 1e-6:
                self.note("parts.import_road_at_contact", height=float(self.contact[2]))
            self._raise(-float(self.contact[2]))
        elif wheel_radius is not None:
            radius = wheel_radius
            # A wheel centre is lower by the tyre deflection, at most a quarter, and higher only by rounding.
            if not 0.75 * radius <= height <= 1.02 * radius:
                self.note("parts.import_moved_up", height=height)
                self._raise(radius - height)
                height = radius
        else:
            radius = height
        if not _RADIUS[0] <= height <= _RADIUS[1]:
            raise DescriptionError(
                "the height of the road is not in the table",
                where=str(self.file),
                found=f"a wheel centre {1e3 * height:.4g} mm above z = 0",
                allowed=Phrase(
                    "{radius:g} mm to {second_radius:g} mm",
                    radius=1000.0 * _RADIUS[0],
                    second_radius=1000.0 * _RADIUS[1],
                ),
                hint="Give --wheel-radius: the wheel then stands on the road.",
            )
        if wheel_radius is None:
            self.estimated.append("wheel.radius")
            self.note("parts.import_radius_taken", radius, radius=radius)
        return round(radius, 9)

    def _raise(self, height: float) -> None:
        self.points = {
            name: point + np.array([0.0, 0.0, height]) for name, point in self.points.items()
        }

    def strut(self, model: str) -> dict[str, str]:
        """Choose the body that carries the strut or push rod: the arm nearest to its end."""
        end = "pushrod_outer" if "pushrod_outer" in self.points else "strut_bottom"
        if end not in self.points:
            return {}
        key = "pushrod_on" if end == "pushrod_outer" else "on"
        rocker = {"on": "rocker"} if key == "pushrod_on" else {}
        if self.table.carrier in cast(type[Corner], RIGS[model]).needed_bodies:
            return {key: self.table.carrier} | rocker
        if model != "double-wishbone":
            return {}
        reach = {arm: self._reach(arm, end) for arm in ("lower", "upper")}
        arm = min(reach, key=lambda name: reach[name])
        self.note(
            "parts.import_on_lower_arm" if arm == "lower" else "parts.import_on_upper_arm",
            end=end,
            key=key,
        )
        self.estimated.append(f"strut.{key}")
        return {key: f"{arm}_arm"} | rocker

    def _reach(self, arm: str, end: str) -> float:
        """Return the distance of a point from the line between the arm's middle and its ball joint."""
        middle = 0.5 * (self.points[f"{arm}_arm_front"] + self.points[f"{arm}_arm_rear"])
        joint = self.points[f"{arm}_ball_joint"]
        return (
            distance_to_line(self.points[end], middle, joint) if np.any(middle != joint) else np.inf
        )


def rotation_of(axes: str) -> Array:
    """Return the rotation matrix for axes such as ``"-x,-y,z"``."""
    words = [word.strip().lower() for word in axes.split(",")]
    matches = [re.fullmatch(r"([+-]?)([xyz])", word) for word in words]
    if (
        len(words) != 3
        or not all(matches)
        or {match[2] for match in matches if match} != {"x", "y", "z"}
    ):
        raise DescriptionError(
            "three axes are required",
            where="axes",
            found=axes,
            allowed='x, y and z of jounce by the axes of the table, such as "-x,-y,z"',
        )
    turn = np.zeros((3, 3))
    for row, match in enumerate(matches):
        assert match is not None
        turn[row, "xyz".index(match[2])] = -1.0 if match[1] == "-" else 1.0
    return turn
