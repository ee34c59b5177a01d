#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""prove_engine_versions.py PROGRAM [-n CHECKS] [PAGE]: does the regression gate pass another version of an engine that draws the same?

Records a baseline with the engines of engines/installed (or UMBRAMETER_ENGINES), checks it CHECKS times (50) with those of other_versions
in there, each time with another seed and 1 to 3 threads, then once with each engine's page breaking the bias. With PAGE the text between
the markers is written anew (docs/engines.md). Exit codes: 0 fine, 1 a check fails or a broken bias is not named, 3 engines are missing."""
import argparse
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from markdown import replace_measured, table

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ("box_contact", "plate")
SCENE_OF_BIAS = "box_contact"  # where the shadow of a bias that is too large comes off the box
SUITE = """schema = 1
title = "Engines of two versions"
scenes = {scenes}
width_px = 192
height_px = 108
samples_per_pixel = 64
"""
RUN = """[[run]]
label = "{label}"
technique = "{technique}"
values = {{ {values} }}
"""
# What each engine is asked for, the file that differs between versions, the line of its page that breaks the bias, and what that looks
# like. Filament's map holds the faces towards the light: too large a bias leaves the box's contact dark and lights the shadow's far end.
ENGINES = {
    "three": {"values": 'type = "pcf", shadowSide = "double", "shadow.mapSize" = 1024, "shadow.bias" = -0.002',
              "bytes": "three/build/three.module.js",
              "sound": "  return light;\n", "broken": "  shadow.bias = -0.04;\n  return light;\n", "named": "peter_panning"},
    "filament": {"values": 'type = "pcf"', "bytes": "filament/filament.wasm",
                 "sound": "shadows.apply(shadowValues(values));",
                 "broken": "shadows.apply({...shadowValues(values), constantBias: 0.2});", "named": "geometric_leak"},
}


class Missing(Exception):
    pass


def suite(folder, technique_of):
    """suite.toml in `folder`: each engine under its own label, from wherever `technique_of` says."""
    runs = [RUN.format(label=name, technique=technique_of(name), values=engine["values"]) for name, engine in ENGINES.items()]
    file = folder / "suite.toml"
    file.write_text(SUITE.format(scenes=json.dumps(SCENES)) + "".join(runs))
    return file


def broken_pages(folder):
    """The engines' folders with a page that breaks the bias, beside the code that they share."""
    shutil.copytree(ROOT / "engines" / "web", folder / "web")
    for name, engine in ENGINES.items():
        shutil.copytree(ROOT / "engines" / name, folder / name)
        page = folder / name / "page.mjs"
        text = page.read_text()
        assert text.count(engine["sound"]) == 1, f"{page} has changed: {engine['sound']!r} stands {text.count(engine['sound'])} times in it"
        page.write_text(text.replace(engine["sound"], engine["broken"]))


class Gate:
    def __init__(self, program, baseline):
        self.program, self.baseline = program, baseline

    def run(self, verb, suite_file, engines, *arguments):
        command = [self.program, "regress", verb, str(suite_file), "--baseline", str(self.baseline), "--json", *arguments]
        done = subprocess.run(command, env={**os.environ, "UMBRAMETER_ENGINES": str(engines)}, capture_output=True, text=True)
        if done.returncode == 3:
            raise Missing(done.stderr.strip())
        if done.returncode not in (0, 1) or not done.stdout:
            raise SystemExit(f"prove_engine_versions: {' '.join(command)} ended with {done.returncode}: {done.stderr}")
        return done.returncode, json.loads(done.stdout)


def require_engines(installed, other):
    for name, engine in ENGINES.items():
        for folder in (installed, other):
            if not (folder / "node_modules" / engine["bytes"]).exists():
                raise Missing(f"NOT CHECKED against {name}: it is not in '{folder}', and scripts/install_engines.sh installs it")


def file_hash(folder, name):
    return hashlib.sha256((folder / "node_modules" / ENGINES[name]["bytes"]).read_bytes()).hexdigest()[:12]


