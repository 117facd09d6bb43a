"""Three browsers without WebGL, whose language is no language tag; each is used by the same few words."""

from __future__ import annotations

import itertools
import json
import os
import shutil
import socket
import subprocess
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Any, ClassVar

Place = tuple[float, float]
LANGUAGE = "C"


class Engine:
    """A browser with one page, open until ``stack`` is left; ``troubles`` are errors and warnings of the page."""

    package: ClassVar[str]
    """What Debian calls it."""

    def __init__(self, stack: ExitStack) -> None:
        self._stack = stack
        self.troubles: list[str] = []

    def _start(self, *words: str, **how: Any) -> subprocess.Popen[str]:
        process = self._stack.enter_context(subprocess.Popen(words, text=True, **how))
        self._stack.callback(process.terminate)
        return process

    @classmethod
    def is_installed(cls) -> bool:
        raise NotImplementedError

    def go(self, address: str) -> None:
        raise NotImplementedError

    def evaluate(self, expression: str) -> Any:
        """Give the value of an expression, or of its promise."""
        raise NotImplementedError

    def drag(self, start: Place, end: Place) -> None:
        """Move the mouse from here to there with its button down; px in the window."""
        raise NotImplementedError

    def resize(self, width: int, height: int) -> None:
        raise NotImplementedError

    def until(self, expression: str, seconds: float = 60.0) -> None:
        end = time.monotonic() + seconds
        while not self.evaluate(expression):
            assert time.monotonic() < end, f"{expression}; {self.troubles}"
            time.sleep(0.05)


def _plain(expression: str) -> str:
    return f"(async () => JSON.stringify(await ({expression})) ?? 'null')()"


class Chromium(Engine):
    package = "chromium"

    def __init__(self, stack: ExitStack, _: Path) -> None:
        from playwright.sync_api import sync_playwright

        super().__init__(stack)
        playwright = stack.enter_context(sync_playwright())
        words = ["--no-sandbox", "--disable-3d-apis"]
        browser = playwright.chromium.launch(executable_path=self._program(), args=words)
        stack.callback(browser.close)
        self._page = browser.new_page()
        said = (
            f"Object.defineProperty(Navigator.prototype, 'language', {{get: () => '{LANGUAGE}'}})"
        )
        self._page.add_init_script(said)
        self._page.on("console", self._hear)
        self._page.on("pageerror", lambda error: self.troubles.append(str(error)))

    def _hear(self, told: Any) -> None:
        if (
            told.type in ("error", "warning") and "readback" not in told.text
        ):  # which is of these tests
            self.troubles.append(told.text)

    @staticmethod
    def _program() -> str | None:
        return shutil.which("chromium") or shutil.which("google-chrome")

    @classmethod
    def is_installed(cls) -> bool:
        return cls._program() is not None

    def go(self, address: str) -> None:
        self._page.goto(address)

    def evaluate(self, expression: str) -> Any:
        return json.loads(self._page.evaluate(_plain(expression)))

    def drag(self, start: Place, end: Place) -> None:
        self._page.mouse.move(*start)
        self._page.mouse.down()
        self._page.mouse.move(*end, steps=4)
        self._page.mouse.up()

    def resize(self, width: int, height: int) -> None:
        self._page.set_viewport_size({"width": width, "height": height})


def _free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def _as_soon_as_it_runs(ask: Callable[[], Any]) -> Any:
    end = time.monotonic() + 60.0
    while True:
        try:
            return ask()
        except OSError:
            if time.monotonic() > end:
                raise
            time.sleep(0.1)


