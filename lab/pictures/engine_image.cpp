// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/engine_image.h"

#include "core/error.h"
#include "core/names.h"
#include "core/srgb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

constexpr std::array<const char*, 3> kTransfers = {"linear", "srgb", "gamma2.2"};
// Rec. 709; sums to 1.
constexpr std::array kLuminance = {0.2126, 0.7152, 0.0722};
constexpr double kDarkSteps = 16.0;  // of the denominator: below, a ratio of 1 is known to an eighth at best
constexpr double kDarkShare = 1e-4;  // of the brightest pixel, for floats
constexpr double kGreySpread = 0.02;
constexpr double kColouredShare = 0.01;  // of the scorable pixels; more is a colour picture
constexpr double kSwappedShare =
    0.002;                             // of the scorable pixels, at least that many are brighter with shadows
constexpr double kSwappedRatio = 4.0;  // and that many times as many as darker ones
constexpr double kSwappedShadow = 0.1;  // and so much less of the light is seen there than elsewhere
constexpr std::array<const char*, 5> kBeside = {"texel.x", "texel.y", "texel_world", "bias_world",
                                                "map_index"};

/// 255 when every number is a multiple of 1/255, as in files of 16 bits made from 8.
double step_of(const ImagePart& part, const std::vector<std::string>& channels) {
  if (part.levels == 0) return 0.0;
  for (const std::string& name : channels) {
    for (const float v : part.image.plane(name)) {
      const double scaled = 255.0 * static_cast<double>(v);
      if (std::abs(scaled - std::round(scaled)) > 1e-3) return 1.0 / part.levels;
    }
  }
  return 1.0 / std::min(part.levels, 255);
}

Transfer transfer_for(const ImagePart& part, const std::string& file, std::string_view transfer) {
  // Of a pair, the other picture may need the transfer that was given.
  if (part.levels == 0) return Transfer::linear;
  if (!transfer.empty()) return parse_transfer(transfer);
  fail_input("the picture does not say how its numbers follow from light", {file},
             "give --transfer srgb, linear or gamma2.2");
}

void take_beside(const PictureChannels& picture, Image& beside) {
  const Image& image = picture.part.image;
  const auto copy = [&](const char* from, const char* to) {
    if (image.has(from)) beside.planes[to].assign(image.plane(from).begin(), image.plane(from).end());
  };
  for (const char* name : kBeside) copy(name, name);
  if (picture.channels.front() == "visibility") copy("visibility_se", "visibility_se");
  if (picture.channels.front() == "irradiance_ratio") copy("irradiance_ratio_se", "visibility_se");
}

void require_size(const EngineImage& a, const EngineImage& b) {
  if (a.width == b.width && a.height == b.height) return;
  fail_input(fmt::format("the shadowed picture is {} x {} px and the unshadowed one {} x {}", a.width,
                         a.height, b.width, b.height),
             {}, "render both with one camera at one size");
}

std::string place(const EngineImage& image, size_t i) {
  return fmt::format("{}, {}", i % static_cast<size_t>(image.width), i / static_cast<size_t>(image.width));
}

void require_number(const EngineImage& image, size_t i) {
  if (std::isfinite(image.light[i])) return;
  fail_input(fmt::format("the picture is {} at pixel {}, where the truth has a surface", image.light[i],
                         place(image, i)));
}

EngineVisibility empty_for(const EngineImage& image) {
  EngineVisibility out;
  out.image = image.beside;
  out.image.width = image.width;
  out.image.height = image.height;
  out.image.planes.erase("visibility");
  out.image.add_plane("visibility", 1.0f);
  out.rounding_sd.assign(image.light.size(), 0.0f);
  out.known.assign(image.light.size(), 0);
  return out;
}

