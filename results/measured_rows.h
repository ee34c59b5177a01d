// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rows of the catalogue that say how they are measured. A file of its own, because stored runs hold its numbers: its text is
// in their keys (cmake/code_hashes.cmake), that of the other rows is not.

#include "results/catalogue.h"

#include <vector>

namespace umbrameter {

/// Rows that are measured from the pictures: {..., .measure = measure_it}.
std::vector<Metric> measured_rows();

}  // namespace umbrameter
