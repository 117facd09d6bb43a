"""Recordings as other programs write them: `python make.py FOLDER` writes one of each library and program it finds.

Run it with several interpreters that hold other libraries, or other versions of them. A file is named after its writer,
that writer's version and how it was called: `pandas-3.1.1-to_csv.csv`. All hold the same recording (README.md).
"""

from __future__ import annotations

import importlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

TIME = np.arange(40) / 100.0
CHANNELS = {
    "sprung.az": (np.round(2.0 * np.sin(9.0 * TIME), 6), "m/s^2"),
    "strut.force": (np.round(200.0 + 50.0 * np.cos(9.0 * TIME), 4), "N"),
}
HEADED = {
    "time [s]": TIME,
    **{f"{name} [{unit}]": values for name, (values, unit) in CHANNELS.items()},
}
SHORT = {"t": TIME, "az": CHANNELS["sprung.az"][0], "F": CHANNELS["strut.force"][0]}
BEGAN = np.datetime64("2026-11-28T12:00:00", "ns")
INSTANTS = BEGAN + np.round(1e9 * TIME).astype("timedelta64[ns]")

Make = Callable[[Path], object]
WRITERS: dict[tuple[str, str], tuple[tuple[str, ...], Make]] = {}


def writer(name: str, *needs: str) -> Callable[[Make], Make]:
    """Add a function that fills a file: `pandas to_csv.csv` is written where pandas and all of `needs` are there."""

    def add(make: Make) -> Make:
        library, _, rest = name.partition(" ")
        WRITERS[library, rest] = (needs, make)
        return make

    return add


# --- netCDF


def _netcdf4(kind: str, unlimited: bool = False, group: str = "", text: type = str) -> Make:
    def make(file: Path) -> None:
        from netCDF4 import Dataset

        with Dataset(file, "w", format=kind) as whole:
            whole.title, whole.note = "a bench run", ""
            place = whole.createGroup(group) if group else whole
            place.createDimension("time", None if unlimited else TIME.size)
            columns = {"time": (TIME, "s"), **CHANNELS}
            for name, (values, unit) in columns.items():
                one = place.createVariable(name, "f8", ("time",))
                one.units, one.long_name = unit, f"{name}, Größe"
                one[:] = values

    return make


for kind in (
    "NETCDF4",
    "NETCDF4_CLASSIC",
    "NETCDF3_CLASSIC",
    "NETCDF3_64BIT_OFFSET",
    "NETCDF3_64BIT_DATA",
):
    writer(f"netCDF4 {kind}.nc")(_netcdf4(kind))
writer("netCDF4 unlimited.nc")(_netcdf4("NETCDF4", unlimited=True))
writer("netCDF4 unlimited3.nc")(_netcdf4("NETCDF3_CLASSIC", unlimited=True))
writer("netCDF4 group.nc")(_netcdf4("NETCDF4", group="bench"))


@writer("netCDF4 packed.nc")
def _packed(file: Path) -> None:
    """Integers with scale, offset and fill value, dimensions of other names, instants, units as strings."""
    from netCDF4 import Dataset

    with Dataset(file, "w") as whole:
        whole.createDimension("sample", TIME.size)
        whole.createDimension("station", 1)
        time = whole.createVariable("time", "i4", ("sample",))
        time.setncattr_string("units", "milliseconds since 2026-11-28 12:00:00")
        time.calendar = "proleptic_gregorian"
        time[:] = np.round(1e3 * TIME)
        for name, (values, unit) in CHANNELS.items():
            one = whole.createVariable(name, "i4", ("sample", "station"), fill_value=-(2**31))
            one.scale_factor, one.add_offset = (1e-6, 0.0) if unit == "m/s^2" else (1e-4, 100.0)
            one.setncattr_string("units", [unit])
            one[:] = values[:, None]


