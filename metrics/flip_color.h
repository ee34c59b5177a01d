#pragma once
// The colour spaces of FLIP. Linear RGB has BT.709 primaries and the D65 white.

#include <glm/vec3.hpp>

namespace umbrameter {

float linear_from_srgb(float encoded);
/// The opponent space the eye's contrast sensitivity is modelled in; linear in XYZ.
glm::vec3 ycxcz_from_linear(const glm::vec3& rgb_linear);
glm::vec3 linear_from_ycxcz(const glm::vec3& ycxcz);
/// CIELab with chroma scaled by lightness (Hunt effect), L in 0..100.
glm::vec3 hunt_lab_from_linear(const glm::vec3& rgb_linear);
/// |dL| + length of (da, db): HyAB, for large differences.
float hyab_distance(const glm::vec3& a, const glm::vec3& b);

}  // namespace umbrameter
