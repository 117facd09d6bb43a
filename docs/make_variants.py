"""Write the table of how-to/recordings.md: results for files with known values in every variant."""

from __future__ import annotations

import itertools
import tempfile
import warnings
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import JounceError
from jounce.core.units import conversion_factor
from jounce.recordings import read_recording
from jounce.recordings.plausibility import implausible
from jounce.recordings.schema import channel_unit

PAGE = Path(__file__).parent / "how-to" / "recordings.md"
MARK = "<!-- docs/make_variants.py writes the following -->\n\n"
TIME = np.arange(1500) * 0.002
CHANNELS = ("sprung.az", "strut.deflection", "strut.force")
UNITS = {
    "time": ("s", "ms", "sec", "min"),
    "sprung.az": ("m/s^2", "m/s2", "m/s²", "g", "mg", "milli-g", "mm/s^2", "ft/s2"),
    "strut.deflection": ("m", "mm", "cm", "in", "µm"),
    "strut.force": ("N", "kN", "daN", "lbf", "kp"),
}
USUAL = {"time": "s", "sprung.az": "g", "strut.deflection": "mm", "strut.force": "kN"}


def truth(time: np.ndarray) -> dict[str, np.ndarray]:
    """The signals in SI."""
    turn = 2.0 * np.pi * 1.5 * time
    return {
        "sprung.az": 3.0 * np.sin(turn) + 0.4 * np.cos(7.0 * turn),
        "strut.deflection": 0.025 * np.cos(turn),
        "strut.force": 900.0 + 600.0 * np.sin(turn + 0.7),
    }


def table(time: np.ndarray = TIME, units: dict[str, str] = USUAL) -> dict[str, np.ndarray]:
    """Columns in the units of a file."""
    columns = {"time": time, **truth(time)}
    return {
        name: values / conversion_factor(units[name], channel_unit(name))
        for name, values in columns.items()
    }


@dataclass
class Group:
    """Variants of one kind, counted by their outcome."""

    what: str
    outcomes: Counter[str] = field(default_factory=Counter)
    wrong: list[str] = field(default_factory=list)


