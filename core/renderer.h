#pragma once
// The one interface both renderers offer, so that study/ needs neither GL nor Embree.

#include "core/image.h"
#include "core/parameters.h"
#include "core/progress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace umbrameter {

struct Scene;  // scenes/scene.h

/// What to render. The reference ignores `technique` and `parameters`.
struct RenderRequest {
  int width_px = 0;
  int height_px = 0;
  uint64_t seed = 1;
  std::string technique;       // technique id, or a path to its folder
  ParameterValues parameters;  // overrides; whatever is missing takes its default
  int timed_frames = 0;        // 0 = render once, no timing
};

/// Time of one pass over the timed frames; the list ends with "total", the whole frames.
struct PassTime {
  std::string pass;
  double median_ms = 0.0;
  double mad_ms = 0.0;  // median absolute deviation
  int frames = 0;
};

/// What came out. Channels by renderer:
/// both: position.x/y/z (world), normal.x/y/z (geometric, unit, facing the camera), shading_normal.x/y/z,
///   primitive_id (-1 = nothing hit), unshadowed_irradiance.
/// reference: visibility, visibility_se, irradiance_ratio, half_a, half_b, sample_count, blocker_distance,
///   blocker_distance_min, blocker_layers.
/// real time: visibility; where one map is drawn from the light's centre also texel.x/y (the point's place in
///   that map, in texels) and texel_world (width of a texel facing the light there); 0 where nothing is hit.
struct Frame {
  Image image;
  ParameterValues parameters;  // the complete set that was used
  std::vector<PassTime> pass_times;
  std::string timer;   // "GL_TIME_ELAPSED" or "glFinish + steady clock"; empty when not timed
  std::string device;  // GL renderer string, or "Embree <version>, <threads> threads"
  uint64_t memory_bytes = 0;
  double wall_time_s = 0.0;
  std::vector<std::string> warnings;
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) = 0;
};

}  // namespace umbrameter