def _scipy(number: int) -> Make:
    def make(file: Path) -> None:
        from scipy.io import netcdf_file

        with netcdf_file(file, "w", version=number) as whole:
            whole.createDimension("time", TIME.size)
            for name, (values, unit) in {"time": (TIME, "s"), **CHANNELS}.items():
                one = whole.createVariable(name, "f8", ("time",))
                one.units = unit
                one[:] = values

    return make


writer("scipy netcdf_file1.nc")(_scipy(1))
writer("scipy netcdf_file2.nc")(_scipy(2))


def _dataset(time: Any = TIME, units: str = "s") -> Any:
    import xarray as xr

    data = {name: ("time", values, {"units": unit}) for name, (values, unit) in CHANNELS.items()}
    return xr.Dataset(
        data, {"time": ("time", time, {"units": units} if units else {})}, {"title": "a bench run"}
    )


def _xarray(kind: str, engine: str, *time: Any) -> Make:
    return lambda file: _dataset(*time).to_netcdf(file, format=kind, engine=engine)


writer("xarray netcdf4.nc", "netCDF4")(_xarray("NETCDF4", "netcdf4"))
writer("xarray netcdf4-classic.nc", "netCDF4")(_xarray("NETCDF4_CLASSIC", "netcdf4"))
writer("xarray netcdf4-3.nc", "netCDF4")(_xarray("NETCDF3_64BIT", "netcdf4"))
writer("xarray h5netcdf.nc", "h5netcdf")(_xarray("NETCDF4", "h5netcdf"))
writer("xarray scipy.nc", "scipy")(_xarray("NETCDF3_CLASSIC", "scipy"))
writer("xarray instants.nc", "netCDF4")(_xarray("NETCDF4", "netcdf4", INSTANTS, ""))
writer("xarray durations.nc", "netCDF4")(_xarray("NETCDF4", "netcdf4", INSTANTS - BEGAN, ""))
writer("xarray instants-3.nc", "scipy")(_xarray("NETCDF3_64BIT", "scipy", INSTANTS, ""))


# --- tables: Parquet, text, workbooks


def _frame(**more: Any) -> Any:
    import pandas as pd

    return pd.DataFrame(HEADED | more)


writer("pandas pyarrow.parquet", "pyarrow")(
    lambda file: _frame().to_parquet(file, engine="pyarrow")
)
writer("pandas index.parquet", "pyarrow")(
    lambda file: _frame().set_index("time [s]").to_parquet(file)
)
writer("pandas instants.parquet", "pyarrow")(
    lambda file: _frame(**{"time [s]": INSTANTS}).to_parquet(file)
)
writer("pandas durations.parquet", "pyarrow")(
    lambda file: _frame(**{"time [s]": INSTANTS - BEGAN}).to_parquet(file)
)
writer("pandas to_csv.csv")(lambda file: _frame().to_csv(file))
writer("pandas semicolons.csv")(
    lambda file: _frame().to_csv(file, sep=";", decimal=",", index=False)
)
writer("pandas instants.csv")(
    lambda file: _frame(time=INSTANTS).drop(columns="time [s]").to_csv(file, index=False)
)
writer("pandas durations.csv")(
    lambda file: _frame(time=INSTANTS - BEGAN).drop(columns="time [s]").to_csv(file, index=False)
)
writer("pandas bom.csv")(
    lambda file: _frame().to_csv(file, index=False, encoding="utf-8-sig", lineterminator="\r\n")
)
writer("pandas openpyxl.xlsx", "openpyxl")(lambda file: _frame().to_excel(file, engine="openpyxl"))
writer("pandas xlsxwriter.xlsx", "xlsxwriter")(
    lambda file: _frame().to_excel(file, engine="xlsxwriter", index=False)
)


@writer("fastparquet write.parquet", "pandas")
def _fastparquet(file: Path) -> None:
    import fastparquet

    fastparquet.write(str(file), _frame(remark="text"), row_group_offsets=25, stats=True)


writer("fastparquet gzip.parquet", "pandas")(
    lambda file: (
        _frame().set_index("time [s]").to_parquet(file, engine="fastparquet", compression="gzip")
    )
)


