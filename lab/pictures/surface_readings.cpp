// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/surface_readings.h"

#include "core/error.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

constexpr double kSamePlace = 1e-3;    // of the distance to the origin of rays, as parity has it
constexpr double kFits = 0.95;         // of the samples: this reading is what was meant
constexpr double kDoesNotFit = 0.5;    // of the samples: that one is not
constexpr size_t kMostSamples = 2000;  // that readings are compared on
constexpr std::array kLengthUnits = {1.0, 0.01, 0.001, 100.0, 1000.0, 0.0254, 0.3048, 0.1, 10.0};

/// What `unit` is called when ours are metres.
std::string unit_name(double unit) {
  if (unit == 0.01) return "centimetres";
  if (unit == 0.001) return "millimetres";
  if (unit == 1000.0) return "kilometres";
  if (unit == 0.0254) return "inches";
  if (unit == 0.3048) return "feet";
  return fmt::format("units of {:g}", unit);
}

/// Pixels where both have a surface, spread over the picture.
std::vector<size_t> samples_of(const EngineSurfaces& surfaces, const Image& reference) {
  std::vector<size_t> all;
  const auto primitive = reference.plane("primitive_id");
  for (size_t i = 0; i < primitive.size(); ++i) {
    if (primitive[i] >= 0.0f && (surfaces.has_data.empty() || surfaces.has_data[i] != 0)) all.push_back(i);
  }
  const size_t step = std::max<size_t>(1, all.size() / kMostSamples);
  std::vector<size_t> chosen;
  for (size_t k = 0; k < all.size(); k += step) chosen.push_back(all[k]);
  return chosen;
}

struct Sample {
  glm::dvec3 theirs, ours;
};

std::vector<Sample> position_samples(const EngineSurfaces& surfaces, const Image& reference) {
  std::vector<Sample> samples;
  const auto at = [](const Image& image, size_t i) {
    return glm::dvec3(image.plane("position.x")[i], image.plane("position.y")[i],
                      image.plane("position.z")[i]);
  };
  for (const size_t i : samples_of(surfaces, reference))
    samples.push_back({at(surfaces.channels, i), at(reference, i)});
  return samples;
}

glm::dvec3 apply(const SurfaceSpace& space, const glm::dvec3& p) {
  glm::dvec3 out(0.0);
  for (int k = 0; k < 3; ++k) {
    const auto index = static_cast<size_t>(k);
    out[k] = space.unit * space.sign[index] * p[space.axis[index]];
  }
  return out;
}

double share_that_fits(const std::vector<Sample>& samples, const SurfaceSpace& space, double tolerance) {
  if (samples.empty()) return 0.0;
  const auto fits = [&](const Sample& sample) {
    return glm::distance(apply(space, sample.theirs), sample.ours) <= tolerance;
  };
  return static_cast<double>(std::ranges::count_if(samples, fits)) / static_cast<double>(samples.size());
}

/// Of all places, so that the tolerance knows no unit.
double extent_of(const std::vector<Sample>& samples) {
  glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const Sample& sample : samples) low = glm::min(low, sample.ours), high = glm::max(high, sample.ours);
  return samples.empty() ? 0.0 : glm::length(high - low);
}

std::vector<SurfaceSpace> all_spaces() {
  std::vector<SurfaceSpace> all;
  std::array<int, 3> axis = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      for (const double unit : kLengthUnits)
        all.push_back({axis, {signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1}, unit});
    }
  } while (std::ranges::next_permutation(axis).found);
  return all;
}

std::optional<SurfaceSpace> better_space(const std::vector<Sample>& samples, const SurfaceSpace& as_read) {
  const double tolerance = kSamePlace * extent_of(samples);
  if (share_that_fits(samples, as_read, tolerance) >= kDoesNotFit) return std::nullopt;
  std::optional<SurfaceSpace> best;
  double best_share = kFits;
  for (const SurfaceSpace& space : all_spaces()) {
    const double share = share_that_fits(samples, space, tolerance);
    if (share < best_share || (best && share == best_share)) continue;
    best = space;
    best_share = share;
  }
  return best;
}

