// SPDX-License-Identifier: Apache-2.0
#pragma once
// Resolution and samples: --quality and what overrides it.

#include "core/error.h"
#include "results/picture_quality.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace umbrameter {

struct QualityOptions {
  std::string quality = "standard";
  std::optional<int64_t> width;
  std::optional<int64_t> height;
  std::optional<int64_t> samples_per_pixel;
  std::optional<double> target_se;
  uint64_t seed = 1;
  FileLocation where;  // of the file that gave them; empty for the command line
};

/// The chosen numbers, checked.
struct Quality {
  std::string name;
  PictureQuality picture;
  int timed_frames = 0;
};

void add_quality_options(CLI::App& verb, QualityOptions& options);

/// Error{input} for an unknown quality and for numbers out of range.
Quality choose_quality(const QualityOptions& options);

}  // namespace umbrameter
