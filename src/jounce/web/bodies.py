"""Requests with strict JSON bodies, tolerant of clients that disconnect early."""

from __future__ import annotations

import json
from collections.abc import Callable, Coroutine
from typing import Any

from jounce.core.optional import require
from jounce.web.untrusted import plain_json

require("fastapi", "web")  # ruff: isort: split
from fastapi import Request, Response  # noqa: E402
from fastapi.routing import APIRoute  # noqa: E402

_GONE = 499  # status that servers log if the client closed the connection


class PlainRequest(Request):
    """A request with a strict JSON body: finite numbers, writable text, and little nesting."""

    async def json(self) -> Any:
        """Read the body."""
        try:
            return plain_json(await self.body())
        except ValueError as error:
            raise json.JSONDecodeError(str(error), "", 0) from None


class Route(APIRoute):
    """A route that receives such requests."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Return what answers requests, given their plain bodies."""
        handler = super().get_route_handler()

        async def answer(request: Request) -> Response:
            plain = PlainRequest(request.scope, request.receive)
            try:
                return await handler(plain)
            except Exception:
                if await plain.is_disconnected():
                    return Response(status_code=_GONE)
                raise

        return answer
