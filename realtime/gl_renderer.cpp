// SPDX-License-Identifier: Apache-2.0
// The Renderer over EGL and GL: keeps context, programs, and the buffers and G-buffers of the scenes and cameras seen last.

#include "core/clock.h"
#include "realtime/device_identity.h"
#include "realtime/executor/blocker_truth.h"
#include "realtime/executor/check_visibility.h"
#include "realtime/executor/execute.h"
#include "realtime/executor/history.h"
#include "realtime/executor/inspect_plan.h"
#include "realtime/executor/kept_textures.h"
#include "realtime/executor/left_out.h"
#include "realtime/executor/receivers.h"
#include "realtime/executor/texel_planes.h"
#include "realtime/harness/context.h"
#include "realtime/harness/gbuffer.h"
#include "realtime/harness/noise_texture.h"
#include "realtime/harness/readback.h"
#include "realtime/manifest/names.h"
#include "realtime/manifest/technique_cache.h"
#include "realtime/realtime.h"
#include "realtime/recently_used.h"
#include "realtime/render_keys.h"
#include "scenes/local_scene.h"

#include <algorithm>
#include <array>
#include <optional>

namespace umbrameter {
namespace {

// Tuners go round and round between a few scenes and cameras: 13 cameras at 480 x 270 px fit.
constexpr size_t kScenesBytes = size_t{256} << 20;
constexpr size_t kPicturesBytes = size_t{256} << 20;
constexpr size_t kTexturesBytes = size_t{512} << 20;  // 32 maps of 2048 texels per side
constexpr size_t kPictureBytesPerPixel = 112;         // 60 of textures, 52 of planes

struct SceneOnGpu {
  SceneBuffers buffers;
  std::vector<CasterCluster> casters;  // none where culling is off
  std::vector<InstanceBox> instance_boxes;
  std::unique_ptr<SceneData> data;
};

size_t gpu_bytes(const Scene& scene) {
  size_t vertices = scene.positions_world.size() + scene.normals_world.size();
  size_t triangles = scene.triangles.size(), instances = 0;
  for (const auto& mesh : scene.instanced) {
    vertices += mesh->positions.size() + mesh->normals.size();
    triangles += mesh->triangles.size();
    instances += mesh->world_from_mesh.size();
  }
  return vertices * sizeof(glm::vec3) + triangles * sizeof(glm::uvec3) + instances * kInstanceBytes;
}

/// A G-buffer with its readback and what follows from it.
struct Picture {
  GBuffer gbuffer;
  Image image;
  std::vector<ReceiverTile> receivers;
  DistanceRange receiver_range;
  glm::dvec4 receiver_plane_world{0.0};
};

/// A technique's plan and everything it points into, in the order of their making.
struct GlRun {
  GlRun(GlContext& owner, Technique staged, ParameterValues complete)
      : context(owner), technique(std::move(staged)), parameters(std::move(complete)) {}
  ~GlRun() { context.make_current(); }  // the GL objects die next
  GlRun(const GlRun&) = delete;
  GlRun& operator=(const GlRun&) = delete;

  GlContext& context;
  Technique technique;
  ParameterValues parameters;
  std::optional<RunContents> contents;  // of a run whose textures may come from others and serve others
  std::shared_ptr<const SceneOnGpu> scene;
  std::shared_ptr<const Picture> picture;
  int frames_before = 0;                            // drawn before the one that counts
  std::string motion;                               // that they show; empty without history
  std::shared_ptr<const Picture> previous_picture;  // of the last of those
  Plan plan;
  std::vector<std::string> left_out;
  std::optional<PassTimers> timers;
  std::optional<Texture> blocker_truth;
};

/// What a run is made for: all that is timed or looked into is drawn.
enum class Use { rendered, timed, inspected };

/// A frame of a run, and what its plan points into.
struct GlFrame {
  Scene scene;
  std::shared_ptr<const SceneOnGpu> on_gpu;
  std::shared_ptr<const Picture> picture;
  std::shared_ptr<const Picture> previous_picture;
  Plan plan;
  RunContents contents;
};

int count_frames_before(const Technique& technique, const ParameterValues& parameters, const Scene& scene) {
  if (!technique.has_history()) return 0;
  if (scene.motion.frames_before) return *scene.motion.frames_before;
  constexpr int64_t kMost = 1024;
  return static_cast<int>(whole_number(technique.frames_before,
                                       parameter_variables(technique.parameters, parameters), 0, kMost,
                                       "frames_before"));
}

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
        techniques_(settings.techniques_folder, settings.shaders_folder),
        context_(settings.device),
        programs_(shader_search_folders(settings.shaders_folder)),
        gbuffer_renderer_(programs_, settings.shaders_folder, context_.limits()),
        empty_vertex_array_(make_empty_vertex_array()) {}

