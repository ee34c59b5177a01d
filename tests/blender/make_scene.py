# SPDX-License-Identifier: Apache-2.0
"""blender -b --factory-startup -P make_scene.py -- kept|said|odd|far|tiny|empty FILE.blend: scenes for test_export.py.

kept: what must arrive complete. said: what must be said since it cannot. odd: what is straightened, told
apart or left out. far: a million metres from the origin. tiny: of a picture without pixels. empty: no light, no camera.
"""
import math
import sys

import bpy
from mathutils import Vector


def clear():
    for things in (bpy.data.objects, bpy.data.meshes, bpy.data.lights, bpy.data.cameras, bpy.data.materials):
        for thing in list(things):
            things.remove(thing)


def add(name, data, location=(0.0, 0.0, 0.0), target=None, collection=None):
    """`target`: what its -z axis points at."""
    thing = bpy.data.objects.new(name, data)
    thing.location = location
    if target:
        thing.rotation_euler = (Vector(target) - Vector(location)).to_track_quat("-Z", "Y").to_euler()
    (collection or bpy.context.scene.collection).objects.link(thing)
    return thing


def mesh(name, vertices, faces, is_smooth=False):
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    data.polygons.foreach_set("use_smooth", [is_smooth] * len(faces))
    return data


def cube(name, is_smooth=False):
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return mesh(name, corners, faces, is_smooth)


def card(name):
    """A unit square, upright, with texture coordinates from 0 to 1."""
    data = mesh(name, [(-0.5, 0, 0), (0.5, 0, 0), (0.5, 0, 1), (-0.5, 0, 1)], [(0, 1, 2, 3)])
    layer = data.uv_layers.new(name="UVMap")
    for loop, uv in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
        layer.data[loop].uv = uv
    return data


def prism(name, sides):
    ring = [(math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)) for k in range(sides)]
    vertices = [(x, y, z) for z in (0.0, 1.0) for x, y in ring]
    walls = [(k, (k + 1) % sides, sides + (k + 1) % sides, sides + k) for k in range(sides)]
    return mesh(name, vertices, [tuple(reversed(range(sides))), tuple(range(sides, 2 * sides)), *walls])


def checkerboard(name, count, is_alpha):
    """count x count texels, the lowest left one solid; but the lowest row is solid, so that up and down differ."""
    image = bpy.data.images.new(name, count, count, alpha=True)
    pixels = []
    for y in range(count):
        for x in range(count):
            solid = float(y == 0 or (x + y) % 2 == 0)
            pixels += [1.0, 1.0, 1.0, solid] if is_alpha else [solid, solid, solid, 1.0]
    image.pixels.foreach_set(pixels)
    image.update()
    image.pack()
    return image


def image_node(nodes, image, interpolation):
    node = nodes.new("ShaderNodeTexImage")
    node.image, node.interpolation = image, interpolation
    return node


def leaf_of_alpha():
    """Principled in a group, with the picture's alpha, clipped."""
    group = bpy.data.node_groups.new("surface", "ShaderNodeTree")
    group.inputs.new("NodeSocketFloat", "Alpha")
    group.outputs.new("NodeSocketShader", "Shader")
    start, end, shader = (group.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput", "ShaderNodeBsdfPrincipled"))
    group.links.new(start.outputs["Alpha"], shader.inputs["Alpha"])
    group.links.new(shader.outputs[0], end.inputs[0])
    material = bpy.data.materials.new("leaf")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    picture = image_node(nodes, checkerboard("leaf_alpha", 8, True), "Closest")
    inner = nodes.new("ShaderNodeGroup")
    inner.node_tree = group
    links.new(picture.outputs["Alpha"], inner.inputs["Alpha"])
    links.new(inner.outputs[0], nodes["Material Output"].inputs["Surface"])
    material.blend_method, material.alpha_threshold = "CLIP", 0.4
    return material


def leaf_of_color():
    """Mixed with Transparent by one minus a colour, the picture twice across."""
    material = bpy.data.materials.new("grate")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    picture = image_node(nodes, checkerboard("grate_color", 4, False), "Linear")
    picture.image.colorspace_settings.name = "Non-Color"  # Cycles and EEVEE interpolate colours differently
    coordinates, mapping = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = (2.0, 1.0, 1.0)
    links.new(coordinates.outputs["UV"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], picture.inputs["Vector"])
    turned = nodes.new("ShaderNodeMath")
    turned.operation, turned.inputs[0].default_value = "SUBTRACT", 1.0
    links.new(picture.outputs["Color"], turned.inputs[1])
    cut = nodes.new("ShaderNodeMath")
    cut.operation, cut.inputs[1].default_value = "GREATER_THAN", 0.5
    links.new(turned.outputs[0], cut.inputs[0])
    mix = nodes.new("ShaderNodeMixShader")
    links.new(cut.outputs[0], mix.inputs["Fac"])
    links.new(nodes["Principled BSDF"].outputs[0], mix.inputs[1])
    links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], nodes["Material Output"].inputs["Surface"])
    return material


