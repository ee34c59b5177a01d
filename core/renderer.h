// SPDX-License-Identifier: Apache-2.0
#pragma once
// The one interface both renderers offer, so that study/ needs neither GL nor Embree.

#include "core/image.h"
#include "core/parameters.h"
#include "core/progress.h"

#include <cstdint>
#include <functional>
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
  /// The truth of this very picture. With it the technique takes blockers' distances from its planes blocker_offset.x/y/z
  /// instead of looking for them; Error{input} where it looks for none. Not owned; the reference ignores it.
  const Image* blocker_truth = nullptr;
};

/// What came out. Channels by renderer:
/// both: position.x/y/z (world), normal.x/y/z (geometric, unit, facing the camera), shading_normal.x/y/z,
///   primitive_id (-1 = nothing hit), unshadowed_irradiance.
/// reference: visibility, visibility_se, half_a, half_b, irradiance_ratio, irradiance_ratio_se, irradiance_half_a,
///   irradiance_half_b, sample_count, blocker_distance, blocker_distance_min, blocker_distance_p10, blocker_layers,
///   blocker_offset.x/y/z (from the receiver), penumbra_width, contact_distance.
/// real time: visibility; of maps drawn from the light's centre texel.x/y (the point's place in its map, in texels), texel_world
///   (width of a texel facing the light there), maybe bias_world; 0 = no hit. Of several map_index, the point's; -1 = none.
struct Frame {
  Image image;
  ParameterValues parameters;  // the complete set that was used
  std::string device;          // GL renderer string, or "Embree <version>, <threads> threads"
  bool is_software = false;    // a rasteriser on the CPU: its times say little about a GPU's
  uint64_t memory_bytes = 0;
  double wall_time_s = 0.0;
  std::vector<std::string> warnings;
  std::vector<std::string> left_out;  // passes and textures that these parameters do not need
  int frames_before = 0;              // drawn first, whose history the image holds
  std::string motion;                 // of those (scenes/motion.h); empty without
};

/// A request kept ready to be drawn again, so that the frames of several can be timed in turn.
struct PreparedRun {
  Frame frame;  // the first one; the caller may take it away
  /// Draws the next frame without allocation, compilation or readback: ms of each pass, in the order of `passes`.
  /// Absent when there is nothing to time. Must neither be called nor live after its renderer.
  std::function<std::vector<double>()> time_frame;
  std::vector<std::string> passes;
  std::string timer;  // "GL_TIME_ELAPSED" or "glFinish + steady clock"
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) = 0;
  /// Renders like render() and keeps what another frame needs. `scene` must outlive the run.
  virtual PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) {
    return {render(scene, request, progress), {}, {}, {}};
  }
};

}  // namespace umbrameter
