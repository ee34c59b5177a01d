# SPDX-License-Identifier: Apache-2.0
"""LaTeX tables (booktabs) with intervals, from the rows of frames(...).runs."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple

from ._core import InputError

if TYPE_CHECKING:
    import pandas

__all__ = ["latex"]

ESCAPES = {"\\": r"\textbackslash{}", "&": r"\&", "%": r"\%", "$": r"\$", "#": r"\#", "_": r"\_", "{": r"\{", "}": r"\}",
           "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
CONTEXT = ("scene_hash", "width_px", "height_px", "samples_per_pixel", "seed", "device", "version", "commit")


def latex(runs: "pandas.DataFrame", value: str = "rmse", rows: str = "label", columns: str = "scene", caption: str = "",
          label: str = "", digits: int = 3) -> str:
    """A table of `value` with its 95 % interval, one row a run and one column a scene; `value` may be any number of the frame whose
    interval is there (rmse, mse, mse_difference, time_ms). Bold: the least of a column, and what its interval cannot be told from. A
    dash: not measured. Comments behind it hold the context of the numbers."""
    low, high = _ends(runs, value)
    cells = _cells(runs, value, low, high, rows, columns)
    names = list(dict.fromkeys(runs[rows]))
    across = list(dict.fromkeys(runs[columns]))
    least = {column: _least(cells, column, names) for column in across}
    lines = [_line([""] + [_escape(str(column)) for column in across]), r"\midrule"]
    for name in names:
        texts = [_text(cells.get((name, column)), least[column], digits) for column in across]
        lines.append(_line([_escape(str(name))] + texts))
    table = [r"\begin{tabular}{l" + "r" * len(across) + "}", r"\toprule", *lines, r"\bottomrule", r"\end{tabular}"]
    if caption or label:
        ends = [rf"\caption{{{caption}}}"] if caption else []
        ends += [rf"\label{{{label}}}"] if label else []
        table = [r"\begin{table}", r"\centering", *ends, *table, r"\end{table}"]
    return "\n".join([*table, *_context(runs)]) + "\n"


def _ends(runs: "pandas.DataFrame", value: str) -> Tuple[str, str]:
    for low, high in ((f"{value}_low", f"{value}_high"), ("time_low", "time_high")):
        if low in runs and value in runs and (low.startswith(value) or value == "time_ms"):
            return low, high
    with_interval = [name for name in runs if f"{name}_low" in runs] + (["time_ms"] if "time_low" in runs else [])
    if value not in runs:
        raise InputError(f"there is no column '{value}' (with an interval: {', '.join(with_interval) or 'none'})")
    raise InputError(f"'{value}' has no interval here (with one: {', '.join(with_interval) or 'none'})")


Cell = Tuple[float, float, float]


def _cells(runs: "pandas.DataFrame", value: str, low: str, high: str, rows: str, columns: str) -> Dict[Tuple[Any, Any], Cell]:
    cells: Dict[Tuple[Any, Any], Cell] = {}
    for _, row in runs.iterrows():
        place = (row[rows], row[columns])
        if place in cells:
            raise InputError(f"two runs are called {place[0]!r} in {place[1]!r}: choose rows first, by seed or camera")
        cells[place] = tuple(math.nan if row[name] is None else float(row[name]) for name in (value, low, high))
    return cells


def _least(cells: Mapping[Tuple[Any, Any], Cell], column: Any, names: Sequence[Any]) -> Optional[Cell]:
    measured = [cells[(name, column)] for name in names if (name, column) in cells and not math.isnan(cells[(name, column)][0])]
    return min(measured, default=None)


def _text(cell: Optional[Cell], least: Optional[Cell], digits: int) -> str:
    if cell is None or math.isnan(cell[0]):
        return "--"
    value, low, high = (f"{part:.{digits}f}" for part in cell)
    is_least = least is not None and (cell == least or cell[1] <= least[2])
    value = rf"\textbf{{{value}}}" if is_least else value
    return value if math.isnan(cell[1]) else rf"{value} {{\footnotesize [{low}, {high}]}}"


def _line(cells: Sequence[str]) -> str:
    return " & ".join(cells) + r" \\"


def _escape(text: str) -> str:
    return "".join(ESCAPES.get(letter, letter) for letter in text)


def _context(runs: "pandas.DataFrame") -> List[str]:
    lines = []
    for name in CONTEXT:
        if name in runs:
            values = ", ".join(str(value) for value in dict.fromkeys(runs[name].dropna()))
            lines.append(f"% {name}: {values}")
    return lines
