"""Hold the pinned packages against known vulnerabilities: ``python requirements/audit.py [PYTHON]``.

``PYTHON`` is an interpreter that has pip-audit. What its service knows of is asked there. Where it cannot be asked (no
network, no pip-audit, packages that the service does not have) only the list of ``advisories.toml`` counts, and that is
said. The exit code is 1 for a known vulnerability, and never because the network is closed.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).parent
_PIN = re.compile(r"^([A-Za-z0-9_.-]+)==([^\s;\\]+)", re.MULTILINE)
_LONGEST = 300  # s


@dataclass(frozen=True)
class Answer:
    """What a service said of one file of pins: vulnerabilities, packages it knows, packages it does not know."""

    found: tuple[str, ...] = ()
    known: int = 0
    unknown: int = 0
    silent: str = ""  # why it did not answer


def pins(text: str) -> dict[str, str]:
    """Give version by package of a list of pins."""
    return {name.lower().replace("_", "-"): version for name, version in _PIN.findall(text)}


def is_before(version: str, other: str) -> bool:
    """Whether a version comes before another one, by its numbers; a version without numbers comes before all."""
    one, two = (
        [int(part) for part in re.findall(r"\d+", text.partition("+")[0])]
        for text in (version, other)
    )
    longest = max(len(one), len(two))
    return one + [0] * (longest - len(one)) < two + [0] * (longest - len(two))


def listed(pinned: dict[str, str], advisories: list[dict[str, str]]) -> list[str]:
    """Vulnerabilities of the list that pinned versions have."""
    return [
        f"{one['package']} {pinned[one['package']]}: {one['id']}, {one['what']}; mended in {one['mended_in']}"
        for one in advisories
        if one["package"] in pinned and is_before(pinned[one["package"]], one["mended_in"])
    ]


def asked(python: str, file: Path) -> Answer:
    """Ask pip-audit's service about one file of pins."""
    command = [
        python,
        "-m",
        "pip_audit",
        "--progress-spinner",
        "off",
        "--timeout",
        "15",
        "--format",
        "json",
    ]
    command += ["--disable-pip", "--require-hashes", "--requirement", str(file)]
    try:
        ran = subprocess.run(command, capture_output=True, text=True, timeout=_LONGEST, check=False)
        return answered(json.loads(ran.stdout))
    except OSError as error:
        return Answer(silent=str(error.strerror))
    except subprocess.TimeoutExpired:
        return Answer(silent=f"no answer within {_LONGEST} s")
    except ValueError:  # no JSON: pip-audit is not there, or could not ask
        return Answer(silent=(ran.stderr.strip().splitlines() or ["no answer"])[-1][:200])


def answered(report: dict[str, list[dict[str, object]]]) -> Answer:
    """What pip-audit's report says; a package that was skipped is one that nothing is known of."""
    rows = report["dependencies"]
    skipped = sum("skip_reason" in row for row in rows)
    found = []
    for row in rows:
        vulnerabilities = row.get("vulns")
        for one in vulnerabilities if isinstance(vulnerabilities, list) else ():
            mended = ", ".join(one.get("fix_versions", ())) or "no version yet"
            found.append(f"{row['name']} {row['version']}: {one['id']}; mended in {mended}")
    return Answer(tuple(found), len(rows) - skipped, skipped)


def main(python: str | None = None, folder: Path = HERE) -> int:
    """Audit all lists of pins; give the exit code."""
    files = sorted(folder.glob("*.txt"))
    content = tomllib.loads((folder / "advisories.toml").read_text(encoding="utf-8"))
    found: set[str] = set()
    for file in files:
        found.update(listed(pins(file.read_text(encoding="utf-8")), content["advisory"]))
    count = len({pin for file in files for pin in pins(file.read_text(encoding="utf-8")).items()})
    answers = {
        file.name: asked(python, file) if python else Answer(silent="pip-audit was not given")
        for file in files
    }
    for name, answer in answers.items():
        found.update(answer.found)
        if answer.silent:
            print(f"{name}: offline ({answer.silent})")
        elif answer.unknown:
            print(
                f"{name}: {answer.known} packages are known to the service, {answer.unknown} are not"
            )
    if not any(answer.known for answer in answers.values()):
        advisories = f"{len(content['advisory'])} advisories of {content['as_of']}"
        print(
            f"OFFLINE: no service could be asked; {count} pins were held against a list of {advisories} only."
        )
    for one in sorted(found):
        print(f"vulnerable: {one}")
    print(f"{len(found)} known vulnerabilities" if found else "no known vulnerability")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:2]))
