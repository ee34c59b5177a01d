# SPDX-License-Identifier: Apache-2.0
"""Blender's lights as ours: tables of [[light]]."""
import math

import numpy

from . import space

SMALLEST_RADIUS_M = 0.001
SUN_DEG = (0.001, 90.0)  # what is told from a point, and what our suns reach


def toml(light, name, middle, metres, said):
    """The keys of a light; None where it is left out. `middle` is the scene's, in Blender's world."""
    values = light.values
    if values["is_portal"]:
        return None  # a hint for Cycles, no light
    if values["energy"] == 0.0:
        said.add("lights without power are left out", name)
        return None
    if values["has_nodes"]:
        said.add("lights' own nodes (textures, IES) are left out", name)
    if not (values["use_shadow"] and values["casts_in_cycles"]):
        said.add("lights that cast no shadow in Blender do", name)
    axes, scales = space.axes_of(light.matrix)
    if values["type"] != "POINT" and space.is_nothing(scales):
        said.add("lights that are scaled to nothing are left out", name)
        return None
    keys = {"name": name, "type": "sun"}
    if values["type"] == "SUN":
        return {**keys, "direction": space.direction(-axes[2]), "angular_diameter_deg": sun_deg(values["angle"], name, said)}
    center = light.matrix[:3, 3]
    keys["center"] = space.point(center, metres)
    if values["type"] == "AREA":
        shape = area(light, axes, scales, name, metres, said)
        return shape and {**keys, **shape}
    towards = -axes[2] if values["type"] == "SPOT" else middle - center
    if values["type"] == "SPOT":
        said.add("spots are spheres without the edges of their cone", name)
    radius_m = values["shadow_soft_size"] * metres
    if radius_m < SMALLEST_RADIUS_M:
        said.add(f"point lights without a size have a radius of {SMALLEST_RADIUS_M} m", name)
    length = float(numpy.linalg.norm(towards))
    return {**keys, "type": "sphere", "direction": space.direction(towards if length > 0.0 else (0.0, 0.0, -1.0)),
            "radius": max(radius_m, SMALLEST_RADIUS_M)}


def sun_deg(angle_rad, name, said):
    degrees = math.degrees(angle_rad)
    taken = min(max(degrees, SUN_DEG[0]), SUN_DEG[1])
    if taken != degrees:
        said.add(f"suns of {degrees:.3g} degrees have {taken:g}", name)
    return taken


def area(light, axes, scales, name, metres, said):
    """Rect or disk; None without a size. Its x and y axes come scaled with its object."""
    values = light.values
    if values["spread"] < math.pi - 1e-4:
        said.add("area lights' spread is left out: ours shine to the whole side they face", name)
    is_one_number = values["shape"] in ("SQUARE", "DISK")
    width = values["size"] * scales[0] * metres
    height = (values["size"] if is_one_number else values["size_y"]) * scales[1] * metres
    across = numpy.cross(axes[0], axes[1])
    if space.is_nothing((width, height, float(numpy.linalg.norm(across)))):
        said.add("area lights without a size are left out", name)
        return None
    back = across / numpy.linalg.norm(across)
    back = back if numpy.dot(back, axes[2]) >= 0.0 else -back
    if max(abs(float(numpy.dot(axes[0], axes[1]))), 1.0 - float(numpy.dot(back, axes[2]))) > 1e-4:
        said.add("area lights that are sheared are not: they lie in the same plane, with right angles", name)
        columns = [axes[0] * scales[0], numpy.cross(back, axes[0]) * scales[1], back]
        light.matrix[:3, :3] = numpy.stack(columns, axis=1)  # pictures have ours
    keys = {"direction": space.direction(-back), "tangent": space.direction(axes[0])}
    if values["shape"] in ("SQUARE", "RECTANGLE"):
        return {**keys, "type": "rect", "size": numpy.array([width, height])}
    if abs(width - height) > 1e-4 * max(width, height):
        said.add("ellipses are disks of the same area", name)
    return {**keys, "type": "disk", "radius": 0.5 * math.sqrt(width * height)}