def _polars(name: str, *, durations: bool = False, **more: Any) -> Make:
    def make(file: Path) -> None:
        import polars as pl

        frame = pl.DataFrame(HEADED)
        if durations:
            frame = frame.with_columns(pl.Series("time [s]", INSTANTS - BEGAN))
        getattr(frame, name)(file, **more)

    return make


writer("polars write_parquet.parquet")(_polars("write_parquet"))
writer("polars durations.parquet")(_polars("write_parquet", durations=True, statistics="full"))
writer("polars write_csv.csv")(_polars("write_csv"))
writer("polars write_excel.xlsx", "xlsxwriter")(_polars("write_excel"))


def _duckdb(more: str, columns: str = "*") -> Make:
    def make(file: Path) -> None:
        import duckdb

        with duckdb.connect() as base:
            base.execute(
                'create table run ("time [s]" double, "sprung.az [m/s^2]" double, "strut.force [N]" double)'
            )
            base.executemany(
                "insert into run values (?, ?, ?)", np.column_stack([*HEADED.values()]).tolist()
            )
            base.execute(f"copy (select {columns} from run) to '{file}' ({more})")

    return make


writer("duckdb copy.parquet")(_duckdb("format parquet", "*, 'a' as remark"))
writer("duckdb zstd.parquet")(
    _duckdb("format parquet, compression zstd, row_group_size 2048, parquet_version v2")
)
writer("duckdb decimal.parquet")(
    _duckdb("format parquet", '"time [s]"::decimal(9, 2) as "time [s]", * exclude "time [s]"')
)
writer("duckdb copy.csv")(_duckdb("format csv, header true"))
INSTANT = "timestamptz '2026-11-28 12:00:00+01' + to_seconds(\"time [s]\")"
writer("duckdb instants.csv")(
    _duckdb("format csv, header true", f'{INSTANT} as time, * exclude "time [s]"')
)
writer("duckdb times.parquet")(
    _duckdb("format parquet", f'({INSTANT})::timestamp::time as time, * exclude "time [s]"')
)


def _pyarrow(**more: Any) -> Make:
    def make(file: Path) -> None:
        import pyarrow as pa
        from pyarrow import parquet

        parquet.write_table(pa.table(HEADED), file, **more)

    return make


writer("pyarrow write_table.parquet")(_pyarrow())
writer("pyarrow groups.parquet")(
    _pyarrow(row_group_size=15, compression="zstd", write_page_index=True, version="1.0")
)
writer("pyarrow checksums.parquet")(
    _pyarrow(use_dictionary=False, compression="none", write_page_checksum=True)
)


@writer("numpy savetxt.csv")
def _savetxt(file: Path) -> None:
    np.savetxt(
        file,
        np.column_stack([*HEADED.values()]),
        delimiter=",",
        header=",".join(HEADED),
        fmt="%.10g",
    )


writer("numpy savetxt.txt")(
    lambda file: np.savetxt(file, np.column_stack([*HEADED.values()]), header=" ".join(HEADED))
)


@writer("xlsxwriter constant_memory.xlsx")
def _xlsxwriter(file: Path) -> None:
    import xlsxwriter

    with xlsxwriter.Workbook(file, {"constant_memory": True}) as book:
        sheet = book.add_worksheet("Messung")
        for i, row in enumerate([list(HEADED), *np.column_stack([*HEADED.values()]).tolist()]):
            sheet.write_row(i, 0, row)


@writer("openpyxl write_only.xlsx")
def _openpyxl(file: Path) -> None:
    from openpyxl import Workbook

    book = Workbook(write_only=True)
    sheet = book.create_sheet("Messung")
    for row in [list(HEADED), *np.column_stack([*HEADED.values()]).tolist()]:
        sheet.append(row)
    book.save(file)


# --- MATLAB, MDF, TDMS, universal files


def _savemat(**more: Any) -> Make:
    def make(file: Path) -> None:
        from scipy.io import savemat

        savemat(file, SHORT, **more)

    return make