def _moves(start: Place, end: Place) -> list[dict[str, Any]]:
    """Give a drag as WebDriver takes it."""
    there, on = (
        {"type": "pointerMove", "x": round(x), "y": round(y), "duration": 50}
        for x, y in (start, end)
    )
    steps = [there, {"type": "pointerDown", "button": 0}, on, {"type": "pointerUp", "button": 0}]
    return [
        {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": steps}
    ]


class Firefox(Engine):
    """By WebDriver BiDi, which it speaks itself."""

    package = "firefox-esr"

    def __init__(self, stack: ExitStack, folder: Path) -> None:
        from websockets.sync.client import connect

        super().__init__(stack)
        settings = f'user_pref("intl.accept_languages", "{LANGUAGE}");\nuser_pref("webgl.disabled", true);\n'
        (folder / "user.js").write_text(settings, encoding="utf-8")
        port = _free_port()
        words = [
            "--headless",
            f"--remote-debugging-port={port}",
            "--no-remote",
            "--profile",
            str(folder),
        ]
        self._start(
            self._program() or "", *words, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL
        )
        plain = _as_soon_as_it_runs(lambda: socket.create_connection(("127.0.0.1", port)))
        self._socket = stack.enter_context(
            connect(f"ws://127.0.0.1:{port}/session", sock=plain, max_size=None)
        )
        self._numbers = itertools.count(1)
        self._ask("session.new", capabilities={})
        self._ask("session.subscribe", events=["log.entryAdded"])
        self._page = {"context": self._ask("browsingContext.getTree")["contexts"][0]["context"]}

    @staticmethod
    def _program() -> str | None:
        return shutil.which("firefox-esr") or shutil.which("firefox")

    @classmethod
    def is_installed(cls) -> bool:
        return cls._program() is not None

    def _ask(self, method: str, **values: Any) -> Any:
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": values}))
        while True:
            answer = json.loads(self._socket.recv(timeout=120))
            if answer.get("method") == "log.entryAdded" and answer["params"]["level"] in (
                "error",
                "warn",
            ):
                self.troubles.append(answer["params"]["text"])
            if answer.get("id") == number:
                assert answer["type"] == "success", answer
                return answer["result"]

    def go(self, address: str) -> None:
        self._ask("browsingContext.navigate", **self._page, url=address, wait="complete")

    def evaluate(self, expression: str) -> Any:
        answer = self._ask(
            "script.evaluate", expression=_plain(expression), target=self._page, awaitPromise=True
        )
        assert answer["type"] == "success", answer
        return json.loads(answer["result"]["value"])

    def drag(self, start: Place, end: Place) -> None:
        self._ask("input.performActions", **self._page, actions=_moves(start, end))

    def resize(self, width: int, height: int) -> None:
        self._ask(
            "browsingContext.setViewport", **self._page, viewport={"width": width, "height": height}
        )


HEAR = """(() => {
  if (window.heard) return;
  window.heard = [];
  addEventListener("error", (event) => heard.push(event.message));
  addEventListener("unhandledrejection", (event) => heard.push(String(event.reason)));
  for (const level of ["error", "warn"]) console[level] = (...words) => heard.push(words.join(" "));
})()"""


class WebKit(Engine):
    """The engine of Safari, by WebDriver, on a screen that nobody sees."""

    package = "webkit2gtk-driver and xvfb"

    def __init__(self, stack: ExitStack, folder: Path) -> None:
        super().__init__(stack)
        words = ["-displayfd", "1", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"]
        screen = self._start("Xvfb", *words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        assert screen.stdout is not None
        display = f":{screen.stdout.readline().strip()}"
        port = _free_port()
        here = {**os.environ, "DISPLAY": display, "GDK_BACKEND": "x11", "HOME": str(folder)}
        here |= {"LC_ALL": f"{LANGUAGE}.UTF-8", "LANGUAGE": ""}
        self._start("WebKitWebDriver", f"--port={port}", env=here, stderr=subprocess.DEVNULL)
        self._base = f"http://127.0.0.1:{port}"
        options = {"binary": str(self._program()), "args": ["--automation"]}
        wanted = {"capabilities": {"alwaysMatch": {"webkitgtk:browserOptions": options}}}
        session = _as_soon_as_it_runs(lambda: self._ask("POST", "/session", wanted))["sessionId"]
        self._base += f"/session/{session}"
        stack.callback(self._ask, "DELETE", "")

    @staticmethod
    def _program() -> Path | None:
        return next(iter(Path("/usr").glob("lib*/**/webkit2gtk-4*/MiniBrowser")), None)

    @classmethod
    def is_installed(cls) -> bool:
        return all(map(shutil.which, ("WebKitWebDriver", "Xvfb"))) and cls._program() is not None

    def _ask(self, method: str, path: str, body: Any = None) -> Any:
        data = None if body is None else json.dumps(body).encode()
        asked = urllib.request.Request(
            self._base + path, data, {"Content-Type": "application/json"}, method=method
        )
        direct = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with direct.open(asked, timeout=120) as answer:
                return json.loads(answer.read())["value"]
        except urllib.error.HTTPError as error:
            raise AssertionError(error.read().decode()) from error

    def go(self, address: str) -> None:
        self._ask("POST", "/url", {"url": address})
        self.evaluate(HEAR)

    def evaluate(self, expression: str) -> Any:
        said = "(value) => arguments[0]([value, (window.heard ?? []).splice(0)])"
        script = (
            f"{_plain(expression)}.then({said}, (error) => arguments[0](['', [String(error)]]))"
        )
        value, troubles = self._ask("POST", "/execute/async", {"script": script, "args": []})
        self.troubles += troubles
        assert value, troubles
        return json.loads(value)

    def drag(self, start: Place, end: Place) -> None:
        self._ask("POST", "/actions", {"actions": _moves(start, end)})

    def resize(self, width: int, height: int) -> None:
        self._ask("POST", "/window/rect", {"width": width, "height": height})
