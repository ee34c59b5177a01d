# SPDX-License-Identifier: Apache-2.0
"""Renders an exported scene with Cycles, once with shadows and once without (docs/your-engine.md).

blender -b --factory-startup -P cycles_pair.py -- EXPORT_FOLDER OUT_FOLDER WIDTH HEIGHT SAMPLES
writes OUT_FOLDER/lit.exr and unlit.exr. White diffuse surfaces, no bounces, a pixel filter of 0.01 px.
"""
import json
import os
import sys

import bpy
from mathutils import Matrix, Vector


def read_obj(path):
    """Vertices and faces alone: flat triangles in our axes."""
    vertices, faces = [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append(tuple(float(word) for word in words[1:4]))
            elif words[:1] == ["f"]:
                faces.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:]))
    return vertices, faces


def white():
    material = bpy.data.materials.new("white")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
    return material


def columns(x, y, z, origin):
    """A matrix whose columns are three axes and an origin."""
    rows = [[x[i], y[i], z[i], origin[i]] for i in range(3)]
    return Matrix(rows + [[0.0, 0.0, 0.0, 1.0]])


def add(name, data, matrix):
    thing = bpy.data.objects.new(name, data)
    thing.matrix_world = matrix
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_camera(camera):
    eye, at, up = (Vector(camera[key]) for key in ("eye_world", "at_world", "up_world"))
    back = (eye - at).normalized()
    right = up.cross(back).normalized()
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = camera["vertical_fov_deg"] * 3.141592653589793 / 180.0
    data.clip_start, data.clip_end = 1e-3, 1e6
    bpy.context.scene.camera = add("camera", data, columns(right, back.cross(right), back, eye))


def add_light(light):
    kind = light["type"]
    data = bpy.data.lights.new("light", "SUN" if kind == "sun" else "POINT" if kind == "sphere" else "AREA")
    matrix = Matrix.Translation(light.get("center_world", (0.0, 0.0, 0.0)))
    if kind == "sphere":
        data.shadow_soft_size = light["radius_world"]
    else:
        direction = Vector(light["direction_world"])
        tangent = Vector(light["tangent_world"]) if "tangent_world" in light else direction.orthogonal().normalized()
        back = -direction
        matrix = columns(tangent, back.cross(tangent), back, light.get("center_world", (0.0, 0.0, 0.0)))
    if kind == "sun":
        data.angle = light["angular_diameter_deg"] * 3.141592653589793 / 180.0
    if kind == "rect":
        data.shape = "RECTANGLE"
        data.size, data.size_y = light["size_world"]
    if kind == "disk":
        data.shape = "DISK"
        data.size = 2.0 * light["radius_world"]
    data.energy = 100.0
    thing = add("light", data, matrix)
    thing.visible_camera = False
    return data


def set_up(width, height, samples):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.cycles.filter_width = 0.01
    scene.world = None
    return scene


def main():
    export, out, width, height, samples = sys.argv[sys.argv.index("--") + 1:]
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    with open(os.path.join(export, "scene.json"), encoding="utf-8") as file:
        description = json.load(file)
    mesh = bpy.data.meshes.new("scene")
    vertices, faces = read_obj(os.path.join(export, "scene.obj"))
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(white())
    add("scene", mesh, Matrix.Identity(4))
    add_camera(description["camera"])
    light = add_light(description["light"])
    scene = set_up(int(width), int(height), int(samples))
    for name, casts in (("lit", True), ("unlit", False)):
        light.cycles.cast_shadow = casts
        scene.render.filepath = os.path.join(os.path.abspath(out), name + ".exr")
        bpy.ops.render.render(write_still=True)


main()
