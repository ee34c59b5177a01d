# SPDX-License-Identifier: Apache-2.0
"""Evaluated meshes as one GLB file: a mesh is stored once, an instance is a node."""
import json
import struct

import numpy

from . import pixels, space

FLOAT, UNSIGNED_INT = 5126, 5125
MASK_CUTOFF = 0.5


class Writer:
    def __init__(self):
        self.chunks, self.length = [], 0
        self.views, self.accessors, self.meshes, self.materials, self.images, self.nodes = [], [], [], [], [], []
        self.material_of = {}

    def view(self, data):
        self.views.append({"buffer": 0, "byteOffset": self.length, "byteLength": len(data)})
        padded = data + b"\0" * (-len(data) % 4)
        self.chunks.append(padded)
        self.length += len(padded)
        return len(self.views) - 1

    def accessor(self, values, component, kind):
        entry = {"bufferView": self.view(values.tobytes()), "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            entry["min"], entry["max"] = values.min(axis=0).tolist(), values.max(axis=0).tolist()
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def material(self, primitive):
        key = (primitive.material, primitive.mask is not None)
        if key in self.material_of:
            return self.material_of[key]
        entry = {"name": primitive.material}
        if primitive.mask is not None:
            self.images.append({"name": primitive.mask.name, "mimeType": "image/png",
                                "bufferView": self.view(pixels.png_of_mask(primitive.mask.solid))})
            entry["alphaMode"], entry["alphaCutoff"] = "MASK", MASK_CUTOFF
            entry["pbrMetallicRoughness"] = {"baseColorTexture": {"index": len(self.images) - 1}}
        self.materials.append(entry)
        self.material_of[key] = len(self.materials) - 1
        return self.material_of[key]

    def primitive(self, primitive):
        attributes = {"POSITION": self.accessor(primitive.positions, FLOAT, "VEC3")}
        if primitive.normals is not None:
            attributes["NORMAL"] = self.accessor(primitive.normals, FLOAT, "VEC3")
        if primitive.uvs is not None:
            downwards = numpy.stack([primitive.uvs[:, 0], numpy.float32(1.0) - primitive.uvs[:, 1]], axis=1)
            attributes["TEXCOORD_0"] = self.accessor(downwards, FLOAT, "VEC2")
        entry = {"attributes": attributes, "indices": self.accessor(primitive.triangles.ravel(), UNSIGNED_INT, "SCALAR")}
        if primitive.material:
            entry["material"] = self.material(primitive)
        return entry

    def mesh(self, name, primitives):
        self.meshes.append({"name": name, "primitives": [self.primitive(one) for one in primitives]})
        return len(self.meshes) - 1

    def file(self):
        tree = {"asset": {"version": "2.0", "generator": "umbrameter_blender"}, "scene": 0,
                "scenes": [{"nodes": list(range(len(self.nodes)))}], "nodes": self.nodes, "meshes": self.meshes,
                "accessors": self.accessors, "bufferViews": self.views, "buffers": [{"byteLength": self.length}]}
        if self.materials:
            tree["materials"] = self.materials
        if self.images:
            tree["images"] = self.images
            tree["textures"] = [{"source": i} for i in range(len(self.images))]
        text = json.dumps(tree, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        data = b"".join(self.chunks)
        header = struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(data))
        return header + struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data


def file_of(evaluated, metres):
    writer = Writer()
    index = {}
    for instance in evaluated.instances:
        if instance.mesh not in index:
            index[instance.mesh] = writer.mesh(*evaluated.meshes[instance.mesh])
        columns = space.matrix(instance.matrix, metres).T.ravel().tolist()
        writer.nodes.append({"name": instance.name, "mesh": index[instance.mesh], "matrix": columns})
    return writer.file()
