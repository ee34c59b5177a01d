// SPDX-License-Identifier: Apache-2.0
#include "results/pictures/picture_classes.h"

#include "core/error.h"
#include "core/image_io.h"
#include "results/pictures/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

std::vector<Rgb8> read_colours(const std::filesystem::path& file) {
  const Image image = read_image(file);
  const std::array planes{image.plane("R"), image.plane("G"), image.plane("B")};
  std::vector<Rgb8> colours(image.pixel_count());
  for (size_t i = 0; i < colours.size(); ++i) {
    for (size_t k = 0; k < planes.size(); ++k) {
      colours[i][k] = static_cast<uint8_t>(std::lround(255.0f * planes[k][i]));
    }
  }
  return colours;
}

template <class Class, class Legend>
std::vector<Class> classes_of(const std::filesystem::path& file, Class Legend::*member,
                              std::span<const Legend> legend) {
  std::vector<Class> classes;
  for (const Rgb8& colour : read_colours(file)) {
    const auto found = std::ranges::find(legend, colour, &Legend::colour);
    if (found == legend.end()) {
      fail_input(fmt::format("pixel {} has the colour ({}, {}, {}) of no class", classes.size(), colour[0],
                             colour[1], colour[2]),
                 {file.string()}, "the picture is not the one that validate wrote");
    }
    classes.push_back((*found).*member);
  }
  return classes;
}

}  // namespace

std::vector<FaultClass> read_fault_picture(const std::filesystem::path& file) {
  return classes_of(file, &FaultLegend::fault, fault_legend());
}

std::vector<ParityClass> read_parity_picture(const std::filesystem::path& file) {
  return classes_of(file, &ParityLegend::parity_class, parity_legend());
}

std::vector<uint8_t> read_scored_pixels(const std::filesystem::path& file) {
  const std::vector<Rgb8> colours = read_colours(file);
  std::vector<uint8_t> scored(colours.size());
  std::ranges::transform(colours, scored.begin(),
                         [](const Rgb8& colour) -> uint8_t { return colour != kUnscoredColour; });
  return scored;
}

}  // namespace umbrameter
