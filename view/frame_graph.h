// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique's passes and what they hand to each other, laid out as rows with a lane for each texture. No ImGui.

#include "realtime/manifest/technique.h"

#include <string>
#include <vector>

namespace umbrameter {

struct GraphRow {
  std::string id;
  std::string label;  // that its time is summed under
  int depth = 0;      // of loops around it
  bool is_loop = false;
  std::vector<size_t> reads, writes;  // lanes
};

/// From the first row that has to do with a texture to the last.
struct GraphLane {
  std::string resource;  // the G-buffer's parts are one, kGBufferLane
  size_t first_row = 0, last_row = 0;
  size_t column = 0;  // lanes that do not overlap share one
};
inline constexpr const char* kGBufferLane = "gbuffer";

struct FrameGraph {
  std::vector<GraphRow> rows;  // the first is the G-buffer
  std::vector<GraphLane> lanes;
  size_t columns = 0;
};

/// Of all passes, or of those alone that are `drawn` (ids; empty: all).
FrameGraph frame_graph(const std::vector<PassDeclaration>& passes,
                       const std::vector<std::string>& drawn = {});

}  // namespace umbrameter
