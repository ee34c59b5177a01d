#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""paper_tables.py FOLDER DOC: the tables of docs/papers.md, between its markers, from what bench_papers.sh measured."""

import json
import pathlib
import sys

STUDIES = {"A": ["paper-a"], "C": ["paper-bc"], "D": ["paper-d"], "E": ["paper-e", "paper-e-light-size", "static_loops"]}


def begin(letter):
    return f"<!-- measured: {letter}, scripts/bench_papers.sh writes from here -->"


END = "<!-- to here -->"


def name_of(scene):
    return scene["name"].removeprefix("assets/")


def paper(claim):
    low, high = claim["paper"]["low"], claim["paper"]["high"]
    if high is None:
        return f"at least {low:.3g}"
    return f"{low:.3g}" if low == high else f"{low:.3g} to {high:.3g}"


def compares(claim):
    counts = ["?" if c is None else f"{c:.4g}" for c in claim["compares_per_pixel"]]
    return " : ".join(counts)


def here(scene, claim):
    ours = claim["ours"]
    ratio = "" if ours is None else f" {ours['value']:.3g} [{ours['low']:.3g}, {ours['high']:.3g}],"
    reason = f": {claim['reason']}" if claim["reason"] else ""
    return f"{name_of(scene)}{ratio} {claim['verdict']}{reason}"


def claims_table(study):
    """A claim a row; on which scenes it was judged, in its last cell."""
    rows = {}
    for scene in study["scenes"]:
        for claim in scene["claims"]:
            key = (claim["text"], claim["quantity"], compares(claim))
            papers, cells = rows.setdefault(key, ([], []))
            if paper(claim) not in papers:
                papers.append(paper(claim))
            cells.append(here(scene, claim))
    lines = ["| claim | ratio of | compares per pixel | paper | here |", "|---|---|---|---|---|"]
    lines += [f"| {text} | {quantity} | {counts} | {', '.join(papers)} | {'; '.join(cells)} |"
              for (text, quantity, counts), (papers, cells) in rows.items()]
    return "\n".join(lines)


def error_text(run):
    if run is None or not run["error"] or not run["error"]["rmse"]:
        return ""
    return f"{run['error']['rmse']['value']:.4f}"


def errors_table(study):
    """RMSE of every run. Scenes across."""
    scenes = study["scenes"]
    labels = list(dict.fromkeys(run["label"] for scene in scenes for run in scene["runs"]))
    by_scene = [{run["label"]: run for run in scene["runs"]} for scene in scenes]
    lines = ["| RMSE of | " + " | ".join(name_of(s) for s in scenes) + " |", "|---|" + "---|" * len(scenes)]
    lines += [f"| {label} | " + " | ".join(error_text(runs.get(label)) for runs in by_scene) + " |" for label in labels]
    return "\n".join(lines)


def part(study):
    devices = sorted({f"{run['device']}, {run['timer']}" for scene in study["scenes"] for run in scene["runs"]
                      if run["device"]})
    context = (f"{study['title']}: {study['width_px']} x {study['height_px']} px, reference {study['samples_per_pixel']} "
               f"samples per pixel, {'; '.join(devices)}, commit {study['commit']}.")
    return "\n\n".join([context, claims_table(study), errors_table(study)])


def main():
    folder, doc = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    text = doc.read_text()
    for letter, names in STUDIES.items():
        files = [folder / f"{name}.json" for name in names]
        parts = [part(json.loads(file.read_text())) for file in files if file.exists()]
        if not parts:
            continue
        head, rest = text.split(begin(letter))
        tail = rest.split(END, 1)[1]
        text = head + begin(letter) + "\n" + "\n\n".join(parts) + "\n" + END + tail
    doc.write_text(text)


if __name__ == "__main__":
    main()
