"""A damper map from its files: a folder of records, a record, or a table of forces over velocity."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, TypeAlias

from jounce.core.operation import File
from jounce.dampers.map import DamperMap, damper_map
from jounce.dampers.tables import is_map_table, settings_of_table

MAP = File(
    "A damper map: a table of `jounce damper map --out` or of the damper's maker, or a folder of records with "
    "settings.csv.",
    "MAP",
)
AnyDamperMap: TypeAlias = Annotated[DamperMap | str | Path, MAP]
"""A damper map or its file."""


def read_damper_map(source: str | Path) -> DamperMap:
    r"""Read the map of a damper from a table of forces over velocity, or make it from records of a test rig.

    Parameters
    ----------
    source : str or Path
        A table (CSV, text or workbook) with the columns ``velocity`` and ``force``, and where they are known
        ``clicks`` (or ``bump clicks``, ``rebound clicks``, ``low-speed bump clicks``, ...), ``temperature``,
        ``gas pressure``, ``low`` and ``high`` (ends of the 95 % interval), ``gas force``, ``gas stiffness``,
        ``friction`` and ``lag``: SI unless a heading states a unit, bump and compression positive, force without that
        of the gas. :meth:`jounce.DamperMap.table` writes such a table. Else a record or a folder of records, for
        :func:`jounce.damper_map`; a table ``settings.csv`` in the folder states the settings of each file.

    Returns
    -------
    DamperMap
        The map; without intervals where the table has none.

    Raises
    ------
    RecordingError, FitError, DescriptionError
        If the table or the records cannot be read.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> sheet = pathlib.Path(tempfile.mkdtemp()) / "sheet.csv"
    >>> _ = sheet.write_text("clicks,velocity [mm/s],force [N]\n0,-100,-250\n0,100,150\n8,-100,-170\n8,100,130\n")
    >>> made = jn.read_damper_map(sheet)
    >>> made.clicks, made.at(4.0).force.tolist()
    ((0.0, 8.0), [-210.0, 140.0])
    """
    path = Path(source)
    if path.is_file() and is_map_table(path):
        return DamperMap("peak", settings_of_table(path), (), ())
    table = path / "settings.csv"
    return damper_map([path], table if table.is_file() else None)


def as_damper_map(given: DamperMap | str | Path) -> DamperMap:
    """Return a map as it is, or read its file."""
    return given if isinstance(given, DamperMap) else read_damper_map(given)
