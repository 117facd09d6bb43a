"""Keys of descriptions for information missing in a measured file: columns, clock and time step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.core.description import Description
from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import PositiveTime

if TYPE_CHECKING:
    import xarray as xr

    from jounce.recordings.sensors import Sensor


class TableFormat(Description):
    """Keys of files with columns: ``columns`` and ``variable`` as in `read_columns`."""

    columns: dict[str, str] = {}
    variable: str = ""

    def read_columns(
        self, file: Path, wanted: Mapping[str, str] | Sequence[Mapping[str, str]]
    ) -> tuple[dict[str, Array], list[Finding]]:
        """Read the wanted columns (name to SI unit) of a file, or the first available of several sets."""
        from jounce.recordings.files import read_columns

        return read_columns(file, wanted, columns=self.columns or None, variable=self.variable)


class RecordingFormat(TableFormat):
    """Keys of recordings: ``sample_time``, ``resample`` and ``database`` as in `read_recording`."""

    sample_time: PositiveTime | None = None
    resample: PositiveTime | None = None
    database: str = ""

    def read(
        self, file: Path, folder: Path, sensors: Mapping[str, Sensor] | None = None
    ) -> tuple[xr.Dataset, list[Finding]]:
        """Read a recording; a relative database path is relative to the folder of the description."""
        from jounce.recordings.files import read_recording

        return read_recording(
            file,
            columns=self.columns or None,
            sample_time=self.sample_time,
            variable=self.variable,
            resample=self.resample,
            database=folder / self.database if self.database else None,
            sensors=sensors,
        )

    def signal(self, file: Path, folder: Path, channel: str) -> tuple[Array, Array, list[Finding]]:
        """Read one channel of a recording: time (s), values (SI), and the reader's findings."""
        data, findings = self.read(file, folder)
        if channel not in data:
            raise RecordingError(
                Phrase("no channel {channel!r}", channel=channel),
                where=str(file),
                found=", ".join(map(str, data.data_vars)),
                hint=Phrase(
                    'Map the column of the channel, e.g. columns = {{"{channel}" = "COLUMN [unit]"}}.',
                    channel=channel,
                ),
            )
        return data["time"].to_numpy(), data[channel].to_numpy(), findings
