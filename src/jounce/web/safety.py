"""Access control: accept only requests from this machine that come from the opened page or carry the printed token.

A foreign page open in the same browser can send requests to this server. It cannot set their ``Host`` and ``Origin``
headers, and it does not have the token, which the opened page stores and sends in a header. Cookies are not used,
because browsers would send them to every server of this machine, regardless of port. A report in a frame
or tab, which a browser opens without headers, has a signed address that gives access to this report only.
"""

from __future__ import annotations

import hmac
import secrets
from collections.abc import Mapping
from typing import Any
from urllib.parse import parse_qs

from jounce.web.assets import assets

_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; "
    "connect-src 'self'; frame-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
)
HEADERS = {
    "Content-Security-Policy": _POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
_LARGEST = 4_000_000  # maximum bytes of a request
UPLOAD, _LARGEST_UPLOAD = "/api/upload", 250_000_000
EXPORT, _LARGEST_EXPORT = (
    "/api/export",
    100_000_000,
)  # enough for the numbers of all curves of a page


PROTOCOL = "jounce"
"""Protocol that the page's socket offers, followed by the token, because browsers allow no custom headers there."""


def seal_address(token: str, address: str) -> str:
    """Return an address (path and query) that is accepted without the token; it cannot be forged."""
    key = hmac.new(token.encode(), address.encode(), "sha256").hexdigest()
    return f"{address}{'&' if '?' in address else '?'}key={key}"


class Guard:
    """ASGI middleware: admits requests by the rules above and adds a security policy to every response."""

    def __init__(self, app: Any, *, token: str, port: int) -> None:
        self.app, self.token, self.port = app, token, port
        names = ("127.0.0.1", "localhost")
        self.hosts = {f"{name}:{port}" for name in names} | (set(names) if port == 80 else set())
        self.origins = {f"http://{host}" for host in self.hosts}

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        """Reject forbidden requests and pass on all others."""
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = {
            name.decode("latin-1").lower(): value.decode("latin-1")
            for name, value in scope["headers"]
        }
        problem = self._problem(scope, headers)
        if problem is not None:
            await self._refuse(scope, send, *problem)
        else:
            await self.app(scope, receive, _with_headers(send))

    def _problem(
        self, scope: Mapping[str, Any], headers: Mapping[str, str]
    ) -> tuple[int, str] | None:
        if headers.get("host", "").lower() not in self.hosts:
            return 403, "This workbench accepts requests only at its own address."
        if headers.get("origin", "").lower() not in self.origins | {""}:
            return 403, "Requests from pages of other origins are not allowed."
        length = headers.get("content-length", "0").strip()
        if not length.isdecimal() or not length.isascii():
            return 400, "The content length is not a number."
        most = {UPLOAD: _LARGEST_UPLOAD, EXPORT: _LARGEST_EXPORT}.get(scope["path"], _LARGEST)
        if int(length[:20]) > most or "transfer-encoding" in headers:
            return 413, f"A request has {most} bytes at most, and says how many."
        if scope["path"] == "/" and scope["query_string"]:
            given = parse_qs(scope["query_string"].decode("latin-1")).get("token", [""])[0]
            return (
                None
                if self._is_token(given)
                else (401, "This address is not the one that was printed.")
            )
        if scope["path"] in assets() or self._is_known(headers) or self._is_sealed(scope):
            return None
        return (
            401,
            "The token is missing: open the address that `jounce serve` printed, or send it as a bearer.",
        )

    def _is_known(self, headers: Mapping[str, str]) -> bool:
        scheme, _, given = headers.get("authorization", "").partition(" ")
        if scheme.lower() == "bearer":
            return self._is_token(given.strip())
        offered = [
            protocol.strip() for protocol in headers.get("sec-websocket-protocol", "").split(",")
        ]
        return len(offered) == 2 and offered[0] == PROTOCOL and self._is_token(offered[1])

    def _is_sealed(self, scope: Mapping[str, Any]) -> bool:
        if scope.get("method") != "GET":
            return False
        asked = b"?".join(
            (scope.get("raw_path") or scope["path"].encode(), scope["query_string"])
        ).decode("latin-1")
        address, _, _ = asked.rpartition("key=")
        return secrets.compare_digest(
            asked.encode(), seal_address(self.token, address[:-1]).encode()
        )

    def _is_token(self, given: str) -> bool:
        return secrets.compare_digest(given.encode(), self.token.encode())

    async def _refuse(self, scope: Mapping[str, Any], send: Any, status: int, what: str) -> None:
        if scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008, "reason": what})
            return
        await _answer(send, status, what.encode(), {"Content-Type": "text/plain; charset=utf-8"})


async def _answer(send: Any, status: int, body: bytes, headers: Mapping[str, str]) -> None:
    every = [(name.encode(), value.encode()) for name, value in {**HEADERS, **headers}.items()]
    every.append((b"Content-Length", str(len(body)).encode()))
    await send({"type": "http.response.start", "status": status, "headers": every})
    await send({"type": "http.response.body", "body": body})


def _with_headers(send: Any) -> Any:
    async def sending(message: Any) -> None:
        if message["type"] == "http.response.start":
            own = list(message.get("headers", []))  # a report has a stricter policy
            said = {name.lower() for name, _ in own}
            every = ((name.encode(), value.encode()) for name, value in HEADERS.items())
            message["headers"] = [
                *own,
                *(header for header in every if header[0].lower() not in said),
            ]
        await send(message)

    return sending
