# SPDX-License-Identifier: Apache-2.0
"""The scene folder: scene.glb, scene.toml from the chosen camera, and scene-NAME.toml from each other one."""
import dataclasses
import json
import os
import pathlib
import re
import tempfile

import bpy
import numpy

from . import cameras, evaluated, glb, lights, space
from .said import Refused

MESH_FILE = "scene.glb"
SURFACES_FILE = "surfaces.exr"  # of an engine's pictures
MAX_TRIANGLES = 16777215  # umbrameter's own limit
NOTICEABLE = 1e-5  # of the scene's size: rounding that `umbrameter scene check` warns of


@dataclasses.dataclass
class Export:
    out: pathlib.Path
    camera: cameras.Camera
    lights: list  # (keys as in the TOML file, evaluated.LightInstance)
    masks: list  # of materials in use
    metres: float
    extent: float  # from the camera to the farthest corner, Blender's units
    summary: str


def write_files(out, files):
    """All of `files` (name -> bytes), complete or not at all as far as a file system lets one; the first one last."""
    check_places(out, files)
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".part-", dir=out) as part:
            for name, data in files.items():
                (pathlib.Path(part) / name).write_bytes(data)
            for name in reversed(files):
                os.replace(pathlib.Path(part) / name, out / name)
    except OSError as why:
        raise Refused(f"{out}: cannot be written: {why.strerror}") from None


def check_places(out, names):
    """Refuses a file in the place of a folder, and a folder in that of a file."""
    file = next((place for place in (out, *out.parents) if place.exists() and not place.is_dir()), None)
    if file:
        raise Refused(f"{file} is a file, and has to be a folder")
    for name in names:
        if (out / name).is_dir():
            raise Refused(f"{out / name} is a folder, where a file has to be (move it away)")


def value_text(value):
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, numpy.ndarray):
        return "[" + ", ".join(repr(float(number)) for number in value) + "]"
    return repr(float(value))


def table_text(head, keys):
    return f"\n{head}\n" + "".join(f"{key} = {value_text(value)}\n" for key, value in keys.items())


def scene_text(title, camera, tables, middle, metres):
    text = f"title = {value_text(title)}\n"
    text += f"doc = {value_text(f'Blender {bpy.app.version_string}, camera {camera.name}; its picture has {camera.width_px} x {camera.height_px} px.')}\n"
    text += table_text("[camera]", camera.toml(middle, metres))
    text += f'\n[[mesh]]\nname = "scene"\nfile = "{MESH_FILE}"\n'
    return text + "".join(table_text("[[light]]", keys) for keys in tables)


def unique(name, taken, key=str):
    number, made = 2, name
    while key(made) in taken:
        made, number = f"{name}-{number}", number + 1
    taken.add(key(made))
    return made


def file_name(name, taken):
    """Of no other name in `taken`, also where a file system does not tell capitals from small letters."""
    return unique(re.sub(r"[^\w.-]|^\.", "_", name), taken, str.casefold)


def chosen_cameras(scene, name):
    """The one to look from, and the others."""
    things = [thing for thing in scene.objects if thing.type == "CAMERA"]
    names = ", ".join(f"'{thing.name}'" for thing in things)
    if name and name not in [thing.name for thing in things]:
        raise Refused(f"there is no camera '{name}' (there are {names})" if names else f"there is no camera '{name}', nor any other")
    first = next((thing for thing in things if thing.name == name), None) or scene.camera or (things[0] if things else None)
    if first is None or first.type != "CAMERA":
        raise Refused("the scene has no camera (add one, or make one the scene's)")
    return first, [thing for thing in things if thing != first]


def chosen_lights(found, wanted, middle, metres, said):
    taken, tables, folders = set(), [], {SURFACES_FILE}
    for light in found.lights:
        name = unique(light.name, taken)
        light.folder = file_name(name, folders)  # that of all lights, whichever are wanted
        if wanted and name not in wanted:
            continue
        keys = lights.toml(light, name, middle, metres, said)
        if keys:
            tables.append((keys, light))
    missing = [name for name in wanted if name not in taken]
    if missing:
        raise Refused(f"there is no light '{missing[0]}' in the render (there are {', '.join(map(repr, sorted(taken)))})" if taken else
                      f"there is no light '{missing[0]}' in the render, nor any other")
    if not tables:
        raise Refused("the scene has no light that can be carried over (add a sun, area or point light)")
    return tables


