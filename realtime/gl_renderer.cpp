// The Renderer over EGL and GL: keeps context, programs, and the last scene's buffers and G-buffer.

#include "core/hash.h"
#include "realtime/executor/check_visibility.h"
#include "realtime/executor/execute.h"
#include "realtime/executor/receivers.h"
#include "realtime/executor/texel_planes.h"
#include "realtime/harness/context.h"
#include "realtime/harness/gbuffer.h"
#include "realtime/harness/readback.h"
#include "realtime/manifest/names.h"
#include "realtime/realtime.h"

#include <array>
#include <chrono>
#include <optional>

namespace umbrameter {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMaxTimedFrames = 10000;
constexpr double kWarmUpMs = 50.0;
constexpr int kMaxWarmUpFrames = 16;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void hash_vector(Hasher& hasher, const glm::dvec3& v) {
  hasher.number(v.x).number(v.y).number(v.z);
}

/// Of the geometry; a loaded scene brings its hash along.
std::string geometry_key(const Scene& scene) {
  if (!scene.hash.empty()) return scene.hash;
  Hasher hasher;
  hasher.values(std::span<const glm::vec3>(scene.positions_world));
  hasher.values(std::span<const glm::vec3>(scene.normals_world));
  hasher.values(std::span<const glm::uvec3>(scene.triangles));
  return hasher.hex();
}

/// Of what a G-buffer shows beyond the geometry. The active light may change without the scene's hash.
std::string picture_key(const Scene& scene, const RenderRequest& request) {
  Hasher hasher;
  hasher.text(geometry_key(scene)).number(request.width_px).number(request.height_px);
  hash_vector(hasher, scene.camera.eye_world);
  hash_vector(hasher, scene.camera.at_world);
  hash_vector(hasher, scene.camera.up_world);
  hasher.number(scene.camera.vertical_fov_deg).number(scene.camera.near_world);
  const Light& light = scene.light();
  hasher.number(static_cast<double>(light.type));
  hash_vector(hasher, light.center_world);
  hash_vector(hasher, light.tangent_world);
  hash_vector(hasher, light.bitangent_world);
  hash_vector(hasher, light.direction_world);
  hasher.number(light.size_world.x).number(light.size_world.y).number(light.radius_world);
  return hasher.number(light.half_angle_rad).hex();
}

struct SceneOnGpu {
  std::string key;
  SceneBuffers buffers;
};

/// A G-buffer with its readback and what follows from it.
struct Picture {
  std::string key;
  GBuffer gbuffer;
  Image image;
  std::vector<ReceiverTile> receivers;
  glm::dvec4 receiver_plane_world{0.0};
};

void require_support(const Technique& technique, const Light& light) {
  if (technique.supports(light.type)) return;
  std::string supported;
  for (const LightType type : technique.lights) {
    supported += fmt::format("{}{}", supported.empty() ? "" : ", ", to_text(type));
  }
  fail_input(fmt::format("technique '{}' does not support {} lights", technique.id, to_text(light.type)), {},
             fmt::format("it supports {}", supported));
}

class GlRenderer final : public Renderer {
 public:
  explicit GlRenderer(const RealtimeSettings& settings)
      : settings_(settings),
        context_(settings.device),
        programs_(shader_search_folders(settings.shaders_folder)),
        gbuffer_renderer_(programs_, settings.shaders_folder, context_.limits()),
        empty_vertex_array_(make_empty_vertex_array()) {}

  ~GlRenderer() override { context_.make_current(); }  // the GL objects die next

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    const Clock::time_point start = Clock::now();
    check_request(request);
    context_.make_current();
    Frame frame;
    frame.device = context_.device().renderer;
    if (request.technique.empty()) {
      frame.image = picture_of(scene, request).image;
    } else {
      render_technique(scene, request, progress, frame);
    }
    frame.wall_time_s = milliseconds_since(start) * 1e-3;
    return frame;
  }

 private:
  void check_request(const RenderRequest& request) const {
    const int limit = std::min(context_.limits().max_texture_size, 16384);
    for (const int side : {request.width_px, request.height_px}) {
      if (side >= 1 && side <= limit) continue;
      fail_input(fmt::format("cannot render {}x{} px", request.width_px, request.height_px), {},
                 fmt::format("each side must be 1 to {} px", limit));
    }
    if (request.timed_frames < 0 || request.timed_frames > kMaxTimedFrames) {
      fail_input(fmt::format("cannot time {} frames", request.timed_frames), {},
                 fmt::format("0 to {}", kMaxTimedFrames));
    }
  }

  const SceneBuffers& buffers_of(const Scene& scene) {
    const std::string key = geometry_key(scene);
    if (!scene_ || scene_->key != key) {
      scene_.reset();  // frees the old one before the new one needs the memory
      scene_.emplace(SceneOnGpu{key, SceneBuffers(scene)});
    }
    return scene_->buffers;
  }

