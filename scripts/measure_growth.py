#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""measure_growth.py [--program FILE] [--write]: how a sweep's cost grows with scenes, runs, pixels and triangles, over two decades
each, and what a study of 10^6 runs wants. Prints Markdown; --write puts it into docs/growth.md below its mark. Some minutes.
Times are the processor's, of the whole process tree."""
import argparse
import json
import math
import os
import pathlib
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "growth.md"
MARK = "<!-- measured: scripts/measure_growth.py writes from here -->\n"
SCENE = """title = "Bumps, {number}"
[camera]
eye = [0.0, 3.0, 5.0]
at = [0.0, {height}, 0.0]
[[light]]
type = "rect"
center = [1.5, 4.0, 0.5]
direction = [-0.3, -1.0, -0.1]
size = [0.6, 0.6]
[[mesh]]
file = "{mesh}"
"""
PLATE = """[[mesh]]
shape = "plate"
size = [0.5, 0.5]
translate = [{x}, {y}, {z}]
"""
STUDY = """schema = 1
title = "Growth"
scenes = [{scenes}]
width_px = {width}
height_px = {height}
samples_per_pixel = 64
[[run]]
technique = "{technique}"
label = "{label}"
[run.values]
{values}
"""


def write_mesh(file, triangles):
    """A floor of bumps: two triangles a cell."""
    side = max(2, round(math.sqrt(triangles / 2)))
    with file.open("w") as out:
        for j in range(side + 1):
            for i in range(side + 1):
                x, z = 6 * i / side - 3, 6 * j / side - 3
                out.write(f"v {x:.5f} {0.25 * math.sin(5 * x) * math.sin(5 * z):.5f} {z:.5f}\n")
        for j in range(side):
            for i in range(side):
                a = j * (side + 1) + i + 1
                out.write(f"f {a} {a + side + 1} {a + side + 2}\nf {a} {a + side + 2} {a + 1}\n")
    return 2 * side * side


def write_study(folder, scenes=1, runs=1, triangles=10_000, size=(96, 54), technique="pcss"):
    count = write_mesh(folder / "bumps.obj", triangles)
    names = []
    for i in range(scenes):
        names.append(f"scene{i}.toml")
        plates = "".join(PLATE.format(x=x, y=0.5 + 0.1 * (x + z + 4), z=z) for x in (-2, -1, 0, 1, 2) for z in (-2, -1, 0, 1, 2))
        (folder / names[-1]).write_text(SCENE.format(number=i, height=0.001 * i, mesh="bumps.obj") + plates)
    biases = ", ".join(f"{0.1 + 0.001 * i:.3f}" for i in range(runs))
    (folder / "study.toml").write_text(STUDY.format(scenes=", ".join(f'"{name}"' for name in names), width=size[0], height=size[1],
                                                    technique=technique, label="{bias_texels}", values=f"bias_texels = [{biases}]"))
    return count


def measured(arguments):
    """Processor seconds, seconds by the clock, peak MB, and the answer."""
    start = time.monotonic()
    with tempfile.TemporaryFile() as answer:
        child = subprocess.Popen(arguments, stdout=answer, stderr=subprocess.PIPE)
        said = child.stderr.read()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            raise SystemExit(f"measure_growth: {' '.join(map(str, arguments))} ended with {child.returncode}: {said.decode()[-300:]}")
        answer.seek(0)
        text = answer.read()
    return usage.ru_utime + usage.ru_stime, time.monotonic() - start, usage.ru_maxrss / 1024, json.loads(text)


def folder_mb(folder):
    return sum(file.stat().st_size for file in folder.rglob("*") if file.is_file()) / 1e6