def say_surroundings(scene, said):
    world = scene.world
    if world and has_light(world):
        said.add("the world's light is left out", world.name)
    others = [layer.name for layer in scene.view_layers[1:]]
    for name in others:
        said.add("view layers after the first are left out", name)
    for other in bpy.data.scenes:
        if other != scene:
            said.add("other scenes of the file are left out", other.name)


def say_rounding(corners_m, said):
    reach, diagonal = float(numpy.abs(corners_m).max()), float(numpy.linalg.norm(corners_m.max(axis=0) - corners_m.min(axis=0)))
    rounding = reach * 2.0**-24  # of a float
    if rounding > NOTICEABLE * diagonal:
        said.add(f"positions are rounded by up to {rounding:.2g} m, since the scene is {diagonal:.3g} m wide and lies up to {reach:.3g} m "
                 "from the origin (move it there)", MESH_FILE)


def has_light(world):
    if not world.use_nodes:
        return max(world.color) > 0.0
    output = world.node_tree.get_output_node("ALL")
    if output is None or not output.inputs["Surface"].is_linked:
        return False
    node = output.inputs["Surface"].links[0].from_node
    if node.type != "BACKGROUND":
        return True
    color, strength = node.inputs["Color"], node.inputs["Strength"]
    if color.is_linked or strength.is_linked:
        return True
    return strength.default_value > 0.0 and max(color.default_value[:3]) > 0.0


def export(scene, out, camera_name, light_names, width, said):
    camera_thing, other_things = chosen_cameras(scene, camera_name)
    size = cameras.picture_size(scene, width)
    with evaluated.changed(scene, camera=camera_thing):
        read = {}

        def take(depsgraph):
            read["found"] = evaluated.read(depsgraph, said)
            read["cameras"] = [cameras.read(thing, depsgraph, scene, size, said) for thing in (camera_thing, *other_things)]

        evaluated.with_render_depsgraph(scene, take)
    found, camera, others = read["found"], read["cameras"][0], [one for one in read["cameras"][1:] if one]
    if camera is None:
        fault = "is not perspective, as ours are" if camera_thing.data.type != "PERSP" else "is scaled to nothing"
        raise Refused(f"camera '{camera_thing.name}' {fault} (choose another with --camera)")
    if found.triangle_count() == 0:
        raise Refused("the scene has no triangles that a render shows")
    if found.triangle_count() > MAX_TRIANGLES:
        said.add(f"umbrameter reads up to {MAX_TRIANGLES} triangles a scene, and this has more", str(found.triangle_count()))
    say_surroundings(scene, said)

    metres = space.metres_per_unit(scene)
    corners = found.corners()
    say_rounding(metres * corners, said)
    middle = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
    tables = chosen_lights(found, light_names, middle, metres, said)
    masks = {primitive.mask.material: primitive.mask for _, primitives in found.meshes.values() for primitive in primitives
             if primitive.mask is not None}
    title = pathlib.Path(bpy.data.filepath).stem or scene.name
    keys = [keys for keys, _ in tables]
    files = {"scene.toml": scene_text(title, camera, keys, middle, metres).encode()}
    taken = set()
    for one in others:
        name = file_name(one.name, taken)
        files[f"scene-{name}.toml"] = scene_text(f"{title}, {one.name}", one, keys, middle, metres).encode()
    files[MESH_FILE] = glb.file_of(found, metres)
    write_files(out, files)

    used = len({instance.mesh for instance in found.instances})
    summary = (f"{found.triangle_count()} triangles in {len(found.instances)} instances of {used} meshes, {len(masks)} masks, "
               f"{len(tables)} lights, {1 + len(others)} cameras")
    extent = float(numpy.linalg.norm(corners - camera.eye, axis=1).max())
    return Export(out, camera, tables, list(masks.values()), metres, extent, summary)
