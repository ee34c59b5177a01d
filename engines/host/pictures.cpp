// SPDX-License-Identifier: Apache-2.0
#include "engines/host/pictures.h"

#include "core/error.h"
#include "core/image_io.h"
#include "engines/host/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr std::array kAxes = {"x", "y", "z"};
/// Of the brightest: less light without shadows than that makes no ratio.
constexpr float kDark = 1e-4f;
/// A ratio may exceed 1 by so much through rounding.
constexpr float kRounding = 1e-3f;

Image read_checked(const fs::path& file, int width_px, int height_px) {
  if (!is_picture_path(file.string()))
    fail_environment(
        fmt::format("'{}' has no floats: pictures of engines are EXR, HDR or PFM", file.filename().string()));
  Image image;
  try {
    image = read_image(file);
  } catch (const Error& error) {  // what the engine wrote is not the user's mistake
    fail_environment(error.what());
  }
  if (image.width != width_px || image.height != height_px)
    fail_environment(fmt::format("'{}' has {} x {} px, and {} x {} px were asked for",
                                 file.filename().string(), image.width, image.height, width_px, height_px));
  return image;
}

/// The planes of three axes: "position.x" and so on, or R, G and B.
std::array<std::span<const float>, 3> vectors_of(const Image& image, const std::string& what,
                                                 const fs::path& file) {
  constexpr std::array kColours = {"R", "G", "B"};
  std::array<std::span<const float>, 3> planes;
  for (size_t axis = 0; axis < 3; ++axis) {
    const std::string name = what + "." + kAxes[axis];
    if (!image.has(name) && !image.has(kColours[axis]))
      fail_environment(
          fmt::format("'{}' has neither {} nor {}", file.filename().string(), name, kColours[axis]));
    planes[axis] = image.plane(image.has(name) ? name : kColours[axis]);
  }
  return planes;
}

/// One plane, or the mean of R, G and B: lights are white, and surfaces grey.
std::vector<float> light_of(const Image& image, const fs::path& file) {
  std::vector<float> light(image.pixel_count());
  const std::string only = image.has("visibility") ? "visibility"
                           : image.has("Y")        ? "Y"
                                                   : image.planes.begin()->first;
  const bool is_coloured = image.has("R") && image.has("G") && image.has("B");
  for (size_t i = 0; i < light.size(); ++i) {
    light[i] = is_coloured ? (image.plane("R")[i] + image.plane("G")[i] + image.plane("B")[i]) / 3.0f
                           : image.plane(only)[i];
  }
  const auto bad = std::ranges::find_if(light, [](float value) { return !std::isfinite(value); });
  if (bad != light.end()) {
    const auto at = static_cast<int>(bad - light.begin());
    fail_environment(fmt::format("'{}' is {} at pixel ({}, {})", file.filename().string(), *bad,
                                 at % image.width, at / image.width));
  }
  return light;
}

size_t add_ratio(const std::vector<float>& lit, const std::vector<float>& unlit, Image& image) {
  const float dark = kDark * *std::ranges::max_element(unlit);
  const std::span<float> visibility = image.add_plane("visibility");
  const std::span<float> known = image.add_plane("known", 1.0f);
  size_t unknown = 0;
  for (size_t i = 0; i < lit.size(); ++i) {
    const float ratio = unlit[i] > dark ? lit[i] / unlit[i] : -1.0f;
    if (ratio < -kRounding || ratio > 1.0f + kRounding) {
      known[i] = 0.0f;
      ++unknown;
    } else {
      visibility[i] = std::clamp(ratio, 0.0f, 1.0f);
    }
  }
  return unknown;
}

void add_visibility(const Image& picture, const fs::path& file, Image& image) {
  const std::vector<float> light = light_of(picture, file);
  const std::span<float> visibility = image.add_plane("visibility");
  const std::span<float> known = image.add_plane("known", 1.0f);
  for (size_t i = 0; i < light.size(); ++i) {
    known[i] = light[i] < -kRounding || light[i] > 1.0f + kRounding ? 0.0f : 1.0f;
    visibility[i] = std::clamp(light[i], 0.0f, 1.0f);
  }
}

void add_vectors(const Image& picture, const std::string& what, const fs::path& file, Image& image) {
  const auto planes = vectors_of(picture, what, file);
  for (size_t axis = 0; axis < 3; ++axis)
    std::ranges::copy(planes[axis], image.add_plane(what + "." + kAxes[axis]).begin());
}

void add_primitives(Image& image) {
  const std::span<float> primitive = image.add_plane("primitive_id", kUnknownPrimitive);
  for (size_t i = 0; i < primitive.size(); ++i) {
    for (const char* axis : kAxes) {
      if (!std::isfinite(image.plane(std::string("position.") + axis)[i])) primitive[i] = -1.0f;
    }
    if (primitive[i] >= 0.0f) continue;
    for (const std::string what : {"position.", "normal."}) {
      for (const char* axis : kAxes) {
        if (image.has(what + axis)) image.plane(what + axis)[i] = 0.0f;
      }
    }
  }
}

}  // namespace

Image read_engine_picture(const EngineFiles& files, int width_px, int height_px) {
  Image image(width_px, height_px);
  const auto read = [&](const char* what) { return read_checked(files.at(what), width_px, height_px); };
  if (files.contains("visibility")) {
    add_visibility(read("visibility"), files.at("visibility"), image);
  } else if (files.contains("lit") && files.contains("unlit")) {
    const std::vector<float> lit = light_of(read("lit"), files.at("lit"));
    const std::vector<float> unlit = light_of(read("unlit"), files.at("unlit"));
    if (std::ranges::none_of(unlit, [](float value) { return value > 0.0f; }))
      fail_environment(
          "the picture without shadows is black: the engine's light does not reach what is seen");
    add_ratio(lit, unlit, image);
  } else {
    fail_environment("there is neither a picture of visibility nor the pair lit and unlit");
  }
  for (const char* what : {"position", "normal"}) {
    if (files.contains(what)) add_vectors(read(what), what, files.at(what), image);
  }
  if (files.contains("surfaces")) {
    const Image surfaces = read("surfaces");
    for (const std::string what : {"position", "normal"}) {
      if (surfaces.has(what + ".x")) add_vectors(surfaces, what, files.at("surfaces"), image);
    }
  }
  if (image.has("position.x")) add_primitives(image);
  return image;
}

}  // namespace umbrameter
