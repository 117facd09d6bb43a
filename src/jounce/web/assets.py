"""Files of the page itself, which contain no user data: each read and compressed once.

The build puts the digest of a script or style sheet into its name, so that browsers keep it and never ask again.
"""

from __future__ import annotations

import gzip
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import resources

_KINDS = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
}
_HAS_DIGEST = re.compile(r"-[0-9A-Z]{8}\.\w+")
_KEPT = {"Cache-Control": "private, max-age=31536000, immutable"}


@dataclass(frozen=True)
class Asset:
    """A file of the page."""

    name: str
    content: bytes

    @cached_property
    def compressed(self) -> bytes:
        """Return the content as gzip."""
        return gzip.compress(self.content, 9, mtime=0)

    def response(self, accepted: str) -> tuple[bytes, dict[str, str]]:
        """Return body and headers of a response, compressed if the ``Accept-Encoding`` allows gzip."""
        headers = {
            "Content-Type": _KINDS[self.name[self.name.rindex(".") :]],
            "Vary": "Accept-Encoding",
        }
        if _HAS_DIGEST.search(self.name):
            headers |= _KEPT
        if not _allows_gzip(accepted) or len(self.compressed) >= len(self.content):
            return self.content, headers
        return self.compressed, headers | {"Content-Encoding": "gzip"}


@cache
def assets() -> Mapping[str, Asset]:
    """Return the files of the page by their address."""
    folder = resources.files("jounce.web").joinpath("static")
    files = [file for file in folder.iterdir() if file.name[file.name.rfind(".") :] in _KINDS]
    return {
        "/" if file.name == "index.html" else f"/{file.name}": Asset(file.name, file.read_bytes())
        for file in files
    }


def _allows_gzip(accepted: str) -> bool:
    """Whether an ``Accept-Encoding`` allows gzip.

    >>> _allows_gzip("br, gzip;q=0.5"), _allows_gzip("gzip;q=0"), _allows_gzip("")
    (True, False, False)
    """
    for choice in accepted.lower().split(","):
        name, _, weight = choice.partition(";")
        if name.strip() == "gzip":
            return not re.fullmatch(r"\s*q\s*=\s*0(\.0*)?\s*", weight)
    return False
