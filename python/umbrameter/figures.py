# SPDX-License-Identifier: Apache-2.0
"""Figures for papers, by matplotlib: time against error, penumbrae, crops of errors, classes of faults.

Sizes are those of a two-column page: width="column" (3.5 in) or "page" (7.16 in). Colours are Okabe and Ito's, which people of
any colour vision tell apart; lines and points differ in dashes and shape, too. save(figure, "name.pdf") embeds its fonts.
"""
from __future__ import annotations

import math
import os
from typing import TYPE_CHECKING, Any, List, Mapping, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import InputError
from ._crops import BORDER, box_around, framed, show, worst_place
from ._picture import Picture
from ._plotting import STYLE, line_look, one_plot, point_look, pyplot, width_in
from ._score import FAULTS, PROFILE_OUTCOMES, Score, score

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["error_crops", "fault_classes", "front", "penumbra", "save"]

ERROR_SCALE = 0.25
"""Ends of the signed error's scale, as in the program's pictures."""
DEVIATES_95 = 1.96
UNSCORED = "0.6"
TITLE_IN = 0.22
LEAST_SHARE = 0.0005


def front(runs: "pandas.DataFrame", scene: Optional[str] = None, width: str = "column") -> "Figure":
    """Time against error, of rows of `frames(...).runs` that have both, on logarithmic axes. Bars are 95 % intervals (of a sweep's
    times: the median absolute deviation). Filled points are on the front: no other run's bars lie below both of theirs."""
    rows = _of_scene(runs, scene)
    rows = rows[rows["rmse"].gt(0) & rows["time_ms"].gt(0)].sort_values("time_ms").reset_index(drop=True)
    if rows.empty:
        raise InputError("no run has both a time and an error: bench, or sweep with time=True")
    times = _time_bars(rows)
    on_front = _on_front(rows, *times)
    with one_plot(width, 0.95 if width == "column" else 0.5) as (figure, axes):
        best = rows[on_front & (rows["rmse"] <= rows["rmse"].cummin())]
        axes.step(best["time_ms"], best["rmse"], where="post", color="0.7", linewidth=0.8, zorder=1)
        for i, row in rows.iterrows():
            colour, marker = point_look(i)
            low = max(row["rmse_low"], 0.2 * row["rmse"])  # a logarithmic axis has no zero
            axes.errorbar(row["time_ms"], row["rmse"], color=colour, marker=marker, markersize=4.5, linestyle="none",
                          xerr=[[row["time_ms"] - times[0][i]], [times[1][i] - row["time_ms"]]],
                          yerr=[[row["rmse"] - low], [row["rmse_high"] - row["rmse"]]],
                          markerfacecolor=colour if on_front[i] else "white", elinewidth=0.8, label=row["label"], zorder=2)
        _logarithmic(axes)
        axes.set_xlabel("time of a frame (ms" + (", software rasteriser)" if _is_software(rows) else ")"))
        axes.set_ylabel("RMSE of visibility")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncol=2 if width == "column" else 4, handletextpad=0.3,
                    columnspacing=1.0)
    return figure


def penumbra(truth: Picture, pictures: Mapping[str, Picture], at: Optional[Tuple[int, int]] = None,
             width: str = "column") -> "Figure":
    """Visibility across one penumbra: the truth with its 95 % band, and each picture by name. `at` is a pixel (x, y) on it; default:
    the widest whole one. The inset shows where it is."""
    scores = _scores(pictures, truth)
    x, y = at if at is not None else _widest_penumbra(next(iter(scores.values())))
    walk = max((one.walk(x, y) for one in scores.values()), key=lambda walk: len(walk.rows))
    pixels, distance = (walk.rows, walk.columns), walk.distance_world
    true, band = truth["visibility"][pixels], DEVIATES_95 * truth["visibility_se"][pixels]
    with one_plot(width, 0.68) as (figure, axes):
        axes.fill_between(distance, true - band, true + band, color="0.75", linewidth=0)
        axes.plot(distance, true, color="black", linewidth=1.8, label="truth")
        for i, (name, picture) in enumerate(pictures.items()):
            colour, dashes = line_look(i)
            axes.plot(distance, picture["visibility"][pixels], color=colour, linestyle=dashes, label=name)
        axes.set_xlabel("distance across the shadow's edge (scene's units)")
        axes.set_ylabel("visibility")
        axes.set_ylim(-0.04, 1.04)
        axes.set_xlim(distance[0], distance[-1])
        axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 1.0), ncol=4, handlelength=2.4, columnspacing=1.0, borderpad=0.0)
        inset = axes.inset_axes([0.6, 0.06, 0.38, 0.38])
        inset.imshow(truth["visibility"], cmap="gray", vmin=0, vmax=1)
        inset.plot(walk.columns[[0, -1]], walk.rows[[0, -1]], color=line_look(1)[0], linewidth=1.5)
        framed(inset, BORDER, 0.5)
    return figure


