"""Reader of Adams text files (TeimOrbit): blocks of keys and tables, and their units."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from jounce.core.errors import DescriptionError, at_line
from jounce.core.files import content_of, existing_file
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import conversion_factor

UNITS = {
    "LENGTH": {"meter metre m": "m", "millimeter millimetre mm": "mm", "centimeter centimetre cm": "cm",
               "kilometer kilometre km": "km", "inch in": "inch", "foot feet ft": "foot"},
    "FORCE": {"newton newtons n": "N", "kilo_newton kilonewton kn": "kN", "kilogram_force kgf": "kgf",
              "pound_force lbf": "lbf", "dyne": "dyne", "ounce_force": "ounce_force"},
    "TIME": {"second seconds sec s": "s", "millisecond ms": "ms", "minute min": "minute", "hour": "hour"},
    "PRESSURE": {"pascal pa n/m^2": "Pa", "kilopascal kpa": "kPa", "megapascal mpa n/mm^2": "MPa", "bar": "bar",
                 "psi": "psi"},
    "MASS": {"kilogram kg": "kg", "gram g": "gram", "pound_mass pound lbm lb": "pound", "megagram tonne": "tonne",
             "slug": "slug"},
    "ANGLE": {"radians radian rad": "rad", "degrees degree deg": "deg"},
}  # fmt: skip
SI = {"LENGTH": "m", "FORCE": "N", "TIME": "s", "PRESSURE": "Pa", "MASS": "kg", "ANGLE": "rad"}
"""Unit names in files by quantity, with their SI-convertible units."""
_BLOCK = re.compile(r"\[\s*([A-Za-z0-9_ \t-]+?)\s*\]")
_VALUE = re.compile(r"([A-Za-z_]\w*)\s*=\s*(.*)")
_BEFORE_COMMENT = re.compile(r"(?:[^'$!]|'[^']*')*")  # $ and ! start a comment, except in quotes
_CELL = re.compile(r"'([^']*)'|(\S+)")
_LARGEST = 20_000_000  # bytes: far above the size of real files; protects memory


@dataclass
class Block:
    """Block of a file: keys, table rows, and comments, which contain Adams' dependent values."""

    name: str
    where: str
    values: dict[str, str] = field(default_factory=dict)
    rows: list[tuple[list[str], str]] = field(default_factory=list)
    comments: list[str] = field(default_factory=list)

    @property
    def usage(self) -> str:
        """Usage of the block, in lower case."""
        return self.values.get("USAGE", "").lower()

    def number(self, key: str, default: float | None = None) -> float:
        """Return the number of a key in file units; without a default, a missing key is an error."""
        text = self.values.get(key)
        if text is None:
            if default is None:
                raise DescriptionError(
                    Phrase("{key} is missing", key=key), where=self.where, allowed="a number"
                )
            return default
        return number(text, f"{self.where}: {key}")

    def curve(self, length: float, force: float) -> tuple[Array, Array]:
        """Return two columns of a table in SI; the first must ascend."""
        rows = [
            [number(cell, where) for cell in cells[:2]]
            for cells, where in self.rows
            if len(cells) >= 2
        ]
        if len(rows) < 2:
            raise DescriptionError("no curve", where=self.where, allowed="rows of two numbers")
        columns = np.array(rows) * [length, force]
        if np.any(np.diff(columns[:, 0]) <= 0.0):
            raise DescriptionError("the first column does not increase", where=self.where)
        return columns[:, 0], columns[:, 1]


def number(text: str, where: str) -> float:
    """Parse a finite number; refuse anything else."""
    try:
        value = float(text.lower().replace("d", "e"))
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise DescriptionError("not a number", where=where, found=text)
    return value


@dataclass
class TeimOrbit:
    """Parsed TeimOrbit file with its blocks in order.

    Attributes
    ----------
    path : Path
        The file.
    blocks : list of Block
        All blocks; names may occur several times.
    """

    path: Path
    blocks: list[Block]

    def blocks_of(self, name: str) -> list[Block]:
        """Return all blocks of a name."""
        return [block for block in self.blocks if block.name == name]

    def first(self, name: str) -> Block:
        """Return the first block of a name; raise an error if there is none."""
        blocks = self.blocks_of(name)
        if not blocks:
            raise DescriptionError(
                Phrase("the block [{name}] is missing", name=name), where=str(self.path)
            )
        return blocks[0]

    def unit(self, quantity: str) -> float:
        """Return the SI value of the file's unit of a quantity (LENGTH, FORCE, TIME, MASS, ANGLE)."""
        block = self.first("UNITS")
        text = block.values.get(quantity, "").lower()
        for words, unit in UNITS[quantity].items():
            if text in words.split():
                return conversion_factor(unit, SI[quantity])
        allowed = ", ".join(word for words in UNITS[quantity] for word in words.split())
        raise DescriptionError(
            Phrase("no unit for {quantity}", quantity=quantity),
            where=block.where,
            found=text or None,
            allowed=allowed,
        )


def read_teim_orbit(path: Path | str) -> TeimOrbit:
    """Read the blocks of an Adams text file; refuse missing, large or binary files, and files without blocks."""
    file = existing_file(path)
    if file.stat().st_size > _LARGEST:
        raise DescriptionError(
            "too large for a text file of Adams", where=str(file), allowed="up to 20 MB"
        )
    content = content_of(file)
    if b"\0" in content:
        raise DescriptionError("not a text file", where=str(file), allowed="an Adams text file")
    blocks: list[Block] = []
    for count, line in enumerate(content.decode("cp1252", errors="replace").splitlines(), 1):
        bare, where = line.strip(), at_line(file, count)
        if bare.startswith(("$", "!")):
            if blocks:
                blocks[-1].comments.append(bare.lstrip("$! "))
            continue
        text = _BEFORE_COMMENT.match(bare)
        bare = text[0].strip() if text else ""
        if match := _BLOCK.fullmatch(bare):
            blocks.append(Block(match[1].strip().upper(), where))
        elif bare.startswith("(") and blocks:  # part of the block with a separate table
            blocks.append(
                Block(f"{blocks[-1].name.partition('/')[0]}/{bare.strip('()').upper()}", where)
            )
        elif not blocks or not bare or bare.startswith("{"):
            continue
        elif match := _VALUE.fullmatch(bare):
            blocks[-1].values.setdefault(match[1].upper(), match[2].strip().strip("'").strip())
        else:
            blocks[-1].rows.append(([(a or b).strip() for a, b in _CELL.findall(bare)], where))
    if not blocks:
        raise DescriptionError(
            "the file contains no [BLOCKS]", where=str(file), allowed="an Adams text file"
        )
    return TeimOrbit(file, blocks)
