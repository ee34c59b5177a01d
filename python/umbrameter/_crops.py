# SPDX-License-Identifier: Apache-2.0
"""Pictures with an enlarged crop in a corner."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Sequence, Tuple

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FRAME = "#E69F00"
BORDER = "0.5"
INSET_SHARE = 0.42


class Box(NamedTuple):
    """Pixels [top, top + side) x [left, left + side)."""

    left: int
    top: int
    side: int


def box_around(at: Tuple[int, int], side: int, shape: Tuple[int, int]) -> Box:
    """Around the pixel (x, y), moved into the picture of `shape` (height, width)."""
    height, width = shape
    side = min(side, height, width)
    x, y = at
    return Box(int(np.clip(x - side // 2, 0, width - side)), int(np.clip(y - side // 2, 0, height - side)), side)


def worst_place(errors: Sequence[npt.NDArray[Any]], side: int) -> Tuple[int, int]:
    """The middle (x, y) of the square of `side` pixels with the largest sum of squared errors over all pictures."""
    squares = sum(np.nan_to_num(error) ** 2 for error in errors)
    height, width = squares.shape
    side = min(side, height, width)
    sums = np.zeros((height + 1, width + 1))
    sums[1:, 1:] = squares.cumsum(0).cumsum(1)
    total = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    top, left = np.unravel_index(np.argmax(total), total.shape)
    return int(left) + side // 2, int(top) + side // 2


def show(axes: "Axes", values: npt.NDArray[Any], box: Box, **colours: Any) -> Any:
    """The picture, a frame around the box, and the box enlarged in the corner farthest from it."""
    height, width = values.shape
    shown = axes.imshow(values, interpolation="nearest", **colours)
    framed(axes, BORDER, 0.5)
    outline(axes, box)
    across = INSET_SHARE * height / width
    is_left, is_top = box.left + box.side / 2 < width / 2, box.top + box.side / 2 < height / 2
    inset = axes.inset_axes([1 - across if is_left else 0.0, 0.0 if is_top else 1 - INSET_SHARE, across, INSET_SHARE])
    inset.imshow(values[box.top:box.top + box.side, box.left:box.left + box.side], interpolation="nearest", **colours)
    framed(inset, FRAME, 1.2)
    return shown


def framed(axes: "Axes", colour: str, linewidth: float) -> None:
    """A picture's border instead of a plot's axes."""
    axes.set(xticks=(), yticks=())
    for spine in axes.spines.values():
        spine.set(visible=True, color=colour, linewidth=linewidth)


def outline(axes: "Axes", box: Box) -> None:
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle((box.left - 0.5, box.top - 0.5), box.side, box.side, fill=False, edgecolor=FRAME, linewidth=1.0))
