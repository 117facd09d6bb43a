"""Mutations of the bytes of a good file, each made again by its number."""

from __future__ import annotations

import numpy as np

SEED = 16180
"""Seed of what is chosen and changed, in all parts. A fresh one finds what was mended for the others only."""
KINDS = ("flip", "cut", "insert", "repeat", "remove", "zero", "ones", "number")
STRUCTURAL = ("cut", "insert", "repeat", "remove")
"""What changes the length: a reader can know it. Another number in the place of one it cannot."""
_NUMBERS = (0, 1, 127, 128, 255, 32767, 65535, 2**31 - 1, 2**31, 2**32 - 1, 2**63 - 1, 2**64 - 1)


def mutated(content: bytes, seed: int, number: int) -> tuple[str, bytes]:
    """Kind of the mutation of that number, and what it makes of a file."""
    random = np.random.default_rng([seed, number])
    kind = KINDS[number % len(KINDS)]
    head = random.random() < 0.5  # half of them near the begin, where formats say what follows
    most = min(len(content), 600) if head else len(content)
    at = int(random.integers(most))
    length = int(min(2 ** random.uniform(0.0, 9.0), len(content) - at))
    if kind == "flip":
        made = bytearray(content)
        for place in random.integers(most, size=int(random.integers(1, 5))):
            made[place] ^= 1 << int(random.integers(8))
        return kind, bytes(made)
    if kind == "cut":
        return kind, content[: int(random.integers(len(content)))]
    if kind == "insert":
        return kind, content[:at] + random.bytes(length) + content[at:]
    if kind == "repeat":
        return kind, content[:at] + content[at : at + length] * int(
            random.integers(2, 5)
        ) + content[at + length :]
    if kind == "remove":
        return kind, content[:at] + content[at + length :]
    if kind == "number":
        width = int(random.choice([1, 2, 4, 8]))
        size = _NUMBERS[int(random.integers(len(_NUMBERS)))] % 256**width
        return kind, content[:at] + size.to_bytes(width, "little") + content[at + width :]
    return kind, content[:at] + (b"\0" if kind == "zero" else b"\xff") * length + content[
        at + length :
    ]
