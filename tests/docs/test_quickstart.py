#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test_quickstart.py SOURCE_DIR PROGRAM: the progress of quickstart.sh, the ten lines that it ends with, and the wrapper ./umbrameter. Without it the
first thing that people read could rank techniques wrongly. Exit codes: 0 fine, 1 not, 3 no GL here."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def check_progress(source):
    """A line with the time left of each phase; a failing build's own words stay."""
    given = {"packages": "dlstatus:1:50.0:Retrieving\nReading\n", "build": "@@5 10 Building\nFAILED: x.o\n",
             "measure": "umbrameter: plate (2 of 4), pcf: 50 %, 0:01 left\numbrameter: plate: done, 3 runs\numbrameter: error: no\n"}
    wanted = {"packages": ["quickstart: [1/4] downloading, 50 %, about T left"],
              "build": ["quickstart: [3/4] building, file 5 of 10, 50 %, about T left", "FAILED: x.o"],
              "measure": ["quickstart: [4/4] measuring, scene 2 of 4, 31 %, about T left", "umbrameter: error: no"]}
    for phase, text in given.items():
        told = subprocess.run(["awk", "-v", f"phase={phase}", "-f", source / "scripts/quickstart_progress.awk"], input=text,
                              check=True, capture_output=True, text=True).stdout
        told = re.sub(r"\d+:\d\d left", "T left", told).splitlines()  # a second may pass
        assert told == wanted[phase], told


def main():
    source, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    check_progress(source)
    if subprocess.run([program, "doctor"], capture_output=True).returncode == 3:
        print("test_quickstart: no usable GL", file=sys.stderr)
        return 3
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "validate", "plate", "--technique", "hard", "--technique", "pcf", "--technique", "pcss",
                        "--width", "160", "--height", "90", "--spp", "64", "--out", "out"], cwd=folder, check=True,
                       capture_output=True)
        results = pathlib.Path(folder) / "out/results.json"
        text = subprocess.run([sys.executable, source / "scripts/quickstart_summary.py", results, "7"], check=True,
                              capture_output=True, text=True).stdout
        print(text)
        lines = text.splitlines()
        runs = json.loads(results.read_text())["scenes"][0]["techniques"]
        rmse = {run["label"]: run["error"]["rmse"]["value"] for run in runs}
        ranked = sorted(rmse, key=rmse.get)
        assert [line.split()[0] for line in lines[1:4]] == ranked, (lines, rmse)
        assert f"{rmse[ranked[0]]:.4f}" in lines[1], lines[1]
        assert f"closest to the truth: {ranked[0]};" in lines[4], lines[4]
        total = {run["label"]: next(t["median_ms"] for t in run["pass_times"] if t["pass"] == "total") for run in runs}
        worth = [a for a in ranked if not any(total[b] <= total[a] and rmse[b] < rmse[a] for b in ranked)]
        assert f"best for their time: {', '.join(worth)} (" in lines[4], lines[4]
        assert len(lines) <= 10 and str(results.with_name("report.html")) in lines[5], lines
    # The wrapper runs a program of this checkout, from wherever it is called.
    if os.path.samefile(pathlib.Path(program).parent.parent.parent, source / "build"):
        build = pathlib.Path(program).parent.parent.name
        told = subprocess.run([source / "umbrameter", "--version"], cwd="/", check=True, capture_output=True, text=True,
                              env={**os.environ, "UMBRAMETER_BUILD": build}).stdout
        assert told == subprocess.run([program, "--version"], capture_output=True, text=True).stdout, told
    return 0


if __name__ == "__main__":
    sys.exit(main())