def check_unchanged(gate, suite_file, other, checks):
    """How many checks pass, and all of their cases."""
    passed, cases = 0, []
    for i in range(1, checks + 1):
        code, result = gate.run("check", suite_file, other, "--seed", str(i + 1), "--threads", str(i % 3 + 1))
        passed += code == 0
        cases += result["cases"]
        for case in result["cases"]:
            if case["outcome"] == "fail":
                print(f"check {i} fails: {case['scene']}, {case['label']}: {case['kind']}: {case['message']}", file=sys.stderr)
        print(f"prove_engine_versions: {passed} of {i} checks pass", file=sys.stderr)
    return passed, cases


def versions_of(cases, name):
    """As the engine itself says, recorded and checked; the device's name follows after a comma."""
    pairs = {tuple(case[when]["device"].split(",")[0] for when in ("before", "now"))
             for case in cases if case["label"] == name and case["now"]}
    if len(pairs) != 1:
        raise SystemExit(f"prove_engine_versions: {name} was checked with more than one pair of versions, or with none: {pairs}")
    return pairs.pop()


def rows_of(cases, installed, other):
    rows = []
    for name in ENGINES:
        recorded, checked = versions_of(cases, name)
        hashes = file_hash(installed, name), file_hash(other, name)
        if recorded == checked or hashes[0] == hashes[1]:
            raise SystemExit(f"prove_engine_versions: {name} is the same twice: {recorded}, {checked}, {hashes}")
        outcomes = [case["outcome"] for case in cases if case["label"] == name]
        counts = ", ".join(f"{outcomes.count(kind)} {kind}" for kind in ("pass", "undecided", "better", "fail") if kind in outcomes)
        rows.append((f"{recorded}, {hashes[0]}", f"{checked}, {hashes[1]}", counts))
    return rows


def prove(program, checks, installed, other, folder):
    sound, broken = folder / "sound", folder / "broken"
    sound.mkdir()
    broken.mkdir()
    gate = Gate(program, folder / "baseline")
    suite_file = suite(sound, lambda name: name)
    code, recorded = gate.run("record", suite_file, installed)
    if code != 0:
        raise SystemExit(f"prove_engine_versions: nothing can be recorded: {recorded}")
    passed, cases = check_unchanged(gate, suite_file, other, checks)
    rows = rows_of(cases, installed, other)
    broken_pages(broken)
    _, result = gate.run("check", suite(broken, lambda name: f"./{name}"), other)
    kinds = {case["label"]: case["kind"] if case["outcome"] == "fail" else case["outcome"]
             for case in result["cases"] if case["scene"] == SCENE_OF_BIAS}
    rows = [(*row, kinds[name].replace("_", " ")) for name, row in zip(ENGINES, rows)]
    text = f"{passed} of {checks} checks under the other versions pass, on {' and '.join(SCENES)}.\n\n" \
           + table(("recorded, SHA-256 of its code", "checked", "cases", f"its bias broken, on {SCENE_OF_BIAS}"), rows)
    return text, passed == checks and kinds == {name: engine["named"] for name, engine in ENGINES.items()}, kinds


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("page", nargs="?")
    parser.add_argument("-n", type=int, default=50)
    arguments = parser.parse_args()
    installed = pathlib.Path(os.environ.get("UMBRAMETER_ENGINES") or ROOT / "engines" / "installed").absolute()
    other, program = installed / "other_versions", os.path.abspath(arguments.program)
    try:
        require_engines(installed, other)
        with tempfile.TemporaryDirectory() as folder:
            text, is_proved, kinds = prove(program, arguments.n, installed, other, pathlib.Path(folder))
    except Missing as missing:
        print(f"prove_engine_versions: SKIPPED: {missing}", file=sys.stderr)
        return 3
    print(text)
    if arguments.page:
        replace_measured(pathlib.Path(arguments.page), "prove_engine_versions.py", text)
    if not is_proved:
        print(f"prove_engine_versions: not proved; the broken biases are named {kinds}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
