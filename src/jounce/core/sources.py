"""Digests of jounce's sources, so that files cached by one version are not used by another."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path


@cache
def digest_of(*packages: str) -> str:
    """Digest of all modules of some of the packages, which may also be single modules (``"kernel/engine"``).

    >>> len(digest_of("core")), digest_of("core") == digest_of("kernel")
    (64, False)
    """
    digest, root = hashlib.sha256(), Path(__file__).parent.parent
    for package in packages:
        folder = root / package
        for file in (
            sorted(folder.rglob("*.py")) if folder.is_dir() else [folder.with_suffix(".py")]
        ):
            digest.update(f"{file.relative_to(root)}\n".encode() + file.read_bytes())
    return digest.hexdigest()


def edited_since(*packages: str) -> bool:
    """Whether modules of the packages have changed since this process first computed their digest."""
    return digest_of.__wrapped__(*packages) != digest_of(*packages)
