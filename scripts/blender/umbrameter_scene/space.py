# SPDX-License-Identifier: Apache-2.0
"""Blender's world (z up, units of the scene's own) and ours (y up, metres)."""
import numpy

SMALLEST = 1e-9
Y_UP = numpy.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])


def metres_per_unit(scene):
    settings = scene.unit_settings
    return 1.0 if settings.system == "NONE" else settings.scale_length


def axes_of(matrix):
    """Unit axes and their lengths."""
    columns = [matrix[:3, i] for i in range(3)]
    lengths = [float(numpy.linalg.norm(column)) for column in columns]
    return [column / max(length, 1e-30) for column, length in zip(columns, lengths)], lengths


def is_nothing(lengths):
    """Whether a length is 0, or not finite."""
    return not all(SMALLEST < length < float("inf") for length in lengths)


def direction(vector):
    """A unit vector of ours."""
    turned = Y_UP @ numpy.array(vector, dtype=float)
    return turned / numpy.linalg.norm(turned)


def point(vector, metres):
    return metres * (Y_UP @ numpy.array(vector, dtype=float))


def matrix(world_from_local, metres):
    """4 x 4: from an object's own numbers to our world."""
    turned = numpy.eye(4)
    turned[:3, :] = metres * (Y_UP @ numpy.array(world_from_local, dtype=float)[:3, :])
    return turned
