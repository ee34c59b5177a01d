// SPDX-License-Identifier: Apache-2.0
#pragma once
// pbrt-v4 scenes (.pbrt) of triangles.

#include "scenes/foreign/foreign_scene.h"

#include <filesystem>

namespace umbrameter {

/// Shapes: trianglemesh, plymesh, bilinearmesh, disk, sphere (whole ones, of triangles), and instances of objects. `alpha`, a
/// number or a texture of class imagemap or constant, makes holes where it is below 0.5. Camera: perspective, as pinhole. Lights:
/// `diffuse` area lights on disks, spheres and meshes that are a rectangle, whose shape is no mesh then; point (a sphere),
/// spot (a disk), distant (a sun), with sizes as for glTF. pbrt's world is left-handed: x is negated, unless its camera mirrors
/// it itself (Scale -1 1 1). Everything else is counted. Error{input} with file and line for what is no pbrt file, values that
/// are not finite, indices of vertices that are not there, ends without a begin, files that are not there or include
/// themselves, and mesh files that cannot be read.
ForeignScene read_pbrt(const std::filesystem::path& path);

}  // namespace umbrameter
