#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""readme_table.py RESULTS.json README.md: the README's table, between its markers, from what make_readme.sh measured."""
import json
import pathlib
import sys

from markdown import replace_measured

TITLES = {"contact_hardening": "cube and post, disk light", "assets/bunny": "bunny, disk light", "assets/crytek_sponza": "Sponza, hazy sun"}


def cell(run):
    if run is None or not run["error"] or not run["error"]["rmse"]:
        return "n/a"
    rmse = run["error"]["rmse"]
    return f"{rmse['value']:.3f} [{rmse['low']:.3f}, {rmse['high']:.3f}]"


def table(results):
    scenes = results["scenes"]
    labels = list(dict.fromkeys(run["label"] for scene in scenes for run in scene["techniques"]))
    lines = ["| technique | " + " | ".join(TITLES.get(scene["name"], scene["name"]) for scene in scenes) + " |", "|---" * (len(scenes) + 1) + "|"]
    for label in labels:
        runs = [next((run for run in scene["techniques"] if run["label"] == label), None) for scene in scenes]
        lines.append(f"| {label} | " + " | ".join(map(cell, runs)) + " |")
    return "\n".join(lines)


def context(results):
    devices = {run["device"].split(" (")[0] for scene in results["scenes"] for run in scene["techniques"] if run.get("device")}
    truth = {scene["reference"]["device"] for scene in results["scenes"] if scene.get("reference")}
    return (f"RMSE of visibility (0 = umbra, 1 = whole light seen) against the truth, its noise taken out, with its 95 % interval.\n"
            f"Parameters at their defaults, {results['width_px']} x {results['height_px']} px, truth with up to "
            f"{results['samples_per_pixel']} samples per pixel, seed {results['seed']};\n"
            f"{'; '.join(sorted(truth))}; {'; '.join(sorted(devices))}; umbrameter {results['version']} ({results['commit']}):")


def main():
    results, file = json.loads(pathlib.Path(sys.argv[1]).read_text()), pathlib.Path(sys.argv[2])
    replace_measured(file, "make_readme.sh", f"{context(results)}\n\n{table(results)}")


if __name__ == "__main__":
    main()
