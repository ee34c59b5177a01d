// SPDX-License-Identifier: Apache-2.0
// What the truth costs and how fast it converges: processor seconds (times start when the scene is built), rays per pixel and
// RMSE of visibility over lit pixels, a line of CSV a picture, with what Embree alone needs for its primary and its shadow rays
// (raw_limits.h). Blockers are not probed.
//   bench_truth cube  [WIDTH HEIGHT [THREADS]]   a cube against its closed form, by target and by fixed samples; the exponent of
//                                                convergence
//   bench_truth bunny [WIDTH HEIGHT [THREADS]]   the bunny seen close under the same light, against a picture of more samples
//   bench_truth share [WIDTH HEIGHT [THREADS]]   the bunny of the library: how many of the rays of uniform sampling it takes
// The bunny's model is looked for in UMBRAMETER_ASSETS.

#include "bench/raw_limits.h"
#include "core/clock.h"
#include "lab/truth_curve.h"
#include "reference/exact/box_visibility.h"
#include "reference/ray_budget.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

namespace umbrameter {
namespace {

const BoxUnderLight kCube{{-0.5, 0, -0.5}, {0.5, 1, 0.5}, {-2, 4, 1}, {3, 2}};
constexpr int kManySamples = 1 << 16;

struct Picture {
  int width_px = 960;
  int height_px = 540;
  int threads = 0;
};

struct Rendered {
  Frame frame;
  double cpu_s = 0.0;
};

/// Mean squared error over pixels that light can reach.
using Judge = std::function<double(const Image&)>;

Scene load_bench_scene(const std::string& path) {
  SceneSearch search;
  const std::string source = UMBRAMETER_SOURCE_DIR;
  search.library = source + "/scenes/library";
  if (const char* assets = std::getenv("UMBRAMETER_ASSETS")) search.assets = assets;
  return load_scene(source + path, search);
}

/// The least time of `runs` pictures, which are the same.
Rendered render(const Scene& scene, const Picture& picture, int samples, std::optional<double> target_se,
                int runs = 3, uint64_t seed = 1) {
  SilentProgress progress;
  const auto renderer = make_reference_renderer({samples, target_se, picture.threads, true, false});
  RenderRequest request;
  request.seed = seed;
  request.width_px = request.height_px = 1;
  renderer->render(scene, request, progress);  // builds the scene
  request.width_px = picture.width_px;
  request.height_px = picture.height_px;
  Rendered rendered;
  for (int i = 0; i < runs; ++i) {
    const double before_s = process_cpu_seconds();
    rendered.frame = renderer->render(scene, request, progress);
    const double cpu_s = process_cpu_seconds() - before_s;
    rendered.cpu_s = i == 0 ? cpu_s : std::min(rendered.cpu_s, cpu_s);
  }
  return rendered;
}

template <class ErrorAt>
double mean_over_lit(const Image& image, const ErrorAt& error2_at) {
  const auto lit = image.plane("unshadowed_irradiance");
  double sum = 0.0, n = 0.0;
  for (size_t i = 0; i < lit.size(); ++i) {
    if (lit[i] <= 0.0f) continue;
    sum += error2_at(i);
    n += 1.0;
  }
  return sum / n;
}

double cube_error2(const Image& image) {
  const auto plane = [&](const char* name) { return image.plane(name); };
  const auto v = plane("visibility");
  const auto x = plane("position.x"), y = plane("position.y"), z = plane("position.z");
  const auto nx = plane("normal.x"), ny = plane("normal.y"), nz = plane("normal.z");
  return mean_over_lit(image, [&](size_t i) {
    const double truth = box_visibility(kCube, {x[i], y[i], z[i]}, {nx[i], ny[i], nz[i]});
    return std::pow(static_cast<double>(v[i]) - truth, 2);
  });
}

/// By the two halves of a picture of other samples, whose noise is independent and so drops out.
Judge judge_by(const Image& truth) {
  return [&truth](const Image& image) {
    const auto v = image.plane("visibility"), a = truth.plane("half_a"), b = truth.plane("half_b");
    return mean_over_lit(image, [&](size_t i) {
      return (static_cast<double>(v[i]) - a[i]) * (static_cast<double>(v[i]) - b[i]);
    });
  };
}

void print_head() {
  std::cout << "kind,setting,cpu_s,rays_per_pixel,rmse_lit,proven_lit,proven_dark,sampled,raw_primary_s,raw_"
               "shadow_s,"
               "times_raw\n";
}

TruthPoint print(const Scene& scene, const std::string& kind, double setting, const Rendered& rendered,
                 const Judge& judge) {
  const RayBudget rays = ray_budget(rendered.frame.image);
  const double rmse = std::sqrt(std::max(0.0, judge(rendered.frame.image)));
  const RawLimits raw = raw_limits(scene, rendered.frame.image);
  std::cout << fmt::format("{},{},{:.3f},{:.1f},{:.6f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.2f}\n", kind,
                           setting, rendered.cpu_s, rays.rays_per_pixel, rmse, rays.proven_lit,
                           rays.proven_dark, rays.sampled, raw.primary_s, raw.shadow_s,
                           rendered.cpu_s / (raw.primary_s + raw.shadow_s))
            << std::flush;
  return {kind, setting, {rendered.cpu_s, 0.0}, rays.rays_per_pixel, Interval{rmse, rmse, rmse}};
}

void cube(const Picture& picture) {
  const Scene scene = load_bench_scene("/bench/cube.toml");
  print_head();
  for (const double target : {0.02, 0.01, 0.005, 0.002}) {
    print(scene, "target_se", target, render(scene, picture, kManySamples, target), cube_error2);
  }
  std::vector<TruthPoint> points;
  const Picture quarter{picture.width_px / 4, picture.height_px / 4, picture.threads};
  for (const int samples : {32, 128, 512, 2048}) {
    points.push_back(print(scene, "samples", samples, render(scene, quarter, samples, {}), cube_error2));
  }
  std::cout << fmt::format("error falls with samples to the power {:.2f}\n",
                           convergence_exponent(points).value());
}

void bunny(const Picture& picture) {
  const Scene scene = load_bench_scene("/bench/bunny_close.toml");
  const Rendered truth = render(scene, picture, kManySamples, 0.002, 1, 2);
  print_head();
  for (const double target : {0.05, 0.03, 0.02, 0.01, 0.005}) {
    print(scene, "target_se", target, render(scene, picture, kManySamples, target),
          judge_by(truth.frame.image));
  }
}

void share(const Picture& picture) {
  constexpr int kFew = 256, kMany = 1024;
  const Scene scene = load_bench_scene("/scenes/library/assets/bunny.toml");
  const Rendered truth = render(scene, picture, kManySamples, 0.001, 1, 2);
  const Judge judge = judge_by(truth.frame.image);
  print_head();
  const TruthPoint adaptive =
      print(scene, "target_se", 0.002, render(scene, picture, kManySamples, 0.002), judge);
  const TruthPoint uniform[] = {print(scene, "samples", kFew, render(scene, picture, kFew, {}), judge),
                                print(scene, "samples", kMany, render(scene, picture, kMany, {}), judge)};
  const double exponent = convergence_exponent(uniform).value();
  const double samples = kMany * std::pow(adaptive.rmse->value / uniform[1].rmse->value, 1.0 / exponent);
  const RayBudget budget = ray_budget(truth.frame.image);
  const double rays = samples * (1.0 - budget.background - budget.unlit);
  std::cout << fmt::format(
      "uniform sampling errs with samples to the power {:.2f} and needs {:.0f} samples, {:.0f} rays per "
      "pixel, "
      "for the same "
      "error: the picture took {:.1f} % of its rays\n",
      exponent, samples, rays, 100.0 * adaptive.rays_per_pixel / rays);
}

}  // namespace
}  // namespace umbrameter

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "cube";
  umbrameter::Picture picture;
  if (argc > 3) {
    picture.width_px = std::atoi(argv[2]);
    picture.height_px = std::atoi(argv[3]);
  }
  if (argc > 4) picture.threads = std::atoi(argv[4]);
  if (what == "cube") {
    umbrameter::cube(picture);
  } else if (what == "bunny") {
    umbrameter::bunny(picture);
  } else if (what == "share") {
    umbrameter::share(picture);
  } else {
    std::cerr << "bench_truth: '" << what << "' is none of cube, bunny, share\n";
    return 2;
  }
}
