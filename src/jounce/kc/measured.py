"""Measured K&C sheets: files of a rig, or a few rows of gauges, in the layout of the simulated tests."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.core.errors import JounceError, RecordingError
from jounce.core.findings import Finding, finding, finding_attributes
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import positive_si
from jounce.kc.channels import SCHEMA, KcColumn, KcMap, as_map
from jounce.kc.conventions import SignConvention, convention_in, convention_of
from jounce.kc.loops import directions_of, drift_of, lines_of, noise_of, value_at
from jounce.kc.readings import Channel, Readings, channels_of, proposed_entry, read_section, stated
from jounce.kc.rig_tests import named_test, recognised_test, swept_input
from jounce.kc.sections import Section, read_sections
from jounce.kc.sheet_checks import check_sheet, check_test
from jounce.kc.tests import TESTS
from jounce.kc.two_files import joined, together
from jounce.kc.vocabulary import QUANTITIES, READING, ZEROED, KcQuantity, quantity_name

if TYPE_CHECKING:
    import xarray as xr

_DRIFT, _OPEN, _NEAR, _CLEAR = 0.01, 0.05, 0.02, 10.0
"""Least drift over a test, and gap of a loop, as shares of a range; share of the input's range that is zero; range
of a mean line, in standard deviations of the noise, from which its loop is judged."""


class KcSheet(dict[str, "xr.Dataset"]):
    """Measured tests by name, in the order of a sheet, with the findings of all files.

    Parameters
    ----------
    tests : mapping of str to xarray.Dataset
        The tests.
    findings : iterable of Finding
        What was recognised, assumed or looks wrong, of every file and test.
    """

    def __init__(self, tests: Mapping[str, xr.Dataset], findings: Iterable[Finding] = ()) -> None:
        super().__init__({name: tests[name] for name in TESTS if name in tests})
        self.findings = tuple(findings)


def read_kc(
    paths: Path | str | Sequence[Path | str],
    channels: KcMap | Mapping[str, Any] | Path | str | None = None,
    *,
    convention: str | Mapping[str, str] | SignConvention | None = None,
    track: float | str | None = None,
    axle: Literal["front", "rear"] | None = None,
) -> KcSheet:
    r"""Read measured K&C tests of an axle or a wheel from the files of a rig or a workshop.

    A file is one test, or has a test in each sheet, struct or block of rows; CSV, text, XLSX and MAT files are read.
    The test follows from the channel map, from names of files, sheets and lines above the columns, or from what moves.
    Columns are recognised by their headings (``Toe L [deg]``, ``LF_Camber (deg)``, ``Fy Left N``), others need a
    channel map. Ten rows of travel, toe and camber of one wheel are the bounce test of that wheel; toe may come from
    two dial gauges and the distance between them. Left and right wheel of a test may be in a file each.

    Movements are zeroed where the input is zero, on the mean of both branches; angles and forces stay totals. Drift
    that is linear in time, seen between equal inputs of successive cycles, is removed. A test that cannot be read
    stops no other. Whatever was recognised, assumed, removed or looks wrong is a finding.

    Parameters
    ----------
    paths : Path, str or sequence of them
        The files.
    channels : KcMap, mapping, Path or str, optional
        Channel map, its file (schema ``jounce.kc-map/1``), or columns alone: ``{"AUX 3": "left.toe [deg]"}``.
    convention : str, mapping or SignConvention, optional
        Signs of the readings: ``"iso"`` (x forward, y left, z up), ``"j670e"`` (x forward, y right, z down),
        ``"adams-car"`` (x rearward, y right, z up), or directions by name. By default those of the channel map, of the
        file's text, or ISO 8855, with a finding.
    track : float or str, optional
        Distance of the contact points, m or text with a unit, if the roll angle is not a column.
    axle : {"front", "rear"}, optional
        Axle to read from files with both.

    Returns
    -------
    KcSheet
        A dict of one dataset per test, over ``sample`` in the order of the file, with the coordinates ``input`` and
        ``direction`` (1 rising, -1 falling). Names, units (SI) and signs are those of the simulated tests. Attributes
        of a variable: ``noise`` and ``hysteresis`` (its unit), ``zero`` (subtracted, its unit), ``drift`` (removed,
        its unit per sample). ``findings`` of the sheet has all findings, ``findings`` of a dataset those of its test.

    Raises
    ------
    RecordingError
        If no test can be read: the error of the first one.
    DescriptionError
        For an invalid channel map, convention or track.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "front-left.csv"
    >>> _ = file.write_text("travel [mm]; toe [deg]; camber [deg]\n-20; 0.10; 0.5\n0; 0.05; 0\n20; 0; -0.5\n")
    >>> sheet = read_kc(file)                                             # synthetic
    >>> list(sheet), sheet["bounce"]["input"].values.tolist(), sheet.findings[0].code
    (['bounce'], [-0.02, 0.0, 0.02], 'kc.test_recognised')
    """
    rig = as_map(channels)
    rig = rig if axle is None else rig.with_fields(axle=axle)
    given = rig.track if track is None else positive_si(track, "m", where="track")
    signs = None if convention is None else convention_of(convention, "convention")
    findings: list[Finding] = []
    tests: dict[str, xr.Dataset] = {}
    errors: list[RecordingError] = []
    tables: list[_Table] = []
    known: dict[str, Mapping[str, Channel]] = {}
    for section in _sections(paths):
        if isinstance(section, tuple):
            place, problem = section
            errors.append(problem)
            findings.append(finding("kc.unread", place, error=problem))
            continue
        try:
            _add_table(tables, _read_table(section, rig, signs))
        except RecordingError as error:
            errors.append(error)
            findings.append(finding("kc.unread", section.place, error=error))
    for table in tables:
        test, section = table.test, table.section
        try:
            if not test:
                raise _unknown_test(section, table.readings)
            dataset, own = _read_test(table, given)
        except RecordingError as error:
            errors.append(error)
            findings.append(finding("kc.unread", section.place, error=error))
            continue
        findings += own
        if test in tests:
            both = joined(tests[test], dataset)
            if both is None:
                findings.append(finding("kc.test_twice", section.place, test=test))
                continue
            findings.append(finding("kc.wheels_joined", section.place, test=test))
            dataset, known[test] = both, {**known[test], **table.readings.channels}
            findings += check_test(test, dataset, known[test], f"{section.place}: {test}")
        else:
            known[test] = table.readings.channels
        tests[test] = dataset
    if not tests:
        raise errors[0] if errors else RecordingError("no files", where="paths")
    findings += check_sheet(tests)
    return KcSheet(tests, dict.fromkeys(findings))


def _sections(
    paths: Path | str | Sequence[Path | str],
) -> Iterable[Section | tuple[str, RecordingError]]:
    for path in [paths] if isinstance(paths, str | Path) else paths:
        try:
            yield from read_sections(path)
        except RecordingError as error:
            yield str(path), error


@dataclass(frozen=True)
class _Table:
    """A table with its test, empty if it is not known, and whether a name says it."""

    section: Section
    rig: KcMap
    signs: SignConvention
    is_stated: bool
    test: str
    is_named: bool
    readings: Readings

    def as_test(self, test: str) -> Readings:
        """Read its columns as those of a test."""
        return read_section(self.section, self.rig, self.signs, test or None)


def _read_table(section: Section, rig: KcMap, given: SignConvention | None) -> _Table:
    signs, is_stated = _signs_of(section, rig, given)
    test = stated(section, rig.tests) or named_test(section.names)
    readings = read_section(section, rig, signs, test or None)
    is_named = bool(test)
    if not is_named:
        test = recognised_test(readings.values)
        readings = read_section(section, rig, signs, test) if test else readings
    return _Table(section, rig, signs, is_stated, test, is_named, readings)


def _add_table(tables: list[_Table], table: _Table) -> None:
    """Add a table, or join it with that of the other wheel where only both together tell test or input."""
    for k, other in enumerate(tables):
        needs_both = not (table.is_named or other.is_named) or (
            table.test == other.test == "roll" and "roll_angle" not in other.readings.values
        )
        both = needs_both and together(other.readings, table.readings, table.section.place)
        if not both:
            continue
        test = other.test if other.is_named else recognised_test(both.values)
        readings = together(other.as_test(test), table.as_test(test), table.section.place)
        if test and readings is not None:
            tables[k] = replace(other, test=test, readings=readings)
            return
    tables.append(table)


def _read_test(table: _Table, track: float | None) -> tuple[xr.Dataset, list[Finding]]:
    """Return the test of a table."""
    section, readings = table.section, table.readings
    findings: list[Finding] = [replace(item, place=section.place) for item in section.table.remarks]
    if not table.is_named:
        findings.append(finding("kc.test_recognised", section.place, test=table.test))
    findings += readings.findings
    if not table.is_stated and any(
        QUANTITIES[quantity_name(name)].axis for name in readings.values
    ):
        findings.append(finding("kc.convention_assumed", section.place))
    dataset, own = _dataset(table.test, readings, track, section)
    findings += own
    return dataset.assign_attrs(finding_attributes(findings)), findings


def _signs_of(
    section: Section, rig: KcMap, given: SignConvention | None
) -> tuple[SignConvention, bool]:
    """Return the sign convention of a table, and whether anything states it."""
    if given is not None:
        return given, True
    if rig.convention is not None:
        return convention_of(rig.convention, "convention"), True
    name = convention_in("\n".join([section.preamble, *section.table.comments]))
    return convention_of(name or "iso", section.place), bool(name)


def _unknown_test(section: Section, readings: Readings) -> RecordingError:
    return RecordingError(
        "no test is recognised",
        where=section.place,
        found=", ".join(readings.values) or ", ".join(section.table.names),
        allowed=", ".join(TESTS),
        hint="Name it in the file, or in tests of the channel map; map columns that are not recognised.",
    )


# --- one dataset


def _dataset(
    test: str, readings: Readings, track: float | None, section: Section
) -> tuple[xr.Dataset, list[Finding]]:
    import xarray as xr

    values, place = dict(readings.values), f"{section.place}: {test}"
    findings: list[Finding] = []
    if test == "roll":
        _turn_roll(values, place, findings)
    sweep, unit, made_of = swept_input(test, values, track, section.place)
    values.pop("input", None)
    known = np.isfinite(sweep)
    sweep, values = sweep[known], {name: array[known] for name, array in values.items()}
    if sweep.size < 2 or not np.ptp(sweep) > 0.0:
        raise RecordingError(
            "the input of the test does not move", where=section.place, found=made_of
        )
    if test == "bounce" and made_of == "wheel_centre_z":
        findings.append(finding("kc.bounce_of_wheel", place))
    sweep, values = _zero_input(test, sweep, values, made_of, place, findings)
    drifts = _drifts(sweep, values)
    if drifts:
        findings.append(finding("kc.drift_removed", place, names=[*drifts]))
    zeros: dict[str, float] = {}
    for name, drift in drifts.items():
        values[name] = values[name] - drift * np.arange(sweep.size)
    for name in [name for name in values if quantity_name(name) in ZEROED]:
        zeros[name] = _value_at_zero(sweep, values[name])
        values[name] = values[name] - zeros[name]
    inputs = np.linspace(float(sweep.min()), float(sweep.max()), 41)
    variables: dict[str, Any] = {}
    openings: dict[str, float] = {}
    for name in sorted(values, key=_order):
        lines, spread = lines_of(sweep, values[name], inputs), noise_of(values[name])
        quantity = QUANTITIES[quantity_name(name)]
        reach = _span(lines.mean)
        if reach > _CLEAR * spread and lines.opening > _reading_of(name):
            openings[name] = lines.opening / max(reach, 1e-300)
        about: dict[str, Any] = {"units": quantity.unit, "long_name": quantity.label}
        about |= {"positive": quantity.positive} if quantity.positive else {}
        about |= {"noise": spread, "hysteresis": lines.opening}
        about |= {"zero": zeros[name]} if name in zeros else {}
        about |= {"drift": drifts[name]} if name in drifts else {}
        variables[name] = ("sample", values[name], about)
    swept = QUANTITIES[made_of] if made_of == "handwheel_angle" else TESTS[test]
    label = {"units": unit, "positive": swept.positive}
    label["long_name"] = swept.label if isinstance(swept, KcQuantity) else swept.what
    coordinates = {
        "input": ("sample", sweep, label),
        "direction": ("sample", directions_of(sweep), {"units": "1", "long_name": "direction"}),
    }
    dataset = xr.Dataset(variables, coordinates)
    dataset.attrs |= {"test": test, "kind": "measured", "name": Path(section.table.file).stem,
                      "source": section.place, "input_quantity": made_of}  # fmt: skip
    dataset.attrs |= {} if track is None else {"track": track}
    findings += _loop_findings(sweep, values, openings, place)
    findings += check_test(test, dataset, readings.channels, place)
    return dataset, findings


def _turn_roll(values: dict[str, Array], place: str, findings: list[Finding]) -> None:
    """Give a roll angle the sign of the pads, if the travels show that it is that of the body on them."""
    roll = values.get("roll_angle")
    for quantity in ("contact_point_z", "wheel_centre_z"):
        left, right = (values.get(f"{wheel}.{quantity}") for wheel in ("left", "right"))
        if roll is None or left is None or right is None:
            continue
        good = np.isfinite(roll) & np.isfinite(left) & np.isfinite(right)
        lift, turn = (left - right)[good], roll[good]
        if float(np.sum((lift - lift.mean()) * (turn - turn.mean()))) < 0.0:
            values["roll_angle"] = -roll
            findings.append(finding("kc.roll_of_body", place))
        return
    if roll is not None:
        findings.append(finding("kc.roll_of_pads", place))


def _zero_input(
    test: str,
    sweep: Array,
    values: dict[str, Array],
    made_of: str,
    place: str,
    findings: list[Finding],
) -> tuple[Array, dict[str, Array]]:
    """Shift an input that is an absolute height, and say where an input never is zero."""
    near = _NEAR * float(np.ptp(sweep))
    if float(sweep.min()) <= near and float(sweep.max()) >= -near:
        return sweep, values
    if made_of in ("contact_point_z", "wheel_centre_z"):
        first = float(sweep[0])
        findings.append(finding("kc.height_zeroed", place, first, height=first))
        return sweep - first, values
    least = float(sweep[np.argmin(np.abs(sweep))])
    unit = TESTS[test].unit
    findings.append(finding("kc.no_zero", place, least, least=least, unit=unit))
    return sweep, values


def _value_at_zero(sweep: Array, values: Array) -> float:
    """Return the value at zero input, or at the input closest to it."""
    known = np.isfinite(values)
    if not known.any():
        return 0.0
    zero = value_at(sweep, values)
    if np.isfinite(zero):
        return zero
    closest = np.argmin(np.where(known, np.abs(sweep), np.inf))
    return float(values[closest])


def _drifts(sweep: Array, values: Mapping[str, Array]) -> dict[str, float]:
    """Return the drift per sample of each variable that has a clear one."""
    drifts = {}
    for name, array in values.items():
        drift, error = drift_of(sweep, array)
        whole = abs(drift) * sweep.size
        if abs(drift) > 4.0 * error and whole > _DRIFT * _span(array):
            drifts[name] = drift
    return drifts


def _loop_findings(
    sweep: Array, values: Mapping[str, Array], openings: Mapping[str, float], place: str
) -> list[Finding]:
    findings = []
    if openings:
        widest = max(openings, key=lambda name: openings[name])
        share = openings[widest]
        if share > _OPEN:
            findings.append(finding("kc.hysteresis", place, share, name=widest, share=share))
    if abs(sweep[-1] - sweep[0]) <= _NEAR * float(np.ptp(sweep)):
        gaps = {
            name: abs(float(array[-1] - array[0])) / max(_span(array), 1e-300)
            for name, array in values.items()
            if abs(float(array[-1] - array[0])) > max(6.0 * noise_of(array), _reading_of(name))
        }
        if gaps and max(gaps.values()) > _OPEN:
            name = max(gaps, key=lambda name: gaps[name])
            findings.append(finding("kc.loop_open", place, gaps[name], name=name, share=gaps[name]))
    return findings


def _reading_of(name: str) -> float:
    """Return the least opening of a loop that is told; means of many samples are finer than one reading."""
    return 0.1 * READING.get(QUANTITIES[quantity_name(name)].unit, 0.0)


def _span(values: Array) -> float:
    finite = values[np.isfinite(values)]
    return float(np.ptp(finite)) if finite.size else 0.0


def _order(name: str) -> tuple[int, str]:
    return [*QUANTITIES].index(quantity_name(name)), name


# --- proposed maps


@dataclass(frozen=True)
class KcMapProposal(Shown):
    """A channel map proposed for the files of a rig.

    Attributes
    ----------
    map : KcMap
        What was recognised; it is used as ``channels`` of `read_kc`.
    unrecognised : tuple of str
        Headings that need an entry, or none if they are not needed.
    findings : tuple of Finding
        What was assumed, or could not be read.
    """

    map: KcMap
    unrecognised: tuple[str, ...]
    findings: tuple[Finding, ...]

    def to_toml(self) -> str:
        """Return the text of a channel map's file; headings that were not recognised are comments."""
        lines = [f'schema = "{SCHEMA}"']
        if isinstance(self.map.convention, str):
            lines.append(f'convention = "{self.map.convention}"')
        else:
            lines.append(
                '# convention = "iso"      # x forward, y left, z up; "j670e": y right, z down'
            )
        lines += [
            "",
            "[tests]",
            *(f"{_quoted(k)} = {_quoted(v)}" for k, v in self.map.tests.items()),
        ]
        lines += ["", "[columns]"]
        lines += [f"{_quoted(name)} = {_quoted(_short(c))}" for name, c in self.map.columns.items()]
        lines += [f'# {_quoted(name)} = ""      # not recognised' for name in self.unrecognised]
        return "\n".join([*lines, ""])

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        return {
            "map": self.map.model_dump(mode="json", exclude_none=True),
            "unrecognised": list(self.unrecognised),
            "findings": [vars(item) for item in self.findings],
            "toml": self.to_toml(),
        }


