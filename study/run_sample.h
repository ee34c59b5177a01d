// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[run.sample]`: a Latin hypercube over several parameters.

#include "core/toml.h"

#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

/// One value a parameter.
using SamplePoint = std::vector<std::pair<std::string, TomlNode>>;

/// Each parameter's range is cut into `count` equal pieces and each piece is met by one point; a seed pairs the pieces of
/// different parameters. Whole numbers, and lists shorter than `count`, can make points equal: those come once.
std::vector<SamplePoint> read_samples(const TomlNode& table);

}  // namespace umbrameter
