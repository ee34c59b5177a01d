# SPDX-License-Identifier: Apache-2.0
"""What is drawn beside the light, and how pictures leave Blender: position from Blender's depth (EEVEE's other passes have half
precision), and the geometric normal, as an AOV of the one material."""
import math
import pathlib

import bpy
import numpy

PASSES = ("Image", "Depth", "normal")


def white_with_normal():
    material = bpy.data.materials.new("white")
    material.use_nodes = True
    material.use_backface_culling = False
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    links.new(diffuse.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    output = nodes.new("ShaderNodeOutputAOV")
    output.name = "normal"
    links.new(nodes.new("ShaderNodeNewGeometry").outputs["True Normal"], output.inputs["Color"])
    return material


def add_outputs(scene, out):
    """A file a pass, written by the compositor: Blender gives no pixels to scripts without it."""
    layer = scene.view_layers[0]
    layer.use_pass_z = True
    if "normal" not in layer.aovs:
        layer.aovs.add().name = "normal"
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    source, files = nodes.new("CompositorNodeRLayers"), nodes.new("CompositorNodeOutputFile")
    files.base_path = str(out)
    files.format.file_format = "OPEN_EXR"
    files.format.color_mode, files.format.color_depth = "RGBA", "32"
    files.file_slots.clear()
    for name in PASSES:
        files.file_slots.new(name + "-")
        links.new(source.outputs[name], files.inputs[name + "-"])


def read_pixels(path):
    """[height][width][RGBA], row 0 at the bottom; the file is removed."""
    image = bpy.data.images.load(str(path))
    width, height = image.size
    pixels = numpy.empty(width * height * 4, dtype=numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    pathlib.Path(path).unlink()
    return pixels.reshape(height, width, 4)


def write_pfm(path, pixels):
    height, width = pixels.shape[:2]
    with open(path, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode())
        file.write(numpy.ascontiguousarray(pixels[:, :, :3], dtype="<f4").tobytes())


def positions(camera, depth):
    """World positions of pixel centres at these depths along the camera's axis."""
    height, width = depth.shape
    half = math.tan(0.5 * camera.data.angle)
    x = (2.0 * (numpy.arange(width) + 0.5) / width - 1.0) * half * width / height
    y = (2.0 * (numpy.arange(height) + 0.5) / height - 1.0) * half
    right, up, back, eye = (numpy.array(column[:3]) for column in camera.matrix_world.col)
    towards = x[None, :, None] * right + y[:, None, None] * up - back
    return eye + depth[:, :, None] * towards


def render(scene, out, name):
    """Draws, and leaves `name`.pfm, position.pfm and normal.pfm in `out`; their names by what they show."""
    add_outputs(scene, out)
    scene.frame_set(1)
    bpy.ops.render.render()
    light, depth, normal = (read_pixels(out / f"{what}-0001.exr") for what in PASSES)
    is_hit = light[:, :, 3] > 0.5
    position = positions(scene.camera, numpy.where(is_hit, depth[:, :, 0], numpy.nan))
    eye = numpy.array(scene.camera.matrix_world.translation)
    faces_away = (normal[:, :, :3] * (eye - position)).sum(axis=2) < 0.0
    normal[faces_away] *= -1.0
    normal[~is_hit] = 0.0
    drawn = {name: light, "position": position, "normal": normal}
    for what, pixels in drawn.items():
        write_pfm(out / f"{what}.pfm", pixels)
    return {what: f"{what}.pfm" for what in drawn}
