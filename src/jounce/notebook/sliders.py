"""Sliders for the parameters of a rig, whose response is recomputed and redrawn whenever one is moved."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from hashlib import sha256
from importlib import resources
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.errors import DescriptionError, JounceError, unknown
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.units import to_si
from jounce.parts.rig import unit_of
from jounce.plots.comparison import common_axis, common_channels
from jounce.plots.thinning import thin

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts import Rig

_SHARE = 0.5  # default range: this fraction of the value to each side
_COLUMNS = 400  # samples of a curve
_MOST_CURVES = 6


def live(
    rig: Rig,
    numbers: Sequence[str] | Mapping[str, tuple[float | str, float | str]],
    run: Callable[[Any], xr.Dataset],
    *,
    channels: Sequence[str] | None = None,
) -> Any:
    """Return sliders for parameters of a rig, with curves of the changed and the original rig.

    Parameters
    ----------
    rig : Rig
        Initial rig; it is not modified.
    numbers : sequence of str, or mapping of str to (least, greatest)
        Paths as in ``rig.parameters()``, with slider limits in SI or with units. The default range is ± 50 % of the
        value; a parameter that is 0 requires limits.
    run : callable
        Computes a recording or a sweep of a rig: ``lambda rig: jn.simulate(rig, trial)``.
    channels : sequence of str, optional
        Channels to draw, at most six; by default those of the result's figure.

    Returns
    -------
    anywidget.AnyWidget
        Widget displayed by the notebook, replaced by a static image without a kernel, as in exported pages.
        ``widget.rig()`` returns the rig at the current slider values, ``widget.values`` contains these values (SI).

    Raises
    ------
    DescriptionError
        For an unknown path, invalid limits, or a parameter that is 0 without limits.
    MissingPackageError
        Without anywidget (extra ``notebook``).

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
    >>> widget = live(rig, ["strut.spring.rate"], lambda rig: jn.simulate(rig, trial))  # doctest: +SKIP
    """
    sliders = [_slider(rig, path, ends) for path, ends in _ranges(numbers).items()]
    require("anywidget", "notebook")
    first = run(rig)
    axis = common_axis({"": first})
    names = list(common_channels({"": first}, channels))[:_MOST_CURVES]
    units = {name: _unit(first, name) for name in (axis, *names)}
    return _widget_class()(rig, sliders, run, (axis, *names), units, first)


def _ranges(
    numbers: Sequence[str] | Mapping[str, tuple[float | str, float | str]],
) -> dict[str, tuple[float | str, float | str] | None]:
    if not numbers or isinstance(numbers, str):
        example = '["strut.spring.rate"], or {"strut.spring.rate": ("15 N/mm", "40 N/mm")}'
        raise DescriptionError(
            "no parameters for the sliders", where="numbers", found=numbers, allowed=example
        )
    return dict(numbers) if isinstance(numbers, Mapping) else dict.fromkeys(numbers)


def _slider(rig: Rig, path: str, ends: tuple[float | str, float | str] | None) -> dict[str, Any]:
    """Return a slider: parameter and range, in display units."""
    known = rig.parameters()
    if path not in known:
        raise unknown(path, known, what="number", where="numbers")
    value, si = known[path], unit_of(rig, path)
    if ends is None:
        if value == 0.0:
            raise DescriptionError(
                "the default range around zero is empty",
                where=path,
                hint=Phrase('Give both ends of the range: ("0 {si}", ...).', si=si),
            )
        ends = ((1.0 - _SHARE) * value, (1.0 + _SHARE) * value)
    low, high = sorted(to_si(end, si, where=path) for end in ends)
    if not low < high:
        raise DescriptionError(
            "invalid range", where=path, found=f"{low:g} to {high:g}", allowed="two different ends"
        )
    unit = display_unit(si, max(abs(low), abs(high)))
    return {
        "path": path,
        "value": value,
        "low": low,
        "high": high,
        "unit": unit.name,
        "factor": unit.factor,
    }


def _unit(data: xr.Dataset, name: str) -> DisplayUnit:
    values = data[name].to_numpy().astype(float)
    return display_unit(
        str(data[name].attrs.get("units", "1")), float(np.nanmax(np.abs(values), initial=0.0))
    )


def curves_of(
    data: xr.Dataset, names: Sequence[str], units: Mapping[str, DisplayUnit]
) -> list[dict[str, Any]]:
    """Return curves over the first name, thinned to the visible detail, in the given units; gaps are ``None``."""
    axis, *channels = names
    x = data[axis].to_numpy().astype(float) * units[axis].factor
    curves = []
    for name in channels:
        y = data[name].to_numpy().astype(float) * units[name].factor
        few, seen = thin(x, y, float(x[0]), float(x[-1]), _COLUMNS)
        values = [None if not np.isfinite(value) else float(f"{value:.5g}") for value in seen]
        curves.append({
            "name": name, "unit": units[name].name, "across": f"{axis.replace('_', ' ')} [{units[axis].name or '–'}]",
            "x": [float(f"{value:.6g}") for value in few], "y": values,
        })  # fmt: skip
    return curves


_ALIVE = (
    "The sliders move where the notebook runs: open it in Jupyter with the extra notebook of jounce, and run this "
    "cell. Until then, this is the rig as it was."
)


def still_html(
    sliders: Sequence[Mapping[str, Any]], first: xr.Dataset, names: Sequence[str]
) -> str:
    """Return the static replacement shown without a kernel: values, curves, and how to activate the sliders."""
    import base64

    from jounce.core.shown import html_table, number
    from jounce.report.chart import chart_svg
    from jounce.report.recordings import curve_blocks
    from jounce.report.render import chart_style

    rows = [
        (
            slider["path"],
            f"{number(slider['value'] * slider['factor'])} {slider['unit']}",
            f"{number(slider['low'] * slider['factor'])} to {number(slider['high'] * slider['factor'])}",
        )
        for slider in sliders
    ]
    table = html_table(
        "Rig with sliders", _ALIVE, rows, "widget.rig()", ("number", "value", "range")
    )
    _, figures = curve_blocks({"": {"rig": first}}, list(names[1:]))
    (chart,) = figures.blocks  # type: ignore[union-attr]
    svg = base64.b64encode(chart_svg(chart, chart_style()).encode()).decode()  # type: ignore[arg-type]
    picture = f'<img src="data:image/svg+xml;base64,{svg}" alt="Curves of the rig as it was" style="max-width:100%">'
    return table + picture


@cache
def _widget_class() -> Any:
    """Return the class of the widget; its package is imported on first use."""
    import anywidget
    import traitlets

    folder = resources.files("jounce.notebook")

    class LiveRig(anywidget.AnyWidget):  # type: ignore[misc]
        """Widget of sliders and curves: the page sends values and receives curves."""

        _esm = folder.joinpath("live.js").read_text(encoding="utf-8")
        _css = folder.joinpath("live.css").read_text(encoding="utf-8")
        sliders: Any = traitlets.List().tag(sync=True)
        values: Any = traitlets.Dict().tag(sync=True)
        before: Any = traitlets.List().tag(sync=True)
        curves: Any = traitlets.List().tag(sync=True)
        problem: Any = traitlets.Unicode().tag(sync=True)
        still: Any = traitlets.Unicode().tag(sync=True)

        def __init__(
            self,
            rig: Rig,
            sliders: list[dict[str, Any]],
            run: Callable[[Any], xr.Dataset],
            names: Sequence[str],
            units: Mapping[str, DisplayUnit],
            first: xr.Dataset,
        ) -> None:
            self._rig, self._run, self._names, self._units = rig, run, names, units
            drawn = curves_of(first, names, units)
            values = {slider["path"]: slider["value"] for slider in sliders}
            self._still = still_html(sliders, first, names)
            name = sha256(self._still.encode()).hexdigest()[:16]
            super().__init__(sliders=sliders, values=values, before=drawn, curves=drawn, still=name)
            self.observe(self._redraw, names="values")
            self.on_msg(self._answer)

        def _answer(self, _widget: object, content: Any, _buffers: object) -> None:
            if content == {"ask": "alive"}:
                self.send({"alive": True})

        def _ipython_display_(self, **_options: object) -> None:
            """Show the widget, and an image that is hidden as soon as the widget is active."""
            from IPython.display import display

            bundle = self._repr_mimebundle_()
            data, metadata = bundle if isinstance(bundle, tuple) else (bundle, {})
            display(data, metadata=metadata, raw=True)
            still = f'<div class="jounce-still" data-live="{self.still}">{self._still}</div>'
            display({"text/html": still, "text/plain": _ALIVE}, raw=True)

        def rig(self) -> Rig:
            """Return the rig at the current slider values."""
            known = {slider["path"] for slider in self.sliders}
            return self._rig.with_changes(
                {path: float(value) for path, value in self.values.items() if path in known}
            )

        def _redraw(self, _change: object) -> None:
            try:
                curves = curves_of(self._run(self.rig()), self._names, self._units)
            except JounceError as error:  # the previous curves are kept, and the reason is shown
                self.problem = error.message()
            else:
                self.curves, self.problem = curves, ""

    return LiveRig
