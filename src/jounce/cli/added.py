"""Commands of packages that stand above: each adds its own when it is imported."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from jounce.cli.reply import Reply

Command = TypeVar("Command", bound=Callable[..., Reply])
ADDED: dict[str, Callable[..., Reply]] = {}


def add_command(command: Command) -> Command:
    """Add a command by the name of its function."""
    ADDED[command.__name__] = command
    return command
