#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tuning_tables.py FOLDER DOC: the tables of docs/tuning.md, between its markers, from what bench_tune.sh measured."""

import json
import pathlib
import sys

from markdown import replace_measured

TARGET_OVER_GRID = 1.02
TARGET_SHARE = 0.05
OWN = {"default", "low", "medium", "high", "reference"}  # ours, not a paper's or an engine's


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
    """Presets of papers and engines at the same cost."""
    return [c for c in result["others"] if c["same_cost"] and not set(c["name"].split(", ")) <= OWN]


def default_of(result):
    return [c for c in result["others"] if "default" in c["name"].split(", ")]


def best_rival(result, key):
    return min(rivals(result), key=lambda c: c[key] if c[key] is not None else float("inf"), default=None)


def outcome(against, gain):
    """Against every one of them, beyond the interval: won if all are beaten, lost if one is better."""
    gains = [c[gain] for c in against]
    if not gains or any(g is None for g in gains):
        return "none"
    if any(g["high"] < 0 for g in gains):
        return "lost"
    return "won" if all(g["low"] > 0 for g in gains) else "tied"


def against(result):
    def text(key, gain):
        ours, best = result["best"][key], best_rival(result, key)
        if ours is None or best is None or best[key] is None:
            return "n/a"
        word = outcome(rivals(result), gain)
        return f"{ours:.3f} / {best[key]:.3f}" + {"lost": " **lost**", "tied": " tied"}.get(word, "")

    return f"{text('ratio', 'gain')}; {text('held_out_ratio', 'held_out_gain')}"


def windows(results):
    counts = {}
    for result in results.values():
        # Beside the tuned values, where they were measured: those come last.
        for sweep in {sweep["parameter"]: sweep for sweep in result["bias_sweep"]}.values():
            if not sweep["is_complete"]:
                continue
            with_window, all_of_them = counts.get((result["technique"], sweep["parameter"]), (0, 0))
            counts[(result["technique"], sweep["parameter"])] = (with_window + sweep["has_window"], all_of_them + 1)
    lines = ["| technique | bias | scenes with a safe window |", "| --- | --- | --- |"]
    lines += [f"| {t} | {p} | {some} of {count} |" for (t, p), (some, count) in counts.items()]
    return "\n".join(lines)


def grid_part(results):
    if not results:
        return "Not measured."
    ratios = [over_grid(r) for r in results.values()]
    within = sum(r <= TARGET_OVER_GRID for r in ratios)
    cheap = sum(r["evaluations"] <= TARGET_SHARE * r["grid"]["evaluations"] for r in results.values())
    return (
        f"Objective over the grid's best, and evaluations over the grid's. Within 2 %: {within} of {len(ratios)}; for at "
        f"most 5 % of the evaluations: {cheap} of {len(ratios)}; worst {max(ratios):.4f}.\n\n"
        + table(results, lambda r: f"{over_grid(r):.4f} ({r['evaluations']}/{r['grid']['evaluations']})")
    )


def presets_part(results):
    def count(gain, against):
        outcomes = [outcome(against(r), gain) for r in results.values()]
        return ", ".join(f"{outcomes.count(word)} {word}" for word in ("won", "tied", "lost"))

    def keeps(result, against):
        return any(c["parameters"] == result["best"]["parameters"] for c in against(result))

    worse = [(f"{t} on {s} against {c['name']}: {-c[g]['value']:.4f} [{-c[g]['high']:.4f}, {-c[g]['low']:.4f}] {where}")
             for (s, t), r in results.items() for c in rivals(r)
             for g, where in (("gain", "tuned on"), ("held_out_gain", "held out")) if c[g] and c[g]["high"] < 0]
    return (
        f"{len(results)} pairs. Against papers' and engines' presets at the same cost: on the cameras searched {count('gain', rivals)}; "
        f"held out {count('held_out_gain', rivals)}; in {sum(keeps(r, rivals) for r in results.values())} pairs the tuner kept to one of "
        f"them. Against the technique's own default: {count('gain', default_of)}; held out {count('held_out_gain', default_of)}; "
        f"{sum(keeps(r, default_of) for r in results.values())} kept. Won: better than every one of them beyond the 95 % interval of the "
        "difference over the cameras; lost: worse than one beyond it. In the table: tuned / the best of these presets in hindsight, as "
        "ratios to the default, on the cameras searched; on those held out.\n\n" + table(results, against)
        + "\n\n" + ("Lost: " + "; ".join(worse) + "." if worse else "Nothing is lost.")
    )


def main():
    folder, doc = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    grids, presets = load(folder, "grid"), load(folder, "presets")
    first = next(iter(presets.values()))
    context = f"{first['width_px']} x {first['height_px']} px, maps of 256 texels, {first['device']}."
    parts = [context, "### Against a dense grid", grid_part(grids), "### Against defaults and presets",
             presets_part(presets), "### Safe windows at the tuned values", windows(presets)]
    replace_measured(doc, "bench_tune.sh", "\n\n".join(parts))


if __name__ == "__main__":
    main()