def judge(file: Path, told: dict[str, Any], held: Callable[[Any], bool] | None = None) -> str:
    """Right, refused, flagged, or silently wrong."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            run, findings = read_recording(file, **told)
    except JounceError:
        return "refused"
    time = run["time"].to_numpy()
    expected, inner = truth(time), slice(15, -15)
    is_right = all(
        np.allclose(
            run[name].to_numpy()[inner],
            expected[name][inner],
            rtol=0.0,
            atol=2e-3 * np.ptp(expected[name]),
        )
        for name in map(str, run.data_vars)
    )
    is_whole = set(map(str, run.data_vars)) == set(CHANNELS) and (held is None or held(run))
    if is_right and is_whole:
        return "right"
    return "flagged" if any(found.severity != "note" for found in findings) else "silently wrong"


def text(
    columns: dict[str, np.ndarray],
    units: dict[str, str] = USUAL,
    *,
    separator: str = ",",
    decimal: str = ".",
    style: str = "{} [{}]",
    more: tuple[str, str, str] = ("", "", ""),
    quoted: bool = False,
) -> str:
    """Write a text file; ``more`` adds text before the header, to the header's cells and to the rows' cells."""

    def line(cells: list[str]) -> str:
        return separator.join(f'"{cell}"' if quoted else cell for cell in cells)

    heads = [style.format(name, units[name]) for name in columns] if style else list(columns)
    lines = [more[0] + line(heads) + more[1]]
    if not style:
        lines.append(line([units[name] for name in columns]) + (more[1] and separator))
    rows = zip(*columns.values(), strict=True)
    lines += [
        line([f"{value:.12g}".replace(".", decimal) for value in row]) + more[2] for row in rows
    ]
    return "\n".join(lines) + "\n"


Variant = tuple[str, str, bytes | Callable[[Path], None], dict[str, Any]]
"""Name, suffix, content (or what writes it), and what is told about the file."""


def texts() -> Iterator[tuple[str, Variant]]:
    """Separators, decimals, headers; layouts; units; sampling."""
    styles = ("{} [{}]", "{}[{}]", "{} ({})", "{} / {}", "{} in {}", "")
    for separator, decimal, style in itertools.product((",", ";", "\t", " "), ".,", styles):
        content = text(table(), separator=separator, decimal=decimal, style=style, quoted=False)
        yield (
            "text: separator, decimal, header",
            (f"{separator}{decimal}{style}", ".csv", content.encode(), {}),
        )
    for decimal in ".,":
        content = text(table(), decimal=decimal, quoted=True)
        yield "text: separator, decimal, header", (f"quoted{decimal}", ".csv", content.encode(), {})
    plain = text(table(), separator=";")
    layouts = {
        "windows lines": plain.replace("\n", "\r\n").encode(),
        "byte order mark": b"\xef\xbb\xbf" + plain.encode(),
        "UTF-16": plain.encode("utf-16"),
        "old spreadsheet": text(table(), separator=";", more=("", ";Öl [°C]", ";17")).encode("cp1252"),
        "comments": ("# bench 3\n# operator = 'A'\n\n" + plain).encode(),
        "blank lines": plain.replace("\n", "\n\n").encode(),
        "text column": text(table(), separator=";", more=("", ";remark", ";ok")).encode(),
        "empty column": text(table(), separator=";", more=("", ";spare [V]", ";")).encode(),
        "empty channel": text(table(), separator=";", more=("", ";seat.az [g]", ";")).encode(),
        "date column": text(table(), separator=";", decimal=",", more=("", ";date", ";21.11.2026 10:00")).encode(),
        "trailing separators": text(table(), separator=";", more=("", ";", ";")).encode(),
        "trailing in rows only": text(table(), separator=";", more=("", "", ";")).encode(),
        "number column in front": text(table(), separator=";", more=("", ";no", ";17")).encode(),
        "time twice": text(table(), separator=";").replace("\n", ";time [s]\n", 1).encode(),
        "columns in another order": text(dict(reversed(table().items())), separator=";").encode(),
        "commas and points": text(table(), separator=";", decimal=",").replace(",", ".", 40).encode(),
        "cut in the last row": plain[:-9].encode(),
        "NUL behind": plain.encode() + b"\0\0\0",
        "text in a cell": plain.replace("0.5;", "half;", 1).encode(),
        "NaN in a cell": plain.replace("0.5;", "NaN;", 1).encode(),
        "over range": plain.replace("\n0.5;", "\n9.9e37;", 1).encode(),
    }  # fmt: skip
    for name, content in layouts.items():
        yield "text: layout and damage", (name, ".csv", content, {})
    for names in itertools.product(*UNITS.values()):
        units = dict(zip(UNITS, names, strict=True))
        few = {name: values[::2] for name, values in table(units=units).items()}
        yield "text: units", (" ".join(names), ".csv", text(few, units).encode(), {})
    yield from (("text: sampling", one) for one in samplings())


def samplings() -> Iterator[Variant]:
    """All kinds of clocks, each plain, resampled, and with a sample time."""
    random = np.random.default_rng(3)
    steps = 0.002 * random.uniform(0.4, 1.6, TIME.size)
    clocks = {
        "uniform": TIME,
        "small jitter": TIME + 1e-5 * random.uniform(-1.0, 1.0, TIME.size) * (TIME > 0.0),
        "irregular": np.cumsum(steps),
        "samples missing": np.delete(TIME, [200, 201, 700]),
        "slow": TIME[::5],
        "starts late": TIME + 16.0,
        "since 1970": TIME + 1.7e9,
        "backwards": TIME[::-1],
        "repeated": np.repeat(TIME[::2], 2),
        "few digits": np.round(TIME, 2),
        "zero": 0.0 * TIME,
    }
    ways: dict[str, dict[str, Any]] = {
        "": {}, "resampled": {"resample": "10 ms"}, "finer": {"resample": 0.001}, "right step": {"sample_time": "2 ms"},
        "wrong step": {"sample_time": "5 ms"},
    }  # fmt: skip
    for (clock, time), (way, told) in itertools.product(clocks.items(), ways.items()):
        columns = table(time)
        if clock == "since 1970":
            columns = {**table(TIME), "time": time}
            if way not in {"right step", "wrong step"}:
                continue  # the truth is not counted from 1970
        content = "\n".join(
            [", ".join(f"{name} [{USUAL[name]}]" for name in columns)]
            + [
                ", ".join(repr(float(value)) for value in row)
                for row in zip(*columns.values(), strict=True)
            ]
        )
        yield f"{clock} {way}", ".csv", content.encode(), told


def binaries() -> Iterator[tuple[str, Variant]]:
    """The other formats: units, structures, clocks, files cut off."""
    for names in itertools.product(("s", "ms"), UNITS["sprung.az"][:6], ("m", "mm"), ("N", "kN")):
        units = dict(zip(UNITS, names, strict=True))
        for suffix, write in WRITERS.items():

            def whole(file: Path, write: Any = write, units: dict[str, str] = units) -> None:
                write(file, table(units=units), units)

            yield f"{suffix}: units", (" ".join(names), suffix, whole, {})
    for suffix, write in WRITERS.items():
        for share in (0.02, 0.2, 0.5, 0.8, 0.95, 0.999):

            def cut(file: Path, write: Any = write, share: float = share) -> None:
                write(file, table(), USUAL)
                file.write_bytes(file.read_bytes()[: round(share * file.stat().st_size)])

            yield f"{suffix}: cut off", (f"{share}", suffix, cut, {})
        for way in ({}, {"resample": "10 ms"}):

            def irregular(file: Path, write: Any = write) -> None:
                write(
                    file,
                    table(np.cumsum(0.002 * np.random.default_rng(3).uniform(0.4, 1.6, TIME.size))),
                    USUAL,
                )

            if suffix not in (".tdms", ".uff"):  # these write a step, not instants
                yield f"{suffix}: irregular time", (f"{way}", suffix, irregular, way)


def netcdf(file: Path, columns: dict[str, np.ndarray], units: dict[str, str]) -> None:
    """Files as other programs write them."""
    import xarray as xr

    data = {
        name: ("time", values, {"units": units[name]})
        for name, values in columns.items()
        if name != "time"
    }
    clock = {"time": ("time", columns["time"], {"units": units["time"]})}
    xr.Dataset(data, clock).to_netcdf(file, engine="h5netcdf")


def matlab(file: Path, columns: dict[str, np.ndarray], units: dict[str, str]) -> None:
    """A struct with a signal in each field."""
    from scipy.io import savemat

    signals = {
        f"s{i}": {"name": name, "unit": units[name], "values": columns[name]}
        for i, name in enumerate(columns)
    }
    savemat(file, {"run": signals}, do_compression=True)


def tdms(file: Path, columns: dict[str, np.ndarray], units: dict[str, str]) -> None:
    """Waveforms: the step in s is a property."""
    import nptdms

    step = {"wf_increment": float(TIME[1]), "wf_start_offset": 0.0}
    channels = [
        nptdms.ChannelObject("Run", name, values, properties={"unit_string": units[name], **step})
        for name, values in columns.items()
        if name != "time"
    ]
    with nptdms.TdmsWriter(file) as writer:
        for part in range(3):
            third = slice(part * 500, (part + 1) * 500)
            parts = [
                nptdms.ChannelObject("Run", one.channel, one.data[third], one.properties)
                for one in channels
            ]
            writer.write_segment(parts)


def mdf(file: Path, columns: dict[str, np.ndarray], units: dict[str, str]) -> None:
    """One group for each channel; the time of the format is in s."""
    import asammdf

    time = columns["time"] * conversion_factor(units["time"], "s")
    with asammdf.MDF(version="4.10") as content:
        for name, values in columns.items():
            if name != "time":
                content.append([asammdf.Signal(values, time, name=name, unit=units[name])])
        content.save(file, overwrite=True)


def uff(file: Path, columns: dict[str, np.ndarray], units: dict[str, str]) -> None:
    """Data sets 58, ASCII, each with the step in the unit of time."""
    axis = f"{0:10d}{0:5d}{0:5d}{0:5d} "
    lines = []
    for node, (name, values) in enumerate(columns.items()):
        if name == "time":
            continue
        step = float(columns["time"][1])
        lines += ["    -1", "    58", "title", "NONE", "01-Jan-26", "NONE", "NONE"]
        lines.append(
            f"{1:5d}{0:10d}{0:5d}{0:10d} {name[-10:]:<10s}{node:10d}{3:4d} {'NONE':<10s}{0:10d}{0:4d}"
        )
        lines.append(f"{4:10d}{len(values):10d}{1:10d}{0.0:13.5e}{step:13.5e}{0.0:13.5e}")
        for label, unit in (
            ("Time", units["time"]),
            (name, units[name]),
            ("NONE", "NONE"),
            ("NONE", "NONE"),
        ):
            lines.append(f"{axis}{label[:20]:<20s} {unit:<20s}")
        lines += [
            "".join(f"{v:20.12e}" for v in values[i : i + 4]) for i in range(0, len(values), 4)
        ]
        lines.append("    -1")
    file.write_text("\n".join([*lines, ""]), encoding="utf-8")


def parquet(file: Path, columns: dict[str, np.ndarray], units: dict[str, str]) -> None:
    """Units in the names."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    pq.write_table(
        pa.table({f"{name} [{units[name]}]": values for name, values in columns.items()}), file
    )


