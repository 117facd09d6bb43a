"""What building a wheel does first: machine code of the loops, for every platform (see ``jounce.kernel.loops``)."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class LoopsInWheel(BuildHookInterface[Any]):
    """Make the loops, but not for an editable wheel: `make loops` makes those of a checkout."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002 - the form of a hook
        """Run before the files of the wheel are collected."""
        if version == "editable":
            return
        before = os.environ.get("PYTHONPATH")  # where pip puts what builds need
        path = os.pathsep.join([str(Path(self.root) / "src"), *([before] if before else [])])
        environment = {**os.environ, "PYTHONPATH": path}
        command = [sys.executable, "-m", "jounce.kernel.loops.make", "--all-platforms"]
        subprocess.run(command, check=True, cwd=self.root, env=environment)