  ~GlRenderer() override { context_.make_current(); }  // the GL objects die next

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    return make_local(scene, request, false, progress).frame;
  }

  PreparedRun prepare(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    return make_local(scene, request, true, progress);
  }

  const GlDevice& device() const { return context_.device(); }
  const PassCounts& counts() const { return textures_.counts(); }
  uint64_t scene_data_made() const { return scene_data_made_; }

  Image dump(const Scene& scene, const RenderRequest& request, const ResourcePart& part, Progress& progress) {
    const std::optional<LocalScene> local = local_scene(scene);
    check_request(request);
    context_.make_current();
    const Scene& drawn = local ? local->scene : scene;
    const auto run = make_run(drawn, request, Use::inspected);
    draw_first(*run, drawn, request, progress);
    return read_part(run->technique, *run->plan.targets, part);
  }

  std::optional<Image> maps(const Scene& scene, const RenderRequest& request) {
    const std::optional<LocalScene> local = local_scene(scene);
    check_request(request);
    context_.make_current();
    const auto run = make_run(local ? local->scene : scene, request, Use::inspected);
    if (run->plan.center_views.size() < 2) return std::nullopt;
    return map_indices(run->plan.center_views, run->picture->image);
  }

  std::vector<std::string> passes(const Scene& scene, const RenderRequest& request) {
    check_request(request);
    context_.make_current();
    return drawn_passes(make_run(scene, request, Use::inspected)->plan);
  }

  std::vector<FinalShader> shaders(const Scene& scene, const RenderRequest& request) {
    check_request(request);
    context_.make_current();
    const auto run = make_run(scene, request, Use::inspected);
    return final_shaders(run->plan);
  }

 private:
  /// Near the origin; the frame says where the scene really is.
  PreparedRun make_local(const Scene& scene, const RenderRequest& request, bool is_timed,
                         Progress& progress) {
    const std::optional<LocalScene> local = local_scene(scene);
    if (!local) return make_prepared(scene, request, is_timed, progress);
    PreparedRun prepared = make_prepared(local->scene, request, is_timed, progress);
    add_origin(local->origin_world, prepared.frame.image);
    return prepared;
  }

  PreparedRun make_prepared(const Scene& scene, const RenderRequest& request, bool is_timed,
                            Progress& progress) {
    const Clock::time_point start = Clock::now();
    check_request(request);
    context_.make_current();
    PreparedRun prepared;
    prepared.frame.device = context_.device().renderer;
    prepared.frame.is_software = !context_.device().is_hardware;
    if (request.technique.empty()) {
      prepared.frame.image = picture_of(scene, request)->image;
    } else {
      const auto run = make_run(scene, request, is_timed ? Use::timed : Use::rendered);
      draw_first(*run, scene, request, progress);
      describe(*run, prepared.frame);
      if (is_timed) keep_timing(run, prepared);
    }
    prepared.frame.wall_time_s = seconds_since(start);
    return prepared;
  }

  void check_request(const RenderRequest& request) const {
    const int limit = std::min(context_.limits().max_texture_size, 16384);
    for (const int side : {request.width_px, request.height_px}) {
      if (side >= 1 && side <= limit) continue;
      fail_input(fmt::format("cannot render {}x{} px", request.width_px, request.height_px), {},
                 fmt::format("each side must be 1 to {} px", limit));
    }
  }

  std::shared_ptr<const SceneOnGpu> upload(const Scene& scene) {
    auto made = std::make_shared<SceneOnGpu>(
        SceneOnGpu{SceneBuffers(scene),
                   settings_.cull_casters && scene.cutouts.empty() ? make_caster_clusters(scene)
                                                                   : std::vector<CasterCluster>{},
                   settings_.cull_casters ? make_instance_boxes(scene) : std::vector<InstanceBox>{},
                   {}});
    made->data = std::make_unique<SceneData>(made->buffers, scene_data_made_);
    return made;
  }

