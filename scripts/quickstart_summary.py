#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""quickstart_summary.py RESULTS.JSON SECONDS: what quickstart.sh measured, in ten lines."""
import json
import pathlib
import statistics
import sys

FAULTS = {"acne": "speckles (acne)", "terminator": "dark at the terminator", "extra_shadow": "shadows that are not there",
          "penumbra": "wrong softness", "overlap": "wrong where penumbrae overlap", "resolution": "stairs of the map's texels",
          "peter_panning": "shadows detached from their casters", "bleed": "light bleeding through shadows",
          "geometric_leak": "light leaking in", "lost_shadow": "whole shadows lost"}


def total_ms(run):
    return next((t["median_ms"] for t in run["pass_times"] if t["pass"] == "total"), None)


def collect(results):
    """By technique: RMSEs, times and worst faults over the scenes that were scored."""
    by_technique = {}
    for scene in results["scenes"]:
        for run in scene["techniques"]:
            error = run.get("error")
            if not error or not error["rmse"]:
                continue
            entry = by_technique.setdefault(run["label"], {"rmse": [], "ms": [], "faults": []})
            entry["rmse"].append(error["rmse"]["value"])
            if total_ms(run) is not None:
                entry["ms"].append(total_ms(run))
            worst = (run.get("faults") or {}).get("worst")
            if worst:
                entry["faults"].append(worst)
    return by_technique


def is_worth_its_time(label, mean, ms):
    """Timed, and nothing is both as fast and nearer to the truth."""
    return label in ms and not any(ms[other] <= ms[label] and mean[other] < mean[label] for other in ms)


def summary(results, seconds, page):
    runs = collect(results)
    if not runs:
        return ["quickstart: nothing could be scored; see the page", f"  page: {page}"]
    mean = {label: statistics.mean(entry["rmse"]) for label, entry in runs.items()}
    ms = {label: statistics.mean(entry["ms"]) for label, entry in runs.items() if entry["ms"]}
    ranked = sorted(mean, key=mean.get)
    best = ranked[0]
    scenes = len(results["scenes"])
    device = next(run["device"] for scene in results["scenes"] for run in scene["techniques"] if run.get("device"))
    lines = [f"quickstart: {len(runs)} techniques on {scenes} scene{'' if scenes == 1 else 's'} in {seconds} s; RMSE of visibility (0 = like the truth), "
             f"mean over the scenes"]
    for label in ranked:
        faults = runs[label]["faults"]
        worst = max(sorted(set(faults)), key=faults.count) if faults else None
        time = f"{ms[label]:6.1f} ms" if label in ms else "       -"
        lines.append(f"  {label:8} {mean[label]:.4f} {time}   {'mostly ' + FAULTS.get(worst, worst) if worst else 'no fault'}")
    worth = [label for label in ranked if is_worth_its_time(label, mean, ms)]
    lines.append(f"  closest to the truth: {best}" + (f"; best for their time: {', '.join(worth)}" if worth else "")
                 + f" (times of {device.split(' (')[0]})")
    lines.append(f"  page: {page} (pictures, errors, faults under the cursor)")
    lines.append("  next: ./umbrameter validate plate --technique pcss:filter_taps=64 | ./umbrameter tune plate --technique pcf")
    lines.append("  your own engine's pictures: docs/your-engine.md; a ten-minute tour: docs/tour.md")
    return lines


if __name__ == "__main__":
    file = pathlib.Path(sys.argv[1])
    print("\n".join(summary(json.loads(file.read_text()), int(sys.argv[2]), file.with_name("report.html"))))
