#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""readme_picture.py REPORT.html SCENE RUN,RUN,... PICTURE.png [X,Y]: saves the page's own figure of these runs, with the detail
about pixel X,Y (where the page puts its cursor without it), by opening the page in headless Chromium."""
import base64
import json
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "engines" / "web"))
from chromium import Chromium  # noqa: E402

SECONDS = 120
# Gives the PNG as base64; the same calls as the page's button "Save figure as PNG".
FIGURE = """(async (sceneName, labels, cursor) => {
  const scene = results.scenes.findIndex(one => one.name === sceneName), viewer = makeViewer(scene);
  if (!viewer) throw new Error(`no pictures of '${sceneName}'`);
  const runs = labels.map(label => viewer.scene.techniques.findIndex(run => run.label === label));
  if (runs.includes(-1)) throw new Error(`not all of ${labels} are in the page`);
  await show(viewer, runs.at(-1), kReference);
  if (cursor) viewer.cursor = {x: cursor[0], y: cursor[1]};
  const sheet = await viewerFigure(viewer, runs, {hasErrors: true, hasInset: true, hasTimes: false});
  return sheetCanvas(sheet, sheetFactor(viewer)).toDataURL("image/png").split(",")[1];
})"""


def main():
    page, scene, labels, picture = sys.argv[1:5]
    cursor = [int(number) for number in sys.argv[5].split(",")] if len(sys.argv) > 5 else None
    with tempfile.TemporaryDirectory() as profile:
        browser = Chromium(profile, ["--disable-gpu"], SECONDS)
        try:
            browser.open_page()
            browser.navigate(pathlib.Path(page).resolve().as_uri())
            png = browser.evaluate(f"{FIGURE}({json.dumps(scene)}, {json.dumps(labels.split(','))}, {json.dumps(cursor)})")
        finally:
            browser.close()
    pathlib.Path(picture).write_bytes(base64.b64decode(png))
    print(f"readme_picture: wrote {picture}")


if __name__ == "__main__":
    main()
