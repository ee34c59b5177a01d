#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes realtime/shaders/lib/disk_tables.glsl: point sets on the unit disk for techniques with a table of taps.

Poisson: darts that keep a distance, in the order they were thrown. Blue noise: each point as far as can be from those
before it, so that every prefix is spread evenly. The rim repels too: otherwise points crowd on it and a filter over
them is wider than its radius. The same output everywhere; takes no arguments.
"""

import math
import pathlib
import random

OUTPUT = pathlib.Path(__file__).resolve().parent.parent / "realtime/shaders/lib/disk_tables.glsl"
COUNT = 64
SEED = 1
CANDIDATES = 4096
THROWS = 20000
POISSON_DISTANCE = 0.18  # the largest hundredth at which all darts find room
RIM = 3.5  # measured: prefixes of blue noise from 8 on have a uniform disk's mean squared radius, 1/2, within 0.06

HEADER = f"""// SPDX-License-Identifier: Apache-2.0
// Point sets on the unit disk, {COUNT} each. Written by scripts/disk_tables.py, checked by tests/gpu.
"""


def random_point(generator):
    radius = math.sqrt(generator.random())
    angle = 2.0 * math.pi * generator.random()
    return radius * math.cos(angle), radius * math.sin(angle)


def gap(point, others):
    """Distance to the nearest of `others`, or RIM times that to the rim where this is less."""
    to_rim = RIM * (1.0 - math.hypot(*point))
    return min([to_rim] + [math.dist(point, other) for other in others])


def poisson_disk():
    generator = random.Random(SEED)
    darts = []
    for _ in range(THROWS):
        point = random_point(generator)
        if len(darts) < COUNT and gap(point, darts) >= POISSON_DISTANCE:
            darts.append(point)
    return darts


def blue_noise_disk():
    generator = random.Random(SEED)
    points = [(0.0, 0.0)]
    while len(points) < COUNT:
        candidates = [random_point(generator) for _ in range(CANDIDATES)]
        points.append(max(candidates, key=lambda candidate: gap(candidate, points)))
    return points


def table(name, doc, points):
    rows = [", ".join(f"vec2({x:.6f}, {y:.6f})" for x, y in points[i : i + 4]) for i in range(0, COUNT, 4)]
    body = ",\n  ".join(rows)
    return f"\n// const: {doc}\nconst vec2 {name}[{COUNT}] = vec2[](\n  {body});\n"


def text():
    return (
        HEADER
        + table("kPoissonDisk", "thrown darts; a prefix keeps the distance but leaves holes", poisson_disk())
        + table("kBlueNoiseDisk", "progressive: every prefix is spread evenly", blue_noise_disk())
    )


if __name__ == "__main__":
    OUTPUT.write_text(text())