def add_light(name, kind, location=(0.0, 0.0, 0.0), target=None, **values):
    data = bpy.data.lights.new(name, kind)
    for key, value in values.items():
        setattr(data, key, value)
    return add(name, data, location, target)


def grid_of_cubes():
    """Geometry nodes: a cube on each of 2 x 2 points."""
    tree = bpy.data.node_groups.new("grid", "GeometryNodeTree")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    grid, box = tree.nodes.new("GeometryNodeMeshGrid"), tree.nodes.new("GeometryNodeMeshCube")
    for name, value in (("Size X", 1.0), ("Size Y", 1.0), ("Vertices X", 2), ("Vertices Y", 2)):
        grid.inputs[name].default_value = value
    box.inputs["Size"].default_value = (0.2, 0.2, 0.2)
    instances, output = tree.nodes.new("GeometryNodeInstanceOnPoints"), tree.nodes.new("NodeGroupOutput")
    tree.links.new(grid.outputs["Mesh"], instances.inputs["Points"])
    tree.links.new(box.outputs["Mesh"], instances.inputs["Instance"])
    tree.links.new(instances.outputs["Instances"], output.inputs[0])
    return tree


def add_particles(emitter, kind, render_type, thing=None):
    emitter.modifiers.new("particles", "PARTICLE_SYSTEM")
    settings = emitter.particle_systems[-1].settings
    settings.type, settings.count, settings.render_type = kind, 3, render_type
    if thing:
        settings.instance_object, settings.particle_size, settings.hair_length = thing, 0.25, 1.0


def add_camera(name, location, target, **values):
    camera = add(name, bpy.data.cameras.new(name), location, target)
    for key, value in values.items():
        setattr(camera.data, key, value)
    return camera


def make_kept(scene):
    scene.unit_settings.scale_length = 0.5
    floor = add("floor", mesh("floor", [(-6, -6, 0), (6, -6, 0), (6, 6, 0), (-6, 6, 0)], [(0, 1, 2, 3)]))
    floor.data.materials.append(bpy.data.materials.new("plain"))

    row = add("row", cube("row", is_smooth=True), (-2.2, 1.6, 0.55))
    row.scale = (0.5, 0.5, 0.5)
    smooth = row.modifiers.new("smooth", "SUBSURF")
    smooth.levels, smooth.render_levels = 1, 2
    array = row.modifiers.new("array", "ARRAY")
    array.count, array.relative_offset_displace = 3, (1.3, 0.0, 0.0)

    posts = bpy.data.collections.new("posts")
    add("post", prism("post", 12), collection=posts)
    for k, scale in enumerate(((0.15, 0.15, 1.6), (0.3, 0.1, 1.2), (-0.2, 0.2, 0.8))):
        stand = add(f"stand{k}", None, (1.2 + 0.8 * k, 1.0, 0.0))
        stand.scale, stand.rotation_euler = scale, (0.0, 0.0, 0.4 * k)
        stand.instance_type, stand.instance_collection = "COLLECTION", posts

    hidden = add("hidden", cube("hidden"), (0, 0, 2))
    hidden.hide_render = True
    scattered = add("scattered", mesh("points", [(0, 0, 0)], []), (-3.2, -0.6, 0.1))
    scattered.modifiers.new("grid", "NODES").node_group = grid_of_cubes()
    pebble = add("pebble", cube("pebble"), (0, 0, -50))
    bed = add("bed", mesh("bed", [(1, -2, 0.01), (3, -2, 0.01), (3, 0, 0.01), (1, 0, 0.01)], [(0, 1, 2, 3)]))
    add_particles(bed, "HAIR", "OBJECT", pebble)

    leaf = add("leaf", card("leaf"), (-0.6, -0.9, 0.05))
    leaf.data.materials.append(leaf_of_alpha())
    leaf.scale, leaf.rotation_euler = (1.4, 1.4, 1.4), (0.0, 0.0, 0.3)
    grate = add("grate", card("grate"), (0.9, -0.4, 0.05))
    grate.data.materials.append(leaf_of_color())

    window = add_light("window", "AREA", (-3, -2, 4), (0, 0, 0), shape="RECTANGLE", size=0.6, size_y=0.5)
    window.scale = (2.0, 1.0, 1.0)
    add_light("lamp", "AREA", (2.5, -2.5, 3.5), (0, 0, 0), shape="DISK", size=0.8)
    add_light("bulb", "POINT", (0.2, 2.6, 2.8), shadow_soft_size=0.2)
    add_light("sun", "SUN", (0, 0, 5), (1.5, 1.5, 0.0), angle=math.radians(2.0))
    scene.camera = add_camera("front", (0.5, -6.5, 3.6), (0.1, 0.0, 0.4), lens=40.0)
    add_camera("shifted", (-5.5, -4.0, 3.0), (0.0, 0.0, 0.5), shift_x=0.1, shift_y=-0.2)
    scene.world = None


