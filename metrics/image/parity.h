// SPDX-License-Identifier: Apache-2.0
#pragma once
// Do both renderers see the same surfaces? Asked before any shadow number (METRICS 6.16).

#include "core/image.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct ParityTolerance {
  double relative_depth = 1e-3;       // |difference of positions| / distance to the eye, on other primitives
  double normal_deg = 5.0;            // between geometric normals, on other primitives
  double relative_irradiance = 0.02;  // of unshadowed irradiance, plus 1e-4 of the image's largest
  double required_agreement = 0.995;  // of covered pixels
};

/// Why a pixel is not scored. `unknown`: the surfaces agree, and the test picture says nothing about its shadow (channel
/// "known" is 0), as where an engine's own light does not reach.
enum class ParityClass : uint8_t { agrees, background, coverage, surface, irradiance, unknown };

struct Parity {
  int width = 0;
  int height = 0;
  std::vector<ParityClass> classes;  // [height][width]
  size_t covered = 0;                // hit in either renderer
  size_t coverage_mismatch = 0;      // hit in one only
  size_t surface_mismatch = 0;       // other primitive, and depth or normal differ
  size_t irradiance_mismatch = 0;
  size_t unknown = 0;  // agree, but are not scored
  size_t same_primitive = 0;
  double median_relative_depth_error = 0.0;
  double agreement = 0.0;  // agreeing / covered; 1 when nothing is covered
  bool passes = false;
  /// Whether it fails for the light alone: the surfaces would pass.
  bool is_other_light = false;
};

/// Compares position, normal, primitive_id and unshadowed_irradiance of two frames of one camera. The same
/// primitive agrees; another one still agrees when position and normal do (an edge between two triangles of
/// one surface falls on either side). Error{input} on size mismatch, missing channels, NaN.
Parity compare_surfaces(const Image& test, const Image& reference, const glm::dvec3& eye_world,
                        const ParityTolerance& tolerance = {});

/// 1 where a pixel is scored: surfaces agree and the light can reach it (unshadowed irradiance above 1e-6 of
/// the image's largest).
std::vector<uint8_t> scored_mask(const Parity& parity, const Image& reference);

/// 1 where the truth can score a pixel at all: it shows a surface that the light can reach, as scored_mask has it.
std::vector<uint8_t> scorable_mask(const Image& reference);

/// `mask` without the pixels about which `test` says nothing (channel "known" is 0).
std::vector<uint8_t> known_mask(std::span<const uint8_t> mask, const Image& test);

}  // namespace umbrameter
