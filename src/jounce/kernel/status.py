"""Outcomes of a run: every one is data with a text that helps."""

from __future__ import annotations

from enum import Enum


class Status(Enum):
    """How a run ended; ``help`` says what that means for the user."""

    COMPLETED = (0, "the run reached its end")
    NOT_FINITE = (1, "the solution is no longer a finite number: the model is unstable or an input is extreme")
    STEP_TOO_SMALL = (2, "the step fell below what time can resolve: the model is too stiff or jumps without a switch")
    TOO_MANY_STEPS = (
        3,
        "the step budget is used up: shorten the run, loosen the tolerance or soften the stiffest part",
    )
    CHATTER = (4, "contact switches on and off without time passing: add tyre damping or soften the law")
    LOOP_OPENED = (5, "the loops of the mechanism cannot be closed any more: it has reached the end of its travel")
    LOCKED_UP = (
        6,
        "the mechanism is in a singular configuration: its joints do not determine how it moves on (lock-up or flip)",
    )
    FLIPPED = (
        7,
        "the suspension passed a singular configuration and the wheel flipped over: an obstacle is too high, "
        "stops are too soft",
    )
    DIVERGED = (
        8,
        "the closed loop diverges: smaller gains, a faster actuator or a higher control rate may hold it",
    )
    NO_COMMAND = (9, "the controller gave no finite command")
    RUN_AWAY = (
        10,
        "a strut deflects beyond 10 m or the body turns over: the model is unstable (see its modes) or loads extreme",
    )

    def __init__(self, code: int, text: str) -> None:
        self.code, self.help = code, text

    @classmethod
    def of(cls, code: int) -> Status:
        """Give the status of a loop's return code."""
        return next(status for status in cls if status.code == code)
