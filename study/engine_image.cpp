// SPDX-License-Identifier: Apache-2.0
#include "study/engine_image.h"

#include "core/error.h"
#include "core/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace umbrameter {
namespace {

constexpr std::array<const char*, 3> kTransfers = {"linear", "srgb", "gamma2.2"};
// Rec. 709; sums to 1.
constexpr double kRed = 0.2126, kGreen = 0.7152, kBlue = 0.0722;
constexpr double kDarkSteps = 16.0;   // of the denominator: below, a ratio of 1 is known to an eighth at best
constexpr double kDarkShare = 1e-4;   // of the brightest pixel, for floats
constexpr double kRatioSlack = 2e-3;  // half floats round by .0005 each

bool is_float_format(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".exr" || extension == ".hdr" || extension == ".pfm";
}

/// 255 when every number is a multiple of 1/255, else 65535.
double levels_of(const Image& image) {
  for (const auto& [name, plane] : image.planes) {
    for (const float v : plane) {
      const double scaled = 255.0 * static_cast<double>(v);
      if (std::abs(scaled - std::round(scaled)) > 1e-3) return 65535.0;
    }
  }
  return 255.0;
}

std::vector<std::pair<std::string, double>> channels_of(const Image& image, const std::string& file) {
  for (const char* name : {"visibility", "Y"}) {
    if (image.has(name)) return {{name, 1.0}};
  }
  if (image.has("R") && image.has("G") && image.has("B")) return {{"R", kRed}, {"G", kGreen}, {"B", kBlue}};
  if (image.planes.size() == 1) return {{image.planes.begin()->first, 1.0}};
  fail_input("the image has neither a visibility channel nor grey nor R, G and B", {file},
             "name the channel 'visibility', or give a grey image");
}

Transfer transfer_for(const std::string& file, std::string_view transfer) {
  if (!is_float_format(file)) {
    if (!transfer.empty()) return parse_transfer(transfer);
    fail_input("the picture does not say how its numbers follow from light", {file},
               "give --transfer srgb, linear or gamma2.2");
  }
  return Transfer::linear;  // floats; of a pair, the other picture may need the transfer that was given
}

void require_size(const EngineImage& a, const EngineImage& b) {
  if (a.width == b.width && a.height == b.height) return;
  fail_input(fmt::format("the shadowed picture is {} x {} px and the unshadowed one {} x {}", a.width,
                         a.height, b.width, b.height),
             {}, "render both with one camera at one size");
}

EngineVisibility empty_for(const EngineImage& image) {
  EngineVisibility out;
  out.image = Image(image.width, image.height);
  out.image.add_plane("visibility", 1.0f);
  out.rounding_sd.assign(image.light.size(), 0.0f);
  out.known.assign(image.light.size(), 0);
  return out;
}

void set(EngineVisibility& out, size_t i, double value, double step) {
  out.known[i] = 1;
  out.image.plane("visibility")[i] = static_cast<float>(std::clamp(value, 0.0, 1.0));
  out.rounding_sd[i] = static_cast<float>(step / std::sqrt(12.0));
  out.largest_step = std::max(out.largest_step, step);
}

void finish(EngineVisibility& out) {
  double sum = 0.0, count = 0.0;
  for (size_t i = 0; i < out.known.size(); ++i) {
    if (out.known[i] == 0) continue;
    sum += static_cast<double>(out.rounding_sd[i]) * static_cast<double>(out.rounding_sd[i]);
    count += 1.0;
  }
  if (count > 0.0) out.mean_square_rounding = sum / count;
}

}  // namespace

Transfer parse_transfer(std::string_view text) {
  const auto found = std::ranges::find(kTransfers, text);
  if (found != kTransfers.end()) return static_cast<Transfer>(found - kTransfers.begin());
  const std::vector<std::string> known(kTransfers.begin(), kTransfers.end());
  fail_input(fmt::format("unknown transfer '{}'", text), {}, suggest_name(std::string(text), known));
}

