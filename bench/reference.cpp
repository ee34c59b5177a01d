// SPDX-License-Identifier: Apache-2.0
// What the integrator costs over Embree itself: the same shadow rays, once made, traced and summed by the
// reference, once recorded and only traced, on one and on two threads; rates are per second of processor time, the best of
// the repetitions counts. Prints at the end the ratio of the rates, how a
// whole picture scales from one thread to two, and the time to build and the memory of all beside those of Embree's own tree
// and mesh.
//   bench_reference [SCENE.toml [ASSETS]] [--benchmark_repetitions=5 ...]      without a scene: columns and spheres

#include "reference/reference.h"
#include "core/clock.h"
#include "reference/embree_scene.h"
#include "reference/occluder_tree.h"
#include "reference/primary_hit.h"
#include "reference/shadow_packet.h"
#include "reference/shadow_sampler.h"
#include "scenes/instances.h"
#include "scenes/load_scene.h"
#include "scenes/merge_meshes.h"
#include "scenes/shapes.h"

#include <benchmark/benchmark.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

namespace umbrameter {
namespace {

constexpr uint32_t kPoints = 128;  // a replicate: 1024 samples per pixel
constexpr int kSide = 14;          // pixels; few enough for the recorded rays to stay in a cache
constexpr int kBlocks = (kSide + kBlock - 1) / kBlock;

void add(std::vector<NamedMesh>& meshes, MeshData mesh, const glm::dvec3& offset) {
  for (glm::dvec3& p : mesh.positions) p += offset;
  meshes.push_back({"mesh", "mesh", {}, std::move(mesh)});
}

/// A row of columns before a floor with spheres on it: lit, umbra and penumbra in one picture.
Scene make_bench_scene() {
  std::vector<NamedMesh> meshes;
  add(meshes, make_plane({20.0, 20.0}), {0, 0, 0});
  add(meshes, make_colonnade(9, 1.0, 0.2, 3.0, 64, {0.6, 0.3}), {0, 0, 1.5});
  for (int i = 0; i < 25; ++i) {
    add(meshes, make_sphere(0.3, 128, false), {i % 5 - 2, 0.5, i / 5 - 4});
  }
  Scene scene;
  merge_meshes(meshes, scene);
  Light light;
  light.type = LightType::rect;
  light.center_world = {1, 6, 4};
  light.size_world = {1.0, 1.0};
  scene.lights = {light};
  scene.camera.eye_world = {0, 5, 8};
  scene.camera.at_world = {0, 0, -1};
  scene.camera.vertical_fov_deg = 40.0;
  scene.camera.near_world = 1e-3;
  return scene;
}

struct Work {
  Scene scene;
  EmbreeScene embree;
  SampleSets sets{kPoints};
  struct Pixel {
    glm::vec3 origin_world;
    LightPatch patch;
    uint32_t seed;
  };
  std::vector<Pixel> pixels;

