// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shafts of 16 pixels side by side in lanes, and what boxes and triangles do to them. Included by the one
// file that walks the tree, because lanes must be inlined into the function that is cloned for the machine.

#include "reference/light_proof.h"
#include "reference/shadow_rays.h"
#include "reference/wide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {

using LaneMask = std::array<int32_t, kShafts>;  // -1 or 0

struct LaneVector {
  Lanes x, y, z;
};

/// Inside the shaft n . (p - origin) + margin > 0.
struct LanePlanes {
  LaneVector n;
  Lanes margin;
};

/// A shaft is the cone from the ray origin over the patch's square (which a round patch lies in), from the
/// receiver's plane to where the rays end. Its side planes stand outwards by what rays and edges may be off.
struct alignas(64) LightShafts {
  static constexpr int kPlanes = 6;
  LaneVector origin;
  std::array<LanePlanes, kPlanes> planes;
  std::array<LaneVector, 4> corners;  // where the rays through the patch's corners end, from the origin
  Lanes corner_length;                // the greatest of the four
  Lanes cover_fraction;               // of the way there: what lies farther may be behind the light
  float extent = 0.0f;
};

UMBRAMETER_LANES LaneMask meets_box(const LightShafts& shafts, const OccluderBox& box) {
  LaneMask meets;
  meets.fill(-1);
  for (const LanePlanes& plane : shafts.planes) {
    for (uint32_t i = 0; i < kShafts; ++i) {
      const float x = std::max(plane.n.x[i] * (box.min[0] - shafts.origin.x[i]),
                               plane.n.x[i] * (box.max[0] - shafts.origin.x[i]));
      const float y = std::max(plane.n.y[i] * (box.min[1] - shafts.origin.y[i]),
                               plane.n.y[i] * (box.max[1] - shafts.origin.y[i]));
      const float z = std::max(plane.n.z[i] * (box.min[2] - shafts.origin.z[i]),
                               plane.n.z[i] * (box.max[2] - shafts.origin.z[i]));
      meets[i] &= x + y + z + plane.margin[i] > 0.0f ? -1 : 0;
    }
  }
  return meets;
}

UMBRAMETER_LANES LaneVector from_origins(const LightShafts& shafts, const glm::vec3& p) {
  LaneVector v;
  for (uint32_t i = 0; i < kShafts; ++i) {
    v.x[i] = p.x - shafts.origin.x[i];
    v.y[i] = p.y - shafts.origin.y[i];
    v.z[i] = p.z - shafts.origin.z[i];
  }
  return v;
}

UMBRAMETER_LANES LaneVector lane_cross(const LaneVector& a, const LaneVector& b) {
  LaneVector c;
  for (uint32_t i = 0; i < kShafts; ++i) {
    c.x[i] = a.y[i] * b.z[i] - a.z[i] * b.y[i];
    c.y[i] = a.z[i] * b.x[i] - a.x[i] * b.z[i];
    c.z[i] = a.x[i] * b.y[i] - a.y[i] * b.x[i];
  }
  return c;
}

UMBRAMETER_LANES float lane_dot(const LaneVector& a, const LaneVector& b, uint32_t i) {
  return a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i];
}

/// A triangle as all shafts see it: its corners from each origin.
struct LaneTriangle {
  LaneVector a, b, c;
  glm::vec3 normal;    // not unit
  float normal_error;  // times a distance: what a product with the normal may be off
};

UMBRAMETER_LANES LaneTriangle see_triangle(const LightShafts& shafts, const glm::vec3& a, const glm::vec3& b,
                                           const glm::vec3& c) {
  constexpr float kRoundoffs = 4e-6f;  // 64 of float's: a few for each of the operations in a row
  const glm::vec3 ab = b - a, ac = c - a;
  const glm::vec3 normal{ab.y * ac.z - ab.z * ac.y, ab.z * ac.x - ab.x * ac.z, ab.x * ac.y - ab.y * ac.x};
  const float spread =
      std::sqrt((ab.x * ab.x + ab.y * ab.y + ab.z * ab.z) * (ac.x * ac.x + ac.y * ac.y + ac.z * ac.z));
  return {from_origins(shafts, a), from_origins(shafts, b), from_origins(shafts, c), normal,
          kRoundoffs * spread};
}

/// Which shafts the triangle may meet, and which it covers: every ray of theirs goes through its inside.
struct TriangleVerdict {
  LaneMask meets;
  LaneMask covers;
};

UMBRAMETER_LANES TriangleVerdict judge(const LightShafts& shafts, const LaneTriangle& t) {
  TriangleVerdict verdict;
  verdict.meets.fill(-1);
  for (const LanePlanes& plane : shafts.planes) {
    for (uint32_t i = 0; i < kShafts; ++i) {
      const float highest =
          std::max(std::max(lane_dot(plane.n, t.a, i), lane_dot(plane.n, t.b, i)), lane_dot(plane.n, t.c, i));
      verdict.meets[i] &= highest + plane.margin[i] > 0.0f ? -1 : 0;
    }
  }
  // The origin's height above the triangle's plane, and how far the rays climb until they end.
  Lanes height, least_climb, most_climb;
  for (uint32_t i = 0; i < kShafts; ++i) {
    height[i] = -(t.normal.x * t.a.x[i] + t.normal.y * t.a.y[i] + t.normal.z * t.a.z[i]);
    least_climb[i] = std::numeric_limits<float>::max();
    most_climb[i] = -std::numeric_limits<float>::max();
  }
  const LaneVector ab = lane_cross(t.a, t.b), bc = lane_cross(t.b, t.c), ca = lane_cross(t.c, t.a);
  Lanes least_inside = least_climb, most_inside = most_climb;
  for (const LaneVector& corner : shafts.corners) {
    for (uint32_t i = 0; i < kShafts; ++i) {
      const float climb = t.normal.x * corner.x[i] + t.normal.y * corner.y[i] + t.normal.z * corner.z[i];
      least_climb[i] = std::min(least_climb[i], climb);
      most_climb[i] = std::max(most_climb[i], climb);
      const float u = lane_dot(ab, corner, i), v = lane_dot(bc, corner, i), w = lane_dot(ca, corner, i);
      least_inside[i] = std::min(least_inside[i], std::min(u, std::min(v, w)));
      most_inside[i] = std::max(most_inside[i], std::max(u, std::max(v, w)));
    }
  }
  constexpr float kRoundoffs = 4e-6f;
  for (uint32_t i = 0; i < kShafts; ++i) {
    const float error = t.normal_error * (shafts.corner_length[i] + shafts.extent);
    const float fraction = shafts.cover_fraction[i];
    const bool above = height[i] > error, below = height[i] < -error;
    const bool one_side =
        (above && height[i] + least_climb[i] > error) || (below && height[i] + most_climb[i] < -error);
    const bool crosses = (above && height[i] + fraction * most_climb[i] < -error) ||
                         (below && height[i] + fraction * least_climb[i] > error);
    const float reach2 =
        std::max(lane_dot(t.a, t.a, i), std::max(lane_dot(t.b, t.b, i), lane_dot(t.c, t.c, i)));
    const float sliver = kRoundoffs * reach2 * shafts.corner_length[i];
    const bool inside = least_inside[i] > sliver || most_inside[i] < -sliver;
    verdict.meets[i] &= one_side ? 0 : -1;
    verdict.covers[i] = crosses && inside ? -1 : 0;
  }
  return verdict;
}

}  // namespace umbrameter
