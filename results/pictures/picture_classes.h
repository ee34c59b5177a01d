// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the class pictures say, read back: the inverse of results/pictures/pictures.h.

#include "metrics/faults/faults.h"
#include "metrics/image/parity.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace umbrameter {

/// Classes [height][width] of a PNG of fault_picture or parity_picture. Error{input} naming file and pixel for a
/// colour that no class has.
std::vector<FaultClass> read_fault_picture(const std::filesystem::path& file);
std::vector<ParityClass> read_parity_picture(const std::filesystem::path& file);

/// 1 where a PNG of signed_error_picture shows an error, 0 where the pixel is not scored.
std::vector<uint8_t> read_scored_pixels(const std::filesystem::path& file);

}  // namespace umbrameter
