// What the truth costs and how fast it converges, against a closed form: CPU seconds, rays and RMSE of visibility over
// lit pixels, once by a target standard error (adaptive) and once by a fixed number of samples; the exponent with
// which the error of fixed samples falls. Times start when the scene is built. One line of CSV a picture.
//   bench_truth [WIDTH HEIGHT [THREADS]]

#include "reference/exact/box_visibility.h"
#include "reference/ray_budget.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <optional>

namespace umbrameter {
namespace {

const BoxUnderLight kCube{{-0.5, 0, -0.5}, {0.5, 1, 0.5}, {-2, 4, 1}, {3, 2}};

struct Picture {
  int width_px = 960;
  int height_px = 540;
  int threads = 0;
};

struct Measured {
  double rmse = 0.0;
  double cpu_s = 0.0;
  RayBudget rays;
};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double rmse_over_lit(const Image& image) {
  const auto plane = [&](const char* name) { return image.plane(name); };
  const auto v = plane("visibility"), lit = plane("unshadowed_irradiance");
  const auto x = plane("position.x"), y = plane("position.y"), z = plane("position.z");
  const auto nx = plane("normal.x"), ny = plane("normal.y"), nz = plane("normal.z");
  double error2 = 0.0, n = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (lit[i] <= 0.0f) continue;
    const double truth = box_visibility(kCube, {x[i], y[i], z[i]}, {nx[i], ny[i], nz[i]});
    error2 += std::pow(static_cast<double>(v[i]) - truth, 2);
    n += 1.0;
  }
  return std::sqrt(error2 / n);
}

Measured measure(const Scene& scene, const Picture& picture, int samples, std::optional<double> target_se) {
  SilentProgress progress;
  const auto renderer = make_reference_renderer({samples, target_se, picture.threads});
  RenderRequest request;
  request.width_px = request.height_px = 1;
  renderer->render(scene, request, progress);  // builds the scene
  request.width_px = picture.width_px;
  request.height_px = picture.height_px;
  const double before_s = cpu_seconds();
  const Frame frame = renderer->render(scene, request, progress);
  const double cpu_s = cpu_seconds() - before_s;
  return {rmse_over_lit(frame.image), cpu_s, ray_budget(frame.image)};
}

void print(const std::string& kind, double setting, const Measured& m) {
  std::cout << fmt::format("{},{},{:.3f},{:.1f},{:.6f},{:.3f},{:.3f}\n", kind, setting, m.cpu_s,
                           m.rays.rays_per_pixel, m.rmse, m.rays.proven_lit, m.rays.proven_dark);
}

/// Least squares of log error over log samples.
double slope(const std::vector<std::pair<double, double>>& samples_and_errors) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  const auto n = static_cast<double>(samples_and_errors.size());
  for (const auto& [samples, error] : samples_and_errors) {
    const double lx = std::log(samples), ly = std::log(error);
    x += lx;
    y += ly;
    xx += lx * lx;
    xy += lx * ly;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void run(const Picture& picture) {
  const Scene scene = load_scene(std::string(UMBRAMETER_SOURCE_DIR) + "/bench/cube.toml", SceneSearch{});
  std::cout << "kind,setting,cpu_s,rays_per_pixel,rmse_lit,proven_lit,proven_dark\n";
  for (const double target : {0.02, 0.01, 0.005, 0.002}) {
    print("target_se", target, measure(scene, picture, 1 << 16, target));
  }
  std::vector<std::pair<double, double>> errors;
  for (const int samples : {32, 128, 512, 2048}) {
    const Measured m =
        measure(scene, {picture.width_px / 4, picture.height_px / 4, picture.threads}, samples, {});
    print("samples", samples, m);
    errors.emplace_back(samples, m.rmse);
  }
  std::cout << fmt::format("error falls with samples to the power {:.2f}\n", slope(errors));
}

}  // namespace
}  // namespace umbrameter

int main(int argc, char** argv) {
  umbrameter::Picture picture;
  if (argc > 2) {
    picture.width_px = std::atoi(argv[1]);
    picture.height_px = std::atoi(argv[2]);
  }
  if (argc > 3) picture.threads = std::atoi(argv[3]);
  umbrameter::run(picture);
}
