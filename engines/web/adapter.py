#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""adapter.py MODULES: draws with a web engine in headless Chromium, with WebGL2 on what EGL finds: a GPU, or Mesa's llvmpipe.

MODULES is the folder of installed npm packages. The engine's own part is page.mjs in UMBRAMETER_ENGINE_FOLDER, which exports
open() and render() (web/page.mjs says how it is called). Speaks the protocol of docs/engines.md on its standard streams.
"""
import json
import os
import pathlib
import sys
import tempfile
import time

from chromium import OFFLINE, Chromium
from server import Server

WEB = pathlib.Path(__file__).resolve().parent
# SwiftShader, Chromium's own renderer, is the last choice: its triangles lie up to 0.15 px beside their places.
GRAPHICS = [["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"],
            ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]]
HAS_WEBGL2 = "document.createElement('canvas').getContext('webgl2') !== null"
SOFTWARE = ("llvmpipe", "softpipe", "swiftshader")
SECONDS_TO_LOAD = 30
SECONDS = 3600  # the program that asks has a limit of its own, and ends this one


def say(answer):
    print(json.dumps(answer), flush=True)


def short(error):
    """The first lines of a JavaScript exception, or of ours."""
    return " ".join(str(error).split("\n")[:2])


def browser_with_webgl2():
    for flags in GRAPHICS:
        browser = Chromium(tempfile.mkdtemp(prefix="profile-"), OFFLINE + flags, SECONDS)
        browser.open_page()
        if browser.evaluate(HAS_WEBGL2):
            return browser
        browser.close()
    raise RuntimeError("Chromium has no WebGL2 here")


class Page:
    def __init__(self, modules):
        engine = pathlib.Path(os.environ["UMBRAMETER_ENGINE_FOLDER"])
        self.server = Server({"web": WEB, "engine": engine, "modules": modules})
        self.browser = browser_with_webgl2()
        self.browser.navigate(self.server.url("web/index.html"))
        self.wait_for_script()
        self.about = self.browser.evaluate("umbrameterReady")
        self.browser.console()

    def wait_for_script(self):
        """A page that is loaded may still be the blank one from before."""
        deadline = time.monotonic() + SECONDS_TO_LOAD
        while self.browser.evaluate("typeof umbrameterReady") == "undefined":
            if time.monotonic() > deadline:
                raise RuntimeError("its script does not run: " + "; ".join(self.browser.console()[:4]))
            time.sleep(0.02)

    def render(self, request):
        self.server.readable["scene"] = pathlib.Path(request["scene"])
        self.server.writable = {"out": pathlib.Path(request["out"])}
        plain = {key: value for key, value in request.items() if key not in ("protocol", "id", "scene", "out")}
        answer = self.browser.evaluate(f"umbrameterRender({json.dumps(plain)})")
        answer.setdefault("warnings", []).extend(sorted(set(self.browser.console()))[:8])
        return answer


def main():
    try:
        page = Page(sys.argv[1])
    except Exception as error:
        say({"error": f"the page does not open: {short(error)}"})
        return
    is_software = any(name in page.about["device"].lower() for name in SOFTWARE)
    say({"ready": True, "is_software": is_software, **page.about})
    for line in sys.stdin:
        request = json.loads(line)
        try:
            say({"id": request["id"], **page.render(request)})
        except Exception as error:
            print(error, file=sys.stderr)
            say({"id": request["id"], "error": short(error)})
    page.browser.close()


if __name__ == "__main__":
    main()
