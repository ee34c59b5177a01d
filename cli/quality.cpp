// SPDX-License-Identifier: Apache-2.0
#include "cli/quality.h"

#include "core/error.h"
#include "core/names.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int64_t kMaxSide_px = 16384;
constexpr int64_t kMaxPixels = 7680 * 4320;  // 8K UHD: all channels of both renderers still fit 8 GiB
constexpr int64_t kMaxSamples = 1 << 20;

struct NamedQuality {
  const char* name;
  int width_px, height_px, samples_per_pixel, timed_frames;
};

constexpr std::array<NamedQuality, 3> kQualities{
    {{"quick", 480, 270, 256, 5}, {"standard", 960, 540, 1024, 9}, {"full", 1920, 1080, 4096, 15}}};

const NamedQuality& find_quality(const std::string& name, const FileLocation& where) {
  std::vector<std::string> known;
  for (const NamedQuality& quality : kQualities) {
    if (name == quality.name) return quality;
    known.emplace_back(quality.name);
  }
  fail_input(fmt::format("unknown quality '{}'", name), where, suggest_name(name, known));
}

int checked(const std::optional<int64_t>& given, int fallback, const char* option, int64_t max) {
  if (!given) return fallback;
  if (*given < 1 || *given > max) fail_input(fmt::format("{} is {}, not in 1 to {}", option, *given, max));
  return static_cast<int>(*given);
}

}  // namespace

void add_quality_options(CLI::App& verb, QualityOptions& options) {
  verb.add_option("--quality", options.quality,
                  "quick (480x270, 256 samples), standard (960x540, 1024) or full (1920x1080, 4096)")
      ->capture_default_str();
  verb.add_option("--width", options.width, "picture width in pixels");
  verb.add_option("--height", options.height, "picture height in pixels");
  verb.add_option("--spp", options.samples_per_pixel,
                  "reference samples per pixel; with --target-se the most");
  verb.add_option("--target-se", options.target_se, "stop sampling at this standard error of visibility");
  verb.add_option("--seed", options.seed, "seed of all sampling")->capture_default_str();
}

Quality choose_quality(const QualityOptions& options) {
  const NamedQuality& named = find_quality(options.quality, options.where);
  Quality quality;
  quality.name = named.name;
  quality.timed_frames = named.timed_frames;
  PictureQuality& picture = quality.picture;
  picture.width_px = checked(options.width, named.width_px, "--width", kMaxSide_px);
  picture.height_px = checked(options.height, named.height_px, "--height", kMaxSide_px);
  const int64_t pixels = int64_t{picture.width_px} * picture.height_px;
  if (pixels > kMaxPixels) {
    fail_input(fmt::format("{} x {} is {} pixels, more than {}", picture.width_px, picture.height_px, pixels,
                           kMaxPixels));
  }
  picture.samples_per_pixel =
      checked(options.samples_per_pixel, named.samples_per_pixel, "--spp", kMaxSamples);
  if (options.target_se && !(*options.target_se > 0.0 && *options.target_se < 1.0)) {
    fail_input(fmt::format("--target-se is {}, not between 0 and 1", *options.target_se));
  }
  picture.target_se = options.target_se;
  picture.seed = options.seed;
  return quality;
}

}  // namespace umbrameter
