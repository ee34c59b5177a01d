# SPDX-License-Identifier: Apache-2.0
"""How figures look, and what matplotlib needs to be told for it."""
from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any, Iterator, Tuple

from ._core import InputError, MachineError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTHS_IN = {"column": 3.5, "page": 7.16}
# Okabe and Ito's, without the yellow that white paper swallows.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
DASHES = ((0, (5, 1.5)), (0, (1.5, 1.2)), (0, (5, 1.2, 1.2, 1.2)), (0, (3, 1, 1, 1, 1, 1)), (0, (8, 2)))
STYLE = {
    "font.size": 8, "axes.titlesize": 8, "axes.labelsize": 8, "xtick.labelsize": 7, "ytick.labelsize": 7, "legend.fontsize": 7,
    "axes.linewidth": 0.6, "lines.linewidth": 1.2, "pdf.fonttype": 42, "ps.fonttype": 42, "savefig.dpi": 300,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False,
}


def pyplot() -> Any:
    try:
        from matplotlib import pyplot as module
    except ImportError:
        raise MachineError("figures need matplotlib, which is not installed (Debian: python3-matplotlib)") from None
    return module


def width_in(width: str) -> float:
    if width not in WIDTHS_IN:
        raise InputError(f"width is '{width}', not {' or '.join(WIDTHS_IN)}")
    return WIDTHS_IN[width]


@contextlib.contextmanager
def one_plot(width: str, aspect: float) -> Iterator[Tuple["Figure", "Axes"]]:
    """A figure of one plot, `aspect` times as high as it is wide."""
    wide = width_in(width)
    with pyplot().rc_context(STYLE):
        yield pyplot().subplots(figsize=(wide, wide * aspect), layout="constrained")


def point_look(i: int) -> Tuple[str, str]:
    """Colour and marker of the i-th point: 49 pairs, none twice."""
    return COLOURS[i % len(COLOURS)], MARKERS[(i + i // len(COLOURS)) % len(MARKERS)]


def line_look(i: int) -> Tuple[str, Any]:
    """Colour and dashes of the i-th line: 30 pairs, none twice. Black and solid is the truth's."""
    return COLOURS[i % 6], DASHES[(i + i // 30) % len(DASHES)]
