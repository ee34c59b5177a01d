#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when an include crosses a room's arrow, folders of a room include each other in a circle, plans include each other, or
a heavy library leaves its one home."""
import pathlib
import re
import sys

# A room may include itself and these.
GROUND = {"core", "scenes"}
TRUTHS = {"metrics", "reference", "realtime", "engines"}
ARROWS = {
    "core": set(),
    "scenes": {"core"},
    "metrics": {"core"},
    "reference": GROUND,
    "realtime": GROUND,
    "engines": GROUND,
    "store": {"core"},
    "results": GROUND | {"metrics"},
    "lab": GROUND | {"metrics", "store", "results"},
    "study": GROUND | {"metrics", "store", "results", "lab"},
    "report": {"core", "metrics", "store", "results", "lab", "study"},
    "view": GROUND | {"metrics", "reference", "realtime", "results", "lab"},
    "cli": GROUND | TRUTHS | {"store", "results", "lab", "study", "report", "view"},
    "python": GROUND | TRUTHS | {"store", "results", "lab"},
}
# In a circle of folders a room's own files count as a folder, but for these rooms: theirs are both the face and the floor.
FACE_AND_FLOOR = ("scenes", "realtime", "engines")
# The folders of these rooms never include each other.
APART = ("study",)
# Include prefix -> where it may appear.
HOMES = {
    "toml++/": ("core/toml.cpp",),
    "CGAL/": ("reference/exact/",),
    "embree3/": ("reference/", "realtime/scene_data/box_tree.cpp"),
    "epoxy/": ("realtime/", "view/", "tests/gpu/"),
    "GLFW/": ("view/",),
    "imgui": ("view/",),
    "backends/imgui": ("view/",),
    "EGL/": ("realtime/",),
    "OpenImageIO/": ("core/image_io.cpp", "cli/", "report/html.cpp"),
    "tiny_obj_loader.h": ("scenes/",),
    "assimp/": ("scenes/assimp/",),
    "pugixml.hpp": ("scenes/mitsuba/", "report/regress_output_data.cpp"),
    "CLI/": ("cli/",),
    "sqlite3.h": ("store/",),
    "pybind11/": ("python/",),
    "nlopt.hpp": ("study/tune/search/",),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def problems_in(path: pathlib.PurePosixPath, text: str):
    room = path.parts[0]
    for number, line in enumerate(text.splitlines(), 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        target = found.group(2)
        target_room = target.split("/")[0]
        if found.group(1) == '"' and room in ARROWS and target_room in ARROWS:
            if target_room != room and target_room not in ARROWS[room]:
                yield f"{path}:{number}: {room} must not include {target}"
        for prefix, homes in HOMES.items():
            if target.startswith(prefix) and path.parts[0] != "bench" and not str(path).startswith(homes):
                yield f"{path}:{number}: <{target}> belongs in {' or '.join(homes)}"


def folder_of(path: pathlib.PurePosixPath):
    """Two levels: "study/tune", or "study" for a room's own files."""
    return "/".join(path.parts[: min(2, len(path.parts) - 1)])


def folder_includes(files):
    """{(folder, other folder of the same room): a place where it is included}"""
    found = {}
    for path, text in files.items():
        for number, line in enumerate(text.splitlines(), 1):
            include = INCLUDE.match(line)
            if not include or include.group(1) != '"' or include.group(2).split("/")[0] != path.parts[0]:
                continue
            edge = folder_of(path), folder_of(pathlib.PurePosixPath(include.group(2)))
            if edge[0] != edge[1]:
                found.setdefault(edge, f"{path}:{number}")
    return found


def reached_from(folder, edges):
    reached, ahead = set(), [folder]
    while ahead:
        here = ahead.pop()
        for target in (b for a, b in edges if a == here and b not in reached):
            reached.add(target)
            ahead.append(target)
    return reached


def folder_problems(files):
    edges = {(a, b): place for (a, b), place in folder_includes(files).items()
             if not {a, b} & set(FACE_AND_FLOOR)}
    for (a, b), place in sorted(edges.items()):
        if a in reached_from(b, edges):
            yield f"{place}: {a} includes {b}, which includes it again: a circle of folders"
        elif a.startswith(tuple(room + "/" for room in APART)) and "/" in b:
            yield f"{place}: {a} must not include its sibling {b}"


def self_test():
    """The check itself must be able to fail."""
    def of(name):
        return pathlib.PurePosixPath(name)
    assert list(problems_in(of("metrics/x.cpp"), '#include "reference/reference.h"\n'))
    assert list(problems_in(of("results/x.cpp"), '#include "lab/score.h"\n'))
    assert list(problems_in(of("study/x.cpp"), "#include <embree3/rtcore.h>\n"))
    assert not list(problems_in(of("cli/x.cpp"), '#include "results/results.h"\n'))
    down = {of("lab/a.cpp"): '#include "lab/causes/b.h"\n'}
    assert not list(folder_problems(down))
    assert list(folder_problems(down | {of("lab/causes/b.cpp"): '#include "lab/a.h"\n'}))
    around = {of(f"metrics/{a}/x.cpp"): f'#include "metrics/{b}/y.h"\n' for a, b in ("ab", "bc", "ca")}
    assert len(list(folder_problems(around))) == 3
    assert list(folder_problems({of("study/tune/x.cpp"): '#include "study/grid/y.h"\n'}))
    assert not list(folder_problems({of("study/tune/x.cpp"): '#include "study/tune/search/y.h"\n#include "study/z.h"\n'}))


def main():
    self_test()
    root = pathlib.Path(sys.argv[1])
    paths = [f for room in [*ARROWS, "tests", "bench"] for f in (root / room).rglob("*") if f.suffix in (".cpp", ".h")]
    files = {pathlib.PurePosixPath(f.relative_to(root)): f.read_text() for f in paths}
    found = [p for path, text in files.items() for p in problems_in(path, text)]
    found += folder_problems({path: text for path, text in files.items() if path.parts[0] in ARROWS})
    print("\n".join(found) or f"{len(files)} files respect the arrows")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
