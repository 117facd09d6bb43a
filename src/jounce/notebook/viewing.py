"""The viewer of the reports as the output of a cell: linked curves, and the mechanism that moves with them."""

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
    """A page within a cell, isolated from its surroundings.

    Attributes
    ----------
    page : str
        HTML text, complete in itself.
    height : int
        Of the cell, in points of the screen [1].
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
        Over the same axis: ``time`` (s), or what was swept; channels in SI. Several are compared.
    rig : Rig, optional
        The 3-D rig that moves with the first of them; its run needs ``detail=True``, its sweep ``points=True``.
    trial : Trial, optional
        What its run was driven over.
    channels : sequence of str, optional
        What is shown first; all others can be chosen.
    height : int
        Of the cell, in points of the screen [1].

    Returns
    -------
    EmbeddedPage
        A notebook shows it when it is the last line of a cell; nothing is fetched from a network.

    Raises
    ------
    RecordingError
        For nothing to show, different axes, or a channel that one of them does not hold.

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
