// SPDX-License-Identifier: Apache-2.0
#include "metrics/causes/substitutions.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

using enum RunPart;

constexpr std::array<Substitution, 13> kSubstitutions = {{
    {"bias_zero", bias, 0.0, "bias 0", "the bias is too large", 1.0},
    {"bias_tenth", bias, 0.1, "a tenth of the bias", "the bias is too large", 1.0},
    {"bias_tenfold", bias, 10.0, "ten times the bias", "the bias is too small", 1.0},
    {"filter_quarter", filter_size, 0.25, "a filter a quarter as wide", "the filter is too wide", 1.0},
    {"filter_half", filter_size, 0.5, "a filter half as wide", "the filter is too wide", 1.0},
    {"filter_double", filter_size, 2.0, "a filter twice as wide", "the filter is too narrow", 2.0},
    {"filter_fourfold", filter_size, 4.0, "a filter four times as wide", "the filter is too narrow", 4.0},
    {"taps_fourfold", taps, 4.0, "a fourfold number of taps", "the taps are too few", 4.0},
    {"map_fourfold", map_size, 4.0, "a map four times as large", "the map's texels are too coarse", 8.0},
    {"map_sixteenfold", map_size, 16.0, "a map sixteen times as large", "the map's texels are too coarse",
     8.0},
    {"fit_scene", map_fit, 1.0, "a map of the whole scene", "the map's fit leaves casters or receivers out",
     2.0},
    {"blocker_truth", blocker_distance, 1.0, "the truth's blocker distance",
     "the search does not find the blockers' true distance", 1.0},
    {"light_points", light_points, 1.0, "a mean over maps from 16 points of the light",
     "what holds for the light's centre does not hold for its other points", 16.0, true},
}};

}  // namespace

std::string_view name_of(RunPart part) {
  constexpr std::array<std::string_view, 7> kNames = {
      "bias",           "map size",      "number of taps", "fit of the map", "width of the filter",
      "light's points", "blocker search"};
  return kNames[static_cast<size_t>(part)];
}

std::span<const Substitution> substitutions() {
  return kSubstitutions;
}

const Substitution* find_substitution(std::string_view id) {
  const auto found = std::ranges::find(kSubstitutions, id, &Substitution::id);
  return found == kSubstitutions.end() ? nullptr : &*found;
}

}  // namespace umbrameter
