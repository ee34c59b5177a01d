#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""engine_tables.py CSV DOC: the tables of docs/engines.md, between its markers, from what `umbrameter export --csv` wrote and from
the engines' manifests."""
import csv
import pathlib
import sys
import tomllib

from markdown import replace_measured, table

ENGINES = pathlib.Path(__file__).resolve().parent.parent / "engines"


def error_of(run):
    if run["status"] != "ok" or not run["rmse"]:
        return "failed: " + (run["failure"] or "not measured")
    return f'{float(run["rmse"]):.3f} [{float(run["rmse_low"]):.3f}, {float(run["rmse_high"]):.3f}]'


def settings_of(run):
    """Parameters of the technique alone: the others' columns are empty."""
    prefix = "parameter."
    values = {key[len(prefix):]: value for key, value in run.items() if key.startswith(prefix) and value != ""}
    return ", ".join(f"{name} = {value}" for name, value in values.items())


def quantity_of(technique):
    manifest = ENGINES / technique / "engine.toml"
    return tomllib.loads(manifest.read_text())["quantity"] if manifest.exists() else "visibility"


def mappings(runs):
    rows = []
    for technique in dict.fromkeys(run["technique"] for run in runs):
        manifest = ENGINES / technique / "engine.toml"
        if manifest.exists():
            engine = tomllib.loads(manifest.read_text())
            rows += [(engine["title"], light, text) for light, text in engine["lights"].items()]
    return table(("engine", "light", "becomes"), rows)


def measured(runs):
    scenes = list(dict.fromkeys(run["scene"] for run in runs))
    lights = {run["scene"]: run["light"] for run in runs}
    labels = list(dict.fromkeys(run["label"] for run in runs))
    by_place = {(run["label"], run["scene"]): run for run in runs}
    first = {label: next(run for run in runs if run["label"] == label) for label in labels}
    errors = table(("run", "compared as", *(f"{scene} ({lights[scene]})" for scene in scenes)),
                   [(label, quantity_of(first[label]["technique"]),
                     *(error_of(by_place[label, scene]) if (label, scene) in by_place else "not run" for scene in scenes))
                    for label in labels])
    context = table(("run", "version, device", "settings"),
                    [(label, first[label]["device"], settings_of(first[label])) for label in labels])
    size = f'{runs[0]["width_px"]} x {runs[0]["height_px"]} px, truth of {runs[0]["samples_per_pixel"]} samples per pixel, ' \
           f'seed {runs[0]["seed"]}, commit {runs[0]["commit"]}'
    return f"RMSE with its 95 % interval; {size}.\n\n{errors}\n\n{context}\n\nWhat became of the lights:\n\n{mappings(runs)}"


def main():
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        runs = list(csv.DictReader(file))
    replace_measured(pathlib.Path(sys.argv[2]), "engine_tables.sh", measured(runs))


main()
