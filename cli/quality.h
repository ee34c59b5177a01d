#pragma once
// Resolution and samples: --quality and what overrides it.

#include "core/error.h"
#include "core/renderer.h"

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
  int width_px = 0;
  int height_px = 0;
  int samples_per_pixel = 0;
  std::optional<double> target_se;
  int timed_frames = 0;
  uint64_t seed = 1;
};

void add_quality_options(CLI::App& verb, QualityOptions& options);

/// Error{input} for an unknown quality and for numbers out of range.
Quality choose_quality(const QualityOptions& options);

/// Size and seed, no technique.
RenderRequest request_of(const Quality& quality);

}  // namespace umbrameter
