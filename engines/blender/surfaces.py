# SPDX-License-Identifier: Apache-2.0
"""What is drawn beside the light, as AOVs of the one material: position and geometric normal.

EEVEE keeps AOVs as half floats and adds its samples up in them. So a position is drawn in two parts, relative to the
camera and with one sample: multiples of a step, and what is left.
"""
import math

import bpy
import numpy

AOVS = ("coarse", "fine", "normal")
STEPS = 1024  # a half float holds whole numbers up to 2048


def white(eye, extent):
    """A white diffuse material whose AOVs hold points up to `extent` away from the eye."""
    material = bpy.data.materials.new("white")
    material.use_nodes = True
    material.use_backface_culling = False
    material.node_tree.nodes.clear()
    paint(material, eye, extent)
    return material


def paint(material, eye, extent, solid=None):
    """Adds that to a material's nodes. `solid`: a socket that is 1 where there is a surface and 0 in holes."""
    nodes, links = material.node_tree.nodes, material.node_tree.links

    def vector_math(operation, a, b):
        node = nodes.new("ShaderNodeVectorMath")
        node.operation = operation
        links.new(a, node.inputs[0])
        if isinstance(b, bpy.types.NodeSocket):
            links.new(b, node.inputs[1])
        else:
            node.inputs[1].default_value = b
        return node.outputs["Vector"]

    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    shader = diffuse.outputs[0]
    if solid is not None:
        mix = nodes.new("ShaderNodeMixShader")
        links.new(solid, mix.inputs["Fac"])
        links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], mix.inputs[1])
        links.new(shader, mix.inputs[2])
        shader = mix.outputs[0]
    links.new(shader, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    geometry = nodes.new("ShaderNodeNewGeometry").outputs
    step = 2.0 ** math.ceil(math.log2(extent / STEPS))
    towards = vector_math("SUBTRACT", geometry["Position"], eye)
    coarse = vector_math("SNAP", towards, (step, step, step))
    fine = vector_math("SUBTRACT", towards, coarse)
    for name, value in zip(AOVS, (coarse, fine, geometry["True Normal"])):
        output = nodes.new("ShaderNodeOutputAOV")
        output.name = name
        if solid is not None:  # Cycles adds up what it meets on its way through holes
            value = vector_math("MULTIPLY", value, solid)
        links.new(value, output.inputs["Color"])


def from_aovs(eye, is_hit, coarse, fine, normal):
    """Position, not a number where nothing is hit, and the normal towards the camera; the inputs are [height][width][3 or more]."""
    towards = coarse[:, :, :3] + fine[:, :, :3]
    position = towards + numpy.array(eye)
    position[~is_hit] = numpy.nan
    normal = normal[:, :, :3].copy()
    normal[(normal * towards).sum(axis=2) > 0.0] *= -1.0
    normal[~is_hit] = 0.0
    return {"position": position, "normal": normal}
