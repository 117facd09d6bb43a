"""The command line: thin wrappers around the public functions. Each command returns a `Reply`; `main` prints it."""

from jounce.cli.entry import main

__all__ = ["main"]
