#include "metrics/flip_color.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace umbrameter {

namespace {

// BT.709 primaries with the white the FLIP paper uses (row sums below).
const glm::dmat3 kXyzFromLinear =
    glm::transpose(glm::dmat3{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0,  //
                              2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0,    //
                              1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0});
const glm::dvec3 kWhiteXyz = kXyzFromLinear * glm::dvec3(1.0);

// XYZ relative to white, and back.
const glm::mat3 kRelativeFromLinear = glm::mat3(
    glm::dmat3{1.0 / kWhiteXyz.x, 0.0, 0.0, 0.0, 1.0 / kWhiteXyz.y, 0.0, 0.0, 0.0, 1.0 / kWhiteXyz.z} *
    kXyzFromLinear);
const glm::mat3 kLinearFromRelative = glm::mat3(glm::inverse(glm::dmat3(kRelativeFromLinear)));

// CIE 15: cube root above (6/29)^3, its tangent line below.
float lab_curve(float relative) {
  constexpr float kDelta = 6.0f / 29.0f;
  if (relative > kDelta * kDelta * kDelta) return std::cbrt(relative);
  return relative / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

}  // namespace

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

glm::vec3 ycxcz_from_linear(const glm::vec3& rgb_linear) {
  const glm::vec3 relative = kRelativeFromLinear * rgb_linear;
  return {116.0f * relative.y - 16.0f, 500.0f * (relative.x - relative.y),
          200.0f * (relative.y - relative.z)};
}

glm::vec3 linear_from_ycxcz(const glm::vec3& ycxcz) {
  const float y = (ycxcz.x + 16.0f) / 116.0f;
  return kLinearFromRelative * glm::vec3{y + ycxcz.y / 500.0f, y, y - ycxcz.z / 200.0f};
}

glm::vec3 hunt_lab_from_linear(const glm::vec3& rgb_linear) {
  const glm::vec3 relative = kRelativeFromLinear * rgb_linear;
  const float x = lab_curve(relative.x), y = lab_curve(relative.y), z = lab_curve(relative.z);
  const float lightness = 116.0f * y - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

float hyab_distance(const glm::vec3& a, const glm::vec3& b) {
  return std::abs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

}  // namespace umbrameter
