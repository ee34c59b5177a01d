// What the integrator costs over Embree itself: the same shadow rays, once made, traced and summed by the
// reference, once recorded and only traced. One thread. Prints the ratio of the rates at the end.
//   bench_reference [SCENE.toml [ASSETS]] [--benchmark_...]      without a scene: columns and spheres

#include "reference/embree_scene.h"
#include "reference/primary_hit.h"
#include "reference/shadow_packet.h"
#include "reference/shadow_sampler.h"
#include "scenes/load_scene.h"
#include "scenes/merge_meshes.h"
#include "scenes/shapes.h"

#include <benchmark/benchmark.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <utility>

namespace umbrameter {
namespace {

constexpr uint32_t kPoints = 128;  // a replicate: 1024 samples a pixel
constexpr int kSide = 14;          // pixels; few enough for the recorded rays to stay in a cache

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
    for (int i = 0; i < kSide * kSide; ++i) {
      const auto hit = camera.hit(embree, i % kSide, i / kSide);
      if (!hit) continue;
      const LightPatch patch = make_light_patch(scene.light(), hit->receiver, scene.bounds_world.diagonal());
      if (is_below_horizon(patch)) continue;
      pixels.push_back({hit->receiver.ray_origin_world, patch, pixel_seed(1, static_cast<uint32_t>(i))});
    }
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

BENCHMARK(integrator)->Unit(benchmark::kMillisecond);
BENCHMARK(ray_making)->Unit(benchmark::kMillisecond);
BENCHMARK(raw_single)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(raw_packets, 4)->ArgName("coherent")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(raw_packets, 8)->ArgName("coherent")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(raw_packets, 16)->ArgName("coherent")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// Keeps the fastest run of each benchmark.
class BestRates final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      const auto rate = run.counters.find("Mrays/s");
      if (rate == run.counters.end() || run.run_type != Run::RT_Iteration) continue;
      double& best = run.run_name.function_name == "integrator" ? integrator_ : raw_of(run);
      best = std::max(best, rate->second.value);
    }
  }
  void print_ratio() const {
    if (integrator_ > 0.0 && raw_ > 0.0) {
      std::printf("integrator / best raw Embree rate: %.2f / %.2f Mrays/s = %.3f\n", integrator_, raw_,
                  integrator_ / raw_);
    }
  }

 private:
  double& raw_of(const Run& run) { return run.run_name.function_name.starts_with("raw") ? raw_ : ignored_; }
  double integrator_ = 0.0;
  double raw_ = 0.0;
  double ignored_ = 0.0;
};

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
  rates.print_ratio();
  benchmark::Shutdown();
}
