// SPDX-License-Identifier: Apache-2.0
// The frame graph with the passes' times, and the texture that is shown.

#include "view/frame_graph.h"
#include "view/panel_row.h"
#include "view/panels.h"

#include <imgui.h>

#include <algorithm>
#include <numeric>

namespace umbrameter {
namespace {

constexpr float kColumn_px = 13.0f, kDot_px = 4.0f, kIndent_px = 12.0f;

/// Lanes are told apart by these, which colour-blind people can, too.
ImU32 lane_colour(size_t lane) {
  const Rgb8& colour = map_colour(lane);
  return IM_COL32(colour[0], colour[1], colour[2], 255);
}

/// Of the pass summed under `label`; nothing when it was not drawn or not timed.
std::optional<double> time_of(const Drawing* drawing, const std::string& label) {
  if (drawing == nullptr) return std::nullopt;
  const auto found = std::ranges::find(drawing->passes, label);
  const auto index = static_cast<size_t>(found - drawing->passes.begin());
  return index < drawing->times_ms.size() ? std::optional(drawing->times_ms[index]) : std::nullopt;
}

/// The lines that run beside rows `top` to `bottom` of the screen, and this row's dots: full where it writes.
void draw_lanes(const FrameGraph& graph, size_t row, float left, float top, float bottom, float middle) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (size_t k = 0; k < graph.lanes.size(); ++k) {
    const GraphLane& lane = graph.lanes[k];
    if (row < lane.first_row || row > lane.last_row) continue;
    const float x = left + kColumn_px * (float(lane.column) + 0.5f);
    list.AddLine({x, row == lane.first_row ? middle : top}, {x, row == lane.last_row ? middle : bottom},
                 lane_colour(k), 2.0f);
    const bool writes = std::ranges::find(graph.rows[row].writes, k) != graph.rows[row].writes.end();
    const bool reads = std::ranges::find(graph.rows[row].reads, k) != graph.rows[row].reads.end();
    if (reads) {
      list.AddCircleFilled({x, middle}, kDot_px, ImGui::GetColorU32(ImGuiCol_WindowBg));
      list.AddCircle({x, middle}, kDot_px, lane_colour(k), 0, 2.0f);
    }
    if (writes) list.AddCircleFilled({x, middle}, kDot_px + 0.5f, lane_colour(k));
  }
}

/// What a pass reads and writes, in words.
void explain(const FrameGraph& graph, const GraphRow& row) {
  if (!ImGui::IsItemHovered()) return;
  const auto names = [&](const std::vector<size_t>& lanes) {
    std::string text;
    for (const size_t lane : lanes) text += (text.empty() ? "" : ", ") + graph.lanes[lane].resource;
    return text.empty() ? std::string("nothing") : text;
  };
  ImGui::SetTooltip("reads %s\nwrites %s", names(row.reads).c_str(), names(row.writes).c_str());
}

void show_resource(ViewState& state, const std::string& lane) {
  state.resource = {lane == kGBufferLane ? "gbuffer.position" : lane, 0, 0};
  state.layout = Layout::resource;
}

/// A pass: its lanes, its time as a bar, and what it writes as buttons that show it.
void pass_row(ViewState& state, const FrameGraph& graph, size_t index, const Drawing* drawing,
              double all_ms) {
  const GraphRow& row = graph.rows[index];
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  const float gutter = kColumn_px * float(graph.columns) + 6.0f, indent = kIndent_px * float(row.depth);
  const float height = ImGui::GetFrameHeight();
  ImGui::PushID(static_cast<int>(index));
  ImGui::SetCursorScreenPos({begin.x + gutter + indent, begin.y});
  const std::optional<double> time_ms = time_of(drawing, row.label);
  const std::string title = row.is_loop ? row.id + ", again and again:" : row.id,
                    time = time_ms ? fmt::format("{:.3f} ms", *time_ms) : "";
  const float width = std::max(ImGui::GetContentRegionAvail().x, 60.0f);
  ImGui::ProgressBar(static_cast<float>(time_ms.value_or(0.0) / std::max(all_ms, 1e-9)), {width, height}, "");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float text_y = begin.y + ImGui::GetStyle().FramePadding.y, left = begin.x + gutter + indent;
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  list.AddText({left + 6.0f, text_y}, ink, title.c_str());
  list.AddText({left + width - ImGui::CalcTextSize(time.c_str()).x - 6.0f, text_y}, ink, time.c_str());
  explain(graph, row);
  for (size_t k = 0; k < row.writes.size(); ++k) {
    const std::string& name = graph.lanes[row.writes[k]].resource;
    if (k == 0) ImGui::SetCursorScreenPos({begin.x + gutter + indent, ImGui::GetCursorScreenPos().y});
    if (k > 0) ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(lane_colour(row.writes[k])));
    if (ImGui::SmallButton(name.c_str())) show_resource(state, name);
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("show this texture");
  }
  draw_lanes(graph, index, begin.x, begin.y, ImGui::GetCursorScreenPos().y, begin.y + height / 2);
  ImGui::SetCursorScreenPos({begin.x, ImGui::GetCursorScreenPos().y});
  ImGui::PopID();
}

void resource_controls(ViewState& state) {
  ImGui::SetNextItemWidth(176.0f);
  if (ImGui::BeginCombo("texture", state.resource.resource.c_str())) {
    std::vector<std::string> names{"visibility", "gbuffer.position", "gbuffer.normal"};
    for (const ResourceDeclaration& resource : state.shown().resources) names.push_back(resource.name);
    for (const std::string& name : names) {
      if (!ImGui::Selectable(name.c_str(), name == state.resource.resource)) continue;
      state.resource = {name, 0, 0};
      state.layout = Layout::resource;
    }
    ImGui::EndCombo();
  }
  ImGui::SetNextItemWidth(176.0f);
  ImGui::InputInt("layer", &state.resource.layer);
  ImGui::SetNextItemWidth(176.0f);
  ImGui::InputInt("level", &state.resource.level);
  state.resource.layer = std::max(state.resource.layer, 0);
  state.resource.level = std::max(state.resource.level, 0);
}

}  // namespace

void passes_panel(ViewState& state, const Session& session) {
  state.wants_times = ImGui::CollapsingHeader(heading_of(Section::passes));
  if (!state.wants_times) return;
  const Drawing* drawing = session.drawing();
  double all_ms = 0.0;
  if (drawing != nullptr && !drawing->times_ms.empty()) {
    all_ms = std::accumulate(drawing->times_ms.begin(), drawing->times_ms.end(), 0.0);
    panel_row("All passes", fmt::format("{:.3f} ms", all_ms));
    panel_row("Timed by", drawing->timer);
    panel_row("Textures", fmt::format("{:.1f} MiB", double(drawing->frame.memory_bytes) / (1 << 20)));
  } else {
    panel_row("All passes", "timed when the camera rests");
  }
  const bool is_of_this = drawing != nullptr && drawing->job.run_version == state.run_version;
  const FrameGraph graph =
      frame_graph(state.shown().passes, is_of_this ? drawing->drawn : std::vector<std::string>());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 3.0f});
  for (size_t row = 0; row < graph.rows.size(); ++row) pass_row(state, graph, row, drawing, all_ms);
  ImGui::PopStyleVar();
  resource_controls(state);
}

}  // namespace umbrameter
