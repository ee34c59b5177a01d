// SPDX-License-Identifier: Apache-2.0
#include "view/frame_graph.h"

#include <algorithm>

namespace umbrameter {
namespace {

std::string lane_name(const std::string& resource) {
  return resource.starts_with("gbuffer.") ? kGBufferLane : resource;
}

class Builder {
 public:
  explicit Builder(const std::vector<std::string>& drawn) : drawn_(drawn) {
    graph_.rows.push_back({kGBufferLane, {}, 0, false, {}, lanes_of({kGBufferLane})});
  }

  void add(const std::vector<PassDeclaration>& passes, int depth) {
    for (const PassDeclaration& pass : passes) {
      if (!is_drawn(pass)) continue;
      const bool is_loop = !pass.body.empty();
      GraphRow row{pass.id, pass.timer.empty() ? pass.id : pass.timer, depth, is_loop, {}, {}};
      row.reads = lanes_of(pass.reads);
      row.writes = lanes_of(pass.writes);
      graph_.rows.push_back(std::move(row));
      if (is_loop) add(pass.body, depth + 1);
    }
  }

  FrameGraph finish() {
    std::vector<size_t> free_from;  // by column: the first row after its last lane
    for (GraphLane& lane : graph_.lanes) {
      const auto column = std::ranges::find_if(free_from, [&](size_t row) { return row <= lane.first_row; });
      lane.column = static_cast<size_t>(column - free_from.begin());
      if (column == free_from.end()) free_from.push_back(0);
      free_from[lane.column] = lane.last_row + 1;
    }
    graph_.columns = free_from.size();
    return std::move(graph_);
  }

 private:
  /// A loop is where one of its passes is.
  bool is_drawn(const PassDeclaration& pass) const {
    if (drawn_.empty()) return true;
    if (pass.body.empty()) return std::ranges::find(drawn_, pass.id) != drawn_.end();
    return std::ranges::any_of(pass.body, [&](const PassDeclaration& inner) { return is_drawn(inner); });
  }

  /// Of the row that comes next; each once.
  std::vector<size_t> lanes_of(const std::vector<std::string>& resources) {
    const size_t row = graph_.rows.size();
    std::vector<size_t> lanes;
    for (const std::string& resource : resources) {
      const std::string name = lane_name(resource);
      auto lane = std::ranges::find(graph_.lanes, name, &GraphLane::resource);
      if (lane == graph_.lanes.end()) {
        graph_.lanes.push_back({name, row, row, 0});
        lane = std::prev(graph_.lanes.end());
      }
      lane->last_row = row;
      const auto index = static_cast<size_t>(lane - graph_.lanes.begin());
      if (std::ranges::find(lanes, index) == lanes.end()) lanes.push_back(index);
    }
    return lanes;
  }

  const std::vector<std::string>& drawn_;
  FrameGraph graph_;
};

}  // namespace

FrameGraph frame_graph(const std::vector<PassDeclaration>& passes, const std::vector<std::string>& drawn) {
  Builder builder(drawn);
  builder.add(passes, 0);
  return builder.finish();
}

}  // namespace umbrameter