  std::shared_ptr<const SceneOnGpu> scene_on_gpu(const Scene& scene) {
    const std::string key = geometry_key(scene);
    if (auto known = scenes_.find(key)) return known;
    scenes_.make_room(gpu_bytes(scene));
    auto made = upload(scene);
    scenes_.keep(key, made, gpu_bytes(scene));
    return made;
  }

  std::shared_ptr<const Picture> picture_of(const Scene& scene, const RenderRequest& request) {
    const std::string key = picture_key(scene, request);
    if (auto known = pictures_.find(key)) return known;
    const size_t pixels = static_cast<size_t>(request.width_px) * static_cast<size_t>(request.height_px);
    pictures_.make_room(pixels * kPictureBytesPerPixel);
    auto picture = draw_picture(scene, scene_on_gpu(scene), request);
    pictures_.keep(key, picture, pixels * kPictureBytesPerPixel);
    return picture;
  }

  std::shared_ptr<const Picture> draw_picture(const Scene& scene,
                                              const std::shared_ptr<const SceneOnGpu>& on_gpu,
                                              const RenderRequest& request) {
    auto picture = std::make_shared<Picture>(Picture{GBuffer(request.width_px, request.height_px),
                                                     Image(request.width_px, request.height_px),
                                                     {},
                                                     {},
                                                     {}});
    gbuffer_renderer_.render(scene, on_gpu->buffers, picture->gbuffer);
    check_gl_errors("G-buffer");
    read_gbuffer(picture->gbuffer, picture->image);
    picture->receivers = receiver_tiles(picture->image);
    picture->receiver_range = receiver_range(picture->image, scene.camera);
    picture->receiver_plane_world = receiver_plane(picture->image);
    return picture;
  }

  std::shared_ptr<GlRun> make_run(const Scene& scene, const RenderRequest& request, Use use) {
    const std::shared_ptr<const Technique> found = techniques_.find(request.technique);
    const Technique& declared = *found;
    require_support(declared, scene.light());
    const ParameterValues parameters = in_world(
        declared.parameters, resolve_parameters(declared, request.parameters), scene.bounds_world.diagonal());
    auto run = std::make_shared<GlRun>(context_, with_stages(declared, parameters), parameters);
    run->scene = scene_on_gpu(scene);
    run->picture = picture_of(scene, request);
    run->frames_before = count_frames_before(declared, parameters, scene);
    const bool is_first = run->frames_before == 0;
    if (declared.has_history()) run->motion = scene.motion.name;
    if (!blue_noise_ && reads(declared.passes, kBlueNoise)) blue_noise_ = make_blue_noise();
    const Scene before = scene_at(scene, is_first ? 0 : -1, request.height_px);
    if (!is_first) run->previous_picture = picture_in(before, scene, request);
    const RunInputs inputs = inputs_of(*run, scene, *run->scene, *run->picture, request, run->frames_before,
                                       is_first ? nullptr : &before.camera, run->previous_picture.get());
    if (request.blocker_truth != nullptr)
      run->blocker_truth = upload_blocker_truth(*request.blocker_truth, request.width_px, request.height_px);
    run->plan = make_plan(inputs, programs_);
    if (run->blocker_truth) require_blocker_search(run->plan, declared.id);
    run->left_out = left_out(inputs, run->plan);
    if (use == Use::rendered && settings_.keep_textures)
      run->contents = find_contents(run->plan, inputs, picture_key(scene, request));
    if (use != Use::timed) return run;
    textures_.forget();
    if (!timer_) timer_ = choose_timer();
    run->timers.emplace(*timer_, run->plan.labels.size());
    return run;
  }

  RunInputs inputs_of(const GlRun& run, const Scene& scene, const SceneOnGpu& on_gpu, const Picture& picture,
                      const RenderRequest& request, int frame, const Camera* previous_camera,
                      const Picture* previous) const {
    return {run.technique,
            run.parameters,
            scene,
            on_gpu.buffers,
            *on_gpu.data,
            picture.gbuffer,
            picture.receivers,
            on_gpu.casters,
            on_gpu.instance_boxes,
            picture.image,
            picture.receiver_range,
            picture.receiver_plane_world,
            request.seed,
            settings_.shaders_folder,
            request.blocker_truth != nullptr,
            frame,
            previous_camera,
            previous == nullptr ? nullptr : &previous->gbuffer,
            blue_noise_ ? &*blue_noise_ : nullptr};
  }