std::string space_note(const SurfaceSpace& space) {
  const SurfaceSpace z_up = {{0, 2, 1}, {1, 1, -1}, 1.0};
  const SurfaceSpace turned = {space.axis, space.sign, 1.0};
  std::vector<std::string> how, options;
  if (turned != SurfaceSpace{}) {
    how.push_back(turned == z_up ? "z up" : fmt::format("other axes ({})", to_text(space)));
    options.push_back("--axes=" + to_text(space));
  }
  if (space.unit != 1.0) {
    how.push_back(unit_name(space.unit));
    options.push_back(fmt::format("--unit {:g}", space.unit));
  }
  return fmt::format("the positions fit the truth far better when they are read as {}: give {}",
                     how.size() == 2 ? how[0] + ", in " + how[1] : how.front(),
                     options.size() == 2 ? options[0] + " " + options[1] : options.front());
}

bool is_constant(const Image& image, const char* channel, const std::vector<size_t>& samples) {
  const auto plane = image.plane(channel);
  return std::ranges::all_of(samples, [&](size_t i) { return plane[i] == plane[samples.front()]; });
}

std::string constant_note(const char* name, const std::string& value) {
  return fmt::format("{} is {} in every pixel that shows a surface: was that pass rendered at all?", name,
                     value);
}

std::optional<std::string> better_depth(const EngineSurfaces& surfaces, const SurfaceReading& reading,
                                        const Image& reference) {
  if (reading.camera == nullptr) return std::nullopt;
  const auto depth = surfaces.channels.plane("depth");
  const std::vector<size_t> samples = samples_of(surfaces, reference);
  const auto share = [&](DepthKind kind, double unit) {
    const auto fits = [&](size_t i) {
      const glm::dvec3 p_world(reference.plane("position.x")[i], reference.plane("position.y")[i],
                               reference.plane("position.z")[i]);
      const double ours = depth_of(p_world, *reading.camera, kind);
      return std::abs(unit * static_cast<double>(depth[i]) - ours) <= kSamePlace * ours;
    };
    return samples.empty() ? 1.0
                           : static_cast<double>(std::ranges::count_if(samples, fits)) /
                                 static_cast<double>(samples.size());
  };
  if (share(reading.depth, reading.space.unit) >= kDoesNotFit) return std::nullopt;
  for (const DepthKind kind :
       {reading.depth, reading.depth == DepthKind::axis ? DepthKind::ray : DepthKind::axis}) {
    for (const double unit : kLengthUnits) {
      if (share(kind, unit) < kFits) continue;
      std::string options = fmt::format("--depth {}", kind == DepthKind::axis ? "axis" : "ray");
      if (unit != 1.0) options += fmt::format(" --unit {:g}", unit);
      return fmt::format("the depths fit the truth far better when they are read along the {}{}: give {}",
                         kind == DepthKind::axis ? "camera's axis" : "rays",
                         unit == 1.0 ? "" : ", in " + unit_name(unit), options);
    }
  }
  if (samples.size() > 1 && is_constant(surfaces.channels, "depth", samples))
    return constant_note("depth", fmt::format("{:g}", depth[samples.front()]));
  return std::nullopt;
}

