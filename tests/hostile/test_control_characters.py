"""Signs that no XML can hold, in titles and names: they cost no picture, no page and no workbook."""

from __future__ import annotations

from contextlib import suppress
from xml.etree import ElementTree as ET

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

import jounce as jn
from jounce.core.errors import OutputError
from jounce.core.workbooks import CONTROL
from jounce.plots.figures import render_figure
from jounce.report.page import Page, PageTable, Section
from jounce.report.render import write_page

SIGNS = ("\x00", "\x07", "\x0b", "\x1b", "\ufffe", "\uffff", "\ud800")


@pytest.mark.parametrize("sign", SIGNS)
def test_pictures(sign: str) -> None:
    figure = Figure()
    axes = figure.subplots()
    axes.plot([0.0, 1.0], label=f"run {sign}")
    axes.legend()
    axes.set(title=f"a{sign}b", xlabel=sign)
    made = render_figure(figure, (".svg", ".png", ".pdf"))
    assert "a b" in "".join(ET.fromstring(made[".svg"]).itertext())
    assert all(made.values())


@pytest.mark.parametrize("sign", SIGNS)
def test_pages_with_their_tables(tmp_path, sign: str) -> None:
    pytest.importorskip("openpyxl")
    pytest.importorskip("typst")
    table = PageTable(f"of {sign}", ("name", f"value {sign}"), ((f"a{sign}b", "1"),))
    page = Page(f"title {sign}", (Section(f"heading {sign}", (table,)),), banner=f"banner {sign}")
    files = write_page(page, tmp_path / "out", tables=("csv", "xlsx"), pdf=True)
    html = next(file for file in files if file.suffix == ".html").read_text(encoding="utf-8")
    assert "a b" in html
    assert not CONTROL.search(html)
    assert {".pdf", ".xlsx", ".csv"} <= {file.suffix for file in files}


@pytest.mark.parametrize("sign", SIGNS)
def test_workbooks_of_recordings(tmp_path, sign: str) -> None:
    pytest.importorskip("openpyxl")

    def recording(name: str) -> xr.Dataset:
        clock = {"time": ("time", np.arange(9) * 0.01, {"units": "s"})}
        return xr.Dataset(
            {name: ("time", np.arange(9.0), {"units": "m/s^2"})}, clock, {"title": f"a{sign}b"}
        )

    again, _ = jn.read_recording(jn.write_recording(recording("sprung.az"), tmp_path / "a.xlsx"))
    assert again.attrs["title"] == f"a{sign}b"
    with pytest.raises(OutputError, match="a name that the file cannot store"):
        jn.write_recording(recording(f"x{sign}.sprung.az"), tmp_path / "b.xlsx")


@pytest.mark.parametrize("suffix", [".nc", ".csv", ".mat", ".mf4", ".parquet", ".xlsx"])
@pytest.mark.parametrize("text", ["a\0b", "\ud800", ".", "", "\x1b[31m", "a\nb", "x" * 300])
def test_odd_texts_of_a_recording_are_written_or_refused(tmp_path, suffix, text):
    """NUL and halves of characters were errors of a library, and dots a folder of HDF5."""
    for package in {".mf4": ["asammdf"], ".parquet": ["pyarrow"], ".xlsx": ["openpyxl"]}.get(
        suffix, []
    ):
        pytest.importorskip(package)
    time = np.arange(20) * 0.01
    base = xr.Dataset(
        {"sprung.az": ("time", np.sin(9.0 * time), {"units": "m/s^2"})},
        {"time": ("time", time, {"units": "s"})},
    )
    channel, units, long_name, name, value, texts = (base.copy(deep=True) for _ in range(6))
    units["sprung.az"].attrs["units"] = long_name["sprung.az"].attrs["long_name"] = text
    name.attrs[text] = "x"
    value.attrs["rig"] = text
    texts.attrs["rigs"] = [text, {text: text}]
    for dataset in (channel.rename({"sprung.az": text}), units, long_name, name, value, texts):
        file = tmp_path / f"run{suffix}"
        try:
            jn.write_recording(dataset, file, force=True)
        except jn.OutputError:
            assert not file.exists()
            continue
        with suppress(jn.JounceError):  # what is written may be no channel, or no unit of one
            jn.read_recording(file)
        file.unlink()