double light_of(double stored, Transfer transfer) {
  if (transfer == Transfer::linear) return stored;
  if (transfer == Transfer::gamma22) return std::pow(std::max(0.0, stored), 2.2);
  return stored <= 0.04045 ? stored / 12.92 : std::pow((stored + 0.055) / 1.055, 2.4);  // IEC 61966-2-1
}

double slope_of_light(double stored, Transfer transfer) {
  if (transfer == Transfer::linear) return 1.0;
  if (transfer == Transfer::gamma22) return 2.2 * std::pow(std::max(0.0, stored), 1.2);
  return stored <= 0.04045 ? 1.0 / 12.92 : 2.4 / 1.055 * std::pow((stored + 0.055) / 1.055, 1.4);
}

EngineImage decode_engine_image(const Image& image, const std::string& file, std::string_view transfer_text) {
  const Transfer transfer = transfer_for(file, transfer_text);
  const double stored_step = is_float_format(file) ? 0.0 : 1.0 / levels_of(image);
  EngineImage out = {image.width, image.height, {}, {}};
  out.light.assign(image.pixel_count(), 0.0f);
  std::vector<double> step(image.pixel_count(), 0.0);
  for (const auto& [name, weight] : channels_of(image, file)) {
    require_finite(image, name);
    const std::span<const float> plane = image.plane(name);
    for (size_t i = 0; i < plane.size(); ++i) {
      out.light[i] += static_cast<float>(weight * light_of(plane[i], transfer));
      // The channels of a grey picture round together: their steps add.
      step[i] += weight * stored_step * slope_of_light(plane[i], transfer);
    }
  }
  out.step.assign(step.begin(), step.end());
  return out;
}

EngineVisibility visibility_of(const EngineImage& visibility) {
  EngineVisibility out = empty_for(visibility);
  for (size_t i = 0; i < visibility.light.size(); ++i) {
    const double v = visibility.light[i];
    if (v > 1.0 + kRatioSlack || v < -kRatioSlack) {
      fail_input(
          fmt::format("visibility is {:.4g} at pixel {}, {}", v, i % static_cast<size_t>(visibility.width),
                      i / static_cast<size_t>(visibility.width)),
          {}, "visibility lies in 0 to 1; for lit pictures give --shadowed and --unshadowed");
    }
    set(out, i, v, visibility.step[i]);
  }
  finish(out);
  return out;
}

EngineVisibility visibility_of_pair(const EngineImage& shadowed, const EngineImage& unshadowed) {
  require_size(shadowed, unshadowed);
  EngineVisibility out = empty_for(shadowed);
  const double brightest = unshadowed.light.empty() ? 0.0 : *std::ranges::max_element(unshadowed.light);
  for (size_t i = 0; i < out.known.size(); ++i) {
    const double s = shadowed.light[i], u = unshadowed.light[i];
    if (u <= kDarkShare * brightest || u < kDarkSteps * static_cast<double>(unshadowed.step[i])) {
      ++out.dark;
      continue;
    }
    const double step =
        (static_cast<double>(shadowed.step[i]) + s / u * static_cast<double>(unshadowed.step[i])) / u;
    if (s / u > 1.0 + step + kRatioSlack || s < 0.0) {
      ++out.brighter;
      continue;
    }
    set(out, i, s / u, step);
  }
  finish(out);
  return out;
}

void apply_rounding(const EngineVisibility& engine, Image& test, Image& reference) {
  require_same_size(test, reference, "score");
  const std::span<float> se = reference.plane("visibility_se");
  const std::span<float> irradiance = reference.plane("unshadowed_irradiance");
  for (size_t i = 0; i < se.size(); ++i) {
    se[i] = std::hypot(se[i], engine.rounding_sd[i]);
    if (engine.known[i] != 0) continue;
    irradiance[i] = 0.0f;
    if (test.has("unshadowed_irradiance")) test.plane("unshadowed_irradiance")[i] = 0.0f;
  }
}

}  // namespace umbrameter
