# SPDX-License-Identifier: Apache-2.0
"""OpenEXR files of floats, not compressed, with channels of any name: Blender's Python writes none."""
import struct

import numpy

FLOAT = 2


def attribute(name, kind, data):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data


def file_of(channels):
    """`channels`: name -> [height][width], row 0 on top."""
    names = sorted(channels)
    height, width = channels[names[0]].shape
    listed = b"".join(name.encode() + b"\0" + struct.pack("<iiii", FLOAT, 0, 1, 1) for name in names) + b"\0"
    window = struct.pack("<iiii", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2) + attribute("channels", "chlist", listed)
    header += attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", window)
    header += attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", b"\0")
    header += attribute("pixelAspectRatio", "float", struct.pack("<f", 1.0))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0.0, 0.0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1.0)) + b"\0"
    pixels = numpy.stack([numpy.asarray(channels[name], dtype="<f4") for name in names], axis=1)  # [height][channel][width]
    row_bytes = 8 + pixels[0].nbytes
    first = len(header) + 8 * height
    offsets = struct.pack(f"<{height}Q", *(first + y * row_bytes for y in range(height)))
    rows = (struct.pack("<ii", y, pixels[y].nbytes) + pixels[y].tobytes() for y in range(height))
    return header + offsets + b"".join(rows)
