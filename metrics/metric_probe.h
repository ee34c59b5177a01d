// SPDX-License-Identifier: Apache-2.0
#pragma once
// Known answers that an error metric must give before anybody believes it: operands in order, mask obeyed, squares
// squared, halves multiplied.

#include "core/image.h"
#include "metrics/error/visibility_error.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

using ErrorMetric =
    std::function<VisibilityError(const Image& test, const Image& reference, std::span<const uint8_t> mask)>;

/// The real one.
VisibilityError error_metric(const Image& test, const Image& reference, std::span<const uint8_t> mask);

/// One sentence for every number of `metric` that is not the known one.
std::vector<std::string> metric_problems(const ErrorMetric& metric);

}  // namespace umbrameter
