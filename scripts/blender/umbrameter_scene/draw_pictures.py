# SPDX-License-Identifier: Apache-2.0
"""Inside a further Blender, with a copy of the scene: blender -b COPY.blend -P draw_pictures.py -- PLAN.json

The scene stays Blender's own: its meshes, instances, camera, lights' shapes and masks. Colours become white, and one light
shines at a time, as docs/your-engine.md asks.
"""
import json
import math
import pathlib
import sys
import tempfile

import bpy
import numpy
from mathutils import Matrix

PLAN = json.loads(pathlib.Path(sys.argv[sys.argv.index("--") + 1]).read_text(encoding="utf-8"))
sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1]), str(pathlib.Path(PLAN["engines"]) / "blender")]

import exported
import pictures
import surfaces
from umbrameter_scene import exr, folder, masks, space


def set_up_scene(scene):
    scene.world = None
    for layer in scene.view_layers[1:]:
        layer.use = False
    scene.view_layers[0].material_override = None
    for name in ("use_motion_blur", "use_border", "use_freestyle", "use_multiview", "use_sequencer"):
        setattr(scene.render, name, False)
    scene.render.use_compositing = True  # how pictures leave Blender
    scene.render.pixel_aspect_x = scene.render.pixel_aspect_y = 1.0
    view = scene.view_settings
    view.view_transform, view.look, view.exposure, view.gamma = "Raw", "None", 0.0, 1.0
    view.use_curve_mapping = False
    cycles = scene.cycles
    cycles.sample_clamp_direct = 0.0
    cycles.transparent_max_bounces = 1024
    cycles.time_limit = 0.0
    cycles.use_auto_tile = False
    exported.set_size(scene, PLAN["camera"]["width_px"], PLAN["camera"]["height_px"])


def set_up_camera(scene):
    thing = bpy.data.objects[PLAN["camera"]["name"]]
    if PLAN["camera"]["is_straightened"]:
        thing = bpy.data.objects.new("camera", thing.data)
        thing.matrix_world = Matrix(PLAN["camera"]["matrix"])
        scene.collection.objects.link(thing)
    data = thing.data
    data.dof.use_dof = False
    data.clip_end = 1.01 * PLAN["extent"]  # ours has no far plane
    if PLAN["camera"]["is_wider"]:
        data.shift_x = data.shift_y = 0.0
        data.sensor_fit = "VERTICAL"
        data.angle = math.radians(PLAN["camera"]["vertical_fov_deg"])
    scene.camera = thing


def solid_of_group(node, output):
    """The same of a group's shader: the group gets one more output."""
    tree = node.node_tree
    end = next(one for one in tree.nodes if one.type == "GROUP_OUTPUT" and one.is_active_output)
    given = solid_of(tree.nodes, tree.links, masks.matching(end.inputs, output))
    if not isinstance(given, bpy.types.NodeSocket):
        return given
    tree.outputs.new("NodeSocketFloat", "solid")
    index = len(tree.outputs) - 1
    tree.links.new(given, end.inputs[index])
    return node.outputs[index]


def solid_of(nodes, links, socket):
    """A number, or a socket of one: how solid the shader at `socket` is. Blender computes it, not our masks."""
    if not socket.is_linked:
        return 1.0
    node = socket.links[0].from_node
    if node.type == "REROUTE":
        return solid_of(nodes, links, node.inputs[0])
    if node.type == "GROUP":
        return solid_of_group(node, socket.links[0].from_socket)
    if node.type == "GROUP_INPUT":
        raise RuntimeError(f"a shader with a mask goes through the input of a group, '{node.id_data.name}', which pictures cannot show")
    if node.type == "BSDF_TRANSPARENT":
        return 0.0
    if node.type == "BSDF_PRINCIPLED":
        return number_of(node.inputs["Alpha"])
    if node.type != "MIX_SHADER":
        return 1.0

    def maths(operation, a, b):
        made = nodes.new("ShaderNodeMath")
        made.operation = operation
        for value, wanted in zip((a, b), made.inputs):
            if isinstance(value, bpy.types.NodeSocket):
                links.new(value, wanted)
            else:
                wanted.default_value = value
        return made.outputs[0]

    share = number_of(node.inputs["Fac"])
    below, above = (solid_of(nodes, links, node.inputs[i]) for i in (1, 2))
    return maths("ADD", maths("MULTIPLY", maths("SUBTRACT", 1.0, share), below), maths("MULTIPLY", share, above))


def number_of(socket):
    return socket.links[0].from_socket if socket.is_linked else socket.default_value


def whiten(material, eye):
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    threshold = PLAN["masks"].get(material.name)
    solid = None
    output = material.node_tree.get_output_node("CYCLES")
    if threshold is not None:
        compare = nodes.new("ShaderNodeMath")
        compare.operation = "GREATER_THAN"
        compare.inputs[1].default_value = threshold
        alpha = solid_of(nodes, links, output.inputs["Surface"])
        if isinstance(alpha, bpy.types.NodeSocket):
            links.new(alpha, compare.inputs[0])
        else:
            compare.inputs[0].default_value = alpha
        solid = compare.outputs[0]
    for node in [node for node in nodes if node.type in ("OUTPUT_MATERIAL", "OUTPUT_AOV")]:
        nodes.remove(node)
    surfaces.paint(material, eye, PLAN["extent"], solid)
    material.use_backface_culling = False
    material.blend_method = "OPAQUE" if solid is None else "CLIP"
    material.shadow_method = "OPAQUE" if solid is None else "CLIP"
    material.alpha_threshold = 0.5


