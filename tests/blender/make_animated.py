# SPDX-License-Identifier: Apache-2.0
"""blender -b --factory-startup -P make_animated.py -- FOLDER: a moving box, an arm that two bones bend, and a swelling ball, with
cameras and lights, as animated.glb and animated.fbx by Blender's own exporters; truth.json holds Blender's own answers.

Positions in truth.json are y up, in metres.
"""
import json
import math
import os
import sys

import bpy
from mathutils import Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from make_scene import add, clear, cube, mesh  # noqa: E402

FRAMES = (1, 9, 20)
LAST_FRAME = 24


def y_up(p):
    return [p[0], p[2], -p[1]]


def add_box():
    """It goes, turns and grows; its curve is Blender's own Bezier."""
    box = add("box", cube("box"), (2.0, 0.0, 1.0))
    for frame, place, angle, size in ((1, (2, 0, 1), 0.0, 1.0), (12, (2, 3, 1.5), 1.2, 0.5), (24, (4, 1, 1), 2.0, 1.5)):
        box.location, box.rotation_euler, box.scale = place, (0.0, 0.3 * angle, angle), (size, 1.0, size)
        for path in ("location", "rotation_euler", "scale"):
            box.keyframe_insert(path, frame=frame)


def add_arm():
    """A beam along z of four segments; two bones, the upper one bends, the lower one turns."""
    rings = [(x, y, z) for z in (0.0, 1.0, 2.0, 3.0, 4.0) for x, y in ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2))]
    sides = [(4 * k + i, 4 * k + (i + 1) % 4, 4 * k + 4 + (i + 1) % 4, 4 * k + 4 + i) for k in range(4) for i in range(4)]
    beam = add("beam", mesh("beam", rings, [(3, 2, 1, 0), *sides, (16, 17, 18, 19)]))
    bones = bpy.data.armatures.new("bones")
    rig = add("rig", bones, (-3.0, 1.0, 0.0))
    beam.parent = rig
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    lower, upper = bones.edit_bones.new("lower"), bones.edit_bones.new("upper")
    lower.head, lower.tail = (0, 0, 0), (0, 0, 2)
    upper.head, upper.tail, upper.parent = (0, 0, 2), (0, 0, 4), lower
    bpy.ops.object.mode_set(mode="OBJECT")
    for name, share in (("lower", (1, 1, 0.5, 0, 0)), ("upper", (0, 0, 0.5, 1, 1))):
        group = beam.vertex_groups.new(name=name)
        for v in range(20):
            if share[v // 4] > 0:
                group.add([v], share[v // 4], "REPLACE")
    beam.modifiers.new("rig", "ARMATURE").object = rig
    for name, keys in (("lower", ((1, 0.0), (24, 0.6))), ("upper", ((1, 0.0), (12, 1.3), (24, -0.4)))):
        bone = rig.pose.bones[name]
        bone.rotation_mode = "XYZ"
        for frame, angle in keys:
            bone.rotation_euler = (angle, 0.2 * angle, 0.0)
            bone.keyframe_insert("rotation_euler", frame=frame)


def add_ball():
    """A shape key that swells it."""
    ball = add("ball", cube("ball"), (0.0, -2.0, 1.0))
    ball.shape_key_add(name="Basis")
    swollen = ball.shape_key_add(name="swollen")
    for point in swollen.data:
        point.co = point.co * 1.5 + Vector((0.0, 0.0, 0.25))
    for frame, value in ((1, 0.0), (24, 1.0)):
        swollen.value = value
        swollen.keyframe_insert("value", frame=frame)


def add_views():
    """Two cameras; a point, a sun, a spot and an area, some with a size among their own properties."""
    for name, place, lens in (("eye", (9.0, -12.0, 6.0), 40.0), ("other", (-8.0, -9.0, 4.0), 60.0)):
        camera = bpy.data.cameras.new(name)
        camera.lens = lens
        add(name, camera, place, (0.0, 0.0, 1.0))
    for name, kind, place, properties in (("bulb", "POINT", (1.0, 2.0, 6.0), {"radius": 0.25}),
                                          ("sky", "SUN", (0.0, 0.0, 9.0), {"angular_diameter_deg": 2.0}),
                                          ("torch", "SPOT", (-4.0, -3.0, 5.0), {}),
                                          ("panel", "AREA", (3.0, -4.0, 7.0), {"size": [1.5, 0.5]})):
        lamp = add(name, bpy.data.lights.new(name, kind), place, (0.5, 0.5, 0.0))
        for key, value in properties.items():
            lamp[key] = value


def positions(scene):
    """Of every mesh as it is now, sorted."""
    graph = bpy.context.evaluated_depsgraph_get()
    every = {}
    for thing in scene.objects:
        if thing.type != "MESH":
            continue
        seen = thing.evaluated_get(graph)
        data = seen.to_mesh()
        every[thing.name] = sorted(y_up(seen.matrix_world @ vertex.co) for vertex in data.vertices)
        seen.to_mesh_clear()
    return every


def views(scene):
    every = {}
    for thing in scene.objects:
        if thing.type not in ("CAMERA", "LIGHT"):
            continue
        turn = thing.matrix_world.to_3x3()
        every[thing.name] = {"place": y_up(thing.matrix_world.translation),
                             "forward": y_up(turn @ Vector((0, 0, -1))), "up": y_up(turn @ Vector((0, 1, 0)))}
        if thing.type == "CAMERA":
            width_fov = thing.data.angle_x
            every[thing.name]["fov_deg"] = math.degrees(2 * math.atan(math.tan(width_fov / 2) * 9 / 16))
    return every


def main():
    folder = sys.argv[sys.argv.index("--") + 1]
    clear()
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, LAST_FRAME
    scene.render.fps = 24
    scene.render.resolution_x, scene.render.resolution_y = 1600, 900
    add("floor", mesh("floor", [(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [(0, 1, 2, 3)]))
    add_box()
    add_arm()
    add_ball()
    add_views()
    scene.frame_set(1)
    truth = {"fps": 24, "frames": {}, "views": views(scene)}
    for frame in FRAMES:
        scene.frame_set(frame)
        truth["frames"][frame] = positions(scene)
    scene.frame_set(1)
    with open(os.path.join(folder, "truth.json"), "w", encoding="utf-8") as out:
        json.dump(truth, out)
    bpy.ops.export_scene.gltf(filepath=os.path.join(folder, "animated.glb"), export_format="GLB", export_cameras=True,
                              export_lights=True, export_extras=True)
    bpy.ops.export_scene.fbx(filepath=os.path.join(folder, "animated.fbx"), use_custom_props=True,
                             bake_anim_use_nla_strips=False, bake_anim_use_all_actions=False)


if __name__ == "__main__":
    main()
