// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the camera sees, at pixel centres: the receivers that visibility is computed for.

#include "core/image.h"
#include "realtime/harness/context.h"
#include "realtime/harness/program.h"
#include "realtime/harness/scene_buffers.h"

#include <memory>

namespace umbrameter {

/// Screen-sized textures, row 0 at the bottom.
struct GBuffer {
  GBuffer(int width_px, int height_px);

  Texture position;               // rgba32f: world xyz, w = 1 covered, 0 background
  Texture normal;                 // rgba32f: geometric, unit, facing the camera
  Texture shading_normal;         // rgba32f: interpolated, unit, on the same side as `normal`
  Texture primitive_id;           // r32ui, the shown triangle (scenes/instances.h), kNoPrimitive = background
  Texture unshadowed_irradiance;  // r32f
  Texture depth;                  // depth32f, reversed: near_world / distance along the view axis

  int width() const { return position.width(); }
  int height() const { return position.height(); }
  size_t bytes() const;
};

inline constexpr uint32_t kNoPrimitive = 0xffffffffu;

/// Draws G-buffers. The triangle of a pixel is found by an exact test of the ray through the pixel's centre,
/// not by the rasteriser's snapped vertices, so that it is the one a ray tracer finds.
class GBufferRenderer {
 public:
  /// Compiles its shaders; `programs` must live as long and know the folders shaders/lib and shaders/shared, `shaders_folder`
  /// holds gbuffer/ and lib/.
  GBufferRenderer(ProgramCache& programs, const std::filesystem::path& shaders_folder,
                  const GlLimits& limits);

  /// Draws `scene` (camera and active light) into `target`; changes GL state freely.
  void render(const Scene& scene, const SceneBuffers& buffers, const GBuffer& target);

 private:
  std::shared_ptr<const Program> visible_triangle(const std::string& defines);
  void draw_triangles(const Scene& scene, const SceneBuffers& buffers, const GBuffer& target);

  ProgramCache& programs_;
  std::filesystem::path shaders_folder_;
  std::shared_ptr<const Program> visible_triangle_;
  std::shared_ptr<const Program> surface_;
  Buffer frame_block_;
  Buffer gbuffer_block_;
  Sampler nearest_{SamplerSettings{}};
  VertexArray no_attributes_;
  int subpixel_bits_ = 8;
};

/// Adds position.*, normal.*, shading_normal.*, primitive_id and unshadowed_irradiance to `image`, row 0 on
/// top.
void read_gbuffer(const GBuffer& gbuffer, Image& image);

}  // namespace umbrameter
