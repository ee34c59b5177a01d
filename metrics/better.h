// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which way a metric is better.

#include <cstdint>
#include <string_view>

namespace umbrameter {

enum class Better : uint8_t { lower, higher, nearest_zero, nearest_one };

/// "lower", "nearest_zero": the enumerator's own word.
std::string_view name_of(Better better);

/// Lower is better: the value itself, or how far it is from 0 or 1. Of what is better when higher: the value with the
/// other sign, which has no ratio to a baseline's.
double badness(Better better, double value);

}  // namespace umbrameter
