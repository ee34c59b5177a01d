# SPDX-License-Identifier: Apache-2.0
"""Asks further Blenders for pictures of an exported scene, by a copy of the file: what is open here stays as it is."""
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

import bpy

from . import folder
from .said import Refused, last_line

HERE = pathlib.Path(__file__).resolve().parent
# Beside the add-on where that is installed, else in the source tree.
ENGINES = next((folder for folder in (HERE.parent / "engines", HERE.parents[2] / "engines") if folder.is_dir()), None)
NAMES = ("cycles", "eevee")


def manifest(engine):
    """Quantity and default values of engines/NAME/engine.toml."""
    try:
        import tomllib
    except ImportError:
        raise Refused("pictures need a Blender whose Python has tomllib (3.11 or newer)") from None
    with open(ENGINES / engine / "engine.toml", "rb") as file:
        table = tomllib.load(file)
    return table["quantity"], {parameter["name"]: parameter["default"] for parameter in table["parameter"]}


def environment(engine):
    """EEVEE draws with OpenGL on a display of its own, as engines/blender/launch.py has it."""
    made = {**os.environ, "PATH": os.defpath, "PYTHONDONTWRITEBYTECODE": "1"}
    if engine == "eevee":
        sys.path.insert(0, str(ENGINES / "blender"))
        import launch
        try:
            made["DISPLAY"] = launch.start_display()
        except RuntimeError as why:
            raise Refused(str(why)) from None
        made.pop("WAYLAND_DISPLAY", None)
        made["LIBGL_ALWAYS_SOFTWARE"] = "1"
    return made


def draw(export, engine, samples, seed, said):
    """Writes OUT/ENGINE/surfaces.exr and OUT/ENGINE/LIGHT/lit.exr, unlit.exr. Returns commands that score them."""
    if ENGINES is None:
        raise Refused("pictures need engines/ of Umbrameter's source tree, which is not here")
    quantity, values = manifest(engine)
    folder.check_places(export.out / engine, (folder.SURFACES_FILE,))
    for _, light in export.lights:
        folder.check_places(export.out / engine / light.folder, ("lit.exr", "unlit.exr"))
    if samples:
        values["samples" if engine == "cycles" else "taa_render_samples"] = samples
    for image in bpy.data.images:
        if image.is_dirty:
            said.add("pictures that were changed and not saved are drawn as the file has them", image.name)
    camera = export.camera
    plan = {"engine": engine, "engines": str(ENGINES), "out": str(export.out / engine), "values": values, "seed": seed,
            "metres": export.metres, "extent": export.extent,
            "camera": {"name": camera.name, "is_wider": camera.is_wider, "is_straightened": camera.is_straightened,
                       "matrix": camera.matrix().tolist(), "vertical_fov_deg": camera.vertical_fov_deg,
                       "width_px": camera.width_px, "height_px": camera.height_px},
            "lights": [{"object": light.object_name, "matrix": light.matrix.tolist(), "folder": light.folder}
                       for _, light in export.lights],
            "masks": {mask.material: mask.threshold for mask in export.masks}}
    with tempfile.TemporaryDirectory(prefix="umbrameter-") as scratch:
        copy, plan_file = pathlib.Path(scratch) / "scene.blend", pathlib.Path(scratch) / "plan.json"
        bpy.ops.wm.save_as_mainfile(filepath=str(copy), copy=True, check_existing=False)
        plan_file.write_text(json.dumps(plan), encoding="utf-8")
        command = [bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", str(copy), "--python-exit-code", "9",
                   "-P", str(HERE / "draw_pictures.py"), "--", str(plan_file)]
        ended = subprocess.run(command, env=environment(engine), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace")
    if ended.returncode != 0:
        raise Refused(f"Blender ended with {ended.returncode} while it drew {engine}'s pictures: {last_line(ended.stdout)}")
    return [score_command(export, engine, quantity, keys["name"], light.folder) for keys, light in export.lights]


def quoted(text):
    return shlex.quote(str(text))


def score_command(export, engine, quantity, light, light_folder):
    pictures = export.out / engine
    view = "" if len(export.lights) == 1 else f" --light {quoted(light)}"
    return (f"umbrameter score --shadowed {quoted(pictures / light_folder / 'lit.exr')} --unshadowed {quoted(pictures / light_folder / 'unlit.exr')} "
            f"--surfaces {quoted(pictures / folder.SURFACES_FILE)} --scene {quoted(export.out / 'scene.toml')}{view} --quantity {quantity}")
