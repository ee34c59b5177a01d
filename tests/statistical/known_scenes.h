// SPDX-License-Identifier: Apache-2.0
#pragma once
// Nine scenes whose visibility is known at every point of the floor, three of them made to fool a sampler: a wire, a comb of
// slits and a pin-hole.

#include "tests/statistical/oracle_scenes.h"

#include <functional>
#include <string>
#include <vector>

namespace umbrameter {

struct KnownScene {
  std::string name;
  Scene scene;
  std::function<double(const glm::dvec3&)> visibility;
};

std::vector<KnownScene> known_scenes();

}  // namespace umbrameter
