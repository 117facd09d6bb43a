"""Signs that no XML can hold, in titles and names: they cost no picture, no page and no workbook."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

import jounce as jn
from jounce.core.errors import OutputError
from jounce.core.workbooks import CONTROL
from jounce.plots.figures import rendered
from jounce.report.page import Page, Section, Table
from jounce.report.render import write_page

SIGNS = ("\x00", "\x07", "\x0b", "\x1b", "\ufffe", "\uffff", "\ud800")


@pytest.mark.parametrize("sign", SIGNS)
def test_pictures(sign: str) -> None:
    figure = Figure()
    axes = figure.subplots()
    axes.plot([0.0, 1.0], label=f"run {sign}")
    axes.legend()
    axes.set(title=f"a{sign}b", xlabel=sign)
    made = rendered(figure, (".svg", ".png", ".pdf"))
    assert "a b" in "".join(ET.fromstring(made[".svg"]).itertext())
    assert all(made.values())


@pytest.mark.parametrize("sign", SIGNS)
def test_pages_with_their_tables(tmp_path, sign: str) -> None:
    pytest.importorskip("openpyxl")
    pytest.importorskip("typst")
    table = Table(f"of {sign}", ("name", f"value {sign}"), ((f"a{sign}b", "1"),))
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
        return xr.Dataset({name: ("time", np.arange(9.0), {"units": "m/s^2"})}, clock, {"title": f"a{sign}b"})

    again, _ = jn.read_recording(jn.write_recording(recording("sprung.az"), tmp_path / "a.xlsx"))
    assert again.attrs["title"] == f"a{sign}b"
    with pytest.raises(OutputError, match="a name that the file cannot hold"):
        jn.write_recording(recording(f"x{sign}.sprung.az"), tmp_path / "b.xlsx")
