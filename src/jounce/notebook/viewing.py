"""The report viewer as the output of a notebook cell: linked curves with the animated mechanism."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts import Rig
    from jounce.roads import Trial


@dataclass(frozen=True)
class EmbeddedPage:
    """A page embedded in a cell, isolated from the notebook.

    Attributes
    ----------
    page : str
        Self-contained HTML.
    height : int
        Height of the cell in CSS pixels [1].
    """

    page: str
    height: int

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{escape(self.page)}" width="100%" height="{self.height}" style="border:0" '
            'title="jounce viewer" loading="lazy"></iframe>'
        )

    def __repr__(self) -> str:
        return f"Page of {len(self.page) / 1e6:.2f} MB, shown by notebooks"


def viewer(
    runs: xr.Dataset | Mapping[str, xr.Dataset] | Sequence[xr.Dataset],
    rig: Rig | None = None,
    trial: Trial | None = None,
    *,
    channels: Sequence[str] | None = None,
    height: int = 760,
) -> EmbeddedPage:
    """Show recordings, runs or sweeps in a cell: zoom, read values, choose channels, play the mechanism.

    Parameters
    ----------
    runs : xarray.Dataset, or mapping or sequence of them
        Data over a common axis: ``time`` (s), or the swept variable; channels in SI units. Several runs are compared.
    rig : Rig, optional
        3-D rig animated with the first run. A run requires ``detail=True``, a sweep ``points=True``.
    trial : Trial, optional
        Trial of that run, which gives its road.
    channels : sequence of str, optional
        Channels shown initially; all others can be selected.
    height : int
        Height of the cell in CSS pixels [1].

    Returns
    -------
    EmbeddedPage
        Page displayed by the notebook if it is the last expression of a cell; no network access is needed.

    Raises
    ------
    RecordingError
        If there is nothing to show, the axes differ, or a run lacks a requested channel.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-double-wishbone")
    >>> cell = viewer(jn.sweep_travel(rig, [-0.02, 0.0, 0.02], points=True), rig)
    >>> "<iframe srcdoc" in cell._repr_html_()
    True
    """
    from jounce.plots.comparison import common_channels, named_runs
    from jounce.report.live import Viewer
    from jounce.report.page import Page, Section
    from jounce.report.recordings import curve_blocks
    from jounce.report.render import page_html

    named = named_runs([runs] if hasattr(runs, "data_vars") else runs)  # type: ignore[list-item]
    blocks = curve_blocks({"": named}, common_channels(named, channels), rig=rig, trial=trial)
    curves = tuple(block for block in blocks if isinstance(block, Viewer))
    return EmbeddedPage(page_html(Page(", ".join(named), (Section("Curves", curves),)), {}), height)
