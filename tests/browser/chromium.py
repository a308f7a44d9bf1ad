# SPDX-License-Identifier: BSD-3-Clause
"""Chromium without a window, driven through chromedriver by the WebDriver protocol (W3C) over HTTP."""
import base64
import json
import pathlib
import queue
import re
import shutil
import subprocess
import threading
import time
import urllib.error
import urllib.request

PATIENCE = 60  # s that a state may take to appear: a wait ends when it is there, so a slow machine only needs longer
START = ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--no-first-run", "--disable-quic", "--disable-dev-shm-usage",
         "--disable-extensions", "--disable-default-apps", "--force-color-profile=srgb", "--font-render-hinting=none",
         "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"]  # what a page asks for is seen, and goes nowhere
KEYS = {"Tab": "\ue004", "Control": "\ue009", "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012",
        "ArrowRight": "\ue014"}


class BrowserError(Exception):
    """A command of the browser failed, or a state did not come; a sentence."""


def programs():
    """Chromium and its driver, or None where one of them is not installed."""
    found = shutil.which("chromium") or shutil.which("chromium-browser"), shutil.which("chromedriver")
    return found if all(found) else None


class Chromium:
    """One browser with one tab. All logs are kept: `requests` and `console` give what has come since they were last asked."""

    def __init__(self, profile):
        binary, driver = programs()
        self.process = subprocess.Popen([driver, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.session = None
        try:
            self.base = f"http://127.0.0.1:{self.port()}"
            options = {"binary": binary, "args": [*START, f"--user-data-dir={profile}", "about:blank"],
                       "perfLoggingPrefs": {"enableNetwork": True, "enablePage": False}}
            made = self.send("POST", "/session", {"capabilities": {"alwaysMatch": {
                "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
                "timeouts": {"script": 1000 * PATIENCE, "pageLoad": 1000 * PATIENCE}}}})
            self.session = f"/session/{made['sessionId']}"
            self.post("/url", {"url": "about:blank"})
            self.requests()  # of the browser's own start page
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        if self.session:
            try:
                self.send("DELETE", self.session)
            except (BrowserError, OSError):
                pass  # it has gone already
        self.process.terminate()
        self.process.wait()

    def port(self):
        """The free port that the driver has taken; it says it in its first lines."""
        lines = queue.Queue()

        def read():
            for line in self.process.stdout:
                lines.put(line)
            lines.put(None)

        threading.Thread(target=read, daemon=True).start()
        said = ""
        try:
            while (line := lines.get(timeout=PATIENCE)) is not None:
                said += line
                if found := re.search(r"started successfully on port (\d+)", line):
                    return int(found.group(1))
        except queue.Empty:
            pass
        raise BrowserError(f"chromedriver does not start: {said}")

    def send(self, method, path, body=None):
        """A command of WebDriver and its value. @errors BrowserError"""
        data = None if method != "POST" else json.dumps(body or {}).encode()
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=3 * PATIENCE) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as failure:
            raise BrowserError(json.load(failure)["value"]["message"].splitlines()[0]) from None

    def post(self, path, body=None):
        return self.send("POST", self.session + path, body)

    def repeated(self, path, body):
        """The same for what may be done twice: on these the driver waits ten seconds only, less than a busy machine may take."""
        end = time.monotonic() + 3 * PATIENCE
        while True:
            try:
                return self.post(path, body)
            except BrowserError as failure:
                if "Timed out receiving message" not in str(failure) or time.monotonic() > end:
                    raise

    def devtools(self, command, **parameters):
        return self.repeated("/goog/cdp/execute", {"cmd": command, "params": parameters})

    # ------------------------------------------------------------------------------------------------- pages

    def show(self, width, height, scheme="light", media=""):
        """Size of the window in CSS pixels, and light or dark."""
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.devtools("Emulation.setEmulatedMedia", media=media, features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.until(f"return innerWidth === {width} && matchMedia('(prefers-color-scheme: {scheme})').matches", "the window's size")

    def load(self, path):
        self.post("/url", {"url": pathlib.Path(path).resolve().as_uri()})

    def run(self, script, *arguments):
        """The value of a function's body in JavaScript."""
        return self.post("/execute/sync", {"script": script, "args": list(arguments)})

    def run_async(self, script, *arguments):
        """The same for a body that ends by calling its last argument."""
        return self.post("/execute/async", {"script": script, "args": list(arguments)})

    def until(self, script, what, *arguments, seconds=PATIENCE):
        """Waits until the body gives something true, and gives it."""
        end = time.monotonic() + seconds
        while not (value := self.run(script, *arguments)):
            if time.monotonic() > end:
                raise BrowserError(f"waited in vain for {what}")
            time.sleep(0.02)
        return value

    # ------------------------------------------------------------------------------------------------ actions

    def press(self, *keys):
        """Keys one after another, each pressed and let go."""
        steps = [{"type": kind, "value": KEYS.get(key, key)} for key in keys for kind in ("keyDown", "keyUp")]
        self.post("/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": steps}]})

    def point_at(self, x, y, click=False):
        """The mouse to a place of the window."""
        steps = [{"type": "pointerMove", "x": round(x), "y": round(y), "duration": 0}]
        if click:
            steps += [{"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self.post("/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": steps}]})

    def wheel(self, x, y, down, held=None):
        """The wheel at a place of the window, with a key held."""
        keys = [{"type": kind, "value": KEYS[held]} for kind in ("keyDown", "keyUp")] if held else [{"type": "pause"}] * 2
        turn = {"type": "scroll", "x": round(x), "y": round(y), "deltaX": 0, "deltaY": down, "origin": "viewport"}
        self.post("/actions", {"actions": [
            {"type": "key", "id": "keyboard", "actions": [keys[0], {"type": "pause"}, keys[1]]},
            {"type": "wheel", "id": "wheel", "actions": [{"type": "pause"}, turn, {"type": "pause"}]}]})

    # ------------------------------------------------------------------------------------- what it sees and says

    def console(self):
        """Errors and warnings, but for the one on the pixels that a test reads."""
        return [entry["message"] for entry in self.post("/se/log", {"type": "browser"})
                if entry["level"] in ("SEVERE", "WARNING") and "willReadFrequently" not in entry["message"]]

    def requests(self):
        """Addresses that were asked for."""
        events = [json.loads(entry["message"])["message"] for entry in self.post("/se/log", {"type": "performance"})]
        return [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]

    def screenshot(self, x=0, y=0, width=None, height=None):
        """PNG of a part of the page, or of what is seen."""
        clip = {} if width is None else {"clip": {"x": x, "y": y, "width": width, "height": height, "scale": 1},
                                         "captureBeyondViewport": True}
        return base64.b64decode(self.devtools("Page.captureScreenshot", format="png", **clip)["data"])

    def pdf(self, width, height, margin):
        """The page on paper; lengths in cm."""
        margins = {side: margin for side in ("top", "bottom", "left", "right")}
        return base64.b64decode(self.repeated("/print", {"page": {"width": width, "height": height}, "margin": margins,
                                                         "background": True, "shrinkToFit": True}))
