// SPDX-License-Identifier: Apache-2.0
#pragma once
// Mitsuba scenes (.xml): of version 3, and of 2 and 0.6 where only names differ.

#include "scenes/foreign/foreign_scene.h"

#include <filesystem>

namespace umbrameter {

/// Shapes: obj, ply, rectangle, disk, cube, sphere, merge, shapegroup with instance. Disks and spheres become polygons of
/// kRoundSegments corners. bsdf `mask` (within twosided, too) makes holes where its opacity is below 0.5; a shape of bsdf `null`
/// is left out. Cameras: perspective, and thinlens as pinhole. Emitters: `area` on a rectangle, disk, sphere or a mesh that is a
/// rectangle, whose shape is no mesh then; point (a sphere), spot (a disk), directional (a sun), with sizes as for glTF.
/// Everything else is counted. Error{input} with file and line as read_mitsuba_tree(), for values that are not finite, objects
/// that are named and not there, or have two of one name, and mesh files that cannot be read.
ForeignScene read_mitsuba(const std::filesystem::path& path);

}  // namespace umbrameter
