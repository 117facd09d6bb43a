"""``python -m corpus files 300`` or ``python -m corpus commands``: run a part of the corpus and print its counts."""

from __future__ import annotations

import importlib
import sys

from corpus.judging import BAD, counted, judge, table

if __name__ == "__main__":
    part, *rest = (word for word in sys.argv[1:] if word != "-v")
    module = importlib.import_module(f"corpus.{part}")
    counts = [int(word) for word in rest if word.isdigit()]
    only = [word for word in rest if not word.isdigit()]
    asked = [case for case in module.cases(*counts) if not only or case[0] in only]
    found = []
    for case, verdict, said in judge(module.__name__, asked):
        found.append((case[0], verdict))
        if verdict in BAD or "-v" in sys.argv:
            print(case, verdict, " ".join(said.split())[:330], flush=True)
    print(table(counted(found), part))
