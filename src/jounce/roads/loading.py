"""Loading of road files, of a campaign's named roads, and of the shipped courses."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from jounce.core.description import join_path, line_of, read_toml
from jounce.core.errors import DescriptionError, at_line, below, unknown
from jounce.core.files import find_file, shipped_files
from jounce.core.phrases import Phrase
from jounce.roads.measured import Crg, Table
from jounce.roads.road import ROADS, Road
from jounce.roads.rough import Iso8608, class_roughness

SCHEMA = "jounce.road/1"
_SUFFIXES = (".toml", ".crg", ".csv", ".txt", ".tsv")


def road_library() -> dict[str, Path]:
    """Return the files of the shipped measured courses by name.

    Examples
    --------
    >>> list(road_library())
    ['detrended_rms_course_1in']
    """
    return shipped_files("jounce.roads", "library", ".crg")


def source_of_course(file: Path) -> str:
    """Return the entry of a shipped course in its list of sources (``SOURCE.md``); empty without one.

    Examples
    --------
    >>> "BSD" in source_of_course(road_library()["detrended_rms_course_1in"])
    True
    """
    sources = file.parent / "SOURCE.md"
    lines = sources.read_text(encoding="utf-8").splitlines() if sources.is_file() else []
    about = [line for line in lines if file.name in line]
    return (
        "; ".join(cell.replace("`", "").strip() for cell in about[0].strip("|").split("|")[1:])
        if about
        else ""
    )


def load_road(path: Path | str, *, length: float | None = None) -> Road:
    """Load a road from a file, a shipped course by name, or generate a rough road of a class.

    Parameters
    ----------
    path : Path or str
        A TOML file with one road table at top level, an OpenCRG file (``.crg``, at lateral offset 0), a text table
        (``.csv``, ``.txt``, ``.tsv``) with the columns ``x`` and ``z``, or a name of `road_library`; or ``"iso:C"``,
        ``"iso:C:7"`` for a road of an ISO 8608 class (and seed, 0).
    length : float, optional
        Length in m of a road generated from a class, by default 1000 m; ignored for other roads.

    Returns
    -------
    Road
        Frozen description.

    Raises
    ------
    DescriptionError
        With file, line and path: if the description is invalid or the file type unknown.
    RecordingError
        If a measured file is damaged or missing.

    Examples
    --------
    >>> course = load_road("detrended_rms_course_1in")
    >>> round(course.end(), 9)
    504.75
    """
    if is_class(path):
        return _of_class(str(path), length)
    file = find_file(path, road_library(), "road", others="a path to a file, iso:A to iso:H")
    suffix = file.suffix.lower()
    if suffix == ".crg":
        return Crg(file=file)
    if suffix == ".toml":
        table, text = read_toml(file)
        return _Reader({}, str(file), text, file.parent).build(
            _without_schema(table, str(file)), ()
        )
    if suffix in _SUFFIXES:
        return Table(file=file)
    raise DescriptionError(
        "not a road file", where=str(file), found=suffix, allowed=", ".join(_SUFFIXES)
    )


def read_roads(
    tables: Mapping[str, Any],
    *,
    where: str = "",
    text: str = "",
    folder: Path | str = ".",
    path: tuple[str, ...] = ("roads",),
) -> dict[str, Road]:
    """Build named roads; the ``of`` of a train or an enveloped road may refer to any other name.

    Parameters
    ----------
    tables : mapping of str to dict
        Road tables by name; ``kind`` selects the type of road.
    where, text : str
        File name and content, for locations in errors.
    folder : Path or str
        Base folder of relative ``file`` entries.
    path : tuple of str
        Position of the tables in the file.

    Returns
    -------
    dict of str to Road
        Roads in the order of ``tables``.

    Raises
    ------
    DescriptionError
        For invalid fields, unknown kinds and names (with the nearest match), and circular references.

    Examples
    --------
    >>> roads = read_roads({
    ...     "B": {"kind": "train", "of": "A", "count": 5, "pitch": "0.10 m"},
    ...     "A": {"kind": "half-sine", "height": "10 mm", "length": "60 mm"},
    ... })
    >>> roads["B"].end()
    0.46
    """
    reader = _Reader(tables, where, text, Path(folder), path)
    return {name: reader.build_named(name, ()) for name in tables}


def class_and_seed(text: str) -> tuple[str, int | None]:
    """Split ``iso:CLASS`` or ``iso:CLASS:SEED`` into class and seed (None if omitted).

    Examples
    --------
    >>> class_and_seed("iso:C:7"), class_and_seed("iso:a")
    (('C', 7), ('A', None))
    """
    _, name, *seeds = text.split(":")
    if len(seeds) > 1 or (seeds and not seeds[0].isdecimal()):
        raise DescriptionError(
            "not a road class", where=text, allowed="iso:CLASS or iso:CLASS:SEED, e.g. iso:C:7"
        )
    try:
        class_roughness(name)
    except DescriptionError as error:
        raise DescriptionError(error.what, where=text, allowed=error.allowed) from None
    return name.strip().upper(), int(seeds[0]) if seeds else None


def is_class(text: object) -> bool:
    """Whether a road is given as ``iso:CLASS``, with or without a seed."""
    return isinstance(text, str) and text.lower().startswith("iso:")


def _of_class(text: str, length: float | None) -> Iso8608:
    """Return the road of ``iso:CLASS`` or ``iso:CLASS:SEED``."""
    name, seed = class_and_seed(text)
    table = {"class": name, "length": 1000.0 if length is None else length, "seed": seed or 0}
    return Iso8608.from_table({"kind": "iso-8608", **table}, where=text)


def _without_schema(table: dict[str, Any], where: str) -> dict[str, Any]:
    schema = table.get("schema", SCHEMA)
    if schema != SCHEMA:
        raise DescriptionError(
            "not a road file",
            where=where,
            found=schema,
            allowed=Phrase('schema = "{schema}", or no schema line', schema=SCHEMA),
        )
    return {key: value for key, value in table.items() if key != "schema"}


class _Reader:
    """Builder of the roads of one file, with a cache of those already built."""

    def __init__(
        self,
        tables: Mapping[str, Any],
        where: str,
        text: str,
        folder: Path,
        above: tuple[str, ...] = (),
    ) -> None:
        self.tables, self.where, self.text, self.folder, self.above = (
            tables,
            where,
            text,
            folder,
            above,
        )
        self.built: dict[str, Road] = {}

    def build_named(self, name: str, asked_by: tuple[str, ...]) -> Road:
        """Build a road by name; ``asked_by`` lists the names under construction."""
        if name in asked_by:
            circle = " of ".join(repr(step) for step in (*asked_by[asked_by.index(name) :], name))
            raise DescriptionError(
                Phrase(
                    "the {tables} contains itself: {circle}",
                    tables=self.tables[name]["kind"],
                    circle=circle,
                ),
                where=self._place((*self.above, name, "of")),
                hint="Remove the circular reference.",
            )
        if name not in self.built:
            self.built[name] = self.build(self.tables[name], (*self.above, name), (*asked_by, name))
        return self.built[name]

    def build(self, table: Any, path: tuple[str, ...], asked_by: tuple[str, ...] = ()) -> Road:
        """Build the road of the table at ``path``."""
        resolved = self._resolve(table, path, asked_by)
        kind: type[Road] = ROADS[resolved["kind"]]
        return kind.from_table(resolved, where=self.where, text=self.text, path=path)

    def _resolve(
        self, table: Any, path: tuple[str, ...], asked_by: tuple[str, ...]
    ) -> dict[str, Any]:
        """Return the table with its kind checked, a named ``of`` built, and ``file`` relative to the right folder."""
        if not isinstance(table, dict):
            place = self._place(path)
            raise DescriptionError(
                "not a road table", where=place, found=table, allowed='{kind = "...", ...}'
            )
        kind = table.get("kind")
        if kind is None:
            kinds = ", ".join(sorted(ROADS))
            raise DescriptionError(
                "the key 'kind' is missing", where=self._place(path), allowed=kinds
            )
        if not isinstance(kind, str) or kind not in ROADS:
            raise unknown(str(kind), ROADS, what="kind of road", where=self._place((*path, "kind")))
        resolved = dict(table)
        if isinstance(table.get("file"), str):
            resolved["file"] = self.folder / table["file"]
        if "of" in ROADS[kind].model_fields and "of" in table:
            resolved["of"] = self._obstacle(table["of"], (*path, "of"), asked_by)
        return resolved

    def _obstacle(self, of: Any, path: tuple[str, ...], asked_by: tuple[str, ...]) -> Any:
        if isinstance(of, dict):
            return self._resolve(of, path, asked_by)
        if not isinstance(of, str):
            raise DescriptionError(
                "not a road",
                where=self._place(path),
                found=of,
                allowed='the name of a road, or {kind = "...", ...}',
            )
        if of not in self.tables:
            if not self.tables:
                raise DescriptionError(
                    "a road file cannot refer to other roads",
                    where=self._place(path),
                    found=of,
                    allowed='of = {kind = "...", ...}',
                )
            raise unknown(of, self.tables, what="road", where=self._place(path))
        return self.build_named(of, asked_by)

    def _place(self, path: tuple[str, ...]) -> str:
        line = line_of(self.text, path) if self.text else None
        return below(at_line(self.where, line) if self.where else "", join_path(path))
