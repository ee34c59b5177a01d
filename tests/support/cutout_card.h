// SPDX-License-Identifier: Apache-2.0
#pragma once
// Horizontal cards with a repeating pattern of holes, for tests.

#include "scenes/scene.h"

#include <glm/vec2.hpp>

#include <string_view>

namespace umbrameter {

/// Rows from the top, '#' solid, anything else a hole; all of one length.
AlphaMask pattern_mask(std::initializer_list<std::string_view> rows);

/// Share of the mask that is a hole.
double hole_share(const AlphaMask& mask);

/// A card as add_floor() adds it whose mask repeats every `period_world` along x and z. Nothing solid may be added later.
void add_cutout_card(Scene& scene, const AlphaMask& mask, const glm::dvec2& size, double y,
                     double period_world);

}  // namespace umbrameter
