#include "reference/light_patch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr double kUnitRoundoff = 0x1p-24;  // of float

/// The plane the patch lies in: through `to_center`, at right angles to `axis`.
struct PatchPlane {
  glm::dvec3 to_center;
  glm::dvec3 axis;  // unit
  bool along_ray;   // sphere and sun: samples are directions, their points are where these meet the plane
};

glm::dvec3 to_patch_point(const PatchPlane& plane, const LightSample& sample) {
  if (!plane.along_ray) return sample.to_light_world * sample.distance_world;
  return sample.to_light_world *
         (glm::dot(plane.to_center, plane.axis) / glm::dot(sample.to_light_world, plane.axis));
}

PatchPlane find_plane(const Light& light, const glm::dvec3& p_world, const LightSample& middle) {
  switch (light.type) {
    case LightType::rect:
    case LightType::disk:
      return {middle.to_light_world * middle.distance_world, light.direction_world, false};
    case LightType::sphere:
      return {middle.to_light_world * glm::distance(light.center_world, p_world), middle.to_light_world,
              true};
    case LightType::sun:
      break;
  }
  return {middle.to_light_world, middle.to_light_world, true};
}

PatchForm form_of(const glm::dvec3& n, const glm::dvec3& center, const glm::dvec3& per_a,
                  const glm::dvec3& per_b) {
  return {static_cast<float>(glm::dot(n, center)), static_cast<float>(glm::dot(n, per_a)),
          static_cast<float>(glm::dot(n, per_b))};
}

void set_directions(LightPatch& patch, const glm::dvec3& center, const glm::dvec3& per_a,
                    const glm::dvec3& per_b) {
  patch.direction_x = form_of({1, 0, 0}, center, per_a, per_b);
  patch.direction_y = form_of({0, 1, 0}, center, per_a, per_b);
  patch.direction_z = form_of({0, 0, 1}, center, per_a, per_b);
}

float greatest(const PatchForm& form, bool round) {
  const float spread =
      round ? std::hypot(form.per_a, form.per_b) : std::abs(form.per_a) + std::abs(form.per_b);
  return form.center + spread * 1.00001f;
}

/// sin and cos of (pi/4) t for t in [-1,1], Taylor to 2e-9 and 2e-8: below float rounding, and free of calls.
float sin_quarter_pi(float t) {
  constexpr float k = 0.785398163f;
  const float x = k * t;
  const float x2 = x * x;
  return x * (1.0f + x2 * (-1.0f / 6 + x2 * (1.0f / 120 + x2 * (-1.0f / 5040 + x2 * (1.0f / 362880)))));
}
float cos_quarter_pi(float t) {
  constexpr float k = 0.785398163f;
  const float x = k * t;
  const float x2 = x * x;
  return 1.0f + x2 * (-0.5f + x2 * (1.0f / 24 + x2 * (-1.0f / 720 + x2 * (1.0f / 40320))));
}

using Lanes = std::array<float, kBatch>;

/// The square [-1,1]^2 onto the unit disk, as core/sampling/patterns.h concentric_disk does it. Choices are
/// products with 0 or 1 from a loop of their own, which compilers turn into vector code.
void to_disk(Lanes& a, Lanes& b) {
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

float value_at(const PatchForm& form, float a, float b) {
  return form.center + a * form.per_a + b * form.per_b;
}

}  // namespace

