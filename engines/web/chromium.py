# SPDX-License-Identifier: Apache-2.0
"""Headless Chromium through its DevTools pipe: no port and no library is needed."""
import json
import os
import subprocess
import time

# Nothing but the loopback is ever looked up or asked.
OFFLINE = ["--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
           "--disable-default-apps", "--disable-extensions", "--no-default-browser-check", "--disable-breakpad",
           "--disable-domain-reliability", "--dns-prefetch-disable",
           "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1"]


class Chromium:
    """One page. Ends with the program, or with close()."""

    def __init__(self, profile, flags, seconds):
        to_browser, self.writer = os.pipe()
        self.reader, from_browser = os.pipe()
        command = ["chromium", "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--remote-debugging-pipe",
                   f"--user-data-dir={profile}", *flags, "about:blank"]

        def place_pipes():  # Chromium reads from 3 and writes to 4
            source, target = os.dup(to_browser), os.dup(from_browser)
            os.dup2(source, 3)
            os.dup2(target, 4)

        self.process = subprocess.Popen(command, preexec_fn=place_pipes, pass_fds=(3, 4), stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        os.set_blocking(self.reader, False)
        self.rest, self.count, self.events, self.session = b"", 0, [], None
        self.wait_at_most(seconds)

    def wait_at_most(self, seconds):
        self.deadline = time.monotonic() + seconds

    def open_page(self):
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")

    def navigate(self, url):
        self.events = [event for event in self.events if event.get("method") != "Page.loadEventFired"]
        self.call("Page.navigate", url=url)
        self.wait_for("Page.loadEventFired")

    def message(self):
        while b"\0" not in self.rest:
            if time.monotonic() > self.deadline:
                raise TimeoutError("Chromium does not answer")
            try:
                part = os.read(self.reader, 1 << 20)
            except BlockingIOError:
                time.sleep(0.002)
                continue
            if not part:
                raise RuntimeError("Chromium has ended")
            self.rest += part
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.count += 1
        request = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.writer, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") != self.count:
                self.events.append(answer)
                continue
            if "error" in answer:
                raise RuntimeError(f"{method}: {answer['error']}")
            return answer["result"]

    def wait_for(self, method):
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self.message())

    def evaluate(self, script):
        """The value, or the exception's text in RuntimeError. `script` may be a promise."""
        answer = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "exception"))
        return answer["result"].get("value")

    def console(self):
        """What was written to the console since the last time."""
        lines = []
        for event in self.events:
            parameters = event.get("params", {})
            if event.get("method") == "Runtime.exceptionThrown":
                details = parameters["exceptionDetails"]
                lines.append(details.get("exception", {}).get("description", details["text"]))
            if event.get("method") == "Runtime.consoleAPICalled":
                lines.append(" ".join(str(a.get("value", "")) for a in parameters["args"]))
            if event.get("method") == "Log.entryAdded":
                lines.append(parameters["entry"]["text"])
        self.events = []
        return lines

    def close(self):
        self.process.terminate()
        try:
            self.process.wait(5)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
