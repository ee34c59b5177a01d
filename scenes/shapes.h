// SPDX-License-Identifier: Apache-2.0
#pragma once
// Procedural meshes. y is up; lengths are world units. Solids are closed; sheets have no thickness. No parts
// are set.

#include "scenes/mesh_data.h"

#include <glm/vec2.hpp>

namespace umbrameter {

/// Horizontal rectangle facing +y, centred on the origin; `size` along x and z.
MeshData make_plane(const glm::dvec2& size);

/// Box standing on y = 0, centred in x and z.
MeshData make_box(const glm::dvec3& size);

/// Horizontal plate centred on the origin; thickness 0 is a sheet.
MeshData make_plate(const glm::dvec2& size, double thickness);

/// Sphere around the origin: `segments` meridians, segments / 2 rings, vertices on the sphere.
MeshData make_sphere(double radius, int segments, bool smooth);

/// Horizontal regular polygon facing +y with its `segments` corners on the circle.
MeshData make_disk(double radius, int segments);

/// `count` parallel sheets of width `bar` and length `length` along z, one every `period` along x, centred.
MeshData make_comb(int count, double period, double bar, double length);

/// Closed prism of `segments` sides along x, centred on the origin, corners at `radius`.
MeshData make_wire(double radius, double length, int segments);

/// `count` solid steps rising along -z from the origin; each is size.x wide, size.y high and size.z deep.
MeshData make_stairs(int count, const glm::dvec3& size);

/// `count` columns standing on y = 0 in a row along x, centred, and a lintel box on top of them with
/// lintel.x along z and lintel.y high (both 0: none).
MeshData make_colonnade(int count, double spacing, double radius, double height, int segments,
                        const glm::dvec2& lintel);

}  // namespace umbrameter
