#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""repeat_results.py FOLDER SCENES RUNS: makes results.json name SCENES scenes of RUNS runs each by repeating those it has.

The pictures are shared, so a large results folder costs nothing to make; the report packs each run's pixels all the same.
"""
import json
import pathlib
import sys


def main():
    folder, scene_count, run_count = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    file = folder / "results.json"
    results = json.loads(file.read_text())
    scenes = []
    for s in range(scene_count):
        scene = json.loads(json.dumps(results["scenes"][s % len(results["scenes"])]))
        scene["name"] += f"-{s}"
        runs = scene["techniques"]
        scene["techniques"] = [{**runs[r % len(runs)], "label": f"{runs[r % len(runs)]['label']}-{r}"} for r in range(run_count)]
        scenes.append(scene)
    results["scenes"] = scenes
    file.write_text(json.dumps(results, indent=2))


if __name__ == "__main__":
    main()
