#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails when an include crosses a room's arrow, or a heavy library leaves its one home."""
import pathlib
import re
import sys

# A room may include itself and these.
ARROWS = {
    "core": set(),
    "scenes": {"core"},
    "metrics": {"core"},
    "reference": {"core", "scenes"},
    "realtime": {"core", "scenes"},
    "engines": {"core", "scenes"},
    "store": {"core"},
    "study": {"core", "scenes", "metrics", "store"},
    "report": {"core", "store", "study"},
    "view": {"core", "scenes", "metrics", "reference", "realtime", "store", "study"},
    "cli": {"core", "scenes", "metrics", "reference", "realtime", "engines", "store", "study", "report", "view"},
    "python": {"core", "scenes", "metrics", "reference", "realtime", "engines", "store", "study"},
}
# Include prefix -> where it may appear.
HOMES = {
    "toml++/": ("core/toml.cpp",),
    "CGAL/": ("reference/exact/",),
    "embree3/": ("reference/",),
    "epoxy/": ("realtime/", "view/", "tests/gpu/"),
    "GLFW/": ("view/",),
    "imgui": ("view/",),
    "backends/imgui": ("view/",),
    "EGL/": ("realtime/",),
    "OpenImageIO/": ("core/image_io.cpp", "cli/"),
    "tiny_obj_loader.h": ("scenes/",),
    "assimp/": ("scenes/assimp/",),
    "CLI/": ("cli/",),
    "sqlite3.h": ("store/",),
    "pybind11/": ("python/",),
    "nlopt.hpp": ("study/tune/",),
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


def self_test():
    """The check itself must be able to fail."""
    assert list(problems_in(pathlib.PurePosixPath("metrics/x.cpp"), '#include "reference/reference.h"\n'))
    assert list(problems_in(pathlib.PurePosixPath("study/x.cpp"), "#include <embree3/rtcore.h>\n"))
    assert not list(problems_in(pathlib.PurePosixPath("cli/x.cpp"), '#include "study/results.h"\n'))


def main():
    self_test()
    root = pathlib.Path(sys.argv[1])
    files = [f for room in [*ARROWS, "tests", "bench"] for f in (root / room).rglob("*") if f.suffix in (".cpp", ".h")]
    found = [p for f in files for p in problems_in(pathlib.PurePosixPath(f.relative_to(root)), f.read_text())]
    print("\n".join(found) or f"{len(files)} files respect the arrows")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
