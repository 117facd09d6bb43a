"""What other programs read of jounce's files: `python check.py FOLDER` opens `run.nc`, `run.csv` ... with all it finds.

Run it with several interpreters, as `make.py`. The files hold what is told in `README.md`, by `write_recording`.
A line says the program, its version, the file, and "right" or what differs: names, units and values are compared.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from make import CHANNELS, TIME, run_script, versions

Found = dict[str, tuple[Any, str]]
OPENERS: dict[tuple[str, str], Callable[[Path], Found]] = {}
TRUTH: Found = {"time": (TIME, "s"), **CHANNELS}


def opener(name: str) -> Callable[[Callable[[Path], Found]], Callable[[Path], Found]]:
    """Add a function that reads a file: `pandas .csv`, or with more behind it how."""

    def add(read: Callable[[Path], Found]) -> Callable[[Path], Found]:
        library, _, rest = name.partition(" ")
        OPENERS[library, rest] = read
        return read

    return add


def of_headers(columns: dict[str, Any]) -> Found:
    """Names and units of headers like `force [N]`, with nothing before or behind."""
    return {
        head.rpartition(" [")[0] or head: (values, head.rpartition("[")[2].rstrip("]"))
        for head, values in columns.items()
    }


# --- netCDF


@opener("netCDF4 .nc")
def _netcdf4(file: Path) -> Found:
    from netCDF4 import Dataset

    with Dataset(file) as whole:
        assert (whole.made_by, whole.speed) == ("bench 3, Prüfstand", 1.95), whole.ncattrs()
        return {name: (one[:], one.units) for name, one in whole.variables.items()}


def _xarray(**more: Any) -> Callable[[Path], Found]:
    def read(file: Path) -> Found:
        import xarray as xr

        with xr.open_dataset(file, **more) as whole:
            assert whole.attrs["made_by"] == "bench 3, Prüfstand"
            assert whole["sprung.az"].attrs["long_name"].endswith("Größe")
            return {
                str(name): (one.values, one.attrs["units"]) for name, one in whole.variables.items()
            }

    return read


opener("xarray .nc")(_xarray())
opener("xarray .nc netcdf4")(_xarray(engine="netcdf4"))
opener("xarray .nc h5netcdf")(_xarray(engine="h5netcdf"))


@opener("h5py .nc")
def _h5py(file: Path) -> Found:
    import h5py

    with h5py.File(file) as whole:
        return {name: (one[:], one.attrs["units"].decode()) for name, one in whole.items()}


# --- RPC III


@opener("rpc3 .rsp")
def _rpc3(file: Path) -> Found:
    import rpc3

    rpc3.progressbar = False
    channels, _ = rpc3.read(str(file))
    found = {one.name: (one.data, one.unit) for one in channels}
    return {"time": (channels[0].time(), "s"), **found}


# --- tables


@opener("pandas .csv")
def _pandas_csv(file: Path) -> Found:
    import pandas as pd

    return of_headers({name: one.to_numpy() for name, one in pd.read_csv(file).items()})


@opener("pandas .csv pyarrow")
def _pandas_pyarrow(file: Path) -> Found:
    import pandas as pd

    return of_headers(
        {name: one.to_numpy() for name, one in pd.read_csv(file, engine="pyarrow").items()}
    )


@opener("numpy .csv")
def _numpy(file: Path) -> Found:
    found = np.genfromtxt(file, delimiter=",", names=True, deletechars="", replace_space=" ")
    return of_headers({name: found[name] for name in found.dtype.names})


def _with_metadata(table: Any) -> Found:
    return {
        field.name: (column.to_numpy(), field.metadata[b"units"].decode())
        for field, column in zip(table.schema, table.columns, strict=True)
    }


@opener("pyarrow .parquet")
def _pyarrow(file: Path) -> Found:
    from pyarrow import parquet

    return _with_metadata(parquet.read_table(file))


def _bare(columns: dict[str, Any]) -> Found:
    """Columns of a reader that gives no metadata."""
    return {name: (values, TRUTH.get(name, ("", "?"))[1]) for name, values in columns.items()}


@opener("pandas .parquet")
def _pandas_parquet(file: Path) -> Found:
    import pandas as pd

    return _bare({name: one.to_numpy() for name, one in pd.read_parquet(file).items()})


@opener("fastparquet .parquet")
def _fastparquet(file: Path) -> Found:
    import fastparquet

    return _bare(
        {
            name: one.to_numpy()
            for name, one in fastparquet.ParquetFile(str(file)).to_pandas().items()
        }
    )


@opener("polars .parquet")
def _polars_parquet(file: Path) -> Found:
    import polars as pl

    return _bare({one.name: one.to_numpy() for one in pl.read_parquet(file)})


@opener("polars .csv")
def _polars_csv(file: Path) -> Found:
    import polars as pl

    return of_headers({one.name: one.to_numpy() for one in pl.read_csv(file)})


@opener("polars .xlsx")
def _polars_xlsx(file: Path) -> Found:
    import polars as pl

    return of_headers(
        {one.name: one.to_numpy() for one in pl.read_excel(file, sheet_name="recording")}
    )


def _duckdb(words: str, more: Callable[[dict[str, Any]], Found]) -> Callable[[Path], Found]:
    def read(file: Path) -> Found:
        import duckdb

        return more(duckdb.sql(f"select * from {words}('{file}')").fetchnumpy())

    return read


opener("duckdb .parquet")(_duckdb("read_parquet", _bare))
opener("duckdb .csv")(_duckdb("read_csv_auto", of_headers))


@opener("pandas .xlsx openpyxl")
def _pandas_xlsx(file: Path) -> Found:
    import pandas as pd

    return of_headers(
        {name: one.to_numpy() for name, one in pd.read_excel(file, engine="openpyxl").items()}
    )


@opener("pandas .xlsx calamine")
def _pandas_calamine(file: Path) -> Found:
    import pandas as pd

    return of_headers(
        {name: one.to_numpy() for name, one in pd.read_excel(file, engine="calamine").items()}
    )


# --- MATLAB, MDF


def _of_matlab(found: Any) -> Found:
    """Vectors, named and with units in the structs beside them."""
    names, units = found["names"], found["units"]
    return {str(names[key]): (np.ravel(found[key]), str(units[key])) for key in names}


@opener("scipy .mat")
def _scipy(file: Path) -> Found:
    from scipy.io import loadmat

    return _of_matlab(loadmat(file, simplify_cells=True))


@opener("pymatreader .mat")
def _pymatreader(file: Path) -> Found:
    from pymatreader import read_mat

    return _of_matlab(read_mat(file))


@opener("asammdf .mf4")
def _asammdf(file: Path) -> Found:
    import asammdf

    with asammdf.MDF(file) as whole:
        found = {
            one.name: (one.samples, str(one.unit)) for one in whole.iter_channels(skip_master=True)
        }
        return {"time": (whole.get("sprung.az").timestamps, "s"), **found}


@opener("mdfreader .mf4")
def _mdfreader(file: Path) -> Found:
    import mdfreader

    whole = mdfreader.Mdf(str(file))
    (master,) = whole.masterChannelList
    names = {name: "time" if name == master else name for name in whole.masterChannelList[master]}
    return {
        name: (whole.get_channel_data(key), str(whole.get_channel_unit(key)) or "s")
        for key, name in names.items()
    }


# --- programs, which write what they read as text: name, unit, values


def _program(program: str, text: str) -> Callable[[Path], Found]:
    def read(file: Path) -> Found:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out.txt"
            run_script(program, text, file=file.resolve(), out=out)
            rows = [line.split("\t") for line in out.read_text(encoding="utf-8").splitlines()]
        return {name: (np.array(values, dtype=float), unit) for name, unit, *values in rows}

    return read


OCTAVE = """
pkg load netcdf io
o = fopen('@out', 'w');
function one(o, name, unit, values)
  fprintf(o, '%s\\t%s', name, unit); fprintf(o, '\\t%.17g', values); fprintf(o, '\\n');
