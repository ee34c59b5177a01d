// SPDX-License-Identifier: Apache-2.0
#include "reference/reference_planes.h"

namespace umbrameter {

ReferencePlanes::ReferencePlanes(Image& image, bool with_blockers)
    : width_(image.width),
      height_(image.height),
      position_(add_vector(image, "position")),
      normal_(add_vector(image, "normal")),
      shading_normal_(add_vector(image, "shading_normal")),
      primitive_id_(image.add_plane("primitive_id", -1.0f)),
      unshadowed_irradiance_(image.add_plane("unshadowed_irradiance")),
      visibility_(image.add_plane("visibility", 1.0f)),
      visibility_se_(image.add_plane("visibility_se")),
      half_a_(image.add_plane("half_a", 1.0f)),
      half_b_(image.add_plane("half_b", 1.0f)),
      irradiance_ratio_(image.add_plane("irradiance_ratio", 1.0f)),
      irradiance_ratio_se_(image.add_plane("irradiance_ratio_se")),
      irradiance_half_a_(image.add_plane("irradiance_half_a", 1.0f)),
      irradiance_half_b_(image.add_plane("irradiance_half_b", 1.0f)),
      sample_count_(image.add_plane("sample_count")) {
  if (!with_blockers) return;
  blocker_distance_ = image.add_plane("blocker_distance");
  blocker_distance_min_ = image.add_plane("blocker_distance_min");
  blocker_distance_p10_ = image.add_plane("blocker_distance_p10");
  blocker_layers_ = image.add_plane("blocker_layers");
  penumbra_width_ = image.add_plane("penumbra_width");
  contact_distance_ = image.add_plane("contact_distance");
  blocker_offset_ = add_vector(image, "blocker_offset");
}

ReferencePlanes::Vector ReferencePlanes::add_vector(Image& image, const std::string& name) {
  return {image.add_plane(name + ".x"), image.add_plane(name + ".y"), image.add_plane(name + ".z")};
}

void ReferencePlanes::Vector::write(size_t pixel, const glm::dvec3& value) {
  x[pixel] = static_cast<float>(value.x);
  y[pixel] = static_cast<float>(value.y);
  z[pixel] = static_cast<float>(value.z);
}

void ReferencePlanes::write_surface(size_t pixel, const PrimaryHit& hit) {
  position_.write(pixel, hit.receiver.p_world);
  normal_.write(pixel, hit.receiver.n_geometric_world);
  shading_normal_.write(pixel, hit.receiver.n_shading_world);
  primitive_id_[pixel] = static_cast<float>(hit.primitive);
}

void ReferencePlanes::write_unshadowed_irradiance(size_t pixel, double irradiance) {
  unshadowed_irradiance_[pixel] = static_cast<float>(irradiance);
}

void ReferencePlanes::write_light(size_t pixel, const PixelEstimate& estimate) {
  visibility_[pixel] = static_cast<float>(estimate.visibility);
  visibility_se_[pixel] = static_cast<float>(estimate.visibility_se);
  half_a_[pixel] = static_cast<float>(estimate.half_a);
  half_b_[pixel] = static_cast<float>(estimate.half_b);
  irradiance_ratio_[pixel] = static_cast<float>(estimate.irradiance_ratio);
  irradiance_ratio_se_[pixel] = static_cast<float>(estimate.irradiance_ratio_se);
  irradiance_half_a_[pixel] = static_cast<float>(estimate.irradiance_half_a);
  irradiance_half_b_[pixel] = static_cast<float>(estimate.irradiance_half_b);
  sample_count_[pixel] = static_cast<float>(estimate.sample_count);
}

void ReferencePlanes::write_blockers(size_t pixel, const BlockerStatistics& blockers) {
  blocker_distance_[pixel] = static_cast<float>(blockers.distance_mean_world);
  blocker_distance_min_[pixel] = static_cast<float>(blockers.distance_min_world);
  blocker_distance_p10_[pixel] = static_cast<float>(blockers.distance_p10_world);
  penumbra_width_[pixel] = static_cast<float>(blockers.penumbra_width_world);
  contact_distance_[pixel] = static_cast<float>(blockers.contact_distance_world);
  blocker_layers_[pixel] = static_cast<float>(blockers.layers_mean);
  blocker_offset_.write(pixel, blockers.offset_mean_world);
}

}  // namespace umbrameter