void set(EngineVisibility& out, size_t i, double value, double step) {
  const double inside = std::clamp(value, 0.0, 1.0);
  if (value != inside) {
    ++out.nudged;
    out.largest_nudge = std::max(out.largest_nudge, std::abs(value - inside));
  }
  out.known[i] = 1;
  out.image.plane("visibility")[i] = static_cast<float>(inside);
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

void require_grey(const EngineImage& image, std::span<const uint8_t> scorable) {
  size_t coloured = 0, pixels = 0, first = 0;
  for (size_t i = 0; i < scorable.size(); ++i) {
    if (scorable[i] == 0 || image.has_data[i] == 0) continue;
    ++pixels;
    if (!(image.spread[i] > kGreySpread)) continue;
    if (++coloured == 1) first = i;
  }
  if (static_cast<double>(coloured) <= kColouredShare * static_cast<double>(pixels)) return;
  fail_input(
      fmt::format("the picture has colour, first at pixel {}; visibility is grey", place(image, first)), {},
      "for lit pictures give --shadowed and --unshadowed");
}

double brightest_of(const EngineImage& image, std::span<const uint8_t> scorable) {
  double brightest = 0.0;
  for (size_t i = 0; i < scorable.size(); ++i) {
    if (scorable[i] != 0 && std::isfinite(image.light[i]))
      brightest = std::max(brightest, static_cast<double>(image.light[i]));
  }
  return brightest;
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
  return linear_of_srgb(stored);
}

double slope_of_light(double stored, Transfer transfer) {
  if (transfer == Transfer::linear) return 1.0;
  if (transfer == Transfer::gamma22) return 2.2 * std::pow(std::max(0.0, stored), 1.2);
  return stored <= 0.04045 ? 1.0 / 12.92 : 2.4 / 1.055 * std::pow((stored + 0.055) / 1.055, 1.4);
}

EngineImage read_engine_image(const std::string& file, std::string_view transfer_text,
                              const PictureChoice& choice) {
  PictureChannels picture = read_picture(file, choice);
  const Image& image = picture.part.image;
  const Transfer transfer = transfer_for(picture.part, file, transfer_text);
  const double stored_step = step_of(picture.part, picture.channels);
  EngineImage out = {image.width, image.height, {}, {}, {}, {}, {}, std::move(picture.notes)};
  std::vector<double> light(image.pixel_count(), 0.0), step(image.pixel_count(), 0.0);
  std::vector<float> least(image.pixel_count(), std::numeric_limits<float>::max());
  std::vector<float> most(image.pixel_count(), std::numeric_limits<float>::lowest());
  for (size_t c = 0; c < picture.channels.size(); ++c) {
    const double weight = picture.channels.size() == 3 ? kLuminance[c] : 1.0;
    const std::span<const float> plane = image.plane(picture.channels[c]);
    for (size_t i = 0; i < plane.size(); ++i) {
      const double value = light_of(plane[i], transfer);
      light[i] += weight * value;
      least[i] = std::min(least[i], static_cast<float>(value));
      most[i] = std::max(most[i], static_cast<float>(value));
      // The channels of a grey picture round together: their steps add.
      step[i] += weight * stored_step * slope_of_light(plane[i], transfer);
    }
  }
  out.light.assign(light.begin(), light.end());
  out.step.assign(step.begin(), step.end());
  out.spread.resize(light.size());
  for (size_t i = 0; i < light.size(); ++i) out.spread[i] = most[i] - least[i];
  take_beside(picture, out.beside);
  out.has_data = std::move(picture.part.has_data);
  return out;
}

EngineVisibility visibility_of(const EngineImage& visibility, std::span<const uint8_t> scorable) {
  EngineVisibility out = empty_for(visibility);
  require_grey(visibility, scorable);
  for (size_t i = 0; i < scorable.size(); ++i) {
    if (scorable[i] == 0) continue;
    if (visibility.has_data[i] == 0) {
      ++out.missing;
      continue;
    }
    require_number(visibility, i);
    const double v = visibility.light[i];
    if (v > 1.0 + kRangeSlack || v < -kRangeSlack) {
      fail_input(
          fmt::format("visibility is {:.4g} at pixel {}", v, place(visibility, i)), {},
          fmt::format("visibility lies in 0 to 1, give or take {}; for lit pictures give --shadowed and "
                      "--unshadowed",
                      kRangeSlack));
    }
    set(out, i, v, visibility.step[i]);
  }
  finish(out);
  return out;
}

EngineVisibility visibility_of_pair(const EngineImage& shadowed, const EngineImage& unshadowed,
                                    std::span<const uint8_t> scorable) {
  require_size(shadowed, unshadowed);
  EngineVisibility out = empty_for(shadowed);
  const double brightest = brightest_of(unshadowed, scorable);
  for (size_t i = 0; i < scorable.size(); ++i) {
    if (scorable[i] == 0) continue;
    if (shadowed.has_data[i] == 0 || unshadowed.has_data[i] == 0) {
      ++out.missing;
      continue;
    }
    require_number(shadowed, i);
    require_number(unshadowed, i);
    const double s = shadowed.light[i], u = unshadowed.light[i];
    if (u <= kDarkShare * brightest || u < kDarkSteps * static_cast<double>(unshadowed.step[i])) {
      ++out.dark;
      continue;
    }
    const double step =
        (static_cast<double>(shadowed.step[i]) + s / u * static_cast<double>(unshadowed.step[i])) / u;
    if (s / u > 1.0 + step + kRangeSlack || s / u < -kRangeSlack) {
      ++out.brighter;
      continue;
    }
    set(out, i, s / u, step);
  }
  finish(out);
  return out;
}

bool is_swapped(const EngineImage& shadowed, const EngineImage& unshadowed, const Image& reference,
                std::span<const uint8_t> scorable) {
  require_size(shadowed, unshadowed);
  const auto truth = reference.plane("visibility");
  double pixels = 0.0, brighter = 0.0, darker = 0.0, seen_there = 0.0, seen = 0.0;
  for (size_t i = 0; i < scorable.size(); ++i) {
    if (scorable[i] == 0 || shadowed.has_data[i] == 0 || unshadowed.has_data[i] == 0) continue;
    const double s = shadowed.light[i], u = unshadowed.light[i];
    const double slack = static_cast<double>(shadowed.step[i]) + static_cast<double>(unshadowed.step[i]);
    pixels += 1.0;
    seen += static_cast<double>(truth[i]);
    if (u > s * (1.0 + kRangeSlack) + slack) darker += 1.0;
    if (!(s > u * (1.0 + kRangeSlack) + slack)) continue;
    brighter += 1.0;
    seen_there += static_cast<double>(truth[i]);
  }
  if (brighter < kSwappedShare * pixels || brighter < kSwappedRatio * darker || brighter == pixels)
    return false;
  const double elsewhere = (seen - seen_there) / (pixels - brighter);
  return seen_there / brighter < elsewhere - kSwappedShadow;
}

void add_rounding(const EngineVisibility& engine, Image& reference) {
  const std::span<float> se = reference.plane("visibility_se");
  for (size_t i = 0; i < se.size(); ++i) se[i] = std::hypot(se[i], engine.rounding_sd[i]);
}

}  // namespace umbrameter
