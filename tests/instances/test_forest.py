#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test_forest.py PROGRAM [TREES_A_SIDE [WIDTH HEIGHT]]: a forest of 100 x 100 instances of one tree of 9,888 triangles is loaded and
validated with hard and pcf within 2 GiB; copies would need twenty times as much. Prints what it took.
Exit codes: 0 fine, 1 not, 3 no GL device."""
import json
import math
import pathlib
import random
import resource
import struct
import subprocess
import sys
import tempfile
import time

MOST_GIB = 2.0
SPACING_M = 4.0


def add_ball(points, triangles, middle, radius, rings, segments):
    base = len(points)
    for i in range(rings + 1):
        high, wide = -math.cos(math.pi * i / rings), math.sin(math.pi * i / rings)
        for k in range(segments):
            turn = 2 * math.pi * k / segments
            points.append(tuple(m + radius * d for m, d in zip(middle, (wide * math.cos(turn), high, wide * math.sin(turn)))))
    for i in range(rings):
        for k in range(segments):
            low, high = base + i * segments, base + (i + 1) * segments
            a, b, c, d = low + k, low + (k + 1) % segments, high + (k + 1) % segments, high + k
            triangles += ([(a, d, c)] if i < rings - 1 else []) + ([(a, c, b)] if i > 0 else [])


def tree():
    """A stem and a crown of twenty balls."""
    points, triangles, dice = [], [], random.Random(1)
    for _ in range(20):
        middle = (dice.uniform(-.8, .8), dice.uniform(1.3, 3.4), dice.uniform(-.8, .8))
        add_ball(points, triangles, middle, dice.uniform(.3, .6), 16, 16)
    add_ball(points, triangles, (0, .8, 0), .15, 10, 16)
    return points, triangles


def turned(angle, axis):
    return [math.sin(angle / 2) * a for a in axis] + [math.cos(angle / 2)]


def nodes(side):
    dice, width = random.Random(2), side * SPACING_M
    yield {"mesh": 1}
    yield {"camera": 0, "translation": [0, .12 * width, .5 * width + 4], "rotation": turned(-.3, (1, 0, 0))}
    yield {"extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": turned(-.9, (1, 0, 0))}
    for i in range(side * side):
        place = [(cell - side / 2 + .5 + dice.uniform(-.3, .3)) * SPACING_M for cell in (i % side, i // side)]
        size = dice.uniform(.7, 1.3)
        yield {"mesh": 0, "translation": [place[0], 0, place[1]], "scale": [size, size * dice.uniform(.8, 1.2), size],
               "rotation": turned(dice.uniform(0, 6.28), (0, 1, 0))}


def write_forest(file, side):
    points, triangles = tree()
    half = .5 * side * SPACING_M + 2
    parts = [b"".join(struct.pack("<3f", *p) for p in points), b"".join(struct.pack("<3I", *t) for t in triangles),
             struct.pack("<12f", -half, 0, -half, half, 0, -half, half, 0, half, -half, 0, half), struct.pack("<6I", 0, 2, 1, 0, 3, 2)]
    counts = [len(points), 3 * len(triangles), 4, 6]
    starts = [sum(len(part) for part in parts[:i]) for i in range(4)]
    all_nodes = list(nodes(side))
    document = {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": list(range(len(all_nodes)))}], "scene": 0, "nodes": all_nodes,
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "name": "sun"}]}},
        "cameras": [{"type": "perspective", "perspective": {"yfov": .8, "znear": .1}}],
        "meshes": [{"name": name, "primitives": [{"attributes": {"POSITION": i}, "indices": i + 1}]} for name, i in (("tree", 0), ("ground", 2))],
        "accessors": [{"bufferView": i, "componentType": 5125 if i % 2 else 5126, "count": counts[i], "type": "SCALAR" if i % 2 else "VEC3"}
                      for i in range(4)],
        "bufferViews": [{"buffer": 0, "byteOffset": starts[i], "byteLength": len(parts[i])} for i in range(4)],
        "buffers": [{"byteLength": sum(map(len, parts)), "uri": "forest.bin"}]}
    file.write_text(json.dumps(document))
    (file.parent / "forest.bin").write_bytes(b"".join(parts))
    return len(triangles)


def main():
    program = sys.argv[1]
    side, width, height = (int(word) for word in (sys.argv[2:] + ["100", "320", "180"][len(sys.argv) - 2:]))
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "forest.gltf"
        triangles = write_forest(file, side)
        start = time.monotonic()
        run = subprocess.run([program, "validate", str(file), "--technique", "hard", "--technique", "pcf", "--width", str(width), "--height",
                              str(height), "--spp", "64", "--frames", "0", "--causes", "none", "--out", folder + "/out"], capture_output=True, text=True)
        took_s = time.monotonic() - start
    gib = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20
    print(run.stdout[-2000:], run.stderr[-2000:], sep="\n")
    print(f"{side * side} instances of {triangles} triangles: {took_s:.0f} s, {gib:.2f} GiB, exit code {run.returncode}")
    if run.returncode == 3:
        return 3
    return 0 if run.returncode in (0, 1) and "forest" in run.stdout and gib < MOST_GIB else 1


if __name__ == "__main__":
    sys.exit(main())
