// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_show.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/reference_renderer.h"
#include "cli/staging.h"
#include "core/image_io.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kPreviewWidth_px = 640;
constexpr int kHeight_px = 360;
constexpr int kPreviewSamples = 16;
constexpr float kFull = 0.8f;    // of white: where a light is brightest
constexpr float kFaint = 0.12f;  // of white: what faces the camera in the dark
constexpr std::array<uint8_t, 3> kSky = {58, 66, 82};

/// The brightest but for the brightest hundredth; 1 where there is no light at all.
float bright_level(std::vector<float> values) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() - 1 - values.size() / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place > 0.0f ? *place : 1.0f;
}

uint8_t srgb(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  return static_cast<uint8_t>(std::lround(255.0f * encoded));
}

/// Adds the light's share to `light`, one float a pixel.
void add_light(const Image& image, float share, std::vector<float>& light) {
  const auto irradiance = image.plane("unshadowed_irradiance"), ratio = image.plane("irradiance_ratio");
  const float full = bright_level({irradiance.begin(), irradiance.end()});
  for (size_t i = 0; i < light.size(); ++i) light[i] += share * kFull * irradiance[i] / full * ratio[i];
}

std::vector<uint8_t> paint(const Image& image, const glm::dvec3& eye_world, const std::vector<float>& light) {
  std::vector<uint8_t> rgb;
  const auto primitive = image.plane("primitive_id");
  const auto vector_at = [&](const std::string& name, size_t i) {
    return glm::dvec3(image.plane(name + ".x")[i], image.plane(name + ".y")[i], image.plane(name + ".z")[i]);
  };
  for (size_t i = 0; i < light.size(); ++i) {
    if (primitive[i] < 0.0f) {
      rgb.insert(rgb.end(), kSky.begin(), kSky.end());
      continue;
    }
    const glm::dvec3 to_eye = glm::normalize(eye_world - vector_at("position", i));
    const auto facing = static_cast<float>(std::max(0.0, glm::dot(to_eye, vector_at("shading_normal", i))));
    rgb.insert(rgb.end(), 3, srgb(light[i] + kFaint * facing));
  }
  return rgb;
}

}  // namespace

int show_scene(const std::string& name, const GlobalOptions& global) {
  const std::vector<SceneJob> jobs = load_scene_jobs(name, scene_search(global, find_home()));
  const StagedFile file(global.out.empty() ? "scene.png" : global.out, ".png");
  for (const std::string& warning : jobs.front().scene.warnings) print_warning(warning);
  const PictureQuality picture{
      .width_px = kPreviewWidth_px, .height_px = kHeight_px, .samples_per_pixel = kPreviewSamples};
  const auto renderer = open_reference_renderer(global, picture);
  ProgressBar progress;
  std::vector<float> light(size_t{kPreviewWidth_px} * kHeight_px, 0.0f);
  Image image;
  for (const SceneJob& job : jobs) {
    image = renderer->render(job.scene, request_of(picture), progress).image;
    add_light(image, 1.0f / static_cast<float>(jobs.size()), light);
  }
  const std::vector<uint8_t> rgb = paint(image, jobs.front().scene.camera.eye_world, light);
  write_png(file.staged(), kPreviewWidth_px, kHeight_px, rgb);
  file.publish();
  if (global.json) {
    print_json({{"file", file.target().string()}, {"scene", name}, {"lights", jobs.size()}});
  } else {
    print_answer(fmt::format("{}: {} under {} light{}\n", file.target().string(), name, jobs.size(),
                             jobs.size() == 1 ? "" : "s"));
  }
  return kExitFine;
}

}  // namespace umbrameter