def error_crops(truth: Picture, pictures: Mapping[str, Picture], at: Optional[Tuple[int, int]] = None, crop_px: int = 0,
                width: str = "page") -> "Figure":
    """A column each for the truth and every picture: visibility above, signed error below, each with an enlarged crop around the
    pixel `at` (x, y); default: where the errors of all together are largest. `crop_px` is the crop's side; default: an eighth of
    the picture's width."""
    scores = _scores(pictures, truth)
    errors = {name: _signed_error(pictures[name], truth, one) for name, one in scores.items()}
    side = crop_px or max(8, truth.shape[1] // 8)
    box = box_around(at if at is not None else worst_place(list(errors.values()), side), side, truth.shape)
    columns = len(pictures) + 1
    wide = width_in(width)
    with pyplot().rc_context(STYLE):
        size = (wide, 2 * wide / columns * truth.shape[0] / truth.shape[1] + TITLE_IN)
        figure, grid = pyplot().subplots(2, columns, figsize=size, squeeze=False, layout="constrained")
        figure.get_layout_engine().set(w_pad=0.015, h_pad=0.015, wspace=0.0, hspace=0.0)
        for axes, (name, picture) in zip(grid[0], {"truth": truth, **pictures}.items()):
            show(axes, picture["visibility"], box, cmap="gray", vmin=0, vmax=1)
            axes.set_title(name if name not in scores else f"{name}, RMSE {_rmse_text(scores[name])}")
        shown = None
        for axes, error in zip(grid[1][1:], errors.values()):
            shown = show(axes, error, box, cmap=_error_colours(), vmin=-ERROR_SCALE, vmax=ERROR_SCALE)
        _error_legend(figure, grid[1][0], shown)
    return figure


def fault_classes(picture_score: Score, width: str = "column") -> "Figure":
    """The class of every pixel, in the program's colours. The legend names those that are there, with their part of the mean
    absolute error."""
    if picture_score.fault_map is None:
        raise InputError("this score has no diagnosis")
    total = sum(part["mean_abs_error"] for part in picture_score.faults.values())
    colours = np.asarray(_core.fault_colours, dtype=np.uint8)
    height, across = picture_score.fault_map.shape
    there = {name: part["mean_abs_error"] for name, part in picture_score.faults.items() if part["mean_abs_error"] >= LEAST_SHARE * total}
    legend_lines = math.ceil(len(there) / 2)
    with one_plot(width, height / across + 0.048 * legend_lines + 0.02) as (figure, axes):
        from matplotlib.patches import Patch

        axes.imshow(colours[picture_score.fault_map], interpolation="nearest")
        axes.set_anchor("N")
        framed(axes, BORDER, 0.5)
        handles = [Patch(facecolor=colours[FAULTS.index(name)] / 255, edgecolor=BORDER, linewidth=0.4,
                         label=f"{name.replace('_', ' ')}, {share / total:.1%}") for name, share in there.items()]
        axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=2, handlelength=1.0)
    return figure


def save(figure: "Figure", file: Union[str, "os.PathLike[str]"]) -> None:
    """Writes the figure as its name says (.pdf, .svg, .png), fonts embedded, and closes it."""
    with pyplot().rc_context(STYLE):
        figure.savefig(os.fspath(file))
    pyplot().close(figure)


