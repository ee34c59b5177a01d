// SPDX-License-Identifier: Apache-2.0
#include "reference/shadow_rays.h"

#include "reference/wide.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

/// sin and cos of (pi/4) t for t in [-1,1], Taylor to 2e-9 and 2e-8: below float rounding, and free of calls.
UMBRAMETER_LANES float sin_quarter_pi(float t) {
  constexpr float k = 0.785398163f;
  const float x = k * t;
  const float x2 = x * x;
  return x * (1.0f + x2 * (-1.0f / 6 + x2 * (1.0f / 120 + x2 * (-1.0f / 5040 + x2 * (1.0f / 362880)))));
}
UMBRAMETER_LANES float cos_quarter_pi(float t) {
  constexpr float k = 0.785398163f;
  const float x = k * t;
  const float x2 = x * x;
  return 1.0f + x2 * (-0.5f + x2 * (1.0f / 24 + x2 * (-1.0f / 720 + x2 * (1.0f / 40320))));
}

/// The square [-1,1]^2 onto the unit disk, as core/sampling/patterns.h concentric_disk does it. Choices are
/// products with 0 or 1 from a loop of their own, which compilers turn into vector code.
UMBRAMETER_LANES void to_disk(Lanes& a, Lanes& b) {
  constexpr float kTiny = 1e-30f;  // the centre must not divide by 0; lost in any other radius
  Lanes a_wide;
  for (uint32_t i = 0; i < kBatch; ++i) a_wide[i] = std::abs(a[i]) > std::abs(b[i]) ? 1.0f : 0.0f;
  for (uint32_t i = 0; i < kBatch; ++i) {
    const float b_wide = 1.0f - a_wide[i];
    const float radius = a_wide[i] * a[i] + b_wide * b[i];
    const float other = a_wide[i] * b[i] + b_wide * a[i];
    const float t = other / (radius + kTiny);
    const float along = radius * cos_quarter_pi(t);
    const float across = radius * sin_quarter_pi(t);
    a[i] = a_wide[i] * along + b_wide * across;
    b[i] = a_wide[i] * across + b_wide * along;
  }
}

/// Patch coordinates of the samples: 32-bit fractions read as signed lie in [-1,1).
UMBRAMETER_LANES void place_samples(const LightPatch& patch, const SampleStream& stream, uint32_t first,
                                    Lanes& a, Lanes& b) {
  // Pointers to start from: an index that could wrap is fetched lane by lane.
  const uint32_t* x = stream.x + first;
  const uint32_t* y = stream.y + first;
  const uint32_t shift_x = stream.shift_x, shift_y = stream.shift_y;
  for (uint32_t i = 0; i < kBatch; ++i) {
    a[i] = static_cast<float>(static_cast<int32_t>(x[i] ^ shift_x)) * 0x1p-31f;
    b[i] = static_cast<float>(static_cast<int32_t>(y[i] ^ shift_y)) * 0x1p-31f;
  }
  if (patch.round) to_disk(a, b);
}

/// Directions and what follows from them alone; `weight` still lacks the falloff.
UMBRAMETER_LANES void aim(const LightPatch& patch, const Lanes& a, const Lanes& b, Lanes& length2,
                          ShadowRayBatch& batch) {
  // Copies, so that stores to the batch cannot be taken for changes of the patch.
  const PatchForm form_x = patch.direction_x, form_y = patch.direction_y, form_z = patch.direction_z;
  const PatchForm above_surface = patch.above_surface, shading = patch.shading;
  const float strength = patch.strength;
  for (uint32_t i = 0; i < kBatch; ++i) {
    const float x = form_x.at(a[i], b[i]);
    const float y = form_y.at(a[i], b[i]);
    const float z = form_z.at(a[i], b[i]);
    batch.rays.dir_x[i] = x;
    batch.rays.dir_y[i] = y;
    batch.rays.dir_z[i] = z;
    length2[i] = x * x + y * y + z * z;
    batch.is_facing[i] = above_surface.at(a[i], b[i]) > 0.0f ? -1 : 0;
    batch.weight[i] = strength * std::max(0.0f, shading.at(a[i], b[i]));
  }
}

/// The ray origin + t D meets the sphere at t = (m - sqrt(m^2 - D.D (C.C - r^2))) / D.D with m = C.D, and C.D
/// = C.C because the patch is at right angles to C. So t = q (1 - sqrt(1 - (1 - r^2/C.C) / q)), q = C.C/D.D.
UMBRAMETER_LANES void end_on_sphere(const LightPatch& patch, const Lanes& length2, float* end) {
  const glm::vec3 center{patch.direction_x.center, patch.direction_y.center, patch.direction_z.center};
  const float center2 = center.x * center.x + center.y * center.y + center.z * center.z;
  const float outside = 1.0f - patch.sphere_radius_world * patch.sphere_radius_world / center2;
  const float end_fraction = patch.end_fraction;
  for (uint32_t i = 0; i < kBatch; ++i) {
    const float q = center2 / length2[i];
    end[i] = end_fraction * q * (1.0f - std::sqrt(std::max(0.0f, 1.0f - outside / q)));
  }
}

