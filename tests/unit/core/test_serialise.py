"""Results as plain data, and in files whose suffix chooses the format."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import OutputError
from jounce.core.serialise import Plain, to_plain
from jounce.core.writing import Formats


@dataclass(frozen=True)
class Corner(Plain):
    mass: float
    curve: tuple[float, ...]

    left_out = ("curve",)
    also = ("weight",)

    @property
    def weight(self) -> np.float64:
        return np.float64(10.0 * self.mass)


@dataclass(frozen=True)
class Axle(Plain):
    corners: tuple[Corner, ...]
    gap: float = float("nan")


def test_fields_become_plain_data_also_of_results_within():
    axle = Axle((Corner(2.0, (1.0, 2.0)),))
    assert axle.to_dict() == {"corners": [{"mass": 2.0, "weight": 20.0}], "gap": None}
    assert to_plain({"front": axle}) == {"front": axle.to_dict()}


FORMATS = Formats(
    "axles", {".txt": lambda axle, file: file.write_text(repr(axle), encoding="utf-8")}
)


def test_suffix_chooses_the_format(tmp_path: Path):
    file = FORMATS.write(Axle(()), tmp_path / "axle.TXT")
    assert file.read_text(encoding="utf-8") == "Axle(corners=(), gap=nan)"
    assert list(tmp_path.iterdir()) == [file]


def test_other_suffixes_and_existing_files_are_refused(tmp_path: Path):
    with pytest.raises(
        OutputError, match=r"axles are not written in this format; found '\.doc'; allowed: \.txt"
    ):
        FORMATS.check(tmp_path / "axle.doc")
    file = FORMATS.write(Axle(()), tmp_path / "axle.txt")
    with pytest.raises(OutputError, match="the output already exists"):
        FORMATS.write(Axle(()), file)
    FORMATS.write(Axle(()), file, force=True)
