#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""book_pictures.py [FOLDER]: draws docs/images/faults/<class>.png, each with the truth, a picture that has the fault, and the
classes that `score` gives its pixels, and docs/images/tour_*.png. Needs the module (PYTHONPATH=build/ci/python) and matplotlib. A figure
whose fault is not found in it is refused. About two minutes on two cores."""
import pathlib
import sys

import numpy as np

import umbrameter as um
from umbrameter import figures
from umbrameter._plotting import STYLE, pyplot

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIZE = {"width": 320, "height": 180}
SAMPLES = 256
DOTS_PER_INCH = 140
LEAST_SHARE = 0.1  # of the mean absolute error, for a picture to show its fault
NO_BIAS = {"receiver_plane": "none", "bias_texels": 0.0, "normal_offset_texels": 0.0}


def square(value, is_wanted):
    """A picture that is the truth but for one square of `value`: faults of the scene's data, which no technique of ours makes."""
    def paint(truth):
        visibility = truth["visibility"].copy()
        wanted = is_wanted(truth) & (truth["unshadowed_irradiance"] > 0)
        side = 24
        sums = np.cumsum(np.cumsum(np.pad(wanted.astype(int), ((1, 0), (1, 0))), 0), 1)
        rows, columns = np.nonzero(sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side] == side * side)
        middle = np.argmin(np.hypot(rows - truth.shape[0] / 2, columns - truth.shape[1] / 2))
        visibility[rows[middle]:rows[middle] + side, columns[middle]:columns[middle] + side] = value
        return um.Picture.from_arrays({"visibility": visibility})
    return paint


def without_horizon(truth):
    """All of the light, where a part of it is below the receiver's own surface and nothing else hides it."""
    own = (truth["blocker_distance"] == 0) & (truth["visibility"] < 0.8) & (truth["unshadowed_irradiance"] > 0)
    return um.Picture.from_arrays({"visibility": np.where(own, np.float32(1), truth["visibility"])})


# Class: scene, how the picture comes about, technique and parameters or a painter.
FAULTS = {
    "lost_shadow": ("plate", "pcss, back faces in the map", ("pcss", {"map_size": 1024, "caster_layer": "back_faces"})),
    "extra_shadow": ("plate", "shadow painted into the light", square(0.0, lambda truth: truth["visibility"] > 0.999)),
    "terminator": ("sphere_terminator", "light below the horizon counted", without_horizon),
    "peter_panning": ("colonnade", "hard, a bias of 1 m", ("hard", {**NO_BIAS, "map_size": 1024, "bias_world": 1.0})),
    "resolution": ("colonnade", "pcss, a map of 128", ("pcss", {"map_size": 128})),
    "penumbra_too_wide": ("box_contact", "pcf_disk, a kernel of 64 texels", ("pcf_disk", {"map_size": 1024, "radius_texels": 64.0})),
    "penumbra": ("plate", "hard", ("hard", {"map_size": 1024})),
    "overlap": ("contact_hardening", "hard", ("hard", {"map_size": 1024})),
    "acne": ("slanted_plane", "hard, no bias", ("hard", {**NO_BIAS, "map_size": 512})),
    "bleed": ("stacked_plates", "0.3 painted behind two plates",
              square(0.3, lambda truth: (truth["visibility"] < 0.001) & (truth["blocker_layers"] > 1.5))),
    "geometric_leak": ("plate", "light painted into the shadow", square(1.0, lambda truth: truth["visibility"] < 0.001)),
}


def save(figure, file):
    """For a screen: a third of the file that `figures.save` makes for print."""
    with pyplot().rc_context(STYLE):
        figure.savefig(file, dpi=DOTS_PER_INCH, pil_kwargs={"optimize": True})
    pyplot().close(figure)


def draw_fault(name, scene, title, source, folder):
    loaded = um.load_scene(scene)
    truth = um.truth(loaded, samples=SAMPLES, **SIZE)
    picture = source(truth) if callable(source) else um.render(loaded, source[0], **SIZE, **source[1])
    score = um.score(picture, truth)
    share = score.fault(name)["mean_abs_error"] / sum(part["mean_abs_error"] for part in score.faults.values())
    print(f"{name}: {scene}, {title}: {share:.0%} of the error, worst {score.worst_fault}", flush=True)
    if share < LEAST_SHARE:
        raise SystemExit(f"book_pictures: {name} is {share:.1%} of the error on {scene}: no figure of it")
    colours = np.asarray(um._core.fault_colours, dtype=np.uint8)
    mine = np.where((score.fault_map == um.FAULTS.index(name))[..., None], colours[um.FAULTS.index(name)],
                    (160 + 80 * truth["visibility"][..., None]).astype(np.uint8))
    with pyplot().rc_context(STYLE):
        figure, axes = pyplot().subplots(1, 3, figsize=(7.16, 1.5), layout="constrained")
        for one, (text, values) in zip(axes, (("truth", truth["visibility"]), (title, picture["visibility"]),
                                              (f"{name}: {share:.0%} of the error", mine.astype(np.uint8)))):
            one.imshow(values, cmap="gray", vmin=0, vmax=1 if values.ndim == 2 else None, interpolation="nearest")
            one.set_title(text)
            one.set_axis_off()
        save(figure, folder / f"{name}.png")


def draw_tour(folder):
    """The tour's own commands: plate at 240 x 135 px."""
    size = {"width": 240, "height": 135}
    scene = um.load_scene("plate")
    truth = um.truth(scene, samples=64, **size)
    pictures = {name: um.render(scene, name, **size) for name in ("hard", "pcf", "pcss")}
    save(figures.error_crops(truth, pictures), folder / "tour_errors.png")
    save(figures.penumbra(truth, pictures), folder / "tour_penumbra.png")
    save(figures.fault_classes(um.score(pictures["hard"], truth)), folder / "tour_faults.png")


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "images"
    (folder / "faults").mkdir(parents=True, exist_ok=True)
    draw_tour(folder)
    for name, (scene, title, source) in FAULTS.items():
        draw_fault(name, scene, title, source, folder / "faults")


if __name__ == "__main__":
    main()
