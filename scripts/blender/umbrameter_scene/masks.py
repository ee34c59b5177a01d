# SPDX-License-Identifier: Apache-2.0
"""Alpha masks out of materials' nodes: where a surface is solid, as texels.

The nodes between a picture and the surface's alpha are evaluated for every texel: Principled's Alpha, Mix with a Transparent
BSDF, Math, Invert, ColorRamp, Separate RGB, groups.
"""
import dataclasses
import math

import numpy

from . import pixels

CLEAR, SOLID = 0.001, 0.999  # alphas that count as 0 and 1
LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])  # how Blender makes a number of a colour
GLASS = ("BSDF_GLASS", "BSDF_REFRACTION", "BSDF_TRANSLUCENT")
MATHS = {
    "ADD": lambda a, b: a + b,
    "SUBTRACT": lambda a, b: a - b,
    "MULTIPLY": lambda a, b: a * b,
    "MINIMUM": numpy.minimum,
    "MAXIMUM": numpy.maximum,
    "POWER": lambda a, b: numpy.power(numpy.maximum(a, 0.0), b),
    "GREATER_THAN": lambda a, b: numpy.where(a > b, 1.0, 0.0),
    "LESS_THAN": lambda a, b: numpy.where(a < b, 1.0, 0.0),
    "ROUND": lambda a, b: numpy.floor(a + 0.5),
}


class NotRead(Exception):
    """Why an alpha is no mask."""


@dataclasses.dataclass
class Mask:
    name: str
    material: str
    solid: numpy.ndarray  # rows from below
    threshold: float
    uv_layer: str = ""  # empty: the one for renders
    uv_transform: numpy.ndarray = dataclasses.field(default_factory=lambda: numpy.eye(3))
    extension: str = "REPEAT"


def source_of(socket, groups):
    """The output that feeds `socket`, and the groups it stands in; reroutes and groups are seen through. None: not linked."""
    while socket.is_linked:
        output = socket.links[0].from_socket
        node = output.node
        if node.type == "REROUTE":
            socket = node.inputs[0]
        elif node.type == "GROUP" and node.node_tree:
            inside = next(n for n in node.node_tree.nodes if n.type == "GROUP_OUTPUT" and n.is_active_output)
            groups, socket = groups + (node,), matching(inside.inputs, output)
        elif node.type == "GROUP_INPUT":
            groups, socket = groups[:-1], matching(groups[-1].inputs, output)
        elif node.mute:
            raise NotRead(f"a '{node.name}' node is muted")
        else:
            return output, groups, socket
    return None, groups, socket


def matching(sockets, other):
    return next(socket for socket in sockets if socket.identifier == other.identifier)


class Alpha:
    """Of one material. `refine`: its picture is looked at finer than it is, as Blender interpolates it."""

    def __init__(self, refine):
        self.refine = refine
        self.texture = None
        self.is_glass = self.is_bright = False

    def of_surface(self, socket, groups=()):
        output, groups, _ = source_of(socket, groups)
        if output is None:
            return 1.0
        node = output.node
        if node.type == "MIX_SHADER":
            share = self.number(node.inputs["Fac"], groups)
            below, above = (self.of_surface(node.inputs[i], groups) for i in (1, 2))
            return (1.0 - share) * below + share * above
        if node.type == "ADD_SHADER":
            both = [self.of_surface(node.inputs[i], groups) for i in (0, 1)]
            if any(numpy.min(one) < SOLID for one in both):
                raise NotRead("a transparent shader is added to another")
            return 1.0
        if node.type == "BSDF_TRANSPARENT":
            return 0.0
        if node.type == "BSDF_PRINCIPLED":
            self.look_at_principled(node)
            return self.number(node.inputs["Alpha"], groups)
        self.is_glass |= node.type in GLASS
        self.is_bright |= node.type == "EMISSION"
        return 1.0

    def look_at_principled(self, node):
        transmission = node.inputs.get("Transmission") or node.inputs.get("Transmission Weight")
        self.is_glass |= transmission.is_linked or transmission.default_value > 0.0
        emission = node.inputs.get("Emission") or node.inputs.get("Emission Color")
        strength = node.inputs["Emission Strength"]
        is_black = not emission.is_linked and max(emission.default_value[:3]) == 0.0
        self.is_bright |= not is_black and (strength.is_linked or strength.default_value > 0.0)

    def number(self, socket, groups):
        """A float, or one a texel."""
        output, groups, socket = source_of(socket, groups)
        if output is None:
            value = socket.default_value
            return float(value) if isinstance(value, (int, float)) else float(LUMINANCE @ numpy.array(value[:3]))
        node = output.node
        if node.type == "TEX_IMAGE" and output.name == "Alpha":
            return self.picture(node, groups)[..., 3]
        if node.type == "MATH" and node.operation in MATHS:
            with numpy.errstate(all="ignore"):
                value = MATHS[node.operation](self.number(node.inputs[0], groups), self.number(node.inputs[1], groups))
            return numpy.clip(value, 0.0, 1.0) if node.use_clamp else value
        if node.type == "VALUE":
            return float(output.default_value)
        if node.type == "VALTORGB":
            return self.ramp(node, output.name, groups)
        if node.type in ("SEPRGB", "SEPARATE_COLOR") and getattr(node, "mode", "RGB") == "RGB":
            return self.color(node.inputs[0], groups)[..., list(node.outputs).index(output)]
        return self.color_of(output, groups) @ LUMINANCE

    def color(self, socket, groups):
        output, groups, socket = source_of(socket, groups)
        return numpy.array(socket.default_value[:3]) if output is None else self.color_of(output, groups)

    def color_of(self, output, groups):
        node = output.node
        if node.type == "TEX_IMAGE":
            return pixels.linear_colors(node.image, self.picture(node, groups))
        if node.type == "RGB":
            return numpy.array(output.default_value[:3])
        if node.type == "INVERT":
            share = numpy.asarray(self.number(node.inputs["Fac"], groups))[..., None]
            color = self.color(node.inputs["Color"], groups)
            return (1.0 - share) * color + share * (1.0 - color)
        raise NotRead(f"its alpha comes from a node '{node.name}', which is not read")

    def ramp(self, node, channel, groups):
        given = numpy.rint(numpy.clip(self.number(node.inputs["Fac"], groups), 0.0, 1.0) * 65535.0)
        values, index = numpy.unique(given, return_inverse=True)
        colors = [node.color_ramp.evaluate(value / 65535.0) for value in values]
        numbers = numpy.array([color[3] if channel == "Alpha" else LUMINANCE @ numpy.array(color[:3]) for color in colors])
        return numbers[index].reshape(given.shape)

    def picture(self, node, groups):
        if self.texture not in (None, node):
            raise NotRead("its alpha comes from two pictures")
        self.texture = node
        if node.projection != "FLAT":
            raise NotRead(f"its picture is projected ({node.projection.lower()})")
        self.uv_layer, self.uv_transform = texture_space(node.inputs["Vector"], groups)
        return pixels.of_texture(node, self.refine)


