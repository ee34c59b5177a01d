// SPDX-License-Identifier: Apache-2.0
#pragma once
// The channels a reference frame has (core/renderer.h), written pixel by pixel from any thread.

#include "core/image.h"
#include "reference/blocker_probe.h"
#include "reference/primary_hit.h"
#include "reference/shadow_sampler.h"

namespace umbrameter {

class ReferencePlanes {
 public:
  /// Adds the channels to `image`, every pixel set to background; those of blockers only `with_blockers`.
  ReferencePlanes(Image& image, bool with_blockers);

  int width() const { return width_; }
  int height() const { return height_; }

  void write_surface(size_t pixel, const PrimaryHit& hit);
  void write_unshadowed_irradiance(size_t pixel, double irradiance);
  /// Not needed where all of the light is seen: the background is written alike.
  void write_light(size_t pixel, const PixelEstimate& estimate);
  void write_blockers(size_t pixel, const BlockerStatistics& blockers);

 private:
  using Plane = std::span<float>;
  struct Vector {
    Plane x, y, z;
    void write(size_t pixel, const glm::dvec3& value);
  };
  static Vector add_vector(Image& image, const std::string& name);

  int width_;
  int height_;
  Vector position_, normal_, shading_normal_;
  Plane primitive_id_, unshadowed_irradiance_;
  Plane visibility_, visibility_se_, half_a_, half_b_;
  Plane irradiance_ratio_, irradiance_ratio_se_, irradiance_half_a_, irradiance_half_b_, sample_count_;
  Plane blocker_distance_, blocker_distance_min_, blocker_distance_p10_, blocker_layers_;
  Plane penumbra_width_, contact_distance_;
  Vector blocker_offset_;
};

}  // namespace umbrameter