  explicit Work(Scene bench_scene) : scene(std::move(bench_scene)) {
    embree.load(scene);
    const PrimaryCamera camera(scene, kSide, kSide);
    for (int i = 0; i < kBlocks * kBlocks; ++i) {
      for (const auto& hit : camera.hits(embree, kBlock * (i % kBlocks), kBlock * (i / kBlocks))) {
        if (hit) add_pixel(hit->receiver);
      }
    }
  }
  void add_pixel(const Receiver& receiver) {
    const LightPatch patch = make_light_patch(scene.light(), receiver, scene.bounds_world.diagonal());
    if (is_below_horizon(patch)) return;
    pixels.push_back({receiver.ray_origin_world, patch, pixel_seed(1, static_cast<uint32_t>(pixels.size()))});
  }
  int64_t ray_count() const { return static_cast<int64_t>(pixels.size()) * kReplicates * kPoints; }
};

std::unique_ptr<Work> g_work;  // set by main, before any benchmark
const Work& work() {
  return *g_work;
}

void report_rate(benchmark::State& state) {
  state.counters["Mrays/s"] = benchmark::Counter(
      static_cast<double>(work().ray_count() * state.iterations()) * 1e-6, benchmark::Counter::kIsRate);
}

void integrator(benchmark::State& state) {
  for (auto _ : state) {
    for (const Work::Pixel& pixel : work().pixels) {
      PixelSums sums;
      sample_pixel(work().embree, pixel.origin_world, pixel.patch, work().sets, pixel.seed, kPoints, sums);
      benchmark::DoNotOptimize(sums);
    }
  }
  report_rate(state);
}

template <class Use>
void for_each_batch(const Use& use) {
  for (const Work::Pixel& pixel : work().pixels) {
    ShadowRayBatch batch(pixel.origin_world);
    for (uint32_t r = 0; r < kReplicates; ++r) {
      const SampleStream stream = work().sets.stream(pixel.seed, r);
      for (uint32_t first = 0; first < kPoints; first += kBatch) {
        make_shadow_rays(pixel.patch, stream, first, kPoints, batch);
        use(batch);
      }
    }
  }
}

/// The samples alone: what the integrator adds before Embree is called.
void ray_making(benchmark::State& state) {
  for (auto _ : state) {
    for_each_batch([](const ShadowRayBatch& batch) { benchmark::DoNotOptimize(&batch); });
  }
  report_rate(state);
}

template <int Width>
struct Recorded {
  typename ShadowPacket<Width>::Ray ray;
  alignas(64) std::array<int32_t, Width> valid;
  std::array<float, Width> end;
};

template <int Width>
std::vector<Recorded<Width>> record() {
  std::vector<Recorded<Width>> packets;
  for_each_batch([&](const ShadowRayBatch& batch) {
    for (uint32_t first = 0; first < kBatch; first += Width) {
      Recorded<Width>& packet = packets.emplace_back();
      packet.ray = slice<Width>(batch.rays, first);
      std::copy_n(batch.is_facing.data() + first, Width, packet.valid.data());
      std::copy_n(batch.rays.tfar + first, Width, packet.end.data());
    }
  });
  return packets;
}

template <int Width>
void raw_packets(benchmark::State& state) {
  std::vector<Recorded<Width>> packets = record<Width>();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = static_cast<RTCIntersectContextFlags>(state.range(0));
  if (state.range(0) != 0 && !work().scene.instanced.empty()) {
    state.SkipWithError("Embree 3.13.5 does not come back from coherent packets among instances");
    return;
  }
  for (auto _ : state) {
    for (Recorded<Width>& packet : packets) {
      std::copy_n(packet.end.data(), Width, packet.ray.tfar);
      ShadowPacket<Width>::occluded(packet.valid.data(), work().embree.handle(), &context, &packet.ray);
    }
  }
  report_rate(state);
}

void raw_single(benchmark::State& state) {
  const std::vector<Recorded<4>> packets = record<4>();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (auto _ : state) {
    for (const Recorded<4>& packet : packets) {
      for (int i = 0; i < 4; ++i) {
        if (packet.valid[i] == 0) continue;
        RTCRay ray{};
        ray.org_x = packet.ray.org_x[i];
        ray.org_y = packet.ray.org_y[i];
        ray.org_z = packet.ray.org_z[i];
        ray.dir_x = packet.ray.dir_x[i];
        ray.dir_y = packet.ray.dir_y[i];
        ray.dir_z = packet.ray.dir_z[i];
        ray.tfar = packet.end[i];
        ray.mask = ~0u;
        rtcOccluded1(work().embree.handle(), &context, &ray);
        benchmark::DoNotOptimize(ray.tfar);
      }
    }
  }
  report_rate(state);
}

#define UMBRAMETER_ON_ONE_AND_TWO(bench) bench->Threads(1)->Threads(2)->Unit(benchmark::kMillisecond)
UMBRAMETER_ON_ONE_AND_TWO(BENCHMARK(integrator));
UMBRAMETER_ON_ONE_AND_TWO(BENCHMARK(ray_making));
UMBRAMETER_ON_ONE_AND_TWO(BENCHMARK(raw_single));
UMBRAMETER_ON_ONE_AND_TWO(BENCHMARK_TEMPLATE(raw_packets, 4)->ArgName("coherent")->Arg(0)->Arg(1));
UMBRAMETER_ON_ONE_AND_TWO(BENCHMARK_TEMPLATE(raw_packets, 8)->ArgName("coherent")->Arg(0)->Arg(1));
UMBRAMETER_ON_ONE_AND_TWO(BENCHMARK_TEMPLATE(raw_packets, 16)->ArgName("coherent")->Arg(0)->Arg(1));

/// Keeps the fastest run of each benchmark.
class BestRates final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const auto rate = run.counters.find("Mrays/s");
      if (rate == run.counters.end() || run.run_type != Run::RT_Iteration) continue;
      const std::string& name = run.run_name.function_name;
      Rates& best = by_threads_[run.threads];
      if (name == "integrator") best.integrator = std::max(best.integrator, rate->second.value);
      if (name.starts_with("raw")) best.raw = std::max(best.raw, rate->second.value);
    }
  }
  void print_ratios() const {
    for (const auto& [threads, best] : by_threads_) {
      if (!(best.integrator > 0.0 && best.raw > 0.0)) continue;
      std::printf("%ld thread(s): integrator / best raw Embree rate: %.2f / %.2f Mrays/s = %.3f\n",
                  static_cast<long>(threads), best.integrator, best.raw, best.integrator / best.raw);
    }
  }

 private:
  struct Rates {
    double integrator = 0.0;
    double raw = 0.0;
  };
  std::map<int64_t, Rates> by_threads_;
};

