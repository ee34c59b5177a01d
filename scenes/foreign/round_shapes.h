// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes that renderers know and we make of triangles, in their own space.

#include "scenes/primitives.h"

namespace umbrameter {

/// Corners of a disk, meridians of a sphere.
inline constexpr int kRoundDisk = 256;
inline constexpr int kRoundSphere = 64;

/// From -1 to 1 in x and y, facing +z; texture coordinates from 0 to 1.
Primitive unit_rectangle();
/// Of radius 1 around the origin, facing +z.
Primitive unit_disk();
/// Of radius 1 around the origin, with the true sphere's normals.
Primitive unit_sphere();
/// From -1 to 1 along each axis.
Primitive unit_cube();

}  // namespace umbrameter
