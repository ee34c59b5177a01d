#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""engine_tuning_table.py FOLDER DOC: the table of tuned engines in docs/engines.md, between its markers, from what
engine_tuning.sh measured."""
import json
import pathlib
import sys

from markdown import replace_measured, table

SCRIPT = "engine_tuning.sh"


def default_of(result):
    return next(other for other in result["others"] if "default" in other["name"].split(", "))


def error_of(run):
    values = [score["value"] for score in run["scores"] if score["held_out"] and score["value"] is not None]
    return sum(values) / len(values)


def outcome(gain):
    return "won" if gain["low"] > 0 else "lost" if gain["high"] < 0 else "tied"


UNSEEN = "not measured"  # no camera but the one searched with sees enough


def row_of(result):
    default, gain = default_of(result), default_of(result)["held_out_gain"]
    if gain is None:
        return (result["scenes"][0], result["technique"], "n/a", "n/a", "n/a", UNSEEN, "n/a")
    found = {name: result["best"]["parameters"][name] for name in result["tuned"]}
    settings = ", ".join(f"{name} = {value:.3g}" if isinstance(value, float) else f"{name} = {value}" for name, value in found.items()
                         if value != default["parameters"][name])
    return (result["scenes"][0], result["technique"], f'{error_of(default):.3f}', f'{error_of(result["best"]):.3f}',
            f'{gain["value"]:+.2f} [{gain["low"]:+.2f}, {gain["high"]:+.2f}]', outcome(gain), settings or "its defaults")


def main():
    results = [json.loads(file.read_text()) for file in sorted(pathlib.Path(sys.argv[1]).glob("*.json"))]
    rows = [row_of(result) for result in results]
    counts = ", ".join(f"{sum(row[5] == kind for row in rows)} {kind}" for kind in ("won", "tied", "lost", UNSEEN))
    first, commits = results[0], ", ".join(dict.fromkeys(result["commit"] for result in results))
    text = (f'{first["width_px"]} x {first["height_px"]} px, seed {first["seed"]}, commit {commits}. {len(rows)} pairs: {counts}.\n\n'
            + table(("scene", "engine", "default's RMSE", "tuned RMSE", "gain [95 %]", "", "tuned"), rows))
    replace_measured(pathlib.Path(sys.argv[2]), SCRIPT, text)


main()