WRITERS = {
    ".nc": netcdf,
    ".mat": matlab,
    ".tdms": tdms,
    ".mf4": mdf,
    ".uff": uff,
    ".parquet": parquet,
}
UFF_NAMES = {"strut.deflection": "deflection", "strut.force": "trut.force"}  # names of 10 letters


def outcomes(variants: Iterable[tuple[str, Variant]]) -> list[Group]:
    """Result of every variant."""
    groups: dict[str, Group] = {}
    with tempfile.TemporaryDirectory() as folder:
        for what, (name, suffix, content, told) in variants:
            group = groups.setdefault(what, Group(what))
            file = Path(folder) / f"a{suffix}"
            if callable(content):
                content(file)
            else:
                file.write_bytes(content)
            names = {"columns": UFF_NAMES} if suffix == ".uff" else {}
            outcome = judge(file, {**told, **names}, held_of(what))
            group.outcomes[outcome] += 1
            if outcome == "silently wrong":
                group.wrong.append(name)
    return list(groups.values())


def held_of(what: str) -> Callable[[Any], bool] | None:
    """For a truncated file, an incomplete record is not right."""
    return (lambda run: run.sizes["time"] == TIME.size) if what.endswith("cut off") else None


def mislabelled() -> list[tuple[str, int, int]]:
    """Headers with a wrong unit: factor, number of unit pairs, number of reported ones."""
    signals = {
        **truth(TIME), "unsprung.az": 40.0 * np.sin(70.0 * TIME), "strut.deflection_velocity": 0.3 * np.sin(9.0 * TIME),
        "tyre.force": 4000.0 + 800.0 * np.sin(9.0 * TIME), "body.speed": 20.0 + 0.1 * TIME,
    }  # fmt: skip
    choices = {
        "m/s^2": ("m/s^2", "g", "mg", "mm/s^2"), "m": ("m", "cm", "mm"), "N": ("N", "kN"),
        "m/s": ("m/s", "mm/s", "km/h"),
    }  # fmt: skip
    counts: dict[str, list[int]] = {}
    for name, values in signals.items():
        si = channel_unit(name)
        for said, true in itertools.permutations(choices[si], 2):
            factor = conversion_factor(said, si) / conversion_factor(true, si)
            size = max(factor, 1.0 / factor)
            band = (
                "1000 and more"
                if size > 900.0
                else "50 to 900"
                if size > 50.0
                else "3 to 50"
                if size > 3.0
                else "less"
            )
            kind = f"too {'large' if factor > 1.0 else 'small'} by {band}"
            found = implausible(
                {name: factor * values}, float(TIME[1]), where="", written={name: said}
            )
            entry = counts.setdefault(kind, [0, 0])
            entry[0] += 1
            entry[1] += bool(found)
    return [(kind, *counts[kind]) for kind in sorted(counts)]


def tables() -> str:
    """The end of the page."""
    groups = outcomes(itertools.chain(texts(), binaries()))
    names = ("right", "refused", "flagged", "silently wrong")
    rows = [
        [group.what, sum(group.outcomes.values()), *(group.outcomes[name] for name in names)]
        for group in groups
    ]
    rows.append(["**all**", *(sum(int(row[i]) for row in rows) for i in range(1, 6))])
    lines = [
        "| files | variants | right | refused | flagged | silently wrong |",
        "|---|--:|--:|--:|--:|--:|",
    ]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in rows]
    lines += [
        "",
        "| effect of a wrong unit in the header: values | pairs | reported |",
        "|---|--:|--:|",
    ]
    lines += [f"| {kind} | {count} | {told} |" for kind, count, told in mislabelled()]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(
        PAGE.read_text(encoding="utf-8").partition(MARK)[0] + MARK + tables(), encoding="utf-8"
    )