/// Three channels that have one value wherever the truth, which has more, shows a surface.
void note_constant(const EngineSurfaces& surfaces, const Image& reference, const char* name,
                   std::vector<std::string>& notes) {
  const std::vector<size_t> samples = samples_of(surfaces, reference);
  std::string value;
  bool is_constant_in_truth = true;
  for (const char* axis : {".x", ".y", ".z"}) {
    const std::string channel = std::string(name) + axis;
    if (samples.size() < 2 || !surfaces.channels.has(channel)) return;
    if (!is_constant(surfaces.channels, channel.c_str(), samples)) return;
    is_constant_in_truth = is_constant_in_truth && is_constant(reference, channel.c_str(), samples);
    value +=
        fmt::format("{}{:g}", value.empty() ? "" : ", ", surfaces.channels.plane(channel)[samples.front()]);
  }
  if (!is_constant_in_truth) notes.push_back(constant_note(name, "(" + value + ")"));
}

}  // namespace

double depth_of(const glm::dvec3& p_world, const Camera& camera, DepthKind kind) {
  const glm::dvec3 from_eye = p_world - camera.eye_world;
  if (kind == DepthKind::ray) return glm::length(from_eye);
  return glm::dot(from_eye, glm::normalize(camera.at_world - camera.eye_world));
}

std::vector<glm::dvec3> positions_from_depth(const Image& surfaces, const Camera& camera, DepthKind kind,
                                             double unit) {
  const std::span<const float> depth = surfaces.plane("depth");
  const glm::dvec3 forward = glm::normalize(camera.at_world - camera.eye_world);
  const auto width = static_cast<size_t>(surfaces.width);
  std::vector<glm::dvec3> places(depth.size());
  for (size_t i = 0; i < depth.size(); ++i) {
    const double z = unit * static_cast<double>(depth[i]);
    const glm::dvec2 p_px = {static_cast<double>(i % width) + 0.5, static_cast<double>(i / width) + 0.5};
    const glm::dvec3 d_world = camera_ray_direction_world(camera, p_px, surfaces.width, surfaces.height);
    places[i] = camera.eye_world + (kind == DepthKind::ray ? z : z / glm::dot(d_world, forward)) * d_world;
  }
  return places;
}

SurfaceSpace parse_surface_space(std::string_view axes, double unit) {
  SurfaceSpace space;
  space.unit = unit;
  if (axes.empty()) return space;
  const auto fail = [&] {
    fail_input(fmt::format("'{}' are not three axes", axes), {}, "such as x,z,-y for a space with z up");
  };
  size_t k = 0;
  std::array<bool, 3> is_used{};
  for (size_t i = 0; i < axes.size(); ++k) {
    if (k > 2) fail();
    space.sign[k] = axes[i] == '-' ? -1 : 1;
    if (axes[i] == '-' || axes[i] == '+') ++i;
    const size_t axis = i < axes.size() ? std::string_view("xyz").find(axes[i]) : std::string_view::npos;
    if (axis == std::string_view::npos || is_used[axis]) fail();
    is_used[axis] = true;
    space.axis[k] = static_cast<int>(axis);
    ++i;
    if (i < axes.size() && axes[i] != ',') fail();
    ++i;
  }
  if (k != 3) fail();
  return space;
}

std::string to_text(const SurfaceSpace& space) {
  std::string text;
  for (size_t k = 0; k < 3; ++k) {
    text += fmt::format("{}{}{}", k == 0 ? "" : ",", space.sign[k] < 0 ? "-" : "",
                        "xyz"[static_cast<size_t>(space.axis[k])]);
  }
  return text;
}

std::vector<std::string> better_readings(const EngineSurfaces& surfaces, const SurfaceReading& reading,
                                         const Image& reference) {
  const Image& image = surfaces.channels;
  std::vector<std::string> notes;
  const bool has_position = image.has("position.x") && image.has("position.y") && image.has("position.z");
  note_constant(surfaces, reference, "position", notes);
  note_constant(surfaces, reference, "normal", notes);
  if (has_position) {
    if (const auto space = better_space(position_samples(surfaces, reference), reading.space))
      notes.push_back(space_note(*space));
  } else if (image.has("depth")) {
    if (const auto note = better_depth(surfaces, reading, reference)) notes.push_back(*note);
  }
  return notes;
}

}  // namespace umbrameter
