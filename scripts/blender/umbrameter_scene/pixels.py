# SPDX-License-Identifier: Apache-2.0
"""Pictures of image nodes as arrays, rows from below, and as PNG files."""
import struct
import zlib

import numpy

FINEST = 32  # texels of a mask a texel of a picture that is interpolated
MAX_TEXELS = 2048  # a side, for that


def of_texture(node, refine):
    """[height][width][RGBA] of a node's picture; `refine`: as its interpolation shows it."""
    from .masks import NotRead
    image = node.image
    if image is None:
        raise NotRead("its picture is not set")
    if image.source not in ("FILE", "GENERATED"):
        raise NotRead(f"its picture is a {image.source.lower()}")
    width, height = image.size
    if width == 0 or height == 0:
        raise NotRead(f"its picture '{image.name}' is not there")
    values = numpy.empty(width * height * 4, dtype=numpy.float32)
    image.pixels.foreach_get(values)
    values = values.reshape(height, width, 4)
    factor = min(FINEST, MAX_TEXELS // max(width, height))
    if not refine or node.interpolation == "Closest" or factor < 2:
        return values
    for axis in (0, 1):
        values = refined(values, axis, factor, repeats=node.extension == "REPEAT")
    return values


def refined(values, axis, factor, repeats):
    """Linearly interpolated between texels' centres, at the centres of `factor` times as many."""
    count = values.shape[axis]
    at = (numpy.arange(count * factor) + 0.5) / factor - 0.5
    low = numpy.floor(at).astype(int)
    share = (at - low).reshape([-1 if i == axis else 1 for i in range(values.ndim)]).astype(numpy.float32)

    def texels(index):
        return numpy.take(values, index % count if repeats else numpy.clip(index, 0, count - 1), axis=axis)

    return (1.0 - share) * texels(low) + share * texels(low + 1)


def linear_colors(image, values):
    colors = values[..., :3].astype(float)
    if image.is_float or image.colorspace_settings.name != "sRGB":
        return colors
    return numpy.where(colors <= 0.04045, colors / 12.92, ((colors + 0.055) / 1.055) ** 2.4)


def png_of_mask(solid):
    """White, with alpha where it is solid."""
    height, width = solid.shape
    rows = numpy.full((height, 1 + 4 * width), 255, dtype=numpy.uint8)
    rows[:, 0] = 0  # filter: none
    rows[:, 4::4] = numpy.where(solid[::-1], 255, 0)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))
