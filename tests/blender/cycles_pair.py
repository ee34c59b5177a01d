# SPDX-License-Identifier: Apache-2.0
"""Renders an exported scene with Cycles, once with shadows and once without (docs/your-engine.md).

blender -b --factory-startup -P cycles_pair.py -- EXPORT_FOLDER OUT_FOLDER WIDTH HEIGHT SAMPLES
writes OUT_FOLDER/lit.exr and unlit.exr. White diffuse surfaces, no bounces, samples through pixels' centres.
"""
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "engines" / "blender"))

import bpy

import draw_cycles
import exported


def main():
    export, out, width, height, samples = sys.argv[sys.argv.index("--") + 1:]
    folder = pathlib.Path(export)
    description = json.loads((folder / "scene.json").read_text(encoding="utf-8"))
    body, light, scene = exported.build(exported.read_mesh(folder / "scene.obj"), description)
    exported.set_size(scene, int(width), int(height))
    draw_cycles.set_up(scene, body, light, {"samples": int(samples)}, 1)
    for name, casts in (("lit", True), ("unlit", False)):
        draw_cycles.set_shadow(light, casts)
        scene.render.filepath = os.path.join(os.path.abspath(out), name + ".exr")
        bpy.ops.render.render(write_still=True)


main()
