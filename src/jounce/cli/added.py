"""Commands of packages that depend on this one: each registers its command on import."""

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
