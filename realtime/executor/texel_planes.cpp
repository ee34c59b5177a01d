#include "realtime/executor/texel_planes.h"

#include <algorithm>

namespace umbrameter {

void add_texel_planes(const FittedView& fitted, Image& image) {
  const std::span<float> u = image.add_plane("texel.x");
  const std::span<float> v = image.add_plane("texel.y");
  const std::span<float> width_world = image.add_plane("texel_world");
  const auto x = image.plane("position.x"), y = image.plane("position.y"), z = image.plane("position.z");
  const auto primitive = image.plane("primitive_id");
  const LightView& view = fitted.view;
  const glm::dvec4 bounds(view.lateral_bounds);
  const double texels = fitted.data.depth_range.w;
  const glm::dvec2 texel = {(bounds.z - bounds.x) / texels, (bounds.w - bounds.y) / texels};
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    if (primitive[i] < 0.0f) continue;
    const glm::dvec3 p = lateral_and_distance(view, {x[i], y[i], z[i]});
    if (!view.is_orthographic && p.z <= 0.0) continue;
    u[i] = static_cast<float>((p.x - bounds.x) / texel.x);
    v[i] = static_cast<float>((p.y - bounds.y) / texel.y);
    width_world[i] = static_cast<float>(std::max(texel.x, texel.y) * (view.is_orthographic ? 1.0 : p.z));
  }
}

}  // namespace umbrameter
