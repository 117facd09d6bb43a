"""Records that a server has read and computed, for the processes that work on them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from jounce.analysis.layouts import Formula
from jounce.core.errors import DescriptionError, JounceError
from jounce.web.levels import ABOUT, Levels


class RecordSource(Protocol):
    """What opens records by their paths, and computes their channels."""

    def open(self, path: str) -> Levels:
        """Return a record."""

    def compute(
        self, opened: Mapping[str, Levels], formulas: Sequence[Formula]
    ) -> Mapping[str, JounceError]:
        """Compute channels of records; return what failed, by record."""


@dataclass(frozen=True)
class StoredRecords:
    """Records in their folders by path, with their computed channels."""

    folders: Mapping[str, str]

    def open(self, path: str) -> Levels:
        """Return a record."""
        if path not in self.folders:
            raise DescriptionError("not shown", where=path)
        folder = Path(self.folders[path])
        return Levels(folder, json.loads((folder / ABOUT).read_text(encoding="utf-8")))

    def compute(
        self,
        opened: Mapping[str, Levels],  # noqa: ARG002 - all are computed
        formulas: Sequence[Formula],  # noqa: ARG002
    ) -> Mapping[str, JounceError]:
        """Return nothing, since everything is computed."""
        return {}