  /// Pictures of frames before are kept only where nothing moves: nobody asks for the others again.
  std::shared_ptr<const Picture> picture_in(const Scene& before, const Scene& scene,
                                            const RenderRequest& request) {
    if (picture_key(before, request) == picture_key(scene, request)) return picture_of(scene, request);
    return draw_picture(before, on_gpu_in(before, scene), request);
  }

  std::shared_ptr<const SceneOnGpu> on_gpu_in(const Scene& before, const Scene& scene) {
    return geometry_key(before) == geometry_key(scene) ? scene_on_gpu(scene) : upload(before);
  }

  /// Draws the frames before the one that counts, each with what the one before it left; null for none.
  std::unique_ptr<GlFrame> draw_before(const GlRun& run, const Scene& scene, const RenderRequest& request,
                                       Progress& progress) {
    if (request.blocker_truth != nullptr && run.frames_before > 0 && scene.motion.name != Motion{}.name)
      fail_input(fmt::format("technique '{}' needs the truth's blockers of frames before", run.technique.id),
                 {}, "they are known of the last frame: only where nothing moves");
    std::unique_ptr<GlFrame> earlier;
    for (int frame = 0; frame < run.frames_before; ++frame) {
      auto next = std::make_unique<GlFrame>(
          GlFrame{scene_at(scene, frame - run.frames_before, request.height_px), {}, {}, {}, {}, {}});
      next->on_gpu = on_gpu_in(next->scene, scene);
      next->picture = picture_in(next->scene, scene, request);
      if (earlier) next->previous_picture = earlier->picture;
      const RunInputs inputs =
          inputs_of(run, next->scene, *next->on_gpu, *next->picture, request, frame,
                    earlier ? &earlier->scene.camera : nullptr, next->previous_picture.get());
      next->plan = make_plan(inputs, programs_);
      next->contents = find_contents(next->plan, inputs, picture_key(next->scene, request));
      if (earlier) {
        hand_over(run.technique, earlier->plan, next->plan);
        keep_unchanged(earlier->contents, next->contents, next->plan);
      }
      attach(next->plan);
      if (!earlier) clear_previous(run.technique, next->plan);
      draw_frame(next->plan, next->on_gpu->buffers, empty_vertex_array_, {.is_first = frame == 0});
      check_gl_errors("a frame before");
      progress.advance(1);
      earlier = std::move(next);
    }
    return earlier;
  }

  /// Checks for GL errors, and fills the pool of queries.
  void draw_first(GlRun& run, const Scene& scene, const RenderRequest& request, Progress& progress) {
    progress.begin(run.technique.id, run.plan.steps.size() + static_cast<size_t>(run.frames_before));
    if (run.blocker_truth) bind_texture(kBlockerTruthUnit, *run.blocker_truth, nearest_);
    if (const auto earlier = draw_before(run, scene, request, progress))
      hand_over(run.technique, earlier->plan, run.plan);
    if (run.contents) textures_.give(*run.contents, run.plan);
    attach(run.plan);
    if (run.frames_before == 0) clear_previous(run.technique, run.plan);
    if (run.timers) run.timers->begin_frame();
    draw_frame(run.plan, run.scene->buffers, empty_vertex_array_,
               {.timers = run.timers ? &*run.timers : nullptr,
                .is_first = run.frames_before == 0,
                .progress = &progress});
    if (run.timers) run.timers->end_frame();
    if (run.contents) textures_.take(*run.contents, run.plan);
    progress.end();
  }

  void keep_timing(const std::shared_ptr<GlRun>& run, PreparedRun& prepared) {
    prepared.passes = run->plan.labels;
    prepared.timer = to_text(run->timers->kind());
    prepared.time_frame = [this, run] {
      context_.make_current();
      run->timers->begin_frame();
      draw_frame(run->plan, run->scene->buffers, empty_vertex_array_,
                 {.timers = &*run->timers, .is_first = false});
      std::vector<double> times_ms = run->timers->end_frame();
      check_gl_errors("timed frame");
      return times_ms;
    };
  }

