// SPDX-License-Identifier: Apache-2.0
#pragma once
// The colour spaces of FLIP. Linear RGB has BT.709 primaries and the D65 white. Inline and without branches, so that
// a loop over pixels vectorises.

#include "metrics/image/vector_math.h"

#include <glm/vec3.hpp>

#include <cmath>

namespace umbrameter {

/// Row by row.
struct ColorMatrix {
  double m[3][3];
};

constexpr ColorMatrix inverse(const ColorMatrix& matrix) {
  const auto& m = matrix.m;
  ColorMatrix out{};
  double determinant = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      out.m[i][j] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
    determinant += m[0][i] * out.m[i][0];
  }
  for (auto& row : out.m) {
    for (double& value : row) value /= determinant;
  }
  return out;
}

/// BT.709 primaries as the FLIP paper gives them, each row over its sum: XYZ relative to the white.
constexpr ColorMatrix relative_from_linear_matrix() {
  ColorMatrix out{{{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                   {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                   {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};
  for (auto& row : out.m) {
    const double white = row[0] + row[1] + row[2];
    for (double& value : row) value /= white;
  }
  return out;
}

inline constexpr ColorMatrix kRelativeFromLinear = relative_from_linear_matrix();
inline constexpr ColorMatrix kLinearFromRelative = inverse(kRelativeFromLinear);

inline glm::vec3 operator*(const ColorMatrix& matrix, const glm::vec3& v) {
  const auto row = [&](int i) {
    return static_cast<float>(matrix.m[i][0]) * v.x + static_cast<float>(matrix.m[i][1]) * v.y +
           static_cast<float>(matrix.m[i][2]) * v.z;
  };
  return {row(0), row(1), row(2)};
}

/// IEC 61966-2-1; the power 2.4 is x^2 times the square of the fifth root.
inline float linear_from_srgb(float encoded) {
  const float x = (encoded + 0.055f) * (1.0f / 1.055f), fifth = root<5>(x);
  return encoded <= 0.04045f ? encoded * (1.0f / 12.92f) : x * x * fifth * fifth;
}

/// The opponent space the eye's contrast sensitivity is modelled in; linear in XYZ.
inline glm::vec3 ycxcz_from_linear(const glm::vec3& rgb_linear) {
  const glm::vec3 relative = kRelativeFromLinear * rgb_linear;
  return {116.0f * relative.y - 16.0f, 500.0f * (relative.x - relative.y),
          200.0f * (relative.y - relative.z)};
}

inline glm::vec3 linear_from_ycxcz(const glm::vec3& ycxcz) {
  const float y = (ycxcz.x + 16.0f) * (1.0f / 116.0f);
  return kLinearFromRelative * glm::vec3{y + ycxcz.y * (1.0f / 500.0f), y, y - ycxcz.z * (1.0f / 200.0f)};
}

/// CIE 15: cube root above (6/29)^3, its tangent line below.
inline float lab_curve(float relative) {
  constexpr float kDelta = 6.0f / 29.0f;
  const float cube_root = root<3>(relative),
              line = relative * (1.0f / (3.0f * kDelta * kDelta)) + 4.0f / 29.0f;
  return relative > kDelta * kDelta * kDelta ? cube_root : line;
}

/// CIELab with chroma scaled by lightness (Hunt effect), L in 0..100, of what lab_curve gives for relative XYZ.
inline glm::vec3 hunt_lab_from_curved(const glm::vec3& curved) {
  const float lightness = 116.0f * curved.y - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (curved.x - curved.y),
          0.01f * lightness * 200.0f * (curved.y - curved.z)};
}

inline glm::vec3 hunt_lab_from_linear(const glm::vec3& rgb_linear) {
  const glm::vec3 relative = kRelativeFromLinear * rgb_linear;
  return hunt_lab_from_curved({lab_curve(relative.x), lab_curve(relative.y), lab_curve(relative.z)});
}

/// |dL| + length of (da, db): HyAB, for large differences.
inline float hyab_distance(const glm::vec3& a, const glm::vec3& b) {
  return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

}  // namespace umbrameter
