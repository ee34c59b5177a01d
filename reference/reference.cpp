// SPDX-License-Identifier: Apache-2.0
#include "reference/reference.h"

#include "core/error.h"
#include "reference/embree_scene.h"
#include "reference/pixel_tile.h"
#include "reference/primary_hit.h"
#include "reference/reference_planes.h"
#include "reference/sample_sets.h"
#include "scenes/local_scene.h"
#include "scenes/scene.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <glm/common.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace umbrameter {

namespace {

constexpr int kMaxSide = 16384;

int checked_points(const ReferenceSettings& settings) {
  constexpr int kMaxSamples = 1 << 20;
  if (settings.samples_per_pixel < 1 || settings.samples_per_pixel > kMaxSamples) {
    fail_input(fmt::format("samples_per_pixel is {}", settings.samples_per_pixel), {},
               fmt::format("choose 1 to {}", kMaxSamples));
  }
  if (settings.target_se && !(*settings.target_se > 0.0 && *settings.target_se < 1.0)) {
    fail_input(fmt::format("target_se is {}", *settings.target_se), {}, "choose a number between 0 and 1");
  }
  if (settings.threads < 0) fail_input(fmt::format("threads is {}", settings.threads), {}, "0 means all");
  return (settings.samples_per_pixel + kReplicates - 1) / kReplicates;
}

void require_valid(const Scene& scene, const RenderRequest& request) {
  const auto is_bad = [](int side) { return side < 1 || side > kMaxSide; };
  if (is_bad(request.width_px) || is_bad(request.height_px)) {
    fail_input(fmt::format("resolution is {}x{}", request.width_px, request.height_px), {},
               fmt::format("each side is 1 to {}", kMaxSide));
  }
  if (scene.active_light >= scene.lights.size()) {
    fail_input(
        fmt::format("light {} is chosen but the scene has {}", scene.active_light, scene.lights.size()),
        scene.source);
  }
}

double extent_of(const Scene& scene) {
  if (scene.bounds_world.empty()) return 0.0;
  const glm::dvec3 reach = glm::max(glm::abs(scene.bounds_world.min), glm::abs(scene.bounds_world.max));
  return std::max({reach.x, reach.y, reach.z, scene.bounds_world.diagonal()});
}

int tiles_across(int side_px) {
  return (side_px + kTile - 1) / kTile;
}

void warn_of_missed_target(const Image& image, double target_se, uint32_t sample_limit,
                           std::vector<std::string>& warnings) {
  const auto se = image.plane("visibility_se");
  const auto samples = image.plane("sample_count");
  size_t missed = 0;
  for (size_t i = 0; i < se.size(); ++i) {
    if (samples[i] >= static_cast<float>(sample_limit) && static_cast<double>(se[i]) > target_se) ++missed;
  }
  if (missed == 0) return;
  warnings.push_back(
      fmt::format("{} pixels kept a standard error above {} at the sample limit", missed, target_se));
}

struct Geometry {
  EmbreeScene embree;
  OccluderTree occluders;
};

class ReferenceRenderer final : public Renderer {
 public:
  ReferenceRenderer(const ReferenceSettings& settings, std::shared_ptr<Geometry> geometry)
      : settings_(settings),
        geometry_(std::move(geometry)),
        sets_(static_cast<uint32_t>(checked_points(settings))),
        arena_(settings.threads > 0 ? settings.threads : tbb::task_arena::automatic) {
    arena_.initialize();
  }

  Frame render(const Scene& scene, const RenderRequest& request, Progress& progress) override {
    const std::optional<LocalScene> local = local_scene(scene);
    if (!local) return render_local(scene, request, progress);
    Frame frame = render_local(local->scene, request, progress);
    add_origin(local->origin_world, frame.image);
    return frame;
  }

 private:
  Frame render_local(const Scene& scene, const RenderRequest& request, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    require_valid(scene, request);
    EmbreeScene& embree = geometry_->embree;
    arena_.execute([&] {
      if (embree.load(scene)) geometry_->occluders.build(embree, scene);
    });

    Frame frame;
    frame.image = Image(request.width_px, request.height_px);
    ReferencePlanes planes(frame.image, settings_.probe_blockers);
    const PrimaryCamera camera(scene, request.width_px, request.height_px);
    const BlockJob job{scene.light(),
                       embree,
                       camera,
                       sets_,
                       request.seed,
                       extent_of(scene),
                       settings_.target_se,
                       scene,
                       geometry_->occluders,
                       settings_.skip_proven,
                       settings_.probe_blockers};
    render_tiles(job, planes, progress);

    if (settings_.target_se) {
      warn_of_missed_target(frame.image, *settings_.target_se, kReplicates * sets_.points(), frame.warnings);
    }
    frame.device = fmt::format("Embree {}, {} threads", embree.version(), arena_.max_concurrency());
    frame.memory_bytes = embree.memory_bytes();
    frame.wall_time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return frame;
  }

  void render_tiles(const BlockJob& job, ReferencePlanes& planes, Progress& progress) {
    const int columns = tiles_across(planes.width());
    const int rows = tiles_across(planes.height());
    progress.begin("reference", static_cast<uint64_t>(columns) * static_cast<uint64_t>(rows));
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1), [&](const auto& range) {
        for (int y = range.rows().begin(); y < range.rows().end(); ++y) {
          for (int x = range.cols().begin(); x < range.cols().end(); ++x) {
            render_tile(job, x * kTile, y * kTile, planes);
            progress.advance(1);
          }
        }
      });
    });
    progress.end();
  }

  ReferenceSettings settings_;
  std::shared_ptr<Geometry> geometry_;
  SampleSets sets_;
  tbb::task_arena arena_;
};

}  // namespace

std::unique_ptr<Renderer> make_reference_renderer(const ReferenceSettings& settings) {
  return std::make_unique<ReferenceRenderer>(settings, std::make_shared<Geometry>());
}

std::vector<std::unique_ptr<Renderer>> make_reference_renderers(std::span<const ReferenceSettings> settings) {
  const auto geometry = std::make_shared<Geometry>();
  std::vector<std::unique_ptr<Renderer>> renderers;
  for (const ReferenceSettings& each : settings) {
    renderers.push_back(std::make_unique<ReferenceRenderer>(each, geometry));
  }
  return renderers;
}

}  // namespace umbrameter
