// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "metrics/image/shadow_quantity.h"
#include "metrics/penumbra/penumbra.h"
#include "metrics/penumbra/penumbra_walk.h"
#include "python/bindings.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <ranges>

namespace umbrameter::python {
namespace {

using Mask = py::array_t<uint8_t, py::array::c_style | py::array::forcecast>;

/// A PenumbraProfile as numpy keeps it.
struct ProfileRow {
  int32_t x, y;
  uint8_t outcome;
  bool is_partial;
  double reference_width_px, reference_width_world, test_width_world, width_octaves, offset_world;
};

ProfileRow row_of(const PenumbraProfile& profile) {
  return {profile.x,
          profile.y,
          static_cast<uint8_t>(profile.outcome),
          profile.is_partial,
          profile.reference_width_px,
          profile.reference_width_world,
          profile.test_width_world,
          profile.width_octaves,
          profile.offset_world};
}

/// The truth itself, or a copy with the irradiance ratio in visibility's place.
const Image& truth_of(const Image& truth, const std::string& quantity, std::optional<Image>& copy) {
  const ShadowQuantity wanted = parse_shadow_quantity(quantity);
  if (wanted == ShadowQuantity::visibility) return truth;
  copy = with_quantity(truth, wanted);
  return *copy;
}

std::span<const uint8_t> mask_of(const Mask& scored, const Image& truth) {
  const auto pixels = static_cast<size_t>(scored.size());
  if (pixels != truth.pixel_count())
    fail_input(fmt::format("{} pixels are scored, the truth has {}", pixels, truth.pixel_count()));
  return {scored.data(), pixels};
}

py::array profile_rows(const Image& picture, const Image& truth, const Mask& scored,
                       const std::string& quantity) {
  const std::span<const uint8_t> mask = mask_of(scored, truth);
  std::vector<ProfileRow> rows;
  {
    const py::gil_scoped_release unlocked;
    std::optional<Image> copy;
    for (const auto& profile : measure_penumbra(picture, truth_of(truth, quantity, copy), mask).profiles)
      rows.push_back(row_of(profile));
  }
  return py::array_t<ProfileRow>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

/// From dark to light; empty where no penumbra passes.
std::vector<WalkSample> samples_across(const Image& picture, const Image& truth,
                                       std::span<const uint8_t> mask, size_t seed) {
  const ReferenceField field{checked_surface(truth), truth.plane("visibility"), truth.plane("visibility_se"),
                             mask};
  const auto ascent = field.usable(seed) ? fit_ascent(field, seed) : std::nullopt;
  if (!ascent) return {};
  const auto side = [&](bool towards_light) {
    return walk_profile(field, picture.plane("visibility"), seed, *ascent, towards_light,
                        PenumbraSettings{}.max_length_px)
        .samples;
  };
  std::vector<WalkSample> samples = side(false);
  std::ranges::reverse(samples);
  samples.push_back({seed, 0.0});
  std::ranges::copy(side(true), std::back_inserter(samples));
  return samples;
}

/// Rows and columns of the pixels, int32 [n][2], and distances in world units, float64 [n], 0 at (x, y).
py::tuple walk_across(const Image& picture, const Image& truth, const Mask& scored,
                      const std::string& quantity, int x, int y) {
  if (x < 0 || y < 0 || x >= truth.width || y >= truth.height)
    fail_input(
        fmt::format("pixel ({}, {}) is not in a picture of {} x {} px", x, y, truth.width, truth.height));
  const size_t width = static_cast<size_t>(truth.width);
  std::optional<Image> copy;
  const auto samples = samples_across(picture, truth_of(truth, quantity, copy), mask_of(scored, truth),
                                      static_cast<size_t>(y) * width + static_cast<size_t>(x));
  if (samples.empty()) fail_input(fmt::format("no penumbra passes through pixel ({}, {})", x, y));
  py::array_t<int32_t> pixels({samples.size(), size_t{2}});
  py::array_t<double> distances(static_cast<py::ssize_t>(samples.size()));
  auto pixel = pixels.mutable_unchecked<2>();
  auto distance = distances.mutable_unchecked<1>();
  for (py::ssize_t i = 0; i < distance.shape(0); ++i) {
    const WalkSample& sample = samples[static_cast<size_t>(i)];
    pixel(i, 0) = static_cast<int32_t>(sample.pixel / width);
    pixel(i, 1) = static_cast<int32_t>(sample.pixel % width);
    distance(i) = sample.s_world;
  }
  return py::make_tuple(pixels, distances);
}

}  // namespace

void add_profiles(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ProfileRow, x, y, outcome, is_partial, reference_width_px, reference_width_world,
                       test_width_world, width_octaves, offset_world);
  std::vector<std::string> outcomes;
  for (size_t i = 0; i < kProfileOutcomes; ++i)
    outcomes.emplace_back(name_of(static_cast<ProfileOutcome>(i)));
  module.attr("profile_outcomes") = py::tuple(py::cast(outcomes));
  module.def("profiles", &profile_rows, py::arg("picture"), py::arg("truth"), py::arg("scored"),
             py::arg("quantity"));
  module.def("walk", &walk_across, py::arg("picture"), py::arg("truth"), py::arg("scored"),
             py::arg("quantity"), py::arg("x"), py::arg("y"));
}

}  // namespace umbrameter::python
