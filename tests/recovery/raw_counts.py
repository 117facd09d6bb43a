"""Count how often campaigns made of raw laboratories' folders contain what is true.

    python tests/recovery/raw_counts.py FILE.json [FIRST LAST]    evaluate laboratories that are not in the file yet
    python tests/recovery/raw_counts.py FILE.json --show          print the table of what was counted

Each laboratory (see `raw_laboratory`) is written into a folder, taken in with nothing but its settings, and updated; an
interval covers where it holds the true value.
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
import raw_laboratory as laboratory

import jounce as jn
from jounce.campaign.from_folder import campaign_from_folder


def evaluated(seed: int) -> dict[str, Any]:
    """Take in one laboratory; give what was found of it."""
    lab = laboratory.drawn(seed)
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        laboratory.write(lab, place / "raw")
        laboratory.write_book(lab, place / "raw")
        begin = time.process_time()
        made = campaign_from_folder(place / "campaign", place / "raw")
        result = jn.run_campaign(made.campaign)
        seconds = time.process_time() - begin
    truth = laboratory.truths(lab)
    discrepancy = result.strategies[0].update.discrepancy if result.strategies else None
    parameters = {}
    for path, found in (discrepancy.parameters if discrepancy is not None else {}).items():
        parameters[path] = {
            "truth": truth[path], "interval": list(found.interval), "identified": bool(found.identified),
        }  # fmt: skip
    r2 = {
        str(trial.entry.number): min(channel.r2 for channel in trial.after.channels.values())
        for trial in result.trials
        if trial.after is not None
    }
    problems = [
        str(finding)
        for finding in [*made.findings, *result.findings]
        if finding.severity == "problem"
    ]
    return {"parameters": parameters, "r2": r2, "seconds": seconds, "problems": problems}


def table_of(counted: dict[str, Any]) -> str:
    """Say how often each parameter is covered, and how wide its interval is."""
    rows = list(counted.values())
    lines, inside, total = [f"{len(rows)} laboratories"], 0, 0
    for path in sorted({path for row in rows for path in row["parameters"]}):
        found = [row["parameters"][path] for row in rows if path in row["parameters"]]
        covers = [one["interval"][0] <= one["truth"] <= one["interval"][1] for one in found]
        known = sum(one["identified"] for one in found)
        out = sum(
            one["identified"] and not covers_ for one, covers_ in zip(found, covers, strict=True)
        )
        half = np.median(
            [0.5 * (one["interval"][1] - one["interval"][0]) / one["truth"] for one in found]
        )
        counts = f"{sum(covers):3} of {len(found)}, identified {known:3}, of these out {out}"
        lines.append(f"{path:36} {counts}, half-width {100.0 * half:.1f} %")
        inside, total = inside + sum(covers), total + len(found)
    lines.append(f"pooled {inside} of {total} = {100.0 * inside / max(total, 1):.1f} %")
    worst = min((min(row["r2"].values()) for row in rows if row["r2"]), default=float("nan"))
    seconds = np.mean([row["seconds"] for row in rows])
    lines.append(
        f"trials {sum(len(row['r2']) for row in rows)}, worst R2 {worst:.4f}; {seconds:.1f} CPU s"
    )
    lines += [
        f"{seed} {problem[:200]}" for seed, row in counted.items() for problem in row["problems"]
    ]
    return "\n".join(lines)


if __name__ == "__main__":
    file = Path(sys.argv[1])
    counted = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    if "--show" not in sys.argv:
        first, last = (int(text) for text in sys.argv[2:4]) if len(sys.argv) > 3 else (0, 50)
        for seed in range(first, last):
            if str(seed) not in counted:
                counted[str(seed)] = evaluated(seed)
                file.write_text(json.dumps(counted), encoding="utf-8")
    sys.stdout.write(f"{table_of(counted)}\n")
