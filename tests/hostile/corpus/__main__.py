"""``python -m corpus``: run the corpus, or a part of it (``files 300 mat5 -v``), and print its counts.

``python -m corpus --page docs/explanation/robustness.md`` writes the counts of all parts to the end of the page;
``commands`` or another part behind it, of that part alone; and names of its rows, of these alone.
"""

from __future__ import annotations

import importlib
import sys
from collections import Counter
from pathlib import Path

from corpus.judging import BAD, counted, judge, table

PARTS = {"commands": [], "outputs": [], "descriptions": [120], "models": [2000], "files": [2000]}
"""Parts of the corpus, and how many cases there are of each file; of each reader, for mutations of bytes."""
TITLES = {
    "commands": "Commands: wrong values for each option and argument",
    "outputs": "Outputs: each file and folder, written to places of every kind",
    "descriptions": "Descriptions: wrong lines, checked and used",
    "models": "Models and roads of other programs: mutated bytes",
    "files": "Recordings: mutated bytes",
}
MARK = "<!-- python -m corpus --page writes the following -->"


def counts_of(
    part: str, numbers: list[int], only: list[str], *, verbose: bool
) -> dict[str, Counter[str]]:
    """Run a part; give its counts, and say each case that is bad."""
    module = importlib.import_module(f"corpus.{part}")
    found = []
    for case, verdict, said in judge(
        module.__name__, [c for c in module.cases(*numbers) if not only or c[0] in only]
    ):
        found.append((case[0], verdict))
        if verdict in BAD or verbose:
            print(case, verdict, " ".join(said.split())[:330], file=sys.stderr, flush=True)
    return counted(found)


def counts_in(text: str, part: str) -> dict[str, Counter[str]]:
    """The counts of a part on the page."""
    told = text.partition(f"### {TITLES[part]}\n")[2].partition("###")[0]
    rows = [line.strip("| ").split(" | ") for line in told.splitlines() if line.startswith("|")]
    return {
        name: Counter(
            {verdict: int(count) for verdict, count in zip(rows[0][2:], counts[1:], strict=True)}
        )
        for name, *counts in rows[2:-1]
    }


def page_with(text: str, tables: dict[str, str]) -> str:
    """The page with these tables at its end, in the place of those of the same parts."""
    above, _, below = text.partition(MARK)
    sections = dict(
        section.split("\n\n", 1)
        for section in below.strip().removeprefix("### ").split("\n\n### ")
        if section
    )
    sections |= {TITLES[part]: found for part, found in tables.items()}
    told = "\n\n".join(
        f"### {title}\n\n{sections[title].strip()}"
        for title in TITLES.values()
        if title in sections
    )
    return f"{above.rstrip()}\n\n{MARK}\n\n{told}\n"


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word not in ("-v", "--page")]
    given = [int(word) for word in words if word.isdigit()]
    page = Path(words.pop(0)) if "--page" in sys.argv else None
    parts, only = words[:1] or [*PARTS], [word for word in words[1:] if not word.isdigit()]
    for part in parts:
        found = counts_of(part, given or PARTS[part], only, verbose="-v" in sys.argv)
        if page is None:
            print(table(found, part))
            continue
        text = page.read_text(encoding="utf-8")
        rows = {**(counts_in(text, part) if only else {}), **found}
        order = dict.fromkeys(
            case[0] for case in importlib.import_module(f"corpus.{part}").cases(*PARTS[part])
        )
        made = table({name: rows[name] for name in order}, part)
        page.write_text(page_with(text, {part: made}), encoding="utf-8")
