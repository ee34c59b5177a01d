// SPDX-License-Identifier: Apache-2.0
// Milliseconds a megapixel of each metric, on one and two threads, over a synthetic 1920x1080 pair; `everything` is
// what a score with diagnosis and second opinions costs together. cpu_ms_per_megapixel is the time of all threads: what a
// machine with other work can measure.
#include "metrics/causes/causes.h"
#include "metrics/error/lit_similarity.h"
#include "metrics/error/similarity.h"
#include "metrics/error/verdict.h"
#include "metrics/error/visibility_error.h"
#include "metrics/faults/faults.h"
#include "metrics/faults/moire.h"
#include "metrics/flip/flip.h"
#include "metrics/image/parity.h"
#include "metrics/penumbra/contact_hardening.h"
#include "metrics/penumbra/envelope.h"
#include "metrics/penumbra/penumbra.h"
#include "metrics/statistics/significance.h"
#include "metrics/temporal/temporal.h"

#include <benchmark/benchmark.h>

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>

namespace umbrameter {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
const glm::dvec3 kEye{0.0, 0.0, 0.0};

// A floor with soft stripes of shadow, noise in the reference and a slightly shifted test.
struct Pair {
  Image test{kWidth, kHeight};
  Image reference{kWidth, kHeight};
  std::vector<uint8_t> mask = std::vector<uint8_t>(size_t{kWidth} * kHeight, 1);
};

void add_floor(Image& image) {
  for (const char* zero : {"normal.x", "normal.z"}) image.add_plane(zero, 0.0f);
  image.add_plane("normal.y", 1.0f);
  image.add_plane("position.y", -1.0f);
  image.add_plane("primitive_id", 0.0f);
  for (const char* zero : {"shading_normal.x", "shading_normal.z"}) image.add_plane(zero, 0.0f);
  image.add_plane("shading_normal.y", 1.0f);
  image.add_plane("blocker_distance_min", 2.0f);
  image.add_plane("blocker_layers", 1.0f);
  image.add_plane("unshadowed_irradiance", 1.0f);
  const std::span<float> x = image.add_plane("position.x");
  const std::span<float> z = image.add_plane("position.z");
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    x[i] = 0.01f * static_cast<float>(i % kWidth);
    z[i] = -0.01f * static_cast<float>(i / kWidth);
  }
}

Pair make_pair() {
  Pair pair;
  add_floor(pair.test);
  add_floor(pair.reference);
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0f, 0.01f);
  const auto clamped = [](float v) { return std::min(1.0f, std::max(0.0f, v)); };
  const std::span<float> v = pair.test.add_plane("visibility");
  const std::span<float> r = pair.reference.add_plane("visibility");
  const std::span<float> a = pair.reference.add_plane("half_a");
  const std::span<float> b = pair.reference.add_plane("half_b");
  pair.reference.add_plane("visibility_se", 0.007f);
  for (size_t i = 0; i < v.size(); ++i) {
    const float x = static_cast<float>(i % kWidth), y = static_cast<float>(i / kWidth);
    const auto stripe = [&](float shift) {
      return clamped(0.5f + (2.0f + y / 200.0f) * std::sin(0.03f * (x + shift)));
    };
    v[i] = stripe(2.0f);
    a[i] = clamped(stripe(0.0f) + noise(random));
    b[i] = clamped(stripe(0.0f) + noise(random));
    r[i] = 0.5f * (a[i] + b[i]);
  }
  return pair;
}

const Pair& pair() {
  static const Pair shared = make_pair();
  return shared;
}

double process_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

template <class Metric>
void measure(benchmark::State& state, const Metric& metric) {
  const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                          static_cast<size_t>(state.range(0)));
  const Pair& input = pair();
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start_ms = process_ms();
  for (auto _ : state) benchmark::DoNotOptimize(metric(input));
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  const double megapixels = static_cast<double>(input.test.pixel_count()) * 1e-6;
  const double runs = static_cast<double>(state.iterations());
  state.counters["ms"] = elapsed.count() / runs;
  state.counters["ms_per_megapixel"] = elapsed.count() / runs / megapixels;
  state.counters["cpu_ms_per_megapixel"] = (process_ms() - cpu_start_ms) / runs / megapixels;
}

void parity(benchmark::State& state) {
  measure(state, [](const Pair& p) { return compare_surfaces(p.test, p.reference, kEye); });
}

void visibility_error(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_visibility_error(p.test, p.reference, p.mask); });
}

void significance(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_significance(p.test, p.reference, p.mask); });
}

void verdict(benchmark::State& state) {
  static Image baseline = pair().test;
  baseline.plane("visibility")[0] = 0.5f;
  measure(state, [](const Pair& p) { return compare_runs(p.test, baseline, p.reference, p.mask); });
}

void penumbra(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_penumbra(p.test, p.reference, p.mask); });
}

const PenumbraError& shared_penumbra() {
  static const PenumbraError shared = measure_penumbra(pair().test, pair().reference, pair().mask);
  return shared;
}