writer("scipy 4.mat")(_savemat(format="4"))
writer("scipy 5.mat")(_savemat(do_compression=True, oned_as="column"))


@writer("hdf5storage matlab.mat")
def _hdf5storage(file: Path) -> None:
    import hdf5storage

    hdf5storage.savemat(str(file), SHORT, format="7.3")


@writer("hdf5storage struct.mat")
def _hdf5storage_struct(file: Path) -> None:
    import hdf5storage

    hdf5storage.savemat(
        str(file), {"run": {**SHORT, "made_by": "bench 3"}}, format="7.3", oned_as="column"
    )


def _asammdf(number: str, **more: Any) -> Make:
    def make(file: Path) -> None:
        import asammdf

        signals = [
            asammdf.Signal(v, TIME, name=name, unit=unit) for name, (v, unit) in CHANNELS.items()
        ]
        with asammdf.MDF(version=number) as whole:
            whole.append(signals, common_timebase=True)
            whole.save(file, overwrite=True, **more)

    return make


for number, suffix in (("3.30", "mdf"), ("4.00", "mf4"), ("4.10", "mf4"), ("4.20", "mf4")):
    writer(f"asammdf {number}.{suffix}")(_asammdf(number))
writer("asammdf 4.10-packed.mf4")(_asammdf("4.10", compression=2))


def _mdfreader(number: str) -> Make:
    def make(file: Path) -> None:
        import mdfreader

        whole = mdfreader.Mdf()
        whole.MDFVersionNumber = int(number)
        for name, (values, unit) in {"time": (TIME, "s"), **CHANNELS}.items():
            whole.add_channel(name, values, "time", master_type=1, unit=unit)
        whole.write(str(file))

    return make


writer("mdfreader 3.dat")(_mdfreader("300"))
writer("mdfreader 4.mf4")(_mdfreader("400"))


def _nptdms(number: int, **more: Any) -> Make:
    def make(file: Path) -> None:
        from nptdms import ChannelObject, TdmsWriter

        with TdmsWriter(str(file), version=number) as stream:
            for part in (slice(0, 15), slice(15, None)):
                clock = (
                    []
                    if more
                    else [
                        ChannelObject("Bench", "time", TIME[part], properties={"unit_string": "s"})
                    ]
                )
                stream.write_segment(
                    [
                        *clock,
                        *(
                            ChannelObject(
                                "Bench",
                                name,
                                values[part],
                                properties={"unit_string": unit, **more},
                            )
                            for name, (values, unit) in CHANNELS.items()
                        ),
                    ]
                )

    return make


writer("nptdms 4712.tdms")(_nptdms(4712))
writer("nptdms waveform.tdms")(
    _nptdms(4713, wf_increment=0.01, wf_start_offset=0.0, wf_samples=TIME.size)
)


def _pyuff(**more: Any) -> Make:
    def make(file: Path) -> None:
        import pyuff

        whole = pyuff.UFF(str(file))
        for node, (name, (values, unit)) in enumerate(CHANNELS.items(), 1):
            exponents = {f"{kind}_unit_exp": 0 for kind in ("len", "force", "temp")}
            axes = {
                f"{axis}_{key}": value
                for axis in ("abscissa", "ordinate", "orddenom", "z_axis")
                for key, value in {
                    "spec_data_type": 0,
                    "axis_units_lab": "NONE",
                    **exponents,
                }.items()
            }
            axes |= {"abscissa_axis_units_lab": "s", "ordinate_axis_units_lab": unit}
            whole.write_sets(
                pyuff.prepare_58(
                    id1="run",
                    id2="",
                    id3="",
                    id4="",
                    id5="",
                    func_type=1,
                    ver_num=0,
                    load_case_id=0,
                    rsp_ent_name=name[:10],
                    rsp_node=node,
                    rsp_dir=3,
                    ref_ent_name="NONE",
                    ref_node=0,
                    ref_dir=0,
                    ord_data_type=4,
                    num_pts=TIME.size,
                    abscissa_spacing=1,
                    abscissa_min=0.0,
                    abscissa_inc=0.01,
                    z_axis_value=0.0,
                    x=TIME,
                    data=values,
                    **axes,
                    **more,
                ),
                mode="add",
            )

    return make


