# SPDX-License-Identifier: Apache-2.0
"""Blender's cameras as ours: an eye, a direction and a vertical field of view, in square pixels."""
import dataclasses
import math

import numpy

from . import space
from .said import Refused

SIDES_PX = (4, 65536)  # a side of Blender's pictures


@dataclasses.dataclass
class Camera:
    name: str
    eye: numpy.ndarray  # Blender's world, as the two directions
    forward: numpy.ndarray
    up: numpy.ndarray
    vertical_fov_deg: float
    near: float  # Blender's units
    width_px: int
    height_px: int
    is_wider: bool = False  # than Blender's: shifted, or of pixels that are not square
    is_straightened: bool = False  # Blender's is mirrored or sheared

    def matrix(self):
        """4 x 4: Blender's world from a camera of Blender's that looks as ours."""
        made = numpy.eye(4)
        made[:3, :] = numpy.stack([numpy.cross(self.forward, self.up), self.up, -self.forward, self.eye], axis=1)
        return made

    def toml(self, middle, metres):
        """Keys of [camera]. `at` lies where the scene's middle is, along the view."""
        ahead = float(numpy.dot(middle - self.eye, self.forward))
        at = self.eye + (ahead if ahead > 0.0 else 1.0) * self.forward
        return {"eye": space.point(self.eye, metres), "at": space.point(at, metres), "up": space.direction(self.up),
                "fov_deg": self.vertical_fov_deg, "near": self.near * metres}


def picture_size(scene, width):
    """(width, height) in pixels: the render's, or `width` wide."""
    render = scene.render
    size = tuple(side * render.resolution_percentage // 100 for side in (render.resolution_x, render.resolution_y))
    if width:
        size = (width, round(render.resolution_y * width / render.resolution_x))
    if min(size) < SIDES_PX[0] or max(size) > SIDES_PX[1]:
        raise Refused(f"the picture would have {size[0]} x {size[1]} px, and Blender's have {SIDES_PX[0]} to {SIDES_PX[1]} a side (set the "
                      "render's resolution and its percentage, or give --width)")
    return size


def read(thing, depsgraph, scene, size, said):
    """None for a camera that is not perspective, or scaled to nothing."""
    data = thing.evaluated_get(depsgraph).data
    if data.type != "PERSP":
        said.add("cameras that are not perspective are left out", thing.name)
        return None
    matrix = numpy.array(thing.evaluated_get(depsgraph).matrix_world, dtype=float)
    axes, scales = space.axes_of(matrix)
    if space.is_nothing(scales):
        said.add("cameras that are scaled to nothing are left out", thing.name)
        return None
    back = axes[2]
    up = axes[1] - float(numpy.dot(axes[1], back)) * back
    up /= max(float(numpy.linalg.norm(up)), 1e-30)
    is_mirrored = bool(numpy.linalg.det(matrix[:3, :3]) < 0.0)
    is_sheared = max(abs(float(numpy.dot(axes[i], axes[j]))) for i, j in ((0, 1), (0, 2), (1, 2))) > 1e-4
    if is_mirrored:
        said.add("mirrored cameras are not: pictures are the mirror image of Blender's", thing.name)
    if is_sheared:
        said.add("sheared cameras are not: pictures are others than Blender's", thing.name)
    if data.dof.use_dof:
        said.add("cameras' depth of field is left out", thing.name)
    render = scene.render
    clip_from_view = thing.evaluated_get(depsgraph).calc_matrix_camera(
        depsgraph, x=size[0], y=size[1], scale_x=render.pixel_aspect_x, scale_y=render.pixel_aspect_y)
    low, high = (numpy.array([(side + clip_from_view[i][2]) / clip_from_view[i][i] for i in (0, 1)]) for side in (-1.0, 1.0))
    px_per_slope = size[1] / (high[1] - low[1])
    width, height = (math.ceil(2.0 * px_per_slope * max(-low[i], high[i]) - 1e-3) for i in (0, 1))
    is_wider = (width, height) != tuple(size)
    if is_wider:
        first, last = (px_per_slope * side + numpy.array([width, height]) / 2.0 for side in (low, high))
        said.add(f"shifted or anamorphic cameras see more: pictures have {width} x {height} px, and Blender's is columns {first[0]:.0f} "
                 f"to {last[0]:.0f} and rows {height - last[1]:.0f} to {height - first[1]:.0f} of them", thing.name)
    return Camera(thing.name, matrix[:3, 3], -back, up, math.degrees(2.0 * math.atan(height / (2.0 * px_per_slope))),
                  data.clip_start, width, height, is_wider, is_mirrored or is_sheared)
