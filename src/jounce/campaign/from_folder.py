"""Creation of a campaign from a folder: inspect every file, and write the campaign that files and settings define."""

from __future__ import annotations

import math
import os
import re
import tomllib
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import tomlkit

from jounce.campaign.laboratory import (
    CardChannel,
    Laboratory,
    TrialRow,
    load_laboratory,
    read_trials,
    unread_headings,
)
from jounce.campaign.recogniser import RecognisedFile, recognise
from jounce.core.columns import name_and_unit
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.serialise import to_plain
from jounce.core.shown import Shown
from jounce.core.writing import write_files
from jounce.identify.calibration import Calibration, read_calibration
from jounce.recordings.conditioning import sensitivity_of
from jounce.recordings.schema import channel_unit

Strategies = Literal["default", "paper"]
_FITTED = 3
"""Number of trials fitted by default: with three or more, the intervals of an update include model error."""
_START_DAMPING = "150 N*s/m"
"""Start value of the damper; its bounds range from 0.2 to 3 times this value."""
_DAMPING_BOUNDS = ["30 N*s/m", "450 N*s/m"]
_TYRE_DAMPING_BOUNDS = ["0 N*s/m", "100 N*s/m"]
"""Tyre damping is rarely measured; fixed at a guess, it would bias the estimates of damper and masses."""
_SAME_PRESSURE = 0.02
"""Relative tolerance within which a pressure in a file name matches the pressure in the table."""
_SAME_RATE = 0.01
"""Relative tolerance within which sample rates of records count as equal."""
_AGREES = 0.03
"""Relative difference between a calibration and the sensor's stated sensitivity above which a finding is reported."""