def _rpc3(kind: type) -> Make:
    def make(file: Path) -> None:
        import rpc3

        rpc3.progressbar = False
        channels = [
            rpc3.Channel(name, unit, 0.01, values) for name, (values, unit) in CHANNELS.items()
        ]
        rpc3.write(str(file), channels, datatype=kind, overwrite=True)

    return make


writer("rpc3 float.rsp")(_rpc3(float))
writer("rpc3 int.rsp")(_rpc3(int))
writer("pyuff ascii.uff")(_pyuff(binary=0))
writer("pyuff binary.uff")(_pyuff(binary=1))


# --- programs: a script that knows `@csv`, a table of the recording, and `@file`


OCTAVE = """
pkg load netcdf io
table = dlmread('@csv', ',', 1, 0); t = table(:, 1); az = table(:, 2); F = table(:, 3);
run.t = t; run.az = az; run.F = F; run.name = 'bench 3';
"""


def _octave(text: str) -> Make:
    return lambda file: _by_program("octave", OCTAVE + text, file)


writer("octave -v4.mat")(_octave("save('-v4', '@file', 't', 'az', 'F')"))
writer("octave -v6.mat")(_octave("save('-v6', '@file', 't', 'az', 'F')"))
writer("octave -v7.mat")(_octave("save('-v7', '@file', 't', 'az', 'F')"))
writer("octave struct.mat")(_octave("save('-v7', '@file', 'run')"))
for kind in ("classic", "netcdf4", "netcdf4_classic"):
    writer(f"octave {kind}.nc")(
        _octave(
            "function one(name, unit, values, kind)\n"
            "nccreate('@file', name, 'Dimensions', {'time', numel(values)}, 'Format', kind)\n"
            "ncwrite('@file', name, values); ncwriteatt('@file', name, 'units', unit)\nend\n"
            f"k = '{kind}'; one('time', 's', t, k); one('sprung.az', 'm/s^2', az, k); one('strut.force', 'N', F, k)"
        )
    )
writer("octave fprintf.csv")(
    _octave(
        "fid = fopen('@file', 'w'); fprintf(fid, 'time [s]; sprung.az [m/s^2]; strut.force [N]\\n');"
        "fprintf(fid, '%g; %.6f; %.4f\\n', [t az F]'); fclose(fid)"
    )
)
writer("octave xlswrite.xlsx")(
    _octave(
        "xlswrite('@file', [{'time [s]', 'sprung.az [m/s^2]', 'strut.force [N]'}; num2cell([t az F])], 1, '', 'OCT')"
    )
)

R = """
run <- read.csv("@csv")
names(run) <- c("time [s]", "sprung.az [m/s^2]", "strut.force [N]")
frame <- data.frame(run)
"""


def _r(text: str) -> Make:
    return lambda file: _by_program("R", R + text, file)


writer("R write.csv.csv")(_r('write.csv(frame, "@file")'))
writer("R write.csv2.csv")(_r('write.csv2(frame, "@file", row.names = FALSE)'))
writer("R write.table.txt")(_r('write.table(frame, "@file")'))
writer("R tabs.tsv")(_r('write.table(run, "@file", sep = "\\t", row.names = FALSE, quote = FALSE)'))
writer("R data.table-fwrite.csv")(_r('data.table::fwrite(run, "@file")'))
writer("R openxlsx.xlsx")(_r('openxlsx::write.xlsx(run, "@file")'))
for kind in ("FALSE", "TRUE"):
    writer(f"R ncdf4-{kind}.nc")(
        _r(
            'library(ncdf4)\ntime <- ncdim_def("time", "s", run[[1]], unlim = TRUE)\n'
            'az <- ncvar_def("sprung.az", "m/s^2", time, NA, prec = "double")\n'
            'force <- ncvar_def("strut.force", "N", time, -999, prec = "double")\n'
            f'file <- nc_create("@file", list(az, force), force_v4 = {kind})\n'
            "ncvar_put(file, az, run[[2]]); ncvar_put(file, force, run[[3]]); nc_close(file)"
        )
    )


