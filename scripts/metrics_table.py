#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""metrics_table.py PROGRAM [--check]: writes the catalogue of metrics into docs/metrics.md, or fails where the table there is another."""
import json
import pathlib
import subprocess
import sys

import markdown

DOCUMENT = pathlib.Path(__file__).resolve().parent.parent / "docs" / "metrics.md"
HEADINGS = ("metric", "called", "group", "unit", "better", "gate", "in `faults`", "what it is")
KEYS = ("label", "group", "unit")


def gate(limits):
    """What may be added to the baseline's, and the class that says so."""
    return f"{limits['class']}: {limits['excess']:g} + {100 * limits['share']:g} %" if limits else ""


def row(metric):
    term = metric["term"]
    words = [f"`{metric['key']}`", *(metric[key] for key in KEYS), metric["better"].replace("_", " "), gate(metric["gate"]),
             f"{term['name']} / {term['one']:g}" if term else "", metric["doc"]]
    return [word.replace("|", "\\|") for word in words]


def main():
    answer = subprocess.run([sys.argv[1], "metrics", "--json"], check=True, capture_output=True, text=True).stdout
    text = markdown.table(HEADINGS, [row(metric) for metric in json.loads(answer)["metrics"]])
    if "--check" not in sys.argv:
        markdown.replace_measured(DOCUMENT, "metrics_table.py", text)
    elif text not in DOCUMENT.read_text():
        sys.exit(f"{DOCUMENT.name}: the table of metrics is not that of the program (scripts/metrics_table.py PROGRAM)")


main()