@dataclass(frozen=True)
class FolderCampaign(Shown):
    """A campaign made from a folder.

    Attributes
    ----------
    campaign : Path
        The campaign file.
    files : tuple of RecognisedFile
        Every file of the folder with its recognised kind.
    findings : tuple of Finding
        Missing or ambiguous information.
    """

    campaign: Path
    files: tuple[RecognisedFile, ...]
    findings: tuple[Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return plain data: files with their recognised kinds, and findings."""
        files = [
            {
                "file": item.file.name,
                "kind": item.kind,
                "why": item.why,
                "columns": item.columns,
                "number": item.number,
                "pressure": item.pressure,
                "doubt": item.doubt,
            }
            for item in self.files
        ]
        return {
            "campaign": str(self.campaign),
            "files": files,
            "findings": to_plain(list(self.findings)),
        }


def campaign_from_folder(
    folder: Path | str,
    source: Path | str,
    *,
    settings: Path | str | None = None,
    strategies: Strategies = "default",
    force: bool = False,
) -> FolderCampaign:
    """Inspect every file of a laboratory's folder and write the campaign that they define.

    Parameters
    ----------
    folder : Path or str
        Folder in which ``campaign.toml`` and ``rig.toml`` are written; created if necessary.
    source : Path or str
        Folder of the laboratory's files, which are neither moved nor changed.
    settings : Path or str, optional
        Handwritten settings (schema ``jounce.laboratory/1``); default: the file with this schema in ``source``.
    strategies : {"default", "paper"}
        Updates: one with all parameters free, or the three of the quarter-car prototype paper.
    force : bool
        Overwrite existing files.

    Returns
    -------
    FolderCampaign
        The written campaign file, the recognised kind of each file, and findings.

    Raises
    ------
    RecordingError
        If the folder does not exist or has no table of trials.
    DescriptionError
        If the settings are missing or invalid.
    OutputError
        If a file exists and ``force`` is not set.

    Examples
    --------
    >>> import tempfile
    >>> campaign_from_folder("mine", tempfile.mkdtemp())   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: ...: no settings of the laboratory; ...
    """
    place = Path(source)
    known = _settings_of(place, settings)
    laboratory = load_laboratory(known)
    files = recognise(place, laboratory)
    raw = tomllib.loads(known.read_text(encoding="utf-8"))
    maker = _Maker(Path(folder), place, laboratory, raw, files, strategies)
    text = maker.campaign()
    written = {
        "campaign.toml": text.encode(),
        **({} if laboratory.rig else {"rig.toml": maker.rig().encode()}),
    }
    write_files(Path(folder), written, force=force)
    return FolderCampaign(Path(folder) / "campaign.toml", tuple(files), tuple(maker.findings))


def _settings_of(source: Path, given: Path | str | None) -> Path:
    if given is not None:
        return Path(given)
    files = [
        file
        for file in sorted(source.glob("*.toml"))
        if "jounce.laboratory/" in file.read_text(errors="replace")
    ]
    if len(files) != 1:
        raise DescriptionError(
            "no settings of the laboratory" if not files else "several settings of a laboratory",
            where=str(source),
            found=", ".join(file.name for file in files) or None,
            allowed='one TOML file with schema = "jounce.laboratory/1", or --settings FILE',
            hint="The file states both masses, the obstacle, the belt and the channels of the data acquisition card.",
        )
    return files[0]


class _Maker:
    """Writer of a campaign, which also collects findings about missing information."""

    def __init__(
        self,
        folder: Path,
        source: Path,
        laboratory: Laboratory,
        raw: Mapping[str, Any],
        files: Sequence[RecognisedFile],
        strategies: Strategies,
    ) -> None:
        self.folder, self.source, self.laboratory, self.strategies = (
            folder,
            source,
            laboratory,
            strategies,
        )
        self.raw = raw
        self.files, self.findings = files, list[Finding]()
        self.left_out = set[Path]()
        self.rows = {row.number: row for row in self._table()}
        for item in files:
            if item.kind == "unknown":
                self._note("campaign.file_left_out", item.file.name, why=item.why)
            elif item.doubt:
                self._note(
                    self._doubt_code(item),
                    item.file.name,
                    kind=item.kind,
                    why=item.why,
                    doubt=item.doubt,
                )

    def _note(self, code: str, place: str, value: float | None = None, **numbers: Any) -> None:
        self.findings.append(finding(code, place, value, **numbers))

    def _of(self, kind: str) -> list[RecognisedFile]:
        return [item for item in self.files if item.kind == kind and item.file not in self.left_out]

    def _doubt_code(self, item: RecognisedFile) -> str:
        """Return the finding's code for a file of ambiguous kind; exclude the file if other tests are unambiguous."""
        sure = [other for other in self.files if other.kind == item.kind and not other.doubt]
        if item.kind not in ("spring", "tyre") or not sure:
            return "campaign.file_in_doubt"
        self.left_out.add(item.file)
        return "campaign.doubtful_test_left_out"

    def _table(self) -> list[TrialRow]:
        tables = [item.file for item in self._of("table of trials")]
        if self.laboratory.trials:
            tables = [self.source / self.laboratory.trials]
        if len(tables) != 1:
            raise DescriptionError(
                "no table of trials" if not tables else "several tables of trials",
                where=str(self.source),
                found=", ".join(file.name for file in tables) or None,
                allowed="one CSV or XLSX with columns trial, speed, angle, pressure, profile",
                hint='Name the table in the settings: trials = "table.csv".',
            )
        rows, unread = read_trials(tables[0]), unread_headings(tables[0])
        if unread:
            self._note("campaign.columns_not_read", tables[0].name, columns=", ".join(unread))
        for row in rows:
            if row.taken_for_one:
                self._note(
                    "campaign.profile_taken_for_one",
                    f"trial {row.number}",
                    profile=row.taken_for_one,
                )
        return rows

    # the campaign -----------------------------------------------------------------------------------------------------

    def campaign(self) -> str:
        document = tomlkit.document()
        document.add(
            tomlkit.comment(
                f"Made of the files in {self._relative(self.source)}; change what is wrong."
            )
        )
        document["schema"] = "jounce.campaign/1"
        document["title"] = self.laboratory.title
        if self.laboratory.synthetic:
            document["synthetic"] = self.laboratory.synthetic
        document["rig"] = self.laboratory.rig or "rig.toml"
        if self.laboratory.belt is not None:
            document["belt"] = self.raw["belt"]
        document["sensors"] = {
            channel.measures: self._sensor(name, channel)
            for name, channel in self.laboratory.channels.items()
        }
        self._check_columns()
        document["bench"] = self._bench()
        document["roads"] = self._roads()
        if not self._records().keys() & self.rows.keys():
            raise RecordingError(
                "no record of a trial was found",
                where=str(self.source),
                found=", ".join(
                    f"{count} {kind}"
                    for kind, count in Counter(item.kind for item in self.files).items()
                ),
                allowed="files with time and signals whose names have the numbers of the table",
            )
        document["trial"] = _tables(self._trials())
        document["update"] = _tables(self._updates())
        return tomlkit.dumps(document)

    def rig(self) -> str:
        return quarter_car_text(self.raw["sprung_mass"], self.raw["unsprung_mass"], self._angle())

    def _check_columns(self) -> None:
        """Report columns of the settings that no record has, and list the columns of the records."""
        there = {name for item in self.files for name in item.signals}
        belt = self.laboratory.belt
        asked = {f"channels.{column}": column for column in self.laboratory.channels}
        if belt is not None and belt.pulses is not None:
            asked["belt.column"] = belt.column
        for place, column in asked.items():
            if there and column and not {column, name_and_unit(column)[0]} & there:
                self._note(
                    "campaign.no_such_column",
                    place,
                    column=column,
                    columns=", ".join(sorted(there)),
                )
        pulsed = sorted(
            {item.columns["pulses"] for item in self._of("trial") if "pulses" in item.columns}
        )
        if pulsed and belt is not None and not (belt.column and belt.pulses):
            self._note("campaign.pulses_not_used", "belt", columns=", ".join(pulsed))

    def _relative(self, file: Path) -> str:
        return Path(os.path.relpath(file, self.folder)).as_posix()

    def _sensor(self, column: str, channel: CardChannel) -> dict[str, Any]:
        table = {"column": column, **self.raw["channels"][column]}
        table.pop("measures")
        for item in self._of("calibration"):
            if column in [label.partition(" [")[0] for label in item.columns.values()]:
                table |= self._calibrate(item, column, channel)
        return table

    def _calibrate(self, item: RecognisedFile, column: str, channel: CardChannel) -> dict[str, Any]:
        """Return the sensitivity and uncertainty of a calibration, which replace those on the sensor's label."""
        try:
            calibration: Calibration = read_calibration(item.file)
        except JounceError as error:
            self._note("campaign.stated_sensitivity_used", item.file.name, error=error)
            return {}
        unit = channel_unit(channel.measures)
        if calibration.quantity_unit != unit:
            self._note(
                "campaign.calibrates_another_quantity",
                item.file.name,
                unit=calibration.quantity_unit,
                column=column,
                channel=channel.measures,
            )
            return {}
        self.findings += calibration.findings
        size = abs(calibration.sensitivity.value)
        if channel.sensitivity:
            stated = sensitivity_of(channel.sensitivity, unit, where=f"channels.{column}").factor
            if abs(size / stated - 1.0) > _AGREES:
                share = size / stated - 1.0
                self._note(
                    "campaign.calibration_differs",
                    item.file.name,
                    share,
                    share=share,
                    column=column,
                )
        if calibration.sensitivity.value < 0.0:
            self._note(
                "campaign.falls_where_it_grows",
                item.file.name,
                column=column,
                channel=channel.measures,
            )
        table = calibration.sensor()
        if (
            channel.high_pass is not None
        ):  # the zero of a calibration does not apply to a record with AC coupling
            del table["zero"]
        return table

    def _bench(self) -> dict[str, Any]:
        bench: dict[str, Any] = {}
        springs, decays = self._of("spring"), self._decays()
        if springs:
            bench["spring"] = self._tests(springs)
        else:
            self._note("campaign.no_spring_test", "bench.spring")
        tyres: dict[float, list[RecognisedFile]] = {}
        for item in self._of("tyre"):
            if item.pressure is None:
                self._note("campaign.tyre_without_pressure", item.file.name)
            else:
                tyres.setdefault(self._as_listed(item.pressure), []).append(item)
        if tyres:
            bench["tyre"] = {
                f"{1e-6 * pressure:g} MPa": self._tests(items)
                for pressure, items in sorted(tyres.items(), reverse=True)
            }
        asked = {row.pressure for row in self.rows.values() if row.pressure is not None}
        for pressure in sorted(asked - set(tyres)) if tyres else ():
            self._note("campaign.no_tyre_test_at", "bench.tyre", pressure, pressure=pressure)
        if decays:
            bench["decay"] = {"files": [self._relative(item.file) for item in decays]}
            columns = {name: label for item in decays for name, label in item.columns.items()}
            channel = next(iter(columns), None)
            if channel is not None and channel != "sprung.z":
                bench["decay"]["channel"] = channel
            bench["decay"] |= _clock(decays[0])
        return bench

    def _as_listed(self, pressure: float) -> float:
        """Return the table's pressure (Pa) that matches a rounded file name (45 psi for 0.31 MPa), or the given one."""
        listed = {row.pressure for row in self.rows.values() if row.pressure is not None}
        near = [value for value in listed if abs(pressure / value - 1.0) <= _SAME_PRESSURE]
        return min(near, key=lambda value: abs(value - pressure), default=pressure)

    def _decays(self) -> list[RecognisedFile]:
        """Select the decays at the rig's strut angle, if all file names contain an angle of the table."""
        decays = self._of("decay")
        angles = {
            round(math.degrees(row.angle)) for row in self.rows.values() if row.angle is not None
        }
        at = [
            angles & {int(text) for text in re.findall(r"\d+", item.file.stem)} for item in decays
        ]
        if len(angles) < 2 or not all(len(named) == 1 for named in at):
            return decays
        usual = round(math.degrees(self._angle()))
        for item, (angle,) in zip(decays, at, strict=True):
            if angle != usual:
                self._note(
                    "campaign.decay_at_another_angle", item.file.name, angle=angle, usual=usual
                )
        return [item for item, named in zip(decays, at, strict=True) if usual in named] or decays

    def _angle(self) -> float:
        """Return the rig's strut angle in rad, i.e. the angle of the first trial."""
        return next((row.angle for row in self.rows.values() if row.angle is not None), 0.0)

    def _tests(self, items: Sequence[RecognisedFile]) -> dict[str, Any]:
        """Return the table for the tests of one part; files with unusual column names are left out."""
        usual = Counter(tuple(item.columns.items()) for item in items).most_common(1)[0][0]
        for item in items:
            if tuple(item.columns.items()) != usual:
                columns = " and ".join(label for _, label in usual) or "displacement and force"
                self._note("campaign.other_columns", item.file.name, columns=columns)
        alike = [item for item in items if tuple(item.columns.items()) == usual]
        table: dict[str, Any] = {"files": [self._relative(item.file) for item in alike]}
        if usual:
            table["columns"] = dict(usual)
        return table

    def _roads(self) -> dict[str, Any]:
        obstacle = self.laboratory.obstacle
        roads: dict[str, Any] = {
            "A": {
                "kind": obstacle.shape,
                "height": f"{1e3 * obstacle.height:g} mm",
                "length": f"{1e3 * obstacle.length:g} mm",
            }
        }
        for row in self.rows.values():
            if row.pitch is not None:
                roads[road_of(row)] = {
                    "kind": "train",
                    "of": "A",
                    "count": row.count,
                    "pitch": f"{row.pitch:g} m",
                }
        return roads

    # trials -----------------------------------------------------------------------------------------------------------

    def _trials(self) -> Iterator[dict[str, Any]]:
        fitted = trials_to_fit(list(self.rows.values()))
        records = self._records()
        for number, row in self.rows.items():
            item = records.get(number)
            if item is None:
                self._note("campaign.no_record", f"trial {number}")
                continue
            if (
                item.pressure is not None
                and row.pressure is not None
                and abs(item.pressure / row.pressure - 1.0) > _SAME_PRESSURE
            ):
                numbers = {"named": item.pressure, "listed": row.pressure, "number": number}
                self._note(
                    "campaign.name_and_table_differ", item.file.name, item.pressure, **numbers
                )
            table: dict[str, Any] = {"number": number}
            if row.speed is not None:
                table["speed"] = f"{row.speed:g} m/s"
            if row.angle is not None:
                table["strut_angle"] = f"{math.degrees(row.angle):g} deg"
            pressure = row.pressure if row.pressure is not None else item.pressure
            if pressure is None:
                self._note("campaign.no_pressure", f"trial {number}")
            else:
                table["tyre_pressure"] = f"{1e-6 * pressure:g} MPa"
            yield table | {
                "road": road_of(row),
                "recording": self._relative(item.file),
                **_clock(item),
                "use": "fit" if number in fitted else "hold-out",
            }
        rates = Counter(round(item.rate, 1) for item in records.values() if item.rate is not None)
        for item in records.values():
            if (
                item.rate is not None
                and abs(item.rate / (usual := rates.most_common(1)[0][0]) - 1.0) > _SAME_RATE
            ):
                self._note(
                    "campaign.another_rate", item.file.name, item.rate, rate=item.rate, usual=usual
                )
        for item in self._of("trial"):
            if item.number is None:
                self._note("campaign.no_number", item.file.name)
            elif item.number not in self.rows:
                self._note("campaign.not_in_table", item.file.name, number=item.number)
            elif records[item.number] is not item:
                self._note(
                    "campaign.another_record",
                    item.file.name,
                    number=item.number,
                    used=records[item.number].file.name,
                )

    def _records(self) -> Mapping[int, RecognisedFile]:
        """Return the record of each trial number; of several records, the first by name."""
        return {
            item.number: item for item in reversed(self._of("trial")) if item.number is not None
        }

    def _updates(self) -> Iterator[dict[str, Any]]:
        sides = ("strut.damper.bump_coefficient", "strut.damper.rebound_coefficient")
        bounds = ("strut.damper.coefficient",) if self.laboratory.rig else sides
        if self.strategies == "default":
            names = ("strut.spring.rate", *bounds, "tyre.stiffness", "guide.friction.force")
            yield usual_update(
                names if self.laboratory.rig else (*names, "tyre.damping_coefficient")
            )
            return
        ten = dict.fromkeys(bounds, "10 %")
        yield {"name": "strategy 1", "tyre_law": "polynomial", "method": "bfgs", "align": "lag",
               "free": {"strut.spring.rate": "10 %", **ten, "tyre.curve.coefficients[0]": "10 %",
                        "tyre.curve.coefficients[1]": "10 %", "tyre.curve.coefficients[2]": "10 %"}}  # fmt: skip
        yield {"name": "strategy 2", "method": "bfgs", "align": "lag",
               "free": {"strut.spring.rate": "10 %", **ten, "tyre.stiffness": "10 %"}}  # fmt: skip
        low = self._low_pressure()
        if low:
            yield {"name": "strategy 3", "method": "bfgs", "align": "lag", "start_from": "strategy 2", "trials": low,
                   "free": {"tyre.stiffness": "10 %"}}  # fmt: skip

    def _low_pressure(self) -> list[int]:
        """Return the trials at the lowest pressure that have a record."""
        pressures = {row.pressure for row in self.rows.values() if row.pressure is not None}
        if len(pressures) < 2:
            return []
        return [
            n
            for n, row in self.rows.items()
            if row.pressure == min(pressures) and n in self._records()
        ]


def usual_update(names: Collection[str]) -> dict[str, Any]:
    """Return the update that frees the parameters of spring, damper, tyre and friction among these names."""
    bounds = {
        "strut.spring.rate": "20 %",
        "strut.damper.bump_coefficient": _DAMPING_BOUNDS,
        "strut.damper.rebound_coefficient": _DAMPING_BOUNDS,
        "strut.damper.coefficient": "50 %",
        "tyre.stiffness": "20 %",
        "guide.friction.force": ["0 N", "40 N"],
        "guide_friction.force": ["0 N", "40 N"],
        "tyre.damping_coefficient": _TYRE_DAMPING_BOUNDS,
    }
    return {
        "name": "stiffness, damping and friction",
        "free": {name: bound for name, bound in bounds.items() if name in names},
        "weights": "normalised",
        "align": "lag",
    }


def quarter_car_text(sprung: Any, unsprung: Any, angle: float) -> str:
    """Write the rig file of a quarter car with two masses (with units) and a strut angle (rad); the rest is assumed."""
    document = tomlkit.document()
    document["schema"] = "jounce.rig/1"
    document["model"] = "quarter-car"
    document["source"] = (
        "masses as weighed; spring and tyre are replaced by their tests; the rest is a start value"
    )
    document["sprung"] = {"mass": sprung}
    document["unsprung"] = {"mass": unsprung}
    document["strut"] = {
        "angle": f"{math.degrees(angle):g} deg",
        "spring": {"rate": "22 N/mm"},
        "damper": {"bump_coefficient": _START_DAMPING, "rebound_coefficient": _START_DAMPING},
    }
    document["guide"] = {"friction": {"force": "5 N", "regularisation_velocity": "5 mm/s"}}
    document["tyre"] = {"stiffness": "138 N/mm", "damping_coefficient": "10 N*s/m"}
    return tomlkit.dumps(document)


def trials_to_fit(rows: Sequence[TrialRow]) -> set[int]:
    """Select trials with a single obstacle at the most common setting: the slowest, a medium and the fastest."""
    single = [row for row in rows if row.pitch is None and row.speed is not None]
    settings = Counter((row.angle, row.pressure) for row in single)
    if not settings:
        return {row.number for row in rows}
    usual = settings.most_common(1)[0][0]
    alike = sorted(
        (row for row in single if (row.angle, row.pressure) == usual),
        key=lambda row: row.speed or 0.0,
    )
    count = min(_FITTED, len(alike))
    return {alike[round(k * (len(alike) - 1) / max(count - 1, 1))].number for k in range(count)}


def _tables(rows: Iterator[dict[str, Any]]) -> tomlkit.items.AoT:
    tables = tomlkit.aot()
    for row in rows:
        tables.append(tomlkit.item(row))
    return tables


def _clock(item: RecognisedFile) -> dict[str, Any]:
    """Return the keys that a reader needs for a file's time."""
    if item.sample_time is not None:
        return {"sample_time": f"{item.sample_time:.6g} s"}
    return {"columns": {"time": item.time}} if item.time else {}


def road_of(row: TrialRow) -> str:
    """Name the road of a trial: ``A``, or ``B`` with the pitch of its obstacles in m."""
    return "A" if row.pitch is None else f"B {row.pitch:g}"