def whiten_all(eye):
    known = [material for material in bpy.data.materials if not material.is_grease_pencil]
    for material in known:
        whiten(material, eye)
    plain = surfaces.white(eye, PLAN["extent"])
    for thing in bpy.data.objects:
        if thing.type not in ("MESH", "CURVE", "SURFACE", "FONT", "META"):
            continue
        if not thing.data.materials:
            thing.data.materials.append(plain)
        for slot in thing.material_slots:
            slot.material = slot.material or plain
    whiten_bare_geometry(known, plain)


def whiten_bare_geometry(known, plain):
    """What geometry nodes made without any of the `known` materials becomes `plain`."""
    tree = bpy.data.node_groups.new("bare", "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    given, made = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    paint = tree.nodes.new("GeometryNodeSetMaterial")
    paint.inputs["Material"].default_value = plain
    tree.links.new(given.outputs[0], paint.inputs["Geometry"])
    tree.links.new(paint.outputs["Geometry"], made.inputs[0])

    def boolean(operation, *inputs):
        node = tree.nodes.new("FunctionNodeBooleanMath")
        node.operation = operation
        for value, wanted in zip(inputs, node.inputs):
            tree.links.new(value, wanted)
        return node.outputs[0]

    has_one = None
    for material in known:
        select = tree.nodes.new("GeometryNodeMaterialSelection")
        select.inputs["Material"].default_value = material
        has_one = boolean("OR", has_one, select.outputs[0]) if has_one else select.outputs[0]
    if has_one:
        tree.links.new(boolean("NOT", has_one), paint.inputs["Selection"])
    for thing in bpy.data.objects:
        if any(modifier.type == "NODES" for modifier in thing.modifiers):
            thing.modifiers.new("bare", "NODES").node_group = tree


def add_light(scene, light):
    """A copy that shines alone; its power does not count."""
    data = bpy.data.objects[light["object"]].data.copy()
    data.energy = 100.0
    data.color = (1.0, 1.0, 1.0)
    data.use_nodes = False
    data.diffuse_factor = 1.0
    thing = bpy.data.objects.new("light", data)
    thing.parent = bpy.data.objects.new("place", None)
    thing.matrix_parent_inverse = Matrix(light["matrix"])  # matrix_world would lose a shear
    scene.collection.objects.link(thing.parent)
    thing.visible_camera = False
    scene.collection.objects.link(thing)
    return thing


def write(path, layers):
    """`layers`: name -> [height][width][3 or more], row 0 at the bottom."""
    channels = {}
    for name, (letters, values) in layers.items():
        for i, letter in enumerate(letters):
            channels[f"{name}{letter}"] = values[::-1, :, i]
    folder.write_files(path.parent, {path.name: exr.file_of(channels)})


def draw_light(scene, engine, bodies, light, out, scratch, is_first):
    thing = add_light(scene, light)
    for body in bodies:
        engine.set_up(scene, body, thing.data, PLAN["values"], PLAN["seed"])
    if is_first:
        eye = scene.camera.matrix_world.translation
        engine.set_samples(scene, 1)
        picture, *aovs = pictures.draw(scene, scratch, ("Image", *surfaces.AOVS))
        drawn = surfaces.from_aovs(eye, picture[:, :, 3] > 0.5, *aovs)
        position = PLAN["metres"] * (drawn["position"] @ space.Y_UP.T)
        write(out / folder.SURFACES_FILE, {"position.": ("XYZ", position), "normal.": ("XYZ", drawn["normal"] @ space.Y_UP.T)})
        engine.set_samples(scene, PLAN["values"][engine.SAMPLES])
    for name, casts in (("lit", True), ("unlit", False)):
        engine.set_shadow(thing.data, casts)
        [pixels] = pictures.draw(scene, scratch)
        write(out / light["folder"] / f"{name}.exr", {"": ("RGB", pixels)})
    bpy.data.objects.remove(thing.parent)
    bpy.data.objects.remove(thing)


def main():
    engine = __import__(f"draw_{PLAN['engine']}")
    scene = bpy.context.scene
    set_up_scene(scene)
    set_up_camera(scene)
    bpy.context.view_layer.update()
    whiten_all(scene.camera.matrix_world.translation)
    for thing in bpy.data.objects:
        if thing.type == "LIGHT":
            thing.hide_render = True
    bodies = [thing for thing in bpy.data.objects if thing.type not in ("LIGHT", "CAMERA", "EMPTY")]
    out = pathlib.Path(PLAN["out"])
    with tempfile.TemporaryDirectory(prefix="umbrameter-") as scratch:
        for i, light in enumerate(PLAN["lights"]):
            draw_light(scene, engine, bodies, light, out, pathlib.Path(scratch), i == 0)


main()
