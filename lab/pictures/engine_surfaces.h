// SPDX-License-Identifier: Apache-2.0
#pragma once
// Aligning another engine's picture with the reference: its surfaces where it brought any, and what cannot be known where it
// did not. Not here: files (lab/pictures/engine_file.h) and its shadows (lab/pictures/engine_image.h).

#include "core/image.h"
#include "lab/pictures/engine_file.h"
#include "scenes/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// How a depth channel is measured: along the camera's axis, or along the pixel's ray.
enum class DepthKind : uint8_t { axis, ray };

/// How an engine's coordinates become ours: p_world[k] = unit * sign[k] * p_theirs[axis[k]]; normals turn alike.
struct SurfaceSpace {
  std::array<int, 3> axis{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
  double unit = 1.0;  // of theirs, in ours

  bool operator==(const SurfaceSpace&) const = default;
};

/// "x,z,-y" (z up): our x, y and z by theirs. Error{input} for anything else.
SurfaceSpace parse_surface_space(std::string_view axes, double unit);
std::string to_text(const SurfaceSpace& space);

/// How surfaces are read.
struct SurfaceReading {
  const Camera* camera = nullptr;  // depth needs it
  DepthKind depth = DepthKind::axis;
  SurfaceSpace space;
};

/// Fills `test` with the channels that parity needs: those of `surfaces` (position, or depth with a camera; normal;
/// primitive_id; unshadowed_irradiance), else the reference's, which also stands where `surfaces` have no data. One
/// sentence for each that was taken from the reference, as whatever it would have told is not known then, and for readings
/// that fit far better (axes, units, the other depth) and channels that are the same in every pixel. Nothing is hit where
/// depth is no positive number or farther than the truth's farthest surface, and where a place is no number. Leaves `test`
/// alone when nothing of `surfaces` was understood. Error{input} for other sizes, and for depth without a camera.
std::vector<std::string> add_surfaces(const EngineSurfaces& surfaces, const SurfaceReading& reading,
                                      const Image& reference, Image& test);

/// Fills `test` with the reference's own surfaces, for a page that shows places.
void borrow_surfaces(const Image& reference, Image& test);

/// A mirrored or shifted (2 px) reading of `test` that fits the reference far better than it does as it stands: "upside
/// down", "mirrored", "2 px to the left"; absent when there is none. On `known` pixels.
std::optional<std::string> better_alignment(const Image& test, const Image& reference,
                                            std::span<const uint8_t> known);

/// Whether 1 - `test` fits the reference far better than `test`.
bool is_inverted(const Image& test, const Image& reference, std::span<const uint8_t> known);

}  // namespace umbrameter
