# SPDX-License-Identifier: Apache-2.0
"""What is not carried over, gathered for one line a kind."""


LONGEST = 200  # of Blender's own words


class Refused(Exception):
    """Nothing can be written; the message is one sentence."""


def last_line(text):
    """The last one that names an error, or else the last; assertions can be long."""
    lines = [line.strip() for line in text.splitlines() if line.strip()] or ["no words"]
    return next((line for line in reversed(lines) if "Error" in line), lines[-1])[:LONGEST]


class Said:
    def __init__(self):
        self.names = {}

    def add(self, what, name):
        names = self.names.setdefault(what, [])
        if name not in names:
            names.append(name)

    def lines(self):
        """`what (count: the first names)`."""
        lines = []
        for what, names in self.names.items():
            shown = ", ".join(f"'{name}'" for name in names[:3]) + (", ..." if len(names) > 3 else "")
            lines.append(f"{what} ({len(names)}: {shown})")
        return lines
