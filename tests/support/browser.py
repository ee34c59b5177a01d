#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""browser.py PAGE STEPS.json PROFILE_FOLDER: opens PAGE in headless Chromium and takes the steps, real key presses included.

A step is {"eval": JS}, {"key": "ArrowRight"}, {"tabs": COUNT}, {"click" | "hover": SELECTOR}, {"drag" | "swipe": SELECTOR, "by": [dx, dy]},
{"wheel": SELECTOR, "by": dy}, {"pinch": SELECTOR, "by": factor}, {"size": [w, h]}, {"touch": true}, {"media": "print"}, {"dark": true}, {"downloads": FOLDER}, {"await": FILE},
{"pdf": FILE} or {"screenshot": FILE}. `eval` may be a promise; `tabs` marks with data-reached what gets the focus; a swipe is a finger's
drag; pointers start in the middle of what SELECTOR finds. A step with "before" is taken before the page is opened. Prints {"console": [...], "values": [of each eval], "load_ms": ...}. Talks to Chromium through a
pipe, so no port and no library is needed.
"""
import base64
import json
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "engines" / "web"))
from chromium import Chromium  # noqa: E402

SECONDS = 90  # for the whole visit


class Browser(Chromium):
    """With what a person's hands do."""

    def press(self, key):
        typed = {"text": key} if len(key) == 1 else {}
        if key == "Tab":
            typed = {"windowsVirtualKeyCode": 9}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, **typed)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def middle(self, selector):
        return self.evaluate(f"""(() => {{
            const found = document.querySelector({json.dumps(selector)});
            found.scrollIntoView({{block: "center"}});
            const box = found.getBoundingClientRect();
            return [box.x + box.width / 2, box.y + box.height / 2]; }})()""")

    def mouse(self, kind, place, **more):
        x, y = place
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(self, selector, by):
        x, y = self.middle(selector)
        held = {"button": "left", "buttons": 1, "clickCount": 1}
        self.mouse("mousePressed", (x, y), **held)
        for part in (0.5, 1):
            self.mouse("mouseMoved", (x + part * by[0], y + part * by[1]), **held)
        self.mouse("mouseReleased", (x + by[0], y + by[1]), **held)

    def swipe(self, selector, by):
        x, y = self.middle(selector)
        for kind, part in (("touchStart", 0), ("touchMove", 0.3), ("touchMove", 0.6), ("touchMove", 1)):
            point = {"x": x + part * by[0], "y": y + part * by[1]}
            self.call("Input.dispatchTouchEvent", type=kind, touchPoints=[point])
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def pinch(self, selector, factor):
        x, y = self.middle(selector)
        for kind, apart in (("touchStart", 20), ("touchMove", 10 * (1 + factor)), ("touchMove", 20 * factor)):
            points = [{"x": x + side * apart, "y": y, "id": k} for k, side in enumerate((-1, 1))]
            self.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def save_downloads(self, folder):
        session, self.session = self.session, None  # the whole browser's setting
        self.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=folder)
        self.session = session


def take(browser, step, values):
    if "eval" in step:
        values.append(browser.evaluate(step["eval"]))
    if "key" in step:
        browser.press(step["key"])
    for _ in range(step.get("tabs", 0)):
        browser.press("Tab")
        browser.evaluate("document.activeElement.dataset.reached = ''")
    if "click" in step:
        browser.drag(step["click"], (0, 0))
    if "hover" in step:
        browser.mouse("mouseMoved", browser.middle(step["hover"]))
    if "drag" in step:
        browser.drag(step["drag"], step["by"])
    if "swipe" in step:
        browser.swipe(step["swipe"], step["by"])
    if "pinch" in step:
        browser.pinch(step["pinch"], step["by"])
    if "wheel" in step:
        browser.mouse("mouseWheel", browser.middle(step["wheel"]), deltaX=0, deltaY=step["by"])
    if "touch" in step:
        browser.call("Emulation.setTouchEmulationEnabled", enabled=step["touch"])
    if "downloads" in step:
        browser.save_downloads(step["downloads"])
    if "await" in step:
        while not pathlib.Path(step["await"]).exists() and time.monotonic() < browser.deadline:
            time.sleep(0.02)
    if "size" in step:
        width, height = step["size"]
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
    if "media" in step:
        browser.call("Emulation.setEmulatedMedia", media=step["media"])
    if "dark" in step:
        feature = {"name": "prefers-color-scheme", "value": "dark" if step["dark"] else "light"}
        browser.call("Emulation.setEmulatedMedia", features=[feature])
    if "pdf" in step:
        printed = browser.call("Page.printToPDF", printBackground=True)
        pathlib.Path(step["pdf"]).write_bytes(base64.b64decode(printed["data"]))
    if "screenshot" in step:
        shot = browser.call("Page.captureScreenshot", captureBeyondViewport=bool(step.get("whole")))
        pathlib.Path(step["screenshot"]).write_bytes(base64.b64decode(shot["data"]))


def visit(browser, page, steps):
    browser.open_page()
    before = [step for step in steps if step.get("before")]
    for step in before:
        take(browser, step, [])
    start = time.monotonic()
    browser.call("Page.navigate", url=pathlib.Path(page).resolve().as_uri())
    browser.wait_for("Page.loadEventFired")
    values, load_ms = [], 1000 * (time.monotonic() - start)
    for step in steps:
        if not step.get("before"):
            take(browser, step, values)
    return {"console": browser.console(), "values": values, "load_ms": load_ms}


def main():
    page, steps, profile = sys.argv[1:]
    browser = Browser(profile, ["--disable-gpu"], SECONDS)
    try:
        print(json.dumps(visit(browser, page, json.loads(pathlib.Path(steps).read_text()))))
    finally:
        browser.process.kill()
        browser.process.wait()


if __name__ == "__main__":
    main()