def _quoted(text: str) -> str:
    from jounce.core.text import quote

    return quote(text)


def _short(column: KcColumn) -> str:
    sign = "-" if column.sign < 0 else ""
    wheel = f"{column.wheel}." if column.wheel else ""
    return f"{sign}{wheel}{column.quantity} [{column.unit}]"


def kc_map(paths: Path | str | Sequence[Path | str]) -> KcMapProposal:
    r"""Propose a channel map for the files of a rig, and say which headings are not recognised.

    Parameters
    ----------
    paths : Path, str or sequence of them
        Measured K&C files.

    Returns
    -------
    KcMapProposal
        The map, the headings that are not recognised, and what was assumed. ``to_toml()`` is a file to complete.

    Raises
    ------
    RecordingError
        If no file can be read.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "roll.csv"
    >>> _ = file.write_text("Toe L [deg]; AUX 3\n0.1; 1\n0.2; 2\n")
    >>> proposal = kc_map(file)                                           # synthetic
    >>> print(proposal.to_toml())
    schema = "jounce.kc-map/1"
    # convention = "iso"      # x forward, y left, z up; "j670e": y right, z down
    <BLANKLINE>
    [tests]
    "roll" = "roll"
    <BLANKLINE>
    [columns]
    "Toe L [deg]" = "left.toe [deg]"
    # "AUX 3" = ""      # not recognised
    <BLANKLINE>
    """
    tests: dict[str, str] = {}
    columns: dict[str, KcColumn] = {}
    unrecognised: dict[str, None] = {}
    findings: list[Finding] = []
    errors: list[RecordingError] = []
    conventions: set[str] = set()
    for section in _sections(paths):
        if isinstance(section, tuple):
            errors.append(section[1])
            findings.append(finding("kc.unread", section[0], error=section[1]))
            continue
        name = section.title or Path(section.table.file).stem
        conventions.add(convention_in("\n".join([section.preamble, *section.table.comments])))
        test = named_test(section.names)
        if not test:
            test = recognised_test(read_section(section, KcMap(), SignConvention(), None).values)
            if test:
                findings.append(finding("kc.test_recognised", section.place, test=test))
            else:
                findings.append(finding("kc.test_unknown", section.place))
        if test:
            tests[name] = test
        try:
            channels, unknown = channels_of(section, KcMap(), test)
        except JounceError as error:
            findings.append(finding("kc.unread", section.place, error=error))
            continue
        for channel in channels:
            unit = channel.unit or QUANTITIES[channel.quantity].usual
            if not channel.unit and channel.label not in columns:
                findings.append(
                    finding("kc.unit_assumed", section.place, columns=[f"{channel.label} [{unit}]"])
                )
            columns.setdefault(channel.label, proposed_entry(replace(channel, unit=unit)))
        unrecognised |= dict.fromkeys(unknown)
    if not columns and not unrecognised and errors:
        raise errors[0]
    names = {name for name in conventions if name}
    stated = names.pop() if len(names) == 1 else None
    rig = KcMap(convention=stated, tests=tests, columns=columns)
    return KcMapProposal(rig, tuple(unrecognised), tuple(findings))
