#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_third_party.py SOURCE_DIR BUILD_DIR: THIRD_PARTY.md against what is linked and what is compiled in. Without it a
library could come in with a licence nobody looked at, or the GPL ones of the exact oracle reach the program."""
import pathlib
import re
import subprocess
import sys

ROW = re.compile(r"^\| ([^|]+) \| ([^|]+) \| ([^|]+) \| ([^|]+) \| ([^|]+) \| (all|program|exact|python|report|test) \|$")
# Who links what: the owners whose libraries a kind of target may use.
MAY_USE = {"program": {"all", "program"}, "exact": {"all", "exact"}, "python": {"all", "program", "python"},
           "test": {"all", "program", "exact", "python", "test"}}
GPL = re.compile(r"(?<!L)GPL-\d-or-later(?! with the GCC runtime exception)")


def read_rows(text):
    rows = [ROW.match(line) for line in text.splitlines()]
    return [{"name": m[1], "licence": m[3], "sonames": set(m[4].split()) - {"-"}, "headers": set(m[5].split()) - {"-"},
             "of": m[6]} for m in rows if m]


def owner_of_soname(rows, soname):
    stem = re.sub(r"(-[\d_.]+)?\.so.*$", "", soname)
    return next((row for row in rows if stem in row["sonames"] or soname.split(".so")[0] in row["sonames"]), None)


def owner_of_header(rows, header):
    """`header` below /usr/include or /usr/lib/gcc, without a leading architecture."""
    first = header.split("/")[0] + ("/" if "/" in header else "")
    for row in rows:
        if first in row["headers"]:
            return row
    if "/" not in header:
        return next(row for row in rows if "/usr/include/*.h" in row["headers"])
    return None


def kind_of(path):
    if path.startswith(("tests/", "bench/", "fuzz/")):
        return "test"
    if path.startswith("reference/exact/"):
        return "exact"
    return "python" if path.startswith("python/") else "program"


def relative_header(path):
    for root in ("/usr/include/x86_64-linux-gnu/", "/usr/include/", "/usr/lib/"):
        if path.startswith(root):
            return path[len(root):]
    return None


def check_headers(rows, deps_text):
    """`ninja -t deps`: an object and, indented, what it was compiled from."""
    found, kind, pairs = set(), None, set()
    for line in deps_text.splitlines():
        if line and not line.startswith(" "):
            kind = kind_of(line.split(":")[0])
        elif line.strip():
            header = relative_header(line.strip())
            if header and "/cmake" not in header:
                pairs.add((kind, header.split("/")[0] + ("/" if "/" in header else "")))
    for kind, first in sorted(pairs):
        row = owner_of_header(rows, first + ("x.h" if first.endswith("/") else ""))
        if row is None:
            found.add(f"objects of {kind} include <{first}>, which THIRD_PARTY.md does not list")
        elif row["of"] not in MAY_USE[kind]:
            found.add(f"objects of {kind} include <{first}> of {row['name']}, which is for {row['of']} alone")
    return found, len(pairs)


def needed(binary):
    text = subprocess.run(["objdump", "-p", binary], check=True, capture_output=True, text=True).stdout
    return re.findall(r"NEEDED\s+(\S+)", text)


def check_sonames(rows, kind, binary, sonames):
    for soname in sonames:
        row = owner_of_soname(rows, soname)
        if row is None:
            yield f"{binary} needs {soname}, which THIRD_PARTY.md does not list"
        elif row["of"] not in MAY_USE[kind]:
            yield f"{binary} needs {soname} of {row['name']}, which is for {row['of']} alone"


def check_licences(rows):
    for row in rows:
        if GPL.search(row["licence"]) and row["of"] not in ("exact", "test"):
            yield f"{row['name']} is {row['licence']} but for {row['of']}"


def self_test(rows):
    """The check itself must be able to fail."""
    assert list(check_sonames(rows, "program", "x", ["libnew.so.1"]))
    assert list(check_sonames(rows, "program", "x", ["libgmp.so.10"]))
    assert not list(check_sonames(rows, "exact", "x", ["libgmp.so.10", "libImath-3_1.so.29"]))
    assert check_headers(rows, "cli/a.o: #deps 1\n    /usr/include/CGAL/x.h\n")[0]
    assert check_headers(rows, "cli/a.o: #deps 1\n    /usr/include/unknown/x.h\n")[0]
    assert not check_headers(rows, "reference/exact/a.o: #deps 1\n    /usr/include/CGAL/x.h\n")[0]
    assert list(check_licences([{"name": "x", "licence": "GPL-3-or-later", "of": "program"}]))
    assert not list(check_licences([{"name": "x", "licence": "LGPL-3-or-later", "of": "program"}]))


def main():
    source, build = map(pathlib.Path, sys.argv[1:3])
    rows = read_rows((source / "THIRD_PARTY.md").read_text())
    assert len(rows) > 20, f"only {len(rows)} rows could be read"
    self_test(rows)
    problems = set(check_licences(rows))
    binaries = {"program": build / "cli/umbrameter", "exact": build / "cli/umbrameter-exact"}
    for module in build.glob("python/umbrameter/_core*.so"):
        binaries["python"] = module
    for kind, binary in binaries.items():
        problems.update(check_sonames(rows, kind, binary.name, needed(binary)))
    deps = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], check=True, capture_output=True, text=True).stdout
    found, pairs = check_headers(rows, deps)
    problems |= found
    print("\n".join(sorted(problems)) or
          f"{len(rows)} rows cover {len(binaries)} binaries and {pairs} pairs of target and header folder")
    return 1 if problems or pairs < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
