# SPDX-License-Identifier: Apache-2.0
"""A scene as `scene export` makes it (docs/your-engine.md), in Blender. World axes stay as they are: Blender knows no up."""
import math

import bpy
import surfaces
from mathutils import Matrix, Vector


def read_mesh(path):
    """Vertices, triangles, and a normal for each corner, or None where the scene has none."""
    vertices, normals, faces, face_normals = [], [], [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append(tuple(float(word) for word in words[1:4]))
            elif words[:1] == ["vn"]:
                normals.append(tuple(float(word) for word in words[1:4]))
            elif words[:1] == ["f"]:
                corners = [word.split("/") for word in words[1:]]
                faces.append(tuple(int(corner[0]) - 1 for corner in corners))
                face_normals.extend(int(corner[2]) - 1 for corner in corners if len(corner) == 3)
    return vertices, faces, [normals[i] for i in face_normals] or None


def clear():
    for things in (bpy.data.objects, bpy.data.meshes, bpy.data.lights, bpy.data.cameras, bpy.data.materials):
        for thing in list(things):
            things.remove(thing)


def columns(x, y, z, origin):
    """A matrix whose columns are three axes and an origin."""
    rows = [[x[i], y[i], z[i], origin[i]] for i in range(3)]
    return Matrix(rows + [[0.0, 0.0, 0.0, 1.0]])


def add(name, data, matrix):
    thing = bpy.data.objects.new(name, data)
    thing.matrix_world = matrix
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_body(mesh, material):
    vertices, faces, normals = mesh
    data = bpy.data.meshes.new("scene")
    data.from_pydata(vertices, [], faces)
    if normals:
        data.polygons.foreach_set("use_smooth", [True] * len(faces))
        data.use_auto_smooth = True
        data.normals_split_custom_set(normals)
    data.materials.append(material)
    return add("scene", data, Matrix.Identity(4))


def add_camera(camera, extent):
    eye, at, up = (Vector(camera[key]) for key in ("eye_world", "at_world", "up_world"))
    back = (eye - at).normalized()
    right = up.cross(back).normalized()
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(camera["vertical_fov_deg"])
    data.clip_start = camera["near_world"]
    data.clip_end = 1.01 * extent
    bpy.context.scene.camera = add("camera", data, columns(right, back.cross(right), back, eye))


def add_light(light):
    """Its data. Area lights for rect and disk, POINT with a radius for sphere, SUN with an angle for sun."""
    kind = light["type"]
    data = bpy.data.lights.new("light", "SUN" if kind == "sun" else "POINT" if kind == "sphere" else "AREA")
    center = light.get("center_world", (0.0, 0.0, 0.0))
    back, tangent = -Vector(light["direction_world"]), Vector(light["tangent_world"])
    if kind == "sun":
        data.angle = math.radians(light["angular_diameter_deg"])
    if kind == "sphere":
        data.shadow_soft_size = light["radius_world"]
    if kind == "rect":
        data.shape = "RECTANGLE"
        data.size, data.size_y = light["size_world"]
    if kind == "disk":
        data.shape = "DISK"
        data.size = 2.0 * light["radius_world"]
    data.energy = 100.0
    thing = add("light", data, columns(tangent, back.cross(tangent), back, center))
    thing.visible_camera = False
    return data


def build(mesh, description):
    """The one scene there is, anew: the body, the light's data, and Blender's scene with its camera. No world and no curve."""
    clear()
    vertices = mesh[0]
    eye = Vector(description["camera"]["eye_world"])
    extent = max((Vector(vertex) - eye).length for vertex in vertices)
    body = add_body(mesh, surfaces.white(eye, extent))
    add_camera(description["camera"], extent)
    light = add_light(description["light"])
    scene = bpy.context.scene
    scene.world = None
    scene.view_settings.view_transform = "Raw"
    return body, light, scene


def set_size(scene, width, height):
    render = scene.render
    render.resolution_x, render.resolution_y = width, height
    render.resolution_percentage = 100
    render.film_transparent = True
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.image_settings.color_mode = "RGBA"
