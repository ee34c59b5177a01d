// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/gbuffer.h"

#include "realtime/harness/draw.h"
#include "realtime/harness/frame_uniforms.h"
#include "realtime/harness/readback.h"
#include "realtime/views/instance_boxes.h"

#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

namespace umbrameter {

namespace {

namespace fs = std::filesystem;

/// gbuffer/camera.glsl GBufferBlock.
struct GBufferData {
  glm::vec4 right_world;
  glm::vec4 up_world;
  glm::vec4 forward_world;
  glm::vec4 eye_world_low;
  glm::vec4 screen_px;
  glm::ivec4 has_normals;
};

constexpr GLuint kGBufferBinding = 1;
constexpr const char* kHasInstances = "#define HAS_INSTANCES\n";
constexpr double kGrowthInSubpixels = 2.0;  // snapping moves an edge by less than one

glm::vec4 with(const glm::dvec3& v, double w) {
  return glm::vec4(glm::vec3(v), static_cast<float>(w));
}

GBufferData make_gbuffer_data(const Scene& scene, const GBuffer& target, int subpixel_bits) {
  const Camera& camera = scene.camera;
  const glm::dmat4 world_from_view = glm::transpose(view_from_world(camera));  // rotation part only
  const double tan_half_height = std::tan(0.5 * glm::radians(camera.vertical_fov_deg));
  const double tan_half_width = tan_half_height * target.width() / target.height();
  const double growth_px = std::ldexp(kGrowthInSubpixels, -subpixel_bits);
  GBufferData data{};
  data.right_world = with(world_from_view[0], tan_half_width);
  data.up_world = with(world_from_view[1], tan_half_height);
  data.forward_world = with(-glm::dvec3(world_from_view[2]), camera.near_world);
  data.eye_world_low = with(camera.eye_world - glm::dvec3(glm::vec3(camera.eye_world)), 0.0);
  data.screen_px = glm::vec4(target.width(), target.height(), growth_px, 0.0);
  data.has_normals = glm::ivec4(has_shading_normals(scene) ? 1 : 0, 0, 0, 0);
  return data;
}

std::shared_ptr<const Program> load(ProgramCache& programs, const fs::path& vertex, const fs::path& fragment,
                                    const std::string& defines = {}) {
  const std::string prelude = std::string(kFrameBlockGlsl) + defines;
  const std::array<ShaderFile, 2> stages = {
      {{ShaderStage::vertex, vertex, prelude}, {ShaderStage::fragment, fragment, prelude}}};
  return programs.get(stages);
}

}  // namespace

GBuffer::GBuffer(int width_px, int height_px)
    : position(find_texture_format("rgba32f"), width_px, height_px, "gbuffer.position"),
      normal(find_texture_format("rgba32f"), width_px, height_px, "gbuffer.normal"),
      shading_normal(find_texture_format("rgba32f"), width_px, height_px, "gbuffer.shading_normal"),
      primitive_id(find_texture_format("r32ui"), width_px, height_px, "gbuffer.primitive_id"),
      unshadowed_irradiance(find_texture_format("r32f"), width_px, height_px,
                            "gbuffer.unshadowed_irradiance"),
      depth(find_texture_format("depth32f"), width_px, height_px, "gbuffer.depth") {}

size_t GBuffer::bytes() const {
  return position.bytes() + normal.bytes() + shading_normal.bytes() + primitive_id.bytes() +
         unshadowed_irradiance.bytes() + depth.bytes();
}

GBufferRenderer::GBufferRenderer(ProgramCache& programs, const fs::path& shaders_folder,
                                 const GlLimits& limits)
    : programs_(programs),
      shaders_folder_(shaders_folder),
      visible_triangle_(load(programs, shaders_folder / "gbuffer" / "visible_triangle.vert",
                             shaders_folder / "gbuffer" / "visible_triangle.frag")),
      surface_(load(programs, shaders_folder / "lib" / "fullscreen.vert",
                    shaders_folder / "gbuffer" / "surface.frag")),
      frame_block_(sizeof(FrameData), nullptr, true),
      gbuffer_block_(sizeof(GBufferData), nullptr, true),
      no_attributes_(make_empty_vertex_array()),
      subpixel_bits_(limits.subpixel_bits) {}

std::shared_ptr<const Program> GBufferRenderer::visible_triangle(const std::string& defines) {
  if (defines.empty()) return visible_triangle_;
  const fs::path folder = shaders_folder_ / "gbuffer";
  return load(programs_, folder / "visible_triangle.vert", folder / "visible_triangle.frag", defines);
}

void GBufferRenderer::draw_triangles(const Scene& scene, const SceneBuffers& buffers, const GBuffer& target) {
  const std::string cutouts = buffers.cutouts() != nullptr ? "#define HAS_CUTOUTS\n" : "";
  visible_triangle(cutouts)->use();
  buffers.draw_pulled();
  const InstanceBuffers* instances = buffers.instances();
  if (instances == nullptr) return;
  const glm::dmat4 clip = clip_from_world(scene.camera, target.width(), target.height());
  const InstanceSelection seen =
      instances->select(instances_in_view(make_instance_boxes(scene), clip, false));
  visible_triangle(cutouts + kHasInstances)->use();
  instances->draw_pulled(seen);
}

void GBufferRenderer::render(const Scene& scene, const SceneBuffers& buffers, const GBuffer& target) {
  const FrameData frame = make_frame_data(scene, target.width(), target.height(), 0);
  const GBufferData gbuffer = make_gbuffer_data(scene, target, subpixel_bits_);
  frame_block_.update(&frame, sizeof frame);
  gbuffer_block_.update(&gbuffer, sizeof gbuffer);
  bind_uniform_buffer(kFrameBinding, frame_block_);
  bind_uniform_buffer(kGBufferBinding, gbuffer_block_);
  buffers.bind_storage();
  set_default_state();

  const std::array<const Texture*, 1> identity = {&target.primitive_id};
  const Framebuffer triangle_target(identity, &target.depth);
  clear_texture(target.primitive_id, std::array{static_cast<double>(kNoPrimitive)});
  clear_texture(target.depth, std::array{0.0});
  triangle_target.bind();
  draw_triangles(scene, buffers, target);

  const std::array<const Texture*, 4> surfaces = {&target.position, &target.normal, &target.shading_normal,
                                                  &target.unshadowed_irradiance};
  const Framebuffer surface_target(surfaces, nullptr);
  surface_target.bind();
  bind_texture(0, target.primitive_id, nearest_);
  if (buffers.instances() == nullptr) {
    surface_->use();
  } else {
    load(programs_, shaders_folder_ / "lib" / "fullscreen.vert", shaders_folder_ / "gbuffer" / "surface.frag",
         kHasInstances)
        ->use();
  }
  draw_fullscreen(no_attributes_);
  check_gl_errors("drawing the G-buffer");
}

void read_gbuffer(const GBuffer& gbuffer, Image& image) {
  read_texture(gbuffer.position, std::array<std::string, 3>{"position.x", "position.y", "position.z"}, image);
  read_texture(gbuffer.normal, std::array<std::string, 3>{"normal.x", "normal.y", "normal.z"}, image);
  read_texture(gbuffer.shading_normal,
               std::array<std::string, 3>{"shading_normal.x", "shading_normal.y", "shading_normal.z"}, image);
  read_texture(gbuffer.primitive_id, std::array<std::string, 1>{"primitive_id"}, image);
  read_texture(gbuffer.unshadowed_irradiance, std::array<std::string, 1>{"unshadowed_irradiance"}, image);
  check_gl_errors("reading the G-buffer");
}

}  // namespace umbrameter
