#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bench/page.py REPORT.html [REPEATS]: how large the page is and how long headless Chromium takes to open it, from the start of the
navigation: the first paint, the heat map and all numbers, the load event, the overview with its thumbnails and worst places; what of it the page's
main thread computed; then one viewer. Prints the median and the range; asserts nothing."""
import pathlib
import statistics
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "engines" / "web"))
from chromium import Chromium  # noqa: E402

SECONDS = 120
OPENED = """(async () => {
  const until = async isTrue => { while (!isTrue()) await new Promise(done => setTimeout(done, 5)); return performance.now(); };
  const overview = await until(() => document.getElementById("overview").dataset.ready === "yes");
  const paint = performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN;
  return {"first paint": paint, "all numbers drawn": performance.getEntriesByName("numbers")[0].startTime, "load event": performance.getEntriesByType("navigation")[0].loadEventEnd, "overview complete": overview};
})()"""
VIEWER = """(async () => {
  const start = performance.now(), last = results.scenes.length - 1;
  location.hash = `#scene-${last + 1}-run-1`;
  while (!viewers.get(last)?.root.dataset.ready) await new Promise(done => setTimeout(done, 5));
  return performance.now() - start;
})()"""
# DevTools' names of what the page's main thread spends its processor time on; they hold on a busy machine, too.
PARTS = {"TaskDuration": "all of it", "ScriptDuration": "scripts", "LayoutDuration": "layout", "RecalcStyleDuration": "style"}


def visit(page):
    """Times in ms."""
    with tempfile.TemporaryDirectory() as profile:
        browser = Chromium(profile, ["--disable-gpu"], SECONDS)
        try:
            browser.open_page()
            browser.call("Performance.enable", timeDomain="threadTicks")
            browser.navigate(page.resolve().as_uri())
            times = browser.evaluate(OPENED)
            spent = {one["name"]: 1000 * one["value"] for one in browser.call("Performance.getMetrics")["metrics"]}
            times.update({f"processor: {words}": spent[name] for name, words in PARTS.items()})
            return {**times, "a viewer": browser.evaluate(VIEWER)}
        finally:
            browser.close()


def main():
    page, repeats = pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print(f"{page}: {page.stat().st_size / 1e6:.2f} MB")
    visits = [visit(page) for _ in range(repeats)]
    for name in visits[0]:
        values = [one[name] for one in visits]
        print(f"  {name:22} {statistics.median(values):7.0f} ms  [{min(values):.0f}, {max(values):.0f}]")


if __name__ == "__main__":
    main()