  const Picture& picture_of(const Scene& scene, const RenderRequest& request) {
    const std::string key = picture_key(scene, request);
    if (picture_ && picture_->key == key) return *picture_;
    picture_.reset();
    const SceneBuffers& buffers = buffers_of(scene);
    Picture picture{key,
                    GBuffer(request.width_px, request.height_px),
                    Image(request.width_px, request.height_px),
                    {},
                    {}};
    gbuffer_renderer_.render(scene, buffers, picture.gbuffer);
    check_gl_errors("G-buffer");
    read_gbuffer(picture.gbuffer, picture.image);
    picture.receivers = receiver_tiles(picture.image);
    picture.receiver_plane_world = receiver_plane(picture.image);
    picture_.emplace(std::move(picture));
    return *picture_;
  }

  void render_technique(const Scene& scene, const RenderRequest& request, Progress& progress, Frame& frame) {
    const Technique declared =
        find_technique(request.technique, settings_.techniques_folder, settings_.shaders_folder);
    require_support(declared, scene.light());
    frame.parameters = resolve_parameters(declared, request.parameters);
    const Technique technique = with_stages(declared, frame.parameters);
    const SceneBuffers& buffers = buffers_of(scene);
    const Picture& picture = picture_of(scene, request);
    const RunInputs inputs{technique,
                           frame.parameters,
                           scene,
                           buffers,
                           picture.gbuffer,
                           picture.receivers,
                           picture.receiver_plane_world,
                           request.seed,
                           settings_.shaders_folder};
    const Plan plan = make_plan(inputs, programs_);
    draw(plan, buffers, request, technique, progress, frame);
    frame.image = picture.image;
    frame.memory_bytes = plan.targets->declared_bytes();
    frame.warnings.insert(frame.warnings.end(), plan.warnings.begin(), plan.warnings.end());
    read_visibility(plan, technique, frame);
  }

  void draw(const Plan& plan, const SceneBuffers& buffers, const RenderRequest& request,
            const Technique& technique, Progress& progress, Frame& frame) {
    const auto timed_frames = static_cast<uint64_t>(request.timed_frames);
    progress.begin(technique.id, plan.steps.size() * (1 + timed_frames));
    if (timed_frames == 0) {
      draw_frame(plan, buffers, empty_vertex_array_, {.progress = &progress});
    } else {
      time_frames(plan, buffers, request.timed_frames, progress, frame);
    }
    progress.end();
  }

  /// The first frame warms up and checks; short ones are repeated until clocks and caches have settled.
  void time_frames(const Plan& plan, const SceneBuffers& buffers, int count, Progress& progress,
                   Frame& frame) {
    if (!timer_) timer_ = choose_timer();
    PassTimers timers(*timer_, plan.labels);
    const auto draw_timed = [&](bool is_counted, Progress* watch) {
      timers.begin_frame(is_counted);
      draw_frame(plan, buffers, empty_vertex_array_,
                 {.timers = &timers, .is_first = watch != nullptr, .progress = watch});
      timers.end_frame();
    };
    const Clock::time_point start = Clock::now();
    draw_timed(false, &progress);
    for (int i = 1; i < kMaxWarmUpFrames && milliseconds_since(start) < kWarmUpMs; ++i)
      draw_timed(false, nullptr);
    for (int i = 0; i < count; ++i) {
      draw_timed(true, nullptr);
      progress.advance(plan.steps.size());
    }
    check_gl_errors("timed frames");
    frame.pass_times = timers.results();
    frame.timer = to_text(timers.kind());
  }

  void read_visibility(const Plan& plan, const Technique& technique, Frame& frame) {
    const std::array<std::string, 1> channels = {std::string(kVisibility)};
    read_texture(plan.targets->visibility(), channels, frame.image);
    if (const auto warning = check_visibility(frame.image, technique.id)) frame.warnings.push_back(*warning);
    if (!plan.center_view) return;
    add_texel_planes(*plan.center_view, frame.image);
    const double outside = share_outside(frame.image, plan.center_view->view);
    if (outside == 0.0) return;
    frame.warnings.push_back(
        fmt::format("technique '{}': {:.3g} % of the receivers lie outside the light's map and count as lit",
                    technique.id, 100.0 * outside));
  }

  RealtimeSettings settings_;
  GlContext context_;  // before everything that lives in it
  ProgramCache programs_;
  GBufferRenderer gbuffer_renderer_;
  VertexArray empty_vertex_array_;
  std::optional<TimerKind> timer_;
  std::optional<SceneOnGpu> scene_;
  std::optional<Picture> picture_;
};

}  // namespace

std::unique_ptr<Renderer> make_realtime_renderer(const RealtimeSettings& settings) {
  return std::make_unique<GlRenderer>(settings);
}

}  // namespace umbrameter