end
function table(o, heads, t)
  for k = 1:numel(heads)
    parts = strsplit(heads{k}, ' ['); one(o, parts{1}, parts{2}(1:end-1), t(:, k));
  end
end
"""
opener("octave .nc")(
    _program(
        "octave",
        OCTAVE
        + """
for n = {'time', 'sprung.az', 'strut.force'}
  one(o, n{1}, ncreadatt('@file', n{1}, 'units'), ncread('@file', n{1}));
end
fclose(o);
""",
    )
)
opener("octave .mat")(
    _program(
        "octave",
        OCTAVE
        + """
s = load('@file');
for n = fieldnames(s.names)'
  k = n{1}; one(o, s.names.(k), s.units.(k), s.(k));
end
fclose(o);
""",
    )
)
opener("octave .csv")(
    _program(
        "octave",
        OCTAVE
        + """
f = fopen('@file'); heads = strsplit(fgetl(f), ','); fclose(f);
table(o, heads, dlmread('@file', ',', 1, 0)); fclose(o);
""",
    )
)
opener("octave .xlsx")(
    _program(
        "octave",
        OCTAVE
        + "[t, heads] = xlsread('@file', 'recording', '', 'OCT'); table(o, heads, t); fclose(o);",
    )
)
R = r"""
one <- function(name, unit, values) {
  text <- paste(format(values, digits = 17), collapse = "\t")
  cat(name, "\t", unit, "\t", text, "\n", sep = "", file = "@out", append = TRUE)
}
table <- function(t) for (h in names(t)) one(sub(" \\[.*", "", h), sub(".*\\[(.*)\\]", "\\1", h), t[[h]])
"""
opener("R .csv")(_program("R", R + 'table(read.csv("@file", check.names = FALSE))'))
opener("R .csv data.table")(_program("R", R + 'table(data.table::fread("@file"))'))
opener("R .xlsx readxl")(_program("R", R + 'table(readxl::read_excel("@file"))'))
opener("R .xlsx openxlsx")(
    _program("R", R + 'table(openxlsx::read.xlsx("@file", check.names = FALSE, sep.names = " "))')
)
opener("R .nc")(
    _program(
        "R",
        R
        + """