LightPatch make_light_patch(const Light& light, const Receiver& receiver, double scene_extent_world) {
  LightPatch patch;
  const glm::dvec3& p = receiver.p_world;
  const LightSample probe = sample_light(light, p, receiver.n_geometric_world, {0.5, 0.5});
  const LightSample middle = sample_light(light, p, probe.to_light_world, {0.5, 0.5});
  patch.dark = !(middle.irradiance_weight > 0.0);
  if (patch.dark) return patch;

  // Coordinate 1 is twice as far from the centre as uv = 3/4, for the square and for the disk alike.
  const PatchPlane plane = find_plane(light, p, middle);
  const auto edge = [&](const glm::dvec2& uv) {
    return 2.0 * (to_patch_point(plane, sample_light(light, p, middle.to_light_world, uv)) - plane.to_center);
  };
  const glm::dvec3 per_a = edge({0.75, 0.5});
  const glm::dvec3 per_b = edge({0.5, 0.75});

  patch.round = light.type != LightType::rect;
  patch.at_infinity = light.type == LightType::sun;
  patch.above_surface = form_of(receiver.n_geometric_world, plane.to_center, per_a, per_b);
  patch.shading = form_of(receiver.n_shading_world, plane.to_center, per_a, per_b);
  const double length = glm::length(plane.to_center);
  patch.strength =
      static_cast<float>(middle.irradiance_weight * (patch.at_infinity ? 1.0 : length * length * length));
  if (patch.at_infinity) {
    set_directions(patch, plane.to_center, per_a, per_b);
    return patch;
  }
  set_directions(patch, plane.to_center + (p - glm::dvec3(receiver.ray_origin_world)), per_a, per_b);
  if (light.type == LightType::sphere) patch.sphere_radius_world = static_cast<float>(light.radius_world);
  // A surface in the light's own plane must not cut the rays off: stop as far before it as Embree may err.
  const double height = std::abs(glm::dot(plane.to_center, plane.axis));
  const double error_world = 8.0 * kUnitRoundoff * (scene_extent_world + length);
  patch.end_fraction = static_cast<float>(1.0 - std::min(0.5, error_world / height));
  return patch;
}

bool is_below_horizon(const LightPatch& patch) {
  return patch.dark || greatest(patch.above_surface, patch.round) <= 0.0f;
}

bool is_unlit(const LightPatch& patch) {
  return patch.dark || greatest(patch.shading, patch.round) <= 0.0f;
}

// Cloned for wider registers, chosen when the program starts: 16 lanes are one AVX-512 register.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#endif
void make_shadow_rays(const LightPatch& patch, const SampleStream& stream, uint32_t first,
                      ShadowRayBatch& batch) {
  alignas(64) Lanes a;
  alignas(64) Lanes b;
  alignas(64) Lanes length2;
  for (uint32_t i = 0; i < kBatch; ++i) {
    a[i] = static_cast<float>(static_cast<int32_t>(stream.x[first + i] ^ stream.shift_x)) * 0x1p-31f;
    b[i] = static_cast<float>(static_cast<int32_t>(stream.y[first + i] ^ stream.shift_y)) * 0x1p-31f;
  }
  if (patch.round) to_disk(a, b);
  // Copies, so that stores to the batch cannot be taken for changes of the patch.
  const PatchForm form_x = patch.direction_x, form_y = patch.direction_y, form_z = patch.direction_z;
  const PatchForm above_surface = patch.above_surface, shading = patch.shading;
  const float strength = patch.strength;
  for (uint32_t i = 0; i < kBatch; ++i) {
    const float x = value_at(form_x, a[i], b[i]);
    const float y = value_at(form_y, a[i], b[i]);
    const float z = value_at(form_z, a[i], b[i]);
    batch.direction_x[i] = x;
    batch.direction_y[i] = y;
    batch.direction_z[i] = z;
    length2[i] = x * x + y * y + z * z;
    batch.is_facing[i] = value_at(above_surface, a[i], b[i]) > 0.0f ? -1 : 0;
    batch.weight[i] = strength * std::max(0.0f, value_at(shading, a[i], b[i]));
  }
  if (patch.at_infinity) {
    for (uint32_t i = 0; i < kBatch; ++i) {
      batch.weight[i] /= std::sqrt(length2[i]);
      batch.end[i] = std::numeric_limits<float>::infinity();
    }
    return;
  }
  const float end_fraction = patch.end_fraction;
  for (uint32_t i = 0; i < kBatch; ++i) {
    batch.weight[i] /= length2[i] * length2[i];
    batch.end[i] = end_fraction;
  }
  if (patch.sphere_radius_world <= 0.0f) return;
  // The ray origin + t D meets the sphere at t = (m - sqrt(m^2 - D.D (C.C - r^2))) / D.D with m = C.D, and
  // C.D = C.C because the patch is at right angles to C. So t = q (1 - sqrt(1 - (1 - r^2/C.C) / q)), q =
  // C.C/D.D.
  const float center2 =
      form_x.center * form_x.center + form_y.center * form_y.center + form_z.center * form_z.center;
  const float outside = 1.0f - patch.sphere_radius_world * patch.sphere_radius_world / center2;
  for (uint32_t i = 0; i < kBatch; ++i) {
    const float q = center2 / length2[i];
    batch.end[i] = end_fraction * q * (1.0f - std::sqrt(std::max(0.0f, 1.0f - outside / q)));
  }
}

}  // namespace umbrameter
