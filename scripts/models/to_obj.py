#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""to_obj.py FILE OUT.obj COMMENT: a mesh as npm packages carry it, as Wavefront OBJ. Numbers are kept as they are written.

FILE is JavaScript that sets exports.positions and exports.cells, which is read and not run, or PLY in text, maybe .gz.
Exit codes: 0 fine, 1 not such a file, with one sentence.
"""
import gzip
import pathlib
import re
import sys


def of_javascript(text):
    found = {name: rows for name, rows in re.findall(r"exports\.(positions|cells)\s*=\s*\[(\[[^;]*?\])\]", text)}
    if len(found) != 2:
        raise ValueError("it does not set exports.positions and exports.cells")
    rows = {name: [row.split(",") for row in re.findall(r"\[([^\[\]]*)\]", text)] for name, text in found.items()}
    return rows["positions"], [[int(index) for index in row] for row in rows["cells"]]


def of_ply(text):
    head, _, body = text.partition("end_header\n")
    if not head.startswith("ply\nformat ascii 1.0\n") or not body:
        raise ValueError("it is no PLY file in text")
    counts = [int(count) for count in re.findall(r"^element (?:vertex|face) (\d+)$", head, re.M)]
    properties = re.findall(r"^property (?!list)\S+ (\S+)$", head, re.M)
    if len(counts) != 2 or properties[:3] != ["x", "y", "z"]:
        raise ValueError("its header names other elements than vertices x, y, z and faces")
    lines = [line.split() for line in body.splitlines()]
    faces = [[int(index) for index in line[1:]] for line in lines[counts[0]:sum(counts)]]
    return [line[:3] for line in lines[:counts[0]]], faces


def read(path):
    data = path.read_bytes()
    name = path.name
    if name.endswith(".gz"):
        data, name = gzip.decompress(data), name[:-3]
    text = data.decode()
    return of_ply(text) if name.endswith(".ply") else of_javascript(text)


def obj_text(positions, faces, comment):
    if not positions or not faces:
        raise ValueError("it has no vertices or no faces")
    for row in positions:
        if len(row) != 3:
            raise ValueError(f"a position has {len(row)} numbers")
        [float(number) for number in row]
    if min(map(min, faces)) < 0 or max(map(max, faces)) >= len(positions):
        raise ValueError("a face refers to a vertex that is not there")
    lines = [f"# {comment}", *("v " + " ".join(row) for row in positions),
             *("f " + " ".join(str(index + 1) for index in face) for face in faces)]
    return "\n".join(lines) + "\n"


def main():
    source, out, comment = sys.argv[1:]
    try:
        text = obj_text(*read(pathlib.Path(source)), comment)
    except (ValueError, OSError, EOFError) as why:
        print(f"to_obj.py: {source}: {why}", file=sys.stderr)
        return 1
    pathlib.Path(out).write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
