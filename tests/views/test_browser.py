"""The page in a real browser: no error, no overflow, the numbers of the certificates."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from verify.paper.commands.report import NAMES

NAMES_OF_BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")
BROWSER = next(filter(None, map(shutil.which, NAMES_OF_BROWSERS)), None)
OPTIONS = (
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars "
    "--disable-background-networking --disable-component-update --disable-sync "
    "--disable-dev-shm-usage --remote-debugging-pipe"
)

pytestmark = pytest.mark.skipif(
    BROWSER is None, reason="no Chromium is installed, so no page is opened"
)

OVERFLOW = """
[...document.querySelectorAll('body *')]
  .filter(e => e.getBoundingClientRect().right > innerWidth + 1)
  .filter(e => !e.closest('.rows td, pre, .claim, .repair, svg'))
  .map(e => e.tagName + ' ' + e.textContent.slice(0, 40))
"""


class Browser:
    """A browser behind a pipe (descriptors 3 and 4), with one page."""

    def __init__(self, profile: Path) -> None:
        down, self._to = os.pipe()
        self._from, up = os.pipe()
        command = f'exec "$0" {OPTIONS} --user-data-dir="$1" about:blank 3<&{down} 4>&{up}'
        self._process = subprocess.Popen(
            ["/bin/bash", "-c", command, str(BROWSER), str(profile)],
            pass_fds=(down, up),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(down)
        os.close(up)
        self._rest = b""
        self._number = 0
        self._session: str | None = None
        self.events: list[dict[str, Any]] = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if self._session is not None:
            message["sessionId"] = self._session
        os.write(self._to, json.dumps(message).encode() + b"\0")
        while (answer := self._read()).get("id") != self._number:
            self.events.append(answer)
        assert "error" not in answer, answer
        result: dict[str, Any] = answer["result"]
        return result

    def _read(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            more = os.read(self._from, 1 << 20)
            assert more, "the browser has ended"
            self._rest += more
        text, self._rest = self._rest.split(b"\0", 1)
        message: dict[str, Any] = json.loads(text)
        return message

    def open(self, path: Path, width: int, scheme: str, mobile: bool) -> None:
        self.events.clear()
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=900,
                  deviceScaleFactor=1, mobile=mobile)  # fmt: skip
        feature = {"name": "prefers-color-scheme", "value": scheme}
        self.call("Emulation.setEmulatedMedia", features=[feature])
        self.call("Page.navigate", url=path.as_uri())
        while not self.happened("Page.loadEventFired"):
            self.events.append(self._read())

    def happened(self, *methods: str) -> list[dict[str, Any]]:
        return [event for event in self.events if event.get("method") in methods]

    def value(self, expression: str) -> Any:
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def close(self) -> None:
        self._session = None
        os.write(self._to, b'{"id": 0, "method": "Browser.close"}\0')
        try:
            self._process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        os.close(self._to)
        os.close(self._from)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    browser = Browser(tmp_path_factory.mktemp("profile"))
    yield browser
    browser.close()


@pytest.mark.parametrize(
    ("width", "mobile", "scheme"),
    [(390, True, "light"), (390, True, "dark"), (850, False, "light"), (1280, False, "dark")],
)
def test_no_error_no_request_no_overflow(
    browser: Browser, made: Path, width: int, mobile: bool, scheme: str
) -> None:
    for page in (made / "index.html", *sorted((made / "pages").glob("*.html"))):
        _is_fine(browser, page, width, scheme, mobile)


def test_the_first_page_has_three_screens_at_most(browser: Browser, made: Path) -> None:
    browser.open(made / "index.html", 1280, "light", mobile=False)
    assert browser.value("document.documentElement.scrollHeight") <= 3 * 900


def _is_fine(browser: Browser, page: Path, width: int, scheme: str, mobile: bool) -> None:
    browser.open(page, width, scheme, mobile)
    complaints = browser.happened(
        "Log.entryAdded", "Runtime.exceptionThrown", "Runtime.consoleAPICalled"
    )
    assert complaints == []
    requests = [
        e["params"]["request"]["url"] for e in browser.happened("Network.requestWillBeSent")
    ]
    assert [url for url in requests if not url.startswith(("file:", "data:"))] == []
    assert browser.value("document.compatMode") == "CSS1Compat"
    assert browser.value("document.documentElement.scrollWidth") == width
    assert browser.value(OVERFLOW) == []
    browser.value("document.querySelectorAll('details').forEach(e => e.open = true)")
    assert browser.value(OVERFLOW) == []
    assert browser.value("document.querySelectorAll('[tabindex]').length") == 0


def test_what_moves_can_be_held(browser: Browser, made: Path) -> None:
    browser.open(made / "pages/scenes.html", 1280, "light", mobile=False)
    states = "[...new Set(document.getAnimations().map(e => e.playState))].join()"
    assert browser.value(states) == "running"
    browser.value("document.querySelectorAll('.hold input').forEach(e => e.click())")
    assert browser.value(states) == "paused"
    reduced = {"name": "prefers-reduced-motion", "value": "reduce"}
    browser.call("Emulation.setEmulatedMedia", features=[reduced])
    assert browser.value("document.getAnimations().length") == 0
    browser.call("Emulation.setEmulatedMedia", media="print")
    assert browser.value("document.getAnimations().length") == 0
    browser.call("Emulation.setEmulatedMedia", media="")


def test_the_font_is_used(browser: Browser, made: Path) -> None:
    browser.open(made / "pages/printed.html", 1280, "light", mobile=False)
    assert browser.value("document.fonts.check('16px VerifyMath', '√')")
    assert browser.value("[...document.fonts].map(f => f.family + f.status)") == [
        "VerifyMathloaded"
    ]


def test_the_numbers_are_those_of_the_certificate(browser: Browser, made: Path) -> None:
    browser.open(made / "pages/constants.html", 1280, "light", mobile=False)
    shown = set(browser.value("[...document.querySelectorAll('data')].map(e => e.value)"))
    certificate = json.loads((made / "theorem1-r-3-100" / NAMES[1]).read_text(encoding="utf-8"))
    for name, found in certificate["enclosures"]["constants"].items():
        low, high = found["ends"]
        if name in ("r", "c", "V_0", "delta_theta"):
            continue
        assert (low if low == high else f"{low} {high}") in shown, name


def test_a_number_opens_to_both_ends(browser: Browser, made: Path) -> None:
    browser.open(made / "pages/constants.html", 390, "light", mobile=True)
    script = """
      const number = document.querySelector('#constants ~ .grid details.number');
      number.querySelector('summary').click();
      const code = number.querySelector('code').getBoundingClientRect();
      [number.open, code.width > 0, number.querySelector('code').textContent]
    """
    opened, visible, text = browser.value(f"(() => {{ {_returning(script)} }})()")
    assert opened
    assert visible
    assert text.startswith("[0.")


def _returning(script: str) -> str:
    head, _, last = script.strip().rpartition("\n")
    return f"{head}\nreturn {last.strip()};"


def test_formulas_are_typeset(browser: Browser, made: Path) -> None:
    browser.open(made / "pages/printed.html", 1280, "light", mobile=False)
    heights = browser.value(
        "[...document.querySelectorAll('article mfrac')].map(e => e.getBoundingClientRect().height)"
    )
    assert len(heights) > 20
    assert min(heights) > 8


def test_labels_are_readable_in_the_dark(browser: Browser, made: Path) -> None:
    for scheme, dark in (("light", False), ("dark", True)):
        browser.open(made / "index.html", 1280, scheme, mobile=False)
        channels = browser.value(
            "[getComputedStyle(document.body).backgroundColor, "
            "...[...document.querySelectorAll('svg text')].slice(0, 9)"
            ".map(e => getComputedStyle(e).fill)].map(c => +c.match(/[0-9]+/)[0])"
        )
        background, *letters = channels
        assert (background < 60) == dark
        assert all(abs(letter - background) > 100 for letter in letters)