double frame_seconds(int threads) {
  const auto renderer = make_reference_renderer({256, {}, threads});
  SilentProgress progress;
  RenderRequest request;
  request.width_px = request.height_px = 1;
  renderer->render(work().scene, request, progress);  // builds the scene
  request.width_px = 320;
  request.height_px = 180;
  return renderer->render(work().scene, request, progress).wall_time_s;
}

void print_scaling() {
  const double one_s = frame_seconds(1), two_s = frame_seconds(2);
  std::printf("320 x 180 px, 256 samples: %.3f s on one thread, %.3f s on two: efficiency %.2f\n", one_s,
              two_s, one_s / (2.0 * two_s));
}

template <class T>
uint64_t bytes_of(const SharedList<T>& items) {
  return items.size() * sizeof(T);
}

/// What the reference builds, and holds while it renders, over what Embree alone does.
void print_building() {
  const Scene& scene = work().scene;
  EmbreeScene embree;
  const double start_s = process_cpu_seconds();
  embree.load(scene);
  const double loaded_s = process_cpu_seconds();
  const uint64_t alone = embree.memory_bytes();
  OccluderTree occluders;
  occluders.build(embree, scene);
  std::printf("built in %.2f CPU s by Embree and %.2f CPU s for our tree\n", loaded_s - start_s,
              process_cpu_seconds() - loaded_s);
  const uint64_t all = embree.memory_bytes() + bytes_of(scene.positions_world) +
                       bytes_of(scene.normals_world) + bytes_of(scene.triangles);
  std::printf(
      "%zu triangles: Embree's tree and mesh %.1f MB, with our tree and scene %.1f MB: %.2f times as much\n",
      static_cast<size_t>(count_shown_triangles(scene)), 1e-6 * static_cast<double>(alone),
      1e-6 * static_cast<double>(all), static_cast<double>(all) / static_cast<double>(alone));
}

}  // namespace
}  // namespace umbrameter

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  umbrameter::SceneSearch search;
  if (argc > 2) search.assets = argv[2];
  umbrameter::g_work = std::make_unique<umbrameter::Work>(argc > 1 ? umbrameter::load_scene(argv[1], search)
                                                                   : umbrameter::make_bench_scene());
  umbrameter::BestRates rates;
  benchmark::RunSpecifiedBenchmarks(&rates);
  rates.print_ratios();
  umbrameter::print_scaling();
  umbrameter::print_building();
  benchmark::Shutdown();
}