void envelope(benchmark::State& state) {
  measure(state, [](const Pair& p) {
    return measure_envelope(p.test, p.reference, p.mask, shared_penumbra().profiles);
  });
}

void faults(benchmark::State& state) {
  static const Envelope envelope =
      measure_envelope(pair().test, pair().reference, pair().mask, shared_penumbra().profiles);
  measure(state, [](const Pair& p) {
    return classify_faults(p.test, p.reference, p.mask, shared_penumbra().profiles, envelope);
  });
}

const Faults& shared_faults() {
  static const Faults shared = classify_faults(
      pair().test, pair().reference, pair().mask, shared_penumbra().profiles,
      measure_envelope(pair().test, pair().reference, pair().mask, shared_penumbra().profiles));
  return shared;
}

void contact_hardening(benchmark::State& state) {
  measure(state, [](const Pair&) { return measure_contact_hardening(shared_penumbra()); });
}

void causes(benchmark::State& state) {
  measure(state, [](const Pair& p) {
    return measure_causes(p.test, p.reference, p.mask, shared_penumbra().profiles);
  });
}

void moire(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_moire(p.test, p.reference, p.mask, shared_faults()); });
}

// Two frames of a still camera: what a step costs does not depend on how far it goes.
void temporal(benchmark::State& state) {
  measure(state, [](const Pair& p) {
    const glm::dmat4 clip_from_world = {{0.1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0.185, 0, 0}, {-0.96, 0.999, 0, 1}};
    const SequenceFrame frame = {&p.test, &p.reference, p.mask, clip_from_world};
    const std::array<SequenceFrame, 2> frames = {frame, frame};
    benchmark::DoNotOptimize(measure_popping(frames));
    return measure_flicker(frames);
  });
}

const ColorChannels kGrey = {"visibility", "visibility", "visibility"};
// Planes that differ, so that no channel is spared.
const ColorChannels kColor = {"visibility", "half_a", "half_b"};

void flip(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_flip(p.test, p.reference, kGrey); });
}

void flip_color(benchmark::State& state) {
  static Image test = pair().test;
  for (const char* half : {"half_a", "half_b"})
    std::ranges::copy(pair().test.plane("visibility"), test.add_plane(half).begin());
  measure(state, [](const Pair& p) { return measure_flip(test, p.reference, kColor); });
}

// Against a reference that was seen before.
void flip_further(benchmark::State& state) {
  static const FlipReference reference(pair().reference, kGrey);
  measure(state, [](const Pair& p) { return reference.measure(p.test); });
}

void hdr_flip(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_hdr_flip(p.test, p.reference, kGrey); });
}

void hdr_flip_further(benchmark::State& state) {
  static const HdrFlipReference reference(pair().reference, kGrey);
  measure(state, [](const Pair& p) { return reference.measure(p.test); });
}

void ssim(benchmark::State& state) {
  measure(state, [](const Pair& p) { return measure_ssim(p.test, p.reference, "visibility"); });
}

void everything(benchmark::State& state) {
  measure(state, [](const Pair& p) {
    const Parity parity = compare_surfaces(p.test, p.reference, kEye);
    const std::vector<uint8_t> mask = scored_mask(parity, p.reference);
    benchmark::DoNotOptimize(measure_visibility_error(p.test, p.reference, mask));
    benchmark::DoNotOptimize(measure_significance(p.test, p.reference, mask));
    const PenumbraError penumbra = measure_penumbra(p.test, p.reference, mask);
    benchmark::DoNotOptimize(measure_contact_hardening(penumbra));
    const Envelope envelope = measure_envelope(p.test, p.reference, mask, penumbra.profiles);
    const Faults faults = classify_faults(p.test, p.reference, mask, penumbra.profiles, envelope);
    benchmark::DoNotOptimize(measure_moire(p.test, p.reference, mask, faults));
    benchmark::DoNotOptimize(measure_causes(p.test, p.reference, mask, penumbra.profiles));
    return measure_similarity(p.test, p.reference, mask);
  });
}

#define UMBRAMETER_BENCH(metric) \
  BENCHMARK(metric)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()
UMBRAMETER_BENCH(parity);
UMBRAMETER_BENCH(visibility_error);
UMBRAMETER_BENCH(significance);
UMBRAMETER_BENCH(verdict);
UMBRAMETER_BENCH(penumbra);
UMBRAMETER_BENCH(envelope);
UMBRAMETER_BENCH(faults);
UMBRAMETER_BENCH(contact_hardening);
UMBRAMETER_BENCH(causes);
UMBRAMETER_BENCH(moire);
UMBRAMETER_BENCH(temporal);
UMBRAMETER_BENCH(flip);
UMBRAMETER_BENCH(flip_further);
UMBRAMETER_BENCH(flip_color);
UMBRAMETER_BENCH(hdr_flip);
UMBRAMETER_BENCH(hdr_flip_further);
UMBRAMETER_BENCH(ssim);
UMBRAMETER_BENCH(everything);

}  // namespace
}  // namespace umbrameter

BENCHMARK_MAIN();