def texture_space(socket, groups):
    """(UV map's name or empty, the picture's coordinates from it)."""
    output, groups, _ = source_of(socket, groups)
    if output is None or (output.node.type == "TEX_COORD" and output.name == "UV"):
        return "", numpy.eye(3)
    node = output.node
    if node.type == "UVMAP":
        return node.uv_map, numpy.eye(3)
    if node.type == "MAPPING" and node.vector_type in ("POINT", "TEXTURE"):
        layer, inner = texture_space(node.inputs["Vector"], groups)
        placed = mapping_matrix(node)
        return layer, (numpy.linalg.inv(placed) if node.vector_type == "TEXTURE" else placed) @ inner
    raise NotRead(f"its picture is placed by a node '{node.name}', which is not read")


def mapping_matrix(node):
    values = {name: node.inputs[name] for name in ("Location", "Rotation", "Scale")}
    if any(socket.is_linked for socket in values.values()):
        raise NotRead("its picture's mapping is computed")
    x, y, turn_rad = values["Rotation"].default_value
    if abs(x) > 1e-9 or abs(y) > 1e-9:
        raise NotRead("its picture's mapping turns out of its plane")
    c, s = math.cos(turn_rad), math.sin(turn_rad)
    scale, offset = values["Scale"].default_value, values["Location"].default_value
    return numpy.array([[c * scale[0], -s * scale[1], offset[0]], [s * scale[0], c * scale[1], offset[1]], [0.0, 0.0, 1.0]])


class Masks:
    def __init__(self, said):
        self.said = said
        self.known = {}

    def of(self, material):
        """None where the material is solid, as far as it is read."""
        if material.name not in self.known:
            self.known[material.name] = self.read(material)
        return self.known[material.name]

    def read(self, material):
        output = material.node_tree.get_output_node("CYCLES") if material.use_nodes and material.node_tree else None
        if output is None:
            return None
        if output.inputs["Volume"].is_linked:
            self.said.add("materials' volumes are left out", material.name)
        if output.inputs["Displacement"].is_linked and material.cycles.displacement_method != "BUMP":
            self.said.add("materials' displacement is left out", material.name)
        coarse, fine = Alpha(refine=False), Alpha(refine=True)
        try:
            given = numpy.asarray(coarse.of_surface(output.inputs["Surface"]), dtype=float)
            alpha = numpy.asarray(fine.of_surface(output.inputs["Surface"]), dtype=float)
        except NotRead as why:
            self.said.add(f"materials whose transparency is no mask that is read are solid: {why}", material.name)
            return None
        if coarse.is_glass:
            self.said.add("materials that let light through (transmission, glass, translucency) are solid", material.name)
        if coarse.is_bright:
            self.said.add("materials that emit light do not", material.name)
        return self.cut(material, given, alpha, fine)

    def cut(self, material, given, alpha, fine):
        is_clipped = material.blend_method == "CLIP"
        threshold = material.alpha_threshold if is_clipped else 0.5
        solid = alpha > threshold
        if not is_clipped and ((given > CLEAR) & (given < SOLID)).any():
            self.said.add("materials that blend are solid where their alpha is over 0.5, and holes elsewhere", material.name)
        if solid.all():
            return None
        if fine.texture is None:
            self.said.add("materials that are transparent everywhere are holes", material.name)
            return Mask(material.name, material.name, solid.reshape(1, 1), threshold)
        return Mask(fine.texture.image.name, material.name, solid, threshold, fine.uv_layer, fine.uv_transform,
                    fine.texture.extension)
