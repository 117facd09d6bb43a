"""Computed channels: formulas over channels with their units, filters, derivatives and integrals."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any

import numpy as np

from jounce.analysis.formula_functions import FUNCTIONS, Timeline
from jounce.analysis.formula_text import name_in, parse_formula
from jounce.analysis.formula_units import (
    PLAIN,
    SECOND,
    Signal,
    alike,
    fit,
    multiplied,
    powers_of,
    unit_name,
)
from jounce.analysis.record import AnyRecord, read_measured
from jounce.core.errors import DescriptionError, RecordingError, nearest
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import in_base_units

_MOST_POWER = 12.0
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S.*?)?\s*")
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
    tree, quoted = parse_formula(formula)
    work = _Evaluation(channel, names, np.asarray(time, float), quoted, where)
    result = work.value(tree)
    si = unit_name(result.powers)
    values = np.broadcast_to(np.asarray(result.values, float), time.shape)
    if unit:
        base = in_base_units(unit, where="unit")
        if not result.is_zero and not fit(powers_of(base), result.powers):
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
        self.where, self.timeline = where, Timeline(time, where)
        self.used: set[str] = set()
        self.findings: list[Finding] = []

    def value(self, node: ast.AST) -> Signal:
        """Compute a part of the formula."""
        with np.errstate(all="ignore"):
            return self._value(node)

    def _value(self, node: ast.AST) -> Signal:
        if isinstance(node, ast.Constant):
            return self._constant(node)
        if isinstance(node, ast.Name | ast.Attribute) and (name := name_in(node, self.quoted)):
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
            return Signal(float(given), PLAIN, f"{given:g}", given == 0)
        if isinstance(given, str) and (match := _QUANTITY.fullmatch(given)):
            base = in_base_units(match[2] or "1", where=given)
            return Signal(float(match[1]) * base.factor + base.offset, powers_of(base), given)
        raise DescriptionError(
            "not a number with a unit",
            where="formula",
            found=str(given)[:80],
            allowed="'20 Hz', '1 g'",
        )

    def _channel(self, name: str) -> Signal:
        if name == "time":
            return Signal(self.time, SECOND, name)
        if name not in self.names:
            raise RecordingError(
                Phrase("no channel {name!r}", name=name),
                where=self.where,
                hint=nearest(name, self.names) or "Write a quantity in quotes, such as '20 Hz'.",
            )
        self.used.add(name)
        values, unit = self.channel(name)
        base = in_base_units(unit, where=f"{self.where}: {name}")
        return Signal(np.asarray(values, float) * base.factor + base.offset, powers_of(base), name)

    def _operation(self, node: ast.BinOp) -> Signal:
        left, right = self._value(node.left), self._value(node.right)
        text = ast.unparse(node)[:80]
        if isinstance(node.op, ast.Add | ast.Sub):
            left, right = alike(left, right, _SYMBOLS[type(node.op)])
            sign = 1.0 if isinstance(node.op, ast.Add) else -1.0
            return Signal(left.values + sign * right.values, left.powers, text)
        if isinstance(node.op, ast.Mult):
            return Signal(left.values * right.values, multiplied(left.powers, right.powers), text)
        if isinstance(node.op, ast.Div):
            return Signal(
                self._divided(left, right), multiplied(left.powers, right.powers, -1.0), text
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
            inverse = self._divided(Signal(1.0, PLAIN, "1"), left)
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
        left, right = alike(self._value(node.left), self._value(node.comparators[0]), symbol)
        compare = {"<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal}
        values = compare[symbol](left.values, right.values).astype(float)
        gaps = np.isnan(left.values) | np.isnan(right.values)
        return Signal(np.where(gaps, np.nan, values), PLAIN, ast.unparse(node)[:80])

    def _call(self, node: ast.Call) -> Signal:
        name = name_in(node.func, self.quoted)
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
        result = function.work(self.timeline, *given)
        return replace(result, text=ast.unparse(node)[:80], is_zero=False)


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