def make_said(scene):
    ground = add("ground", cube("ground"))
    add("smoke", bpy.data.volumes.new("smoke"))
    add_particles(ground, "HAIR", "PATH")
    glass, glow, fog, blend, noise = (bpy.data.materials.new(name) for name in ("glass", "glow", "fog", "blend", "noise"))
    for material in (glass, glow, fog, blend, noise):
        material.use_nodes = True
        thing = add(material.name, cube(material.name), (3, 0, 0))
        thing.data.materials.append(material)
    glass.node_tree.nodes["Principled BSDF"].inputs["Transmission"].default_value = 1.0
    glow.node_tree.nodes["Principled BSDF"].inputs["Emission"].default_value = (1, 1, 1, 1)
    fog.node_tree.links.new(fog.node_tree.nodes.new("ShaderNodeVolumePrincipled").outputs[0],
                            fog.node_tree.nodes["Material Output"].inputs["Volume"])
    blend.node_tree.nodes["Principled BSDF"].inputs["Alpha"].default_value = 0.7
    noise.node_tree.links.new(noise.node_tree.nodes.new("ShaderNodeTexNoise").outputs["Fac"],
                              noise.node_tree.nodes["Principled BSDF"].inputs["Alpha"])
    shy = add("shy", cube("shy"), (0, 5, 0))
    shy.visible_shadow = False
    add_light("oval", "AREA", (0, 0, 5), (0, 0, 0), shape="ELLIPSE", size=2.0, size_y=1.0, spread=math.radians(90.0))
    add_light("cone", "SPOT", (0, 3, 5), (0, 0, 0))
    add_light("dim", "POINT", (0, 0, 9), energy=0.0)
    scene.camera = add_camera("near", (4, -6, 3), (0, 0, 0))
    scene.camera.data.dof.use_dof = True
    add_camera("plan", (0, 0, 9), (0, 0, 0), type="ORTHO")
    scene.world = bpy.data.worlds.new("sky")
    scene.world.color = (0.5, 0.5, 0.5)


def make_odd(scene):
    """What has to be straightened, told apart or left out."""
    add("floor", mesh("floor", [(-6, -6, 0), (6, -6, 0), (6, 6, 0), (-6, 6, 0)], [(0, 1, 2, 3)]))
    add("box", cube("box"), (0.3, 0.2, 1.0))
    for name, x in (("a/b", -3), ("a_b", 3), ("A_B", 0), ("surfaces.exr", 1), ("..", 2)):
        add_light(name, "POINT", (x, -2, 4), shadow_soft_size=0.2)
    stretched = add("stretched", None)
    stretched.scale = (1.0, 1.0, 2.5)
    sheared = add_light("sheared", "AREA", (-2, -2, 2), (0, 0, 0), shape="RECTANGLE", size=1.5, size_y=1.0)
    sheared.rotation_euler.rotate_axis("Z", 0.6)
    sheared.parent = stretched
    add_light("empty", "AREA", (0, 0, 5), (0, 0, 0), shape="RECTANGLE", size=0.0)
    for name, kind in (("flat", "AREA"), ("flat_sun", "SUN")):
        add_light(name, kind, (0, 0, 5)).scale = (0.0, 0.0, 0.0)
    mirrored = add_camera("mirrored", (0.5, -6.5, 3.6), (0.1, 0.0, 0.4))
    mirrored.scale = (-1.0, 1.0, 1.0)
    leaning = add_camera("leaning", (-4.5, -4.0, 1.5), (0.0, 0.0, 0.2))
    leaning.parent = stretched
    add_camera("nothing", (0, 0, 9), (0, 0, 0)).scale = (0.0, 0.0, 0.0)
    scene.camera = mirrored
    scene.world = None


def make_far(scene):
    add("box", cube("box"), (1e6, 0, 0))
    add_light("bulb", "POINT", (1e6, -2, 4), shadow_soft_size=0.2)
    scene.camera = add_camera("near", (1e6, -6, 3), (1e6, 0, 0))
    scene.world = None


def make_tiny(scene):
    make_kept(scene)
    scene.render.resolution_x = scene.render.resolution_y = 64
    scene.render.resolution_percentage = 1


def main():
    kind, file = sys.argv[sys.argv.index("--") + 1:]
    clear()
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 480, 272, 50
    {"kept": make_kept, "said": make_said, "odd": make_odd, "far": make_far, "tiny": make_tiny, "empty": lambda scene: None}[kind](scene)
    bpy.ops.wm.save_as_mainfile(filepath=file)


if __name__ == "__main__":
    main()
