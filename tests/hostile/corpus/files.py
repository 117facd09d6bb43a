"""Mutations of recordings of every format: read, they are refused, flagged or right."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from corpus import recordings
from corpus.judging import is_clear
from corpus.mutations import SEED, STRUCTURAL, mutated

FEW = 3  # numbers in text that bytes put between them may change
TIME = 3.0
"""Seconds of computing after which reading is taken to be endless: whole files of this size take some hundredths."""


def cases(count: int, seed: int = SEED) -> list[tuple[str, int, int]]:
    """Sample, number and seed of so many mutations of the files of each reader, which its samples share."""
    kinds = Counter(map(recordings.reader_of, recordings.names()))
    return [
        (name, number, seed)
        for name in recordings.names()
        for number in range(-(-count // kinds[recordings.reader_of(name)]))
    ]


def verdict(case: tuple[str, int, int]) -> tuple[str, str]:
    """What reading one mutation gives."""
    from jounce.core.errors import JounceError
    from jounce.recordings import isolated, read_recording

    isolated.TIME = TIME
    name, number, seed = case
    sample = recordings.sample(name)
    kind, content = mutated(sample.content, seed, number)
    file = Path(sample.name)
    file.write_bytes(content)
    try:
        data, findings = read_recording(file, **sample.told)
    except JounceError as error:
        return ("refused" if is_clear(str(error), sample.name) else "unclear"), f"{kind}: {error}"
    except Exception as error:  # noqa: BLE001 - whatever it is, it is a crash
        return "crashed", f"{kind}: {type(error).__name__}: {error}"
    return compared(data, findings, sample, kind)


def compared(data: Any, findings: Any, sample: recordings.Sample, kind: str) -> tuple[str, str]:
    """Whether what was read is what was recorded."""
    said = "; ".join(
        str(finding)
        for finding in findings
        if not str(finding.message).startswith("decimal commas")
    )
    if data.sizes["time"] != recordings.ROWS or set(data.data_vars) != set(recordings.TRUTH):
        if not sample.states_length and kind in STRUCTURAL:
            return "undetectable", kind
        may_be_named_so = sample.reader in ("csv", "lvm", "vbo") or (
            kind not in STRUCTURAL and not sample.has_checksums
        )
        if may_be_named_so and not said and _is_part_of_the_text(data):
            return "undetectable", kind
        found = f"{kind}: {data.sizes['time']} samples of {', '.join(map(str, data.data_vars))}"
        return ("flagged" if said else "silently wrong"), f"{found}; {said}"
    pairs = [(data["time"].to_numpy(), recordings.TIME)]
    pairs += [(data[channel].to_numpy(), truth) for channel, truth in recordings.TRUTH.items()]
    off = [
        int(np.sum(np.abs(got - truth) > sample.rounding * np.abs(truth).max()))
        for got, truth in pairs
    ]
    if not any(off):
        return "right", said
    if said:
        return "flagged", f"{kind}: {off} numbers differ; {said}"
    hidden = not sample.has_checksums and (
        kind not in STRUCTURAL or max(off) <= FEW or not sample.states_length
    )
    return ("undetectable" if hidden else "silently wrong"), f"{kind}: {off} numbers differ"


def _is_part_of_the_text(data: Any) -> bool:
    """Whether it is what another file would say: a text does not tell how many rows it has, nor what its names were."""
    rows, begin = data.sizes["time"], round(float(data["time"][0]) / recordings.TIME[1])
    found = [one.to_numpy() for one in (data["time"], *data.data_vars.values())]
    wanted = [one[begin : begin + rows] for one in (recordings.TIME, *recordings.TRUTH.values())]
    return len(found) == len(wanted) and all(
        any(
            one.shape == truth.shape
            and np.sum(np.abs(one - truth) > 1e-9 * np.abs(truth).max()) <= FEW
            for one in found
        )
        for truth in wanted
    )
