"""Computed channels: formulas over channels with their units, filters, derivatives and integrals."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, Any

import numpy as np

from jounce.analysis.record import AnyRecord, read_measured, refuse_gaps
from jounce.core.errors import DescriptionError, RecordingError, nearest
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import BaseUnit, in_base_units
from jounce.recordings.schema import QUANTITIES

Powers = tuple[tuple[str, float], ...]
_LONGEST, _MOST_NODES, _MOST_POWER = 1000, 300, 12.0
_EVEN = 1e-3  # of a step: larger differences of steps need resampling before a filter
_QUOTED = re.compile(r"`([^`\n]{1,200})`")
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S.*?)?\s*")
_PLAIN: Powers = ()
_ANGLE: Powers = (("rad", 1.0),)
_SECOND: Powers = (("s", 1.0),)
_HERTZ: Powers = (("s", -1.0),)
_SYMBOLS = {ast.Add: "+", ast.Sub: "−", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">="}


@dataclass(frozen=True)
class ComputedChannel(Plain):
    """A channel computed by a formula.

    Attributes
    ----------
    formula : str
        The formula as given.
    unit : str
        Unit of the values: as requested, or the SI unit that follows from the formula.
    channels : tuple of str
        Channels that it uses, in the order of their names.
    values : ndarray, shape (n,)
        One value for each sample of the recording; NaN where there is none.
    findings : tuple of Finding
        Samples without a value, such as those that are divided by zero.
    """

    left_out = ("values",)
    formula: Annotated[str, Shows("formula")]
    unit: Annotated[str, Shows("unit")]
    channels: Annotated[tuple[str, ...], Shows("channels")]
    values: Array
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Signal:
    """A value within a formula: samples (n,) or a number in SI, powers of its base units, and the text it is of.

    A zero (``is_zero``) fits every unit.
    """

    values: Any
    powers: Powers
    text: str
    is_zero: bool = False

    @property
    def is_number(self) -> bool:
        """Whether it is the same at all times."""
        return np.ndim(self.values) == 0


def compute_channel(record: AnyRecord, formula: str, *, unit: str = "") -> ComputedChannel:
    """Compute a channel from others of a recording, with units.

    Parameters
    ----------
    record : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        A recording, a table with columns ``name [unit]``, the result of `read_recording`, or a file.
    formula : str
        Names of channels, numbers, quantities in quotes (``"20 Hz"``), ``+ - * / **``, comparisons and functions:

        - of each sample: ``abs sqrt exp log log10 sin cos tan asin acos atan atan2 sign min max clip where``,
        - of all samples, a number: ``mean rms std minimum maximum first last``,
        - over time: ``derivative integral lowpass highpass bandpass smooth delay detrend``.

        ``time`` is the time in s. A name with spaces or other signs is written in backquotes.
    unit : str
        Unit of the result; by default the SI unit that follows from the formula.

    Returns
    -------
    ComputedChannel
        A channel as long as the recording. Filters have zero phase (`band_limit`), so they use later samples, too.

    Raises
    ------
    DescriptionError
        For a formula that cannot be read, units that do not fit, and a division by a channel that is zero throughout.
    RecordingError
        For an unknown channel, and filters of a recording with gaps.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 2.0, 0.001)
    >>> run = jn.recording(t, {"damper.displacement": (0.01 * np.sin(5.0 * t), "m", "")})
    >>> speed = jn.compute_channel(run, "derivative(damper.displacement)", unit="mm/s")
    >>> speed.unit, round(float(speed.values[0]), 2)
    ('mm/s', 50.0)
    >>> jn.compute_channel(run, "damper.displacement + '3 N'")   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: damper.displacement + 3 N: units do not fit; found 'm and N'...
    """
    used = read_measured(record)

    def channel(name: str) -> tuple[Any, str]:
        return used.values(name), used.unit(name)

    time = used.run["time"].to_numpy()
    return evaluate_formula(formula, channel, used.names, time, unit=unit, where=used.name)


def evaluate_formula(
    formula: str,
    channel: Callable[[str], tuple[Any, str]],
    names: Sequence[str],
    time: Array,
    *,
    unit: str = "",
    where: str = "formula",
) -> ComputedChannel:
    """Compute a formula over channels of any unit, which ``channel`` returns by their names; ``time`` is in s."""
    tree, quoted = _parse(formula)
    work = _Evaluation(channel, names, np.asarray(time, float), quoted, where)
    result = work.value(tree)
    si = _name_of(result.powers)
    values = np.broadcast_to(np.asarray(result.values, float), time.shape)
    if unit:
        base = _base(unit, where="unit")
        if not result.is_zero and not _fit(_powers(base), result.powers):
            raise DescriptionError(
                "the formula has another unit",
                where=formula,
                found=si,
                allowed=Phrase("a unit that converts to {si}", si=unit),
            )
        values = (values - base.offset) / base.factor
    lost = np.flatnonzero(~np.isfinite(values))
    findings = list(work.findings)
    if lost.size and not findings:
        findings.append(_gaps("analysis.no_value", where, lost, time, formula))
    if lost.size:
        values = np.where(np.isfinite(values), values, np.nan)
    return ComputedChannel(formula, unit or si, tuple(sorted(work.used)), values, tuple(findings))


def channels_in(formula: str, names: Sequence[str]) -> list[str]:
    """Return which of some names a formula uses."""
    tree, quoted = _parse(formula)
    used = {
        _path(node, quoted) for node in ast.walk(tree) if isinstance(node, ast.Name | ast.Attribute)
    }
    return [name for name in names if name in used]


def _parse(formula: str) -> tuple[ast.expr, list[str]]:
    """Read a formula; names in backquotes are replaced by placeholders."""
    quoted: list[str] = []

    def stand_in(match: re.Match[str]) -> str:
        quoted.append(match[1])
        return f" _{len(quoted) - 1}_ "

    text = formula.strip()
    if len(text) > _LONGEST:
        raise DescriptionError("the formula is too long", allowed=f"{_LONGEST}", where="formula")
    try:
        tree = ast.parse(_QUOTED.sub(stand_in, text).strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        place = getattr(error, "offset", None)
        raise DescriptionError(
            "the formula cannot be read",
            where=text or "formula",
            found=text[max(0, place - 1) :][:40] if place else None,
            hint="Write for example: lowpass(sprung.az, '20 Hz') / '1 g'. Names with spaces are in backquotes.",
        ) from None
    if sum(1 for _ in ast.walk(tree)) > _MOST_NODES:
        raise DescriptionError("the formula is too long", allowed=f"{_MOST_NODES}", where=text)
    return tree, quoted


def _path(node: ast.AST, quoted: Sequence[str]) -> str:
    """Return the dotted name of a node; empty if it is none."""
    if isinstance(node, ast.Name):
        match = re.fullmatch(r"_(\d+)_", node.id)
        return quoted[int(match[1])] if match and int(match[1]) < len(quoted) else node.id
    if isinstance(node, ast.Attribute):
        before = _path(node.value, quoted)
        return f"{before}.{node.attr}" if before else ""
    return ""


class _Evaluation:
    """One walk through a formula: only what is listed here is allowed in it."""

    def __init__(
        self,
        channel: Callable[[str], tuple[Any, str]],
        names: Sequence[str],
        time: Array,
        quoted: Sequence[str],
        where: str,
    ) -> None:
        self.channel, self.names, self.time, self.quoted = channel, names, time, quoted
        self.where = where
        self.used: set[str] = set()
        self.findings: list[Finding] = []

    def value(self, node: ast.AST) -> Signal:
        """Compute a part of the formula."""
        with np.errstate(all="ignore"):
            return self._value(node)

    def _value(self, node: ast.AST) -> Signal:
        if isinstance(node, ast.Constant):
            return self._constant(node)
        if isinstance(node, ast.Name | ast.Attribute) and (name := _path(node, self.quoted)):
            return self._channel(name)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
            inner = self._value(node.operand)
            sign = -1.0 if isinstance(node.op, ast.USub) else 1.0
            return replace(inner, values=sign * inner.values, text=f"-{inner.text}")
        if isinstance(node, ast.BinOp):
            return self._operation(node)
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            return self._comparison(node)
        if isinstance(node, ast.Call):
            return self._call(node)
        raise DescriptionError(
            "not allowed in a formula",
            where="formula",
            found=ast.unparse(node)[:80],
            allowed="names of channels, numbers, + - * / **, < <= > >=, and functions",
            hint="Write a power as x ** 2." if "^" in ast.unparse(node) else "",
        )

    def _constant(self, node: ast.Constant) -> Signal:
        given = node.value
        if isinstance(given, int | float) and not isinstance(given, bool) and abs(given) < 1e30:
            return Signal(float(given), _PLAIN, f"{given:g}", given == 0)
        if isinstance(given, str) and (match := _QUANTITY.fullmatch(given)):
            base = _base(match[2] or "1", where=given)
            return Signal(float(match[1]) * base.factor + base.offset, _powers(base), given)
        raise DescriptionError(
            "not a number with a unit",
            where="formula",
            found=str(given)[:80],
            allowed="'20 Hz', '1 g'",
        )

    def _channel(self, name: str) -> Signal:
        if name == "time":
            return Signal(self.time, _SECOND, name)
        if name not in self.names:
            raise RecordingError(
                Phrase("no channel {name!r}", name=name),
                where=self.where,
                hint=nearest(name, self.names) or "Write a quantity in quotes, such as '20 Hz'.",
            )
        self.used.add(name)
        values, unit = self.channel(name)
        base = _base(unit, where=f"{self.where}: {name}")
        return Signal(np.asarray(values, float) * base.factor + base.offset, _powers(base), name)

    def _operation(self, node: ast.BinOp) -> Signal:
        left, right = self._value(node.left), self._value(node.right)
        text = ast.unparse(node)[:80]
        if isinstance(node.op, ast.Add | ast.Sub):
            left, right = self._alike(left, right, _SYMBOLS[type(node.op)])
            sign = 1.0 if isinstance(node.op, ast.Add) else -1.0
            return Signal(left.values + sign * right.values, left.powers, text)
        if isinstance(node.op, ast.Mult):
            return Signal(left.values * right.values, _multiplied(left.powers, right.powers), text)
        if isinstance(node.op, ast.Div):
            return Signal(
                self._divided(left, right), _multiplied(left.powers, right.powers, -1.0), text
            )
        if isinstance(node.op, ast.Pow):
            return self._power(left, right, text)
        raise DescriptionError(
            "not allowed in a formula",
            where="formula",
            found=text,
            allowed="names of channels, numbers, + - * / **, < <= > >=, and functions",
            hint="Write a power as x ** 2." if isinstance(node.op, ast.BitXor) else "",
        )

    def _divided(self, left: Signal, right: Signal) -> Any:
        zero = np.asarray(right.values) == 0.0
        if zero.all():
            raise DescriptionError(
                "division by zero",
                where=f"{left.text} / {right.text}",
                found=Phrase("{text} is zero throughout", text=right.text),
                hint="Divide by a channel that is not zero, or limit it: max(speed, '1 m/s').",
            )
        if zero.any():
            self.findings.append(
                _gaps(
                    "analysis.divided_by_zero",
                    self.where,
                    np.flatnonzero(zero),
                    self.time,
                    right.text,
                )
            )
        return np.where(zero, np.nan, left.values / np.where(zero, 1.0, right.values))

    def _power(self, left: Signal, right: Signal, text: str) -> Signal:
        if not right.is_number or right.powers or abs(right.values) > _MOST_POWER:
            raise DescriptionError(
                "not an exponent",
                where=text,
                found=right.text,
                allowed=Phrase(
                    "a number from {least:g} to {most:g}", least=-_MOST_POWER, most=_MOST_POWER
                ),
            )
        number = float(right.values)
        powers = tuple((name, power * number) for name, power in left.powers if power * number)
        if number < 0.0:
            inverse = self._divided(Signal(1.0, _PLAIN, "1"), left)
            return Signal(inverse**-number, powers, text)
        return Signal(np.power(np.asarray(left.values, float), number), powers, text)

    def _comparison(self, node: ast.Compare) -> Signal:
        symbol = _SYMBOLS.get(type(node.ops[0]))
        if symbol is None:
            raise DescriptionError(
                "not allowed in a formula",
                where="formula",
                found=ast.unparse(node)[:80],
                allowed="< <= > >=",
            )
        left, right = self._alike(self._value(node.left), self._value(node.comparators[0]), symbol)
        compare = {"<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal}
        values = compare[symbol](left.values, right.values).astype(float)
        gaps = np.isnan(left.values) | np.isnan(right.values)
        return Signal(np.where(gaps, np.nan, values), _PLAIN, ast.unparse(node)[:80])

    def _alike(self, left: Signal, right: Signal, symbol: str) -> tuple[Signal, Signal]:
        """Return two values of the same unit, or refuse them; a zero has any unit."""
        if left.is_zero and left.is_number:
            left = replace(left, powers=right.powers)
        if right.is_zero and right.is_number:
            right = replace(right, powers=left.powers)
        if not _fit(left.powers, right.powers):
            angle = {left.powers, right.powers} == {_PLAIN, _ANGLE}
            raise DescriptionError(
                "units do not fit",
                where=f"{left.text} {symbol} {right.text}",
                found=f"{_name_of(left.powers)} and {_name_of(right.powers)}",
                allowed="two values of the same unit",
                hint="Give the angle its unit in quotes: '1 deg' or '1 rad'."
                if angle
                else "Write a number with its unit in quotes: '3 mm'.",
            )
        return left, replace(right, powers=left.powers)

    def _call(self, node: ast.Call) -> Signal:
        name = _path(node.func, self.quoted)
        if (
            name not in FUNCTIONS
            or node.keywords
            or any(isinstance(one, ast.Starred) for one in node.args)
        ):
            raise DescriptionError(
                "no such function" if name not in FUNCTIONS else "arguments have no names here",
                where="formula",
                found=ast.unparse(node)[:80],
                allowed=", ".join(FUNCTIONS),
                hint=nearest(name, FUNCTIONS),
            )
        function = FUNCTIONS[name]
        if not function.fewest <= len(node.args) <= function.most:
            raise DescriptionError(
                "wrong number of arguments",
                where=ast.unparse(node)[:80],
                found=len(node.args),
                allowed=function.form,
            )
        given = [self._value(argument) for argument in node.args]
        result = function.work(self, *given)
        return replace(result, text=ast.unparse(node)[:80], is_zero=False)

    def samples(self, signal: Signal) -> Array:
        """Return a value as samples."""
        return np.array(np.broadcast_to(signal.values, self.time.shape), dtype=float)

    def rate(self, what: str) -> float:
        """Return the sample rate (Hz); refuse time with gaps or uneven steps."""
        steps = np.diff(self.time)
        mean = float(self.time[-1] - self.time[0]) / max(1, steps.size)
        if not steps.size or float(np.abs(steps - mean).max()) > _EVEN * mean:
            raise RecordingError(
                "time is not uniform",
                where=f"{self.where}: {what}",
                hint="Read the file with resample, or bring the recording onto constant steps.",
            )
        return 1.0 / mean

    def number(self, signal: Signal, powers: Powers, unit: str) -> float:
        """Return an argument that must be one number of a unit."""
        if not signal.is_number or signal.powers != powers:
            raise DescriptionError(
                "not a value of this argument",
                where="formula",
                found=f"{signal.text} [{_name_of(signal.powers)}]",
                allowed=Phrase("a number in {unit}, in quotes", unit=unit),
            )
        return float(signal.values)


@dataclass(frozen=True)
class _Function:
    """A function of formulas: how it is written, the number of its arguments, and its work."""

    form: str
    fewest: int
    most: int
    work: Callable[..., Signal]


def _of_plain(function: Callable[[Any], Any], result: Powers, angle: bool = False) -> Any:
    def work(_: _Evaluation, x: Signal) -> Signal:
        if _without_angle(x.powers) or (x.powers and not angle):
            raise DescriptionError(
                "units do not fit",
                where=x.text,
                found=_name_of(x.powers),
                allowed="an angle or a plain number" if angle else "a plain number",
            )
        return Signal(function(np.asarray(x.values, float)), result, "")

    return work


def _same(function: Callable[[Any], Any]) -> Any:
    return lambda _, x: Signal(function(x.values), x.powers, "")


def _root(_: _Evaluation, x: Signal) -> Signal:
    powers = tuple((name, 0.5 * power) for name, power in x.powers)
    return Signal(np.sqrt(np.asarray(x.values, float)), powers, "")


def _sign(_: _Evaluation, x: Signal) -> Signal:
    return Signal(np.sign(x.values), _PLAIN, "")


def _angle_of(evaluation: _Evaluation, y: Signal, x: Signal) -> Signal:
    y, x = evaluation._alike(y, x, "atan2")
    return Signal(np.arctan2(y.values, x.values), _ANGLE, "")


def _extreme(
    function: Callable[[Any, Any], Any], evaluation: _Evaluation, *given: Signal
) -> Signal:
    first, *others = given
    for other in others:
        left, right = evaluation._alike(first, other, "and")
        first = Signal(function(left.values, right.values), left.powers, left.text)
    return first


def _clip(evaluation: _Evaluation, x: Signal, low: Signal, high: Signal) -> Signal:
    least, most = _extreme(np.maximum, evaluation, x, low), high
    return _extreme(np.minimum, evaluation, least, most)


def _where(evaluation: _Evaluation, condition: Signal, yes: Signal, no: Signal) -> Signal:
    yes, no = evaluation._alike(yes, no, "and")
    chosen = np.where(np.asarray(condition.values) > 0.0, yes.values, no.values)
    return Signal(np.where(np.isnan(condition.values), np.nan, chosen), yes.powers, "")


def _of_all(function: Callable[[Array], Any], evaluation: _Evaluation, x: Signal) -> Signal:
    values = evaluation.samples(x)
    values = values[np.isfinite(values)]
    if not values.size:
        raise RecordingError("the channel has no value", where=f"{evaluation.where}: {x.text}")
    return Signal(float(function(values)), x.powers, "")


def _derivative(evaluation: _Evaluation, x: Signal) -> Signal:
    values = evaluation.samples(x)
    if values.size < 3:
        raise RecordingError("the signal is too short to differentiate", where=x.text)
    slope = np.gradient(values, evaluation.time, edge_order=2)
    return Signal(slope, _multiplied(x.powers, _SECOND, -1.0), "")


def _integral(evaluation: _Evaluation, x: Signal) -> Signal:
    from scipy.integrate import cumulative_trapezoid

    values = evaluation.samples(x)
    refuse_gaps(evaluation.time, values, where=f"{evaluation.where}: {x.text}")
    area = cumulative_trapezoid(values, evaluation.time, initial=0.0)
    return Signal(area, _multiplied(x.powers, _SECOND), "")


def _filtered(
    evaluation: _Evaluation, x: Signal, above: Signal | None, below: Signal | None
) -> Signal:
    from jounce.recordings.signals import band_limit

    values = evaluation.samples(x)
    refuse_gaps(evaluation.time, values, where=f"{evaluation.where}: {x.text}")
    low, high = (
        None if corner is None else evaluation.number(corner, _HERTZ, "Hz")
        for corner in (above, below)
    )
    return Signal(band_limit(values, evaluation.rate(x.text), above=low, below=high), x.powers, "")


def _low(evaluation: _Evaluation, x: Signal, corner: Signal) -> Signal:
    return _filtered(evaluation, x, None, corner)


def _high(evaluation: _Evaluation, x: Signal, corner: Signal) -> Signal:
    return _filtered(evaluation, x, corner, None)


def _smooth(evaluation: _Evaluation, x: Signal, span: Signal) -> Signal:
    from scipy.ndimage import uniform_filter1d

    values = evaluation.samples(x)
    refuse_gaps(evaluation.time, values, where=f"{evaluation.where}: {x.text}")
    count = round(evaluation.number(span, _SECOND, "s") * evaluation.rate(x.text)) // 2 * 2 + 1
    if not 1 <= count <= values.size:
        raise DescriptionError(
            "the span does not fit the record",
            where=x.text,
            found=span.text,
            allowed=Phrase(
                "up to {span:g} s", span=float(evaluation.time[-1] - evaluation.time[0])
            ),
        )
    return Signal(uniform_filter1d(values, count, mode="nearest"), x.powers, "")


def _delay(evaluation: _Evaluation, x: Signal, lag: Signal) -> Signal:
    values, time = evaluation.samples(x), evaluation.time
    wanted = time - evaluation.number(lag, _SECOND, "s")
    return Signal(np.interp(wanted, time, values, left=np.nan, right=np.nan), x.powers, "")


def _detrend(evaluation: _Evaluation, x: Signal) -> Signal:
    values, time = evaluation.samples(x), evaluation.time
    refuse_gaps(evaluation.time, values, where=f"{evaluation.where}: {x.text}")
    if values.size < 2:
        return Signal(values - values.mean(), x.powers, "")
    slope, level = np.polyfit(time - time.mean(), values, 1)
    return Signal(values - slope * (time - time.mean()) - level, x.powers, "")


FUNCTIONS: Mapping[str, _Function] = {
    "abs": _Function("abs(x)", 1, 1, _same(np.abs)),
    "sqrt": _Function("sqrt(x)", 1, 1, _root),
    "exp": _Function("exp(x)", 1, 1, _of_plain(np.exp, _PLAIN)),
    "log": _Function("log(x)", 1, 1, _of_plain(np.log, _PLAIN)),
    "log10": _Function("log10(x)", 1, 1, _of_plain(np.log10, _PLAIN)),
    "sin": _Function("sin(angle)", 1, 1, _of_plain(np.sin, _PLAIN, angle=True)),
    "cos": _Function("cos(angle)", 1, 1, _of_plain(np.cos, _PLAIN, angle=True)),
    "tan": _Function("tan(angle)", 1, 1, _of_plain(np.tan, _PLAIN, angle=True)),
    "asin": _Function("asin(x)", 1, 1, _of_plain(np.arcsin, _ANGLE)),
    "acos": _Function("acos(x)", 1, 1, _of_plain(np.arccos, _ANGLE)),
    "atan": _Function("atan(x)", 1, 1, _of_plain(np.arctan, _ANGLE)),
    "atan2": _Function("atan2(y, x)", 2, 2, _angle_of),
    "sign": _Function("sign(x)", 1, 1, _sign),
    "min": _Function("min(x, y, ...)", 2, 8, partial(_extreme, np.minimum)),
    "max": _Function("max(x, y, ...)", 2, 8, partial(_extreme, np.maximum)),
    "clip": _Function("clip(x, low, high)", 3, 3, _clip),
    "where": _Function("where(condition, x, y)", 3, 3, _where),
    "mean": _Function("mean(x)", 1, 1, partial(_of_all, np.mean)),
    "rms": _Function("rms(x)", 1, 1, partial(_of_all, lambda x: np.sqrt(np.mean(x * x)))),
    "std": _Function("std(x)", 1, 1, partial(_of_all, np.std)),
    "minimum": _Function("minimum(x)", 1, 1, partial(_of_all, np.min)),
    "maximum": _Function("maximum(x)", 1, 1, partial(_of_all, np.max)),
    "first": _Function("first(x)", 1, 1, partial(_of_all, lambda x: x[0])),
    "last": _Function("last(x)", 1, 1, partial(_of_all, lambda x: x[-1])),
    "derivative": _Function("derivative(x)", 1, 1, _derivative),
    "integral": _Function("integral(x)", 1, 1, _integral),
    "lowpass": _Function("lowpass(x, '20 Hz')", 2, 2, _low),
    "highpass": _Function("highpass(x, '0.5 Hz')", 2, 2, _high),
    "bandpass": _Function("bandpass(x, '0.5 Hz', '20 Hz')", 3, 3, _filtered),
    "smooth": _Function("smooth(x, '0.1 s')", 2, 2, _smooth),
    "delay": _Function("delay(x, '5 ms')", 2, 2, _delay),
    "detrend": _Function("detrend(x)", 1, 1, _detrend),
}
"""Functions of formulas by their names."""


def _gaps(code: str, where: str, lost: Any, time: Array, text: str) -> Finding:
    return finding(
        code,
        where,
        float(lost.size),
        text=text,
        lost=int(lost.size),
        count=int(time.size),
        first=float(time[lost[0]]),
    )


def _base(unit: str, *, where: str) -> BaseUnit:
    return in_base_units(unit, where=where)


def _powers(base: BaseUnit) -> Powers:
    return tuple(sorted(base.powers.items()))


def _multiplied(left: Powers, right: Powers, sign: float = 1.0) -> Powers:
    powers = dict(left)
    for name, power in right:
        powers[name] = round(powers.get(name, 0.0) + sign * power, 9)
    return tuple(sorted((name, power) for name, power in powers.items() if power))


def _fit(left: Powers, right: Powers) -> bool:
    """Whether units are alike; an angle is left out of products with others, but is no plain number itself."""
    plain = _without_angle(left)
    return left == right or (plain != _PLAIN and plain == _without_angle(right))


def _without_angle(powers: Powers) -> Powers:
    return tuple((name, power) for name, power in powers if name != "rad")


def _name_of(powers: Powers) -> str:
    """Write a unit: a usual one if it has a name, otherwise by base units."""
    for wanted in (powers, _without_angle(powers) or powers):  # an angle times a speed is a speed
        for unit in _USUAL:
            if wanted == _powers(in_base_units(unit)):
                return unit
    above = [_raised(name, power) for name, power in powers if power > 0.0]
    below = [_raised(name, -power) for name, power in powers if power < 0.0]
    return "/".join(["*".join(above) or "1", *below])


def _raised(name: str, power: float) -> str:
    return (
        name
        if power == 1.0
        else f"{name}^{power:g}"
        if power == int(power)
        else f"{name}^({power:g})"
    )


_USUAL = tuple(
    dict.fromkeys(
        [unit for unit, _ in QUANTITIES.values() if unit not in ("Hz", "J")]
        + ["N/m", "N*s/m", "N/s", "kg", "kg*m^2", "N/m^3", "rad/m", "1/m", "1/s"]
    )
)
"""Units that have a usual name; torque has that of N*m, not J."""