  void describe(const GlRun& run, Frame& frame) {
    frame.parameters = run.parameters;
    frame.image = run.picture->image;
    frame.memory_bytes = memory_bytes(run.plan);
    frame.warnings = run.plan.warnings;
    frame.left_out = run.left_out;
    frame.frames_before = run.frames_before;
    frame.motion = run.motion;
    read_visibility(run.plan, run.technique, frame);
  }

  void read_visibility(const Plan& plan, const Technique& technique, Frame& frame) {
    const std::array<std::string, 1> channels = {std::string(kVisibility)};
    read_texture(plan.targets->visibility(), channels, frame.image);
    if (const auto warning = check_visibility(frame.image, technique.id)) frame.warnings.push_back(*warning);
    if (!plan.center_views.empty()) {
      add_texel_planes(plan.center_views, frame.image);
      add_bias_plane(frame.parameters, frame.image);
    }
    if (plan.center_views.size() > 1) {
      const Image indices = map_indices(plan.center_views, frame.image);
      std::ranges::copy(indices.plane("Y"), frame.image.add_plane("map_index").begin());
    }
    std::vector<LightView> maps;
    for (const FittedView& fitted : plan.center_views) maps.push_back(fitted.view);
    if (maps.empty() && plan.sample_view) maps.push_back(plan.sample_view->view);
    if (maps.empty()) return;
    const double outside = share_outside(frame.image, maps);
    if (outside == 0.0) return;
    frame.warnings.push_back(
        fmt::format("technique '{}': {:.3g} % of the receivers lie outside the light's map and count as lit",
                    technique.id, 100.0 * outside));
  }

  RealtimeSettings settings_;
  TechniqueCache techniques_;
  GlContext context_;  // before everything that lives in it
  ProgramCache programs_;
  GBufferRenderer gbuffer_renderer_;
  VertexArray empty_vertex_array_;
  Sampler nearest_{SamplerSettings{}};
  std::optional<TimerKind> timer_;
  std::optional<Texture> blue_noise_;  // made when first read
  uint64_t scene_data_made_ = 0;
  RecentlyUsed<SceneOnGpu> scenes_{kScenesBytes};  // runs share both
  RecentlyUsed<Picture> pictures_{kPicturesBytes};
  KeptTextures textures_{kTexturesBytes};
};

template <class Made, class Given>
Made& gl_renderer_of(Given& renderer) {
  auto* gl = dynamic_cast<Made*>(&renderer);
  UMBRAMETER_ASSERT(gl != nullptr, "{} renderer", "not a real-time");
  return *gl;
}

}  // namespace

std::unique_ptr<Renderer> make_realtime_renderer(const RealtimeSettings& settings) {
  return std::make_unique<GlRenderer>(settings);
}

std::string device_identity(const Renderer& renderer) {
  const GlDevice& device = gl_renderer_of<const GlRenderer>(renderer).device();
  return fmt::format("{}, {}", device.renderer, device.version);
}

PassCounts pass_counts(const Renderer& renderer) {
  return gl_renderer_of<const GlRenderer>(renderer).counts();
}

uint64_t scene_data_made(const Renderer& renderer) {
  return gl_renderer_of<const GlRenderer>(renderer).scene_data_made();
}

Image dump_resource(Renderer& renderer, const Scene& scene, const RenderRequest& request,
                    const ResourcePart& part, Progress& progress) {
  return gl_renderer_of<GlRenderer>(renderer).dump(scene, request, part, progress);
}

std::optional<Image> map_indices(Renderer& renderer, const Scene& scene, const RenderRequest& request) {
  return gl_renderer_of<GlRenderer>(renderer).maps(scene, request);
}

std::vector<std::string> drawn_passes(Renderer& renderer, const Scene& scene, const RenderRequest& request) {
  return gl_renderer_of<GlRenderer>(renderer).passes(scene, request);
}

std::vector<FinalShader> final_shaders(Renderer& renderer, const Scene& scene, const RenderRequest& request) {
  return gl_renderer_of<GlRenderer>(renderer).shaders(scene, request);
}

}  // namespace umbrameter