def run_script(program: str, text: str, **places: object) -> None:
    """Run a script of a program, in which `@file` and other places are filled in."""
    for name, place in places.items():
        text = text.replace(f"@{name}", str(place))
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "script"
        script.write_text(text, encoding="utf-8")
        subprocess.run(
            [*SCRIPTS[program], str(script)], check=True, capture_output=True, timeout=300
        )


def write_table(folder: Path) -> Path:
    """Write the recording as plain text, from which programs make theirs."""
    rows = [
        ",".join(HEADED),
        *(",".join(map(repr, row)) for row in np.column_stack([*HEADED.values()]).tolist()),
    ]
    (folder / "run.csv").write_text("\n".join(rows) + "\n")
    return folder / "run.csv"


def _by_program(program: str, text: str, file: Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        run_script(program, text, csv=write_table(Path(folder)), file=file.resolve())


def convert(file: Path, folder: Path, filters: str) -> Path:
    """Convert a table by LibreOffice."""
    words = [
        "soffice",
        f"-env:UserInstallation=file://{folder}/profile",
        "--headless",
        "--convert-to",
        filters,
    ]
    words += ["--infilter=CSV:44,34,76,1,,1033"] * (file.suffix == ".csv")
    subprocess.run(
        [*words, "--outdir", str(folder / "out"), str(file)],
        check=True,
        capture_output=True,
        timeout=300,
    )
    (made,) = (folder / "out").iterdir()
    return made


def _libreoffice(filters: str) -> Make:
    def make(file: Path) -> None:
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(convert(write_table(Path(folder)), Path(folder), filters), file)

    return make


writer("libreoffice calc.xlsx")(_libreoffice("xlsx"))
writer("libreoffice german.csv")(
    _libreoffice("csv:Text - txt - csv (StarCalc):59,34,76,1,,1031,true,true")
)

PROGRAMS = {
    "octave": ["octave-cli", "--eval", "printf('%s', version)"],
    "R": ["Rscript", "-e", "cat(as.character(getRversion()))"],
    "libreoffice": ["soffice", "--version"],
}


SCRIPTS = {"octave": ["octave-cli", "--quiet", "--no-window-system"], "R": ["Rscript", "--vanilla"]}


def versions(libraries: Iterable[str]) -> dict[str, str]:
    """Versions of those libraries and programs that are there."""
    found = {}
    for library in libraries:
        if library in PROGRAMS:
            if shutil.which(PROGRAMS[library][0]):
                told = subprocess.run(
                    PROGRAMS[library], check=True, capture_output=True, text=True
                ).stdout
                found[library] = next(word for word in told.split() if word[0].isdigit())
            continue
        try:
            importlib.import_module(library)
            found[library] = version(
                {"xlsxwriter": "XlsxWriter", "rpc3": "rpc3-file"}.get(library, library)
            )
        except ImportError:
            continue
    return found


def main() -> None:
    """Write all files that can be written here into the folder that is named."""
    folder, chosen = Path(sys.argv[1]), sys.argv[2:]
    there = versions({library for library, _ in WRITERS})
    for (library, rest), (needs, make) in WRITERS.items():
        if library not in there or (chosen and library not in chosen):
            continue
        try:
            for name in needs:
                importlib.import_module(name)
            file = folder / f"{library}-{there[library]}-{rest}"
            file.unlink(missing_ok=True)
            make(file)
            print(file.name, file.stat().st_size)  # noqa: T201
        except Exception as error:  # noqa: BLE001 - one that fails is no reason to leave out the others
            said = getattr(error, "stderr", b"") or b""
            print("FAILED", library, rest, type(error).__name__, error, said.decode()[-300:])  # noqa: T201


if __name__ == "__main__":
    main()