f <- ncdf4::nc_open("@file")
one("time", f$dim$time$units, f$dim$time$vals)
for (n in names(f$var)) one(n, f$var[[n]]$units, ncdf4::ncvar_get(f, n))
stopifnot(ncdf4::ncatt_get(f, 0, "made_by")$value == "bench 3, Pr\\u00fcfstand")
""",
    )
)


def _libreoffice(file: Path) -> Found:
    from make import convert

    with tempfile.TemporaryDirectory() as folder:
        made = convert(
            file, Path(folder), "csv:Text - txt - csv (StarCalc):44,34,76,1,,1033,false,false"
        )
        head, *rows = made.read_text(encoding="utf-8").splitlines()
    table = np.array([row.split(",") for row in rows], dtype=float)
    return of_headers(dict(zip(head.split(","), table.T, strict=True)))


opener("libreoffice .xlsx")(_libreoffice)
opener("libreoffice .csv")(_libreoffice)


def differing(found: Found, precision: float = 1e-14) -> str:
    """What is not as it was written; empty for nothing."""
    if set(found) != set(TRUTH):
        return f"names {', '.join(found)}"
    for name, (values, unit) in TRUTH.items():
        if found[name][1] != unit:
            return f"{name}: unit {found[name][1]!r}"
        if not np.allclose(
            np.asarray(found[name][0], dtype=float), values, rtol=precision, atol=1e-14
        ):
            return f"{name}: values {found[name][0]}"
    return ""


def main() -> None:
    """Open all files that can be opened here."""
    folder, there = Path(sys.argv[1]), versions({library for library, _ in OPENERS})
    for (library, rest), read in OPENERS.items():
        if library in there:
            try:
                said = differing(
                    read(folder / f"run{rest.split()[0]}"),
                    6e-8 if rest.startswith(".rsp") else 1e-14,
                )
            except Exception as error:  # noqa: BLE001 - what one cannot open, another may
                stderr = getattr(error, "stderr", b"") or b""
                said = f"{type(error).__name__}: {error} {stderr.decode()[-300:]}"
            print(library, there[library], rest, said or "right", sep="\t")  # noqa: T201


if __name__ == "__main__":
    main()