/// Not std::fill_n, which is not cloned and would write in narrow steps what is then read as a whole.
UMBRAMETER_LANES void end_at(float fraction, ShadowRayBatch& batch) {
  for (uint32_t i = 0; i < kBatch; ++i) batch.rays.tfar[i] = fraction;
}

/// Falloff and ray ends.
UMBRAMETER_LANES void finish(const LightPatch& patch, const Lanes& length2, ShadowRayBatch& batch) {
  if (patch.at_infinity) {
    for (uint32_t i = 0; i < kBatch; ++i) batch.weight[i] /= std::sqrt(length2[i]);
    end_at(std::numeric_limits<float>::infinity(), batch);
    return;
  }
  for (uint32_t i = 0; i < kBatch; ++i) batch.weight[i] /= length2[i] * length2[i];
  end_at(patch.end_fraction, batch);
  if (patch.sphere_radius_world > 0.0f) end_on_sphere(patch, length2, batch.rays.tfar);
}

}  // namespace

ShadowRayBatch::ShadowRayBatch(const glm::vec3& origin_world) : rays{} {
  std::fill_n(rays.org_x, kBatch, origin_world.x);
  std::fill_n(rays.org_y, kBatch, origin_world.y);
  std::fill_n(rays.org_z, kBatch, origin_world.z);
  std::fill_n(rays.mask, kBatch, ~0u);
}

UMBRAMETER_WIDE
void make_shadow_rays(const LightPatch& patch, const SampleStream& stream, uint32_t first, uint32_t end,
                      ShadowRayBatch& batch) {
  alignas(64) Lanes a;
  alignas(64) Lanes b;
  alignas(64) Lanes length2;
  place_samples(patch, stream, first, a, b);
  aim(patch, a, b, length2, batch);
  finish(patch, length2, batch);
  for (uint32_t i = end - first; i < kBatch; ++i) {
    batch.is_facing[i] = 0;
    batch.weight[i] = 0.0f;
  }
  int32_t any = 0;
  for (uint32_t i = 0; i < kBatch; ++i) any |= batch.is_facing[i];
  batch.any_facing = any != 0;
}

UMBRAMETER_WIDE
void to_packets_of_8(const ShadowRayBatch& batch, std::array<RTCRay8, 2>& packets) {
  for (uint32_t k = 0; k < 2; ++k) {
    for (uint32_t i = 0; i < 8; ++i) {
      packets[k].dir_x[i] = batch.rays.dir_x[8 * k + i];
      packets[k].dir_y[i] = batch.rays.dir_y[8 * k + i];
      packets[k].dir_z[i] = batch.rays.dir_z[8 * k + i];
      packets[k].tfar[i] = batch.rays.tfar[8 * k + i];
    }
  }
}

UMBRAMETER_WIDE
void from_packets_of_8(const std::array<RTCRay8, 2>& packets, ShadowRayBatch& batch) {
  for (uint32_t k = 0; k < 2; ++k) {
    for (uint32_t i = 0; i < 8; ++i) batch.rays.tfar[8 * k + i] = packets[k].tfar[i];
  }
}

UMBRAMETER_WIDE
void add_rays(const ShadowRayBatch& batch, LaneSums& sums) {
  for (uint32_t i = 0; i < kBatch; ++i) {
    const float seen = batch.is_facing[i] != 0 && batch.rays.tfar[i] >= 0.0f ? 1.0f : 0.0f;
    sums.seen[i] += seen;
    sums.weight[i] += batch.weight[i];
    sums.weight_seen[i] += batch.weight[i] * seen;
  }
}

namespace {

/// In four strands, none of which waits for another.
double sum_of(const Lanes& lanes) {
  std::array<double, 4> strands{};
  for (uint32_t i = 0; i < kBatch; i += 4) {
    for (uint32_t k = 0; k < 4; ++k) strands[k] += static_cast<double>(lanes[i + k]);
  }
  return (strands[0] + strands[1]) + (strands[2] + strands[3]);
}

}  // namespace

void add_lanes(const LaneSums& lanes, ReplicateSums& sums) {
  sums.seen += static_cast<uint32_t>(sum_of(lanes.seen));
  sums.weight += sum_of(lanes.weight);
  sums.weight_seen += sum_of(lanes.weight_seen);
}

}  // namespace umbrameter