def _scores(pictures: Mapping[str, Picture], truth: Picture) -> Mapping[str, Score]:
    if not pictures:
        raise InputError("a figure needs a picture beside the truth")
    scores = {name: score(picture, truth, metrics="error") for name, picture in pictures.items()}
    for name, one in scores.items():
        if one.scored is None:
            raise InputError(f"the surfaces of '{name}' are not the truth's: nothing was scored")
    return scores


def _of_scene(runs: "pandas.DataFrame", scene: Optional[str]) -> "pandas.DataFrame":
    there: List[str] = [] if runs.empty else sorted(set(runs["scene"]))
    if scene is None and len(there) == 1:
        scene = there[0]
    if scene not in there:
        raise InputError(f"scene is {scene!r}, not one of: {', '.join(there)}")
    return runs[runs["scene"] == scene]


def _time_bars(rows: "pandas.DataFrame") -> Tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    time = rows["time_ms"].to_numpy(dtype=float)
    if "time_low" in rows and rows["time_low"].notna().all():
        return rows["time_low"].to_numpy(dtype=float), rows["time_high"].to_numpy(dtype=float)
    deviation = rows["time_mad_ms"].fillna(0.0).to_numpy(dtype=float)
    return np.maximum(time - deviation, 0.0), time + deviation


def _on_front(rows: "pandas.DataFrame", time_low: npt.NDArray[Any], time_high: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """The rule of `bench` (results/bench/pareto.h): dominated where another's intervals both lie below."""
    low, high = rows["rmse_low"].to_numpy(dtype=float), rows["rmse_high"].to_numpy(dtype=float)
    return np.array([not np.any((high < low[i]) & (time_high < time_low[i])) for i in range(len(rows))])


def _is_software(rows: "pandas.DataFrame") -> bool:
    """As realtime/harness/context.cpp tells it; whoever compares such times must see that no GPU drew."""
    names = rows["device"].astype(str).str.lower() if "device" in rows else None
    return bool(names is not None and names.str.contains("llvmpipe|softpipe|swrast|swr").any())


def _logarithmic(axes: "Axes") -> None:
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

    for axis, scale in ((axes.xaxis, axes.set_xscale), (axes.yaxis, axes.set_yscale)):
        scale("log")
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.grid(True, which="major", color="0.9", linewidth=0.5)
    axes.set_axisbelow(True)


def _widest_penumbra(picture_score: Score) -> Tuple[int, int]:
    profiles = picture_score.profiles()
    reached = profiles[~profiles["is_partial"] & (profiles["outcome"] == PROFILE_OUTCOMES.index("accepted"))]
    if reached.size == 0:
        raise InputError("no whole penumbra was found: at=(x, y) names a pixel on one")
    widest = reached[np.argmax(reached["reference_width_px"])]
    return int(widest["x"]), int(widest["y"])


def _signed_error(picture: Picture, truth: Picture, picture_score: Score) -> npt.NDArray[Any]:
    return np.where(picture_score.scored == 1, picture["visibility"] - truth["visibility"], np.nan)


def _rmse_text(picture_score: Score) -> str:
    return f"{picture_score.rmse.value:.3f}" if picture_score.rmse else "unknown"


def _error_colours() -> Any:
    colours = pyplot().get_cmap("RdBu_r").copy()
    colours.set_bad(UNSCORED)
    return colours


def _error_legend(figure: "Figure", axes: "Axes", shown: Any) -> None:
    """In the truth's column, which has no error."""
    axes.axis("off")
    bar = axes.inset_axes([0.05, 0.5, 0.9, 0.1])
    figure.colorbar(shown, cax=bar, orientation="horizontal", extend="both", ticks=(-ERROR_SCALE, 0, ERROR_SCALE))
    bar.set_title("error of visibility")
    bar.set_xlabel("$\\leftarrow$ too dark    too bright $\\rightarrow$\n(grey: not scored)")
