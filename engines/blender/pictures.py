# SPDX-License-Identifier: Apache-2.0
"""How pictures leave Blender: as files of the compositor, since scripts get no pixels without it."""
import pathlib

import bpy
import numpy


def draw(scene, out, passes=("Image",)):
    """[height][width][RGBA] a pass, row 0 at the bottom. AOVs are passes by their names. Files of `out` come and go."""
    aovs = scene.view_layers[0].aovs
    for name in passes:
        if name != "Image" and name not in aovs:
            aovs.add().name = name
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    source, files = nodes.new("CompositorNodeRLayers"), nodes.new("CompositorNodeOutputFile")
    files.base_path = str(out)
    files.format.file_format = "OPEN_EXR"
    files.format.color_mode, files.format.color_depth = "RGBA", "32"
    files.file_slots.clear()
    for name in passes:
        files.file_slots.new(name + "-")
        links.new(source.outputs[name], files.inputs[name + "-"])
    bpy.ops.render.render()
    return [read_pixels(out / f"{name}-{scene.frame_current:04d}.exr") for name in passes]


def read_pixels(path):
    """The file is removed."""
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
