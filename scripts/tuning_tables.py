#!/usr/bin/env python3
"""tuning_tables.py FOLDER DOC: the tables of docs/tuning.md, between its markers, from what bench_tune.sh measured."""

import json
import pathlib
import sys

BEGIN, END = "<!-- measured: scripts/bench_tune.sh writes from here -->", "<!-- to here -->"
TARGET_OVER_GRID = 1.02
TARGET_SHARE = 0.05
OWN_LEVELS = {"low", "medium", "high", "reference"}  # ours, not a paper's or an engine's


def load(folder, kind):
    results = {}
    for file in sorted(folder.glob(f"{kind}-*.json")):
        result = json.loads(file.read_text())
        results[(result["scenes"][0], result["technique"])] = result
    return results


def table(results, cell):
    """Scenes down, techniques across."""
    scenes = list(dict.fromkeys(scene for scene, _ in results))
    techniques = list(dict.fromkeys(technique for _, technique in results))
    lines = ["| scene | " + " | ".join(techniques) + " |", "| --- |" + " --- |" * len(techniques)]
    for scene in scenes:
        cells = [cell(results[(scene, t)]) if (scene, t) in results else "" for t in techniques]
        lines.append(f"| {scene} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def over_grid(result):
    return result["best"]["ratio"] / result["grid"]["best_ratio"]


def rivals(result):
    """Defaults and presets of papers and engines at the same cost."""
    return [c for c in result["others"] if c["same_cost"] and not set(c["name"].split(", ")) <= OWN_LEVELS]


def least(candidates, key):
    values = [c[key] for c in candidates if c[key] is not None]
    return min(values) if values else None


def outcome(result, key):
    ours, best = result["best"][key], least(rivals(result), key)
    if ours is None or best is None:
        return "none"
    if ours == best:
        return "tie"
    return "win" if ours < best else "loss"


def against(result):
    def text(key):
        ours, best = result["best"][key], least(rivals(result), key)
        mark = {"loss": " **loss**", "tie": " tie"}.get(outcome(result, key), "")
        return "n/a" if ours is None or best is None else f"{ours:.3f} / {best:.3f}{mark}"

    return f"{text('ratio')}; {text('held_out_ratio')}"


def windows(results):
    counts = {}
    for result in results.values():
        for sweep in result["bias_sweep"]:
            if not sweep["is_complete"]:
                continue
            with_window, all_of_them = counts.get((result["technique"], sweep["parameter"]), (0, 0))
            counts[(result["technique"], sweep["parameter"])] = (with_window + sweep["has_window"], all_of_them + 1)
    lines = ["| technique | bias | scenes with a safe window |", "| --- | --- | --- |"]
    lines += [f"| {t} | {p} | {some} of {count} |" for (t, p), (some, count) in counts.items()]
    return "\n".join(lines)


def grid_part(results):
    ratios = [over_grid(r) for r in results.values()]
    within = sum(r <= TARGET_OVER_GRID for r in ratios)
    cheap = sum(r["evaluations"] <= TARGET_SHARE * r["grid"]["evaluations"] for r in results.values())
    return (
        f"Objective over the grid's best, and evaluations over the grid's. Within 2 %: {within} of {len(ratios)}; for at "
        f"most 5 % of the evaluations: {cheap} of {len(ratios)}; worst {max(ratios):.4f}.\n\n"
        + table(results, lambda r: f"{over_grid(r):.4f} ({r['evaluations']}/{r['grid']['evaluations']})")
    )


def presets_part(results):
    def count(key):
        outcomes = [outcome(r, key) for r in results.values()]
        return f"{outcomes.count('win')} won, {outcomes.count('tie')} tied, {outcomes.count('loss')} lost"

    return (
        "Tuned / best of default and presets, as ratios to the default: on the cameras tuned on; on held-out cameras. "
        f"Tuned on: {count('ratio')}. Held out: {count('held_out_ratio')}. A tie: no change was shown to be worth it, "
        "and the tuner kept to the best setting it was given.\n\n" + table(results, against)
    )


def main():
    folder, doc = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    grids, presets = load(folder, "grid"), load(folder, "presets")
    first = next(iter(presets.values()))
    context = f"{first['width_px']} x {first['height_px']} px, maps of 256 texels, {first['device']}."
    parts = [context, "### Against a dense grid", grid_part(grids), "### Against defaults and presets",
             presets_part(presets), "### Safe windows at the tuned values", windows(presets)]
    text = doc.read_text()
    head, rest = text.split(BEGIN)
    tail = rest.split(END)[1]
    doc.write_text(head + BEGIN + "\n" + "\n\n".join(parts) + "\n" + END + tail)


if __name__ == "__main__":
    main()
