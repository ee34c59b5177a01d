# SPDX-License-Identifier: Apache-2.0
"""Tables in Markdown documents, between the markers of the script that measures them."""


def table(headings, rows):
    lines = ["| " + " | ".join(headings) + " |", "|" + " --- |" * len(headings)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def replace_measured(document, script, text):
    """Puts `text` between `<!-- measured: scripts/SCRIPT writes from here -->` and the next `<!-- to here -->`."""
    begin, end = f"<!-- measured: scripts/{script} writes from here -->", "<!-- to here -->"
    head, rest = document.read_text().split(begin)
    document.write_text(head + begin + "\n\n" + text + "\n\n" + end + rest.split(end, 1)[1])
