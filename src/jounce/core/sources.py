"""Digests of our own sources: what is kept on disk from one version is not taken for another's."""

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
        whole = root / package
        for file in sorted(whole.rglob("*.py")) if whole.is_dir() else [whole.with_suffix(".py")]:
            digest.update(f"{file.relative_to(root)}\n".encode() + file.read_bytes())
    return digest.hexdigest()


def edited_since(*packages: str) -> bool:
    """Whether modules of the packages are others than when this process first asked for their digest."""
    return digest_of.__wrapped__(*packages) != digest_of(*packages)
