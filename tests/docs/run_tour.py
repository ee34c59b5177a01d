#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""run_tour.py PROGRAM_FOLDER PAGE...: runs each page's console blocks in an empty folder. A command must end with 0; the lines
after it must come in its output in that order, "..." standing for anything. Without it the first pages that people try could
be wrong."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def steps(text):
    for block in re.findall(r"^```console\n(.*?)^```", text, re.M | re.S):
        command, expected = None, []
        for line in block.splitlines():
            if line.startswith("$ "):
                if command:
                    yield command, expected
                command, expected = line[2:], []
            else:
                expected.append(line)
        yield command, expected


def missing_line(output, expected):
    """The first expected line that does not follow; None when all do."""
    at = 0
    lines = output.splitlines()
    for wanted in expected:
        if wanted == "...":
            continue
        pattern = re.compile(".*".join(re.escape(part) for part in wanted.split("...")) + "$")
        while at < len(lines) and not pattern.match(lines[at]):
            at += 1
        if at == len(lines):
            return wanted
        at += 1
    return None


def self_test():
    assert list(steps("```console\n$ a\nb\n$ c\n```\n")) == [("a", ["b"]), ("c", [])]
    assert missing_line("one 5\ntwo", ["one ...", "..."]) is None
    assert missing_line("two\none", ["one", "two"]) == "two"
    assert missing_line("one", ["on"]) == "on"


def run_page(page, environment):
    """What is wrong with the page; None when nothing is."""
    all_steps = list(steps(page.read_text()))
    assert len(all_steps) >= 10, (page, len(all_steps))
    with tempfile.TemporaryDirectory() as folder:
        for command, expected in all_steps:
            run = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, text=True)
            print(f"$ {command}\n{run.stdout}{run.stderr}", flush=True)
            wanted = missing_line(run.stdout, expected)
            if run.returncode != 0 or wanted is not None:
                return f"{page.name}: '{command}' ended with {run.returncode}; not found: {wanted}"
    print(f"run_tour: {page.name}: {len(all_steps)} commands")
    return None


def main():
    self_test()
    program_folder, pages = os.path.abspath(sys.argv[1]), [pathlib.Path(page).resolve() for page in sys.argv[2:]]
    environment = {**os.environ, "PATH": program_folder + os.pathsep + os.environ["PATH"], "UMBRAMETER_HOME": "",
                   "UMBRAMETER_ASSETS": ""}
    doctor = subprocess.run(["umbrameter", "doctor"], env=environment, capture_output=True, text=True)
    if doctor.returncode == 3:
        print(f"run_tour: no usable GL: {doctor.stderr.strip()}", file=sys.stderr)
        return 3
    problems = [problem for page in pages if (problem := run_page(page, environment))]
    for problem in problems:
        print(f"run_tour: {problem}", file=sys.stderr)
    return 1 if problems or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