def one(program, **study):
    """A sweep, planned, done and asked for again."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        triangles = write_study(folder, **study)
        common = [folder / "study.toml", "--out", folder / "store", "--json"]
        cpu_s, clock_s, peak_mb, answer = measured([program, "sweep", *common])
        expected = study.get("scenes", 1) * study.get("runs", 1)
        if answer["rendered"] != expected or answer["failures"]:
            raise SystemExit(f"measure_growth: {answer['rendered']} of {expected} runs were rendered")
        plan_s = measured([program, "plan", *common])[0]
        again_s, _, _, again = measured([program, "sweep", *common])
        if again["rendered"] or again["references_rendered"]:
            raise SystemExit("measure_growth: what the store has was rendered again: was the program replaced meanwhile?")
        return {"triangles": triangles, "cpu_s": cpu_s, "clock_s": clock_s, "peak_mb": peak_mb, "store_mb": folder_mb(folder / "store"),
                "plan_s": plan_s, "again_s": again_s}


SERIES = (
    ("scenes", "one run each, 96 x 54 px, 10,000 triangles", [{"scenes": n} for n in (2, 20, 200)], lambda s: s["scenes"]),
    ("runs", "of one scene, 96 x 54 px, 10,000 triangles", [{"runs": n} for n in (4, 40, 400)], lambda s: s["runs"]),
    ("pixels", "4 runs of one scene, 10,000 triangles", [{"runs": 4, "size": size} for size in ((96, 54), (304, 171), (960, 540))],
     lambda s: s["size"][0] * s["size"][1]),
    ("triangles", "4 runs of one scene, 96 x 54 px", [{"runs": 4, "triangles": n} for n in (10_000, 100_000, 1_000_000)],
     lambda s: s["triangles"]),
)


def exponent(points):
    """Of the last decade: what the start costs has least say there."""
    (n0, t0), (n1, t1) = points[-2:]
    return math.log(t1 / t0) / math.log(n1 / n0)


def series_text(program, name, what, studies, count_of):
    rows, points = [], []
    for study in studies:
        result = one(program, **study)
        count = count_of(study)
        points.append((count, result["cpu_s"]))
        rows.append(f"| {count:,} | {result['cpu_s']:.1f} | {1e3 * result['cpu_s'] / count:.3g} | {result['plan_s']:.2f} | "
                    f"{result['again_s']:.2f} | {result['peak_mb']:.0f} | {result['store_mb']:.1f} |")
        print(f"measure_growth: {name} {count}: {result['cpu_s']:.1f} s", flush=True)
    head = f"| {name} | sweep (s) | a piece (ms) | plan (s) | again (s) | peak memory (MB) | store (MB) |\n| --- | --- | --- | --- | --- | --- | --- |"
    return f"**{name.capitalize()}** ({what}): the last decade grows with the power {exponent(points):.2f}.\n\n{head}\n" + "\n".join(rows) + "\n"


def million_text(program):
    """From what one run more costs, at the size of `quality = "quick"`."""
    few, many = (one(program, runs=n, size=(480, 270), triangles=100_000) for n in (4, 24))
    run_s = (many["cpu_s"] - few["cpu_s"]) / 20
    run_mb = (many["store_mb"] - few["store_mb"]) / 20
    hours = run_s * 1e6 / 3600
    return (f"**10^6 runs** at 480 x 270 px, `pcss`, 100,000 triangles, llvmpipe: one run more costs {run_s:.2f} processor seconds and "
            f"{run_mb:.3f} MB of the store. A million are {hours:.0f} hours of one core, so {hours / 32:.1f} hours of one machine of 32 "
            f"cores whose shards keep them busy, and {run_mb * 1e6 / 1e3:.0f} GB. What comes on top, a truth a scene, camera and light and the "
            f"program's start, is {few['cpu_s'] - 4 * run_s:.1f} s here.\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", default=str(ROOT / "build" / "ci" / "cli" / "umbrameter"))
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    version = subprocess.run([options.program, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    parts = [f"{version}, {os.cpu_count()} cores, Mesa llvmpipe. Processor seconds of the whole process.\n"]
    parts += [series_text(options.program, *one_series) for one_series in SERIES]
    parts.append(million_text(options.program))
    text = "\n".join(parts)
    print(text)
    if options.write:
        PAGE.write_text(PAGE.read_text().split(MARK)[0] + MARK + text)


if __name__ == "__main__":
    main()
