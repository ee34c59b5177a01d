// SPDX-License-Identifier: Apache-2.0
// What was measured: labels, summary, faults, the probe under the cursor, passes.

#include "view/panels.h"

#include <imgui.h>

#include <algorithm>
#include <numeric>

namespace umbrameter {
namespace {

const ImVec4 kQuiet{0.59f, 0.62f, 0.67f, 1.0f};

/// "name   value", the values in one column.
void row(const char* name, const std::string& value) {
  ImGui::TextColored(kQuiet, "%s", name);
  ImGui::SameLine(170.0f);
  ImGui::TextUnformatted(value.c_str());
}

ImVec4 colour_of(const Rgb8& colour) {
  const auto share = [](uint8_t byte) { return static_cast<float>(byte) / 255.0f; };
  return {share(colour[0]), share(colour[1]), share(colour[2]), 1.0f};
}

double mean_of_last(const std::deque<double>& values, size_t count) {
  const size_t kept = std::min(count, values.size());
  return std::accumulate(values.end() - static_cast<std::ptrdiff_t>(kept), values.end(), 0.0) /
         static_cast<double>(kept);
}

std::string interval_text(const Interval& interval) {
  return fmt::format("{:.4f}  ({:.4f} to {:.4f})", interval.value, interval.low, interval.high);
}

std::string optional_text(const std::optional<double>& value) {
  return value ? fmt::format("{:+.4f}", *value) : "nothing to measure";
}

void error_rows(const Score& score, int truth_pass) {
  if (!score.error) {
    row("RMSE", "not scored: the surfaces differ");
    return;
  }
  const VisibilityError& error = *score.error;
  row("RMSE of visibility", error.rmse ? interval_text(*error.rmse) : "nothing to score");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "Root mean square of V - R over the %zu scored pixels in the window, the truth's noise taken\n"
        "out, with its 95 %% interval. Pass %d of the truth.",
        error.scored_pixels, truth_pass + 1);
  row("Bias", optional_text(error.bias));
  row("Too dark, too bright",
      fmt::format("{}, {}", optional_text(error.over_shadowing), optional_text(error.under_shadowing)));
  if (score.lit_rmse) row("RMSE of the lit picture", fmt::format("{:.4f}", *score.lit_rmse));
}

/// Pixel values that a plane has, "n/a" without it.
std::string plane_text(const Image& image, const char* name, size_t i, const char* format) {
  return image.has(name) ? fmt::format(fmt::runtime(format), image.plane(name)[i]) : "n/a";
}

void penumbra_rows(const Judged& judged, const glm::ivec2& cursor_px) {
  const PenumbraProfile* profile = profile_near(judged.profiles, cursor_px.x, cursor_px.y);
  if (profile == nullptr) {
    row("Penumbra", judged.profiles.empty() ? "not measured yet" : "none here");
    return;
  }
  row("Penumbra, true width",
      fmt::format("{:.4g} world, {:.1f} px", profile->reference_width_world, profile->reference_width_px));
  row("  of the technique", fmt::format("{:.4g} world, {:.2f} x the true one", profile->test_width_world,
                                        std::exp2(profile->width_octaves)));
  row("  its edge lies", fmt::format("{:.3g} world {}", std::abs(profile->offset_world),
                                     profile->offset_world > 0.0 ? "too far out" : "too far in"));
}

}  // namespace

std::string test_label(const ViewState& state, const Session& session) {
  const Drawing* drawing = session.drawing();
  if (drawing == nullptr) return state.shown().title + ": being drawn";
  std::string text = fmt::format("{}  {:.0f} ms", state.shown().title, 1e3 * drawing->wall_time_s);
  if (!session.is_full(state))
    text += fmt::format("  at {} x {} px", drawing->job.request.width_px, drawing->job.request.height_px);
  return text;
}

std::string truth_label(const ViewState& state, const Session& session) {
  const TruthPass* truth = session.truth(state);
  if (truth == nullptr) return session.is_moving() ? "Truth: when the camera rests" : "Truth: being traced";
  return fmt::format("Truth  se {:.4f}, {:.1f} s{}", truth->se_rms, truth->wall_time_s,
                     truth->pass + 1 < truth->passes ? ", refining" : "");
}

void summary_panel(const ViewState& state, const Session& session) {
  if (!ImGui::CollapsingHeader("Measured in this view", ImGuiTreeNodeFlags_DefaultOpen)) return;
  row("Picture", fmt::format("{} x {} px", state.width_px, state.height_px));
  if (session.moving_intervals_s().empty()) {
    row("While moving", "not moved yet");
  } else {
    row("While moving",
        fmt::format("{:.1f} pictures a second", 1.0 / mean_of_last(session.moving_intervals_s(), 20)));
  }
  const TruthPass* truth = session.truth(state);
  row("Truth", truth == nullptr ? std::string("not there yet")
                                : fmt::format("pass {} of {}, se {:.4f} rms, {:.3f} max", truth->pass + 1,
                                              truth->passes, truth->se_rms, truth->se_max));
  if (const Judged* judged = session.judged(state)) {
    error_rows(judged->score, judged->job.truth_pass);
  } else {
    row("RMSE of visibility", "needs the truth");
  }
  if (!session.judge_problem().empty()) ImGui::TextWrapped("%s", session.judge_problem().c_str());
}

void faults_panel(const ViewState& state, const Session& session) {
  if (!ImGui::CollapsingHeader("Faults (F)")) return;
  const Judged* judged = session.judged(state);
  if (judged == nullptr || !judged->score.diagnosis) {
    ImGui::TextColored(kQuiet, "told apart once the truth's second pass is there");
    return;
  }
  const FaultNumbers& numbers = judged->score.diagnosis->faults;
  for (const FaultLegend& legend : fault_legend()) {
    const FaultShare& share = numbers.of(legend.fault);
    if (legend.fault == FaultClass::unscored || legend.fault == FaultClass::explained || share.pixels == 0)
      continue;
    ImGui::ColorButton("##colour", colour_of(legend.colour), ImGuiColorEditFlags_NoTooltip, {14, 14});
    ImGui::SameLine();
    ImGui::TextUnformatted(std::string(name_of(legend.fault)).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(legend.text).c_str());
    ImGui::SameLine(190.0f);
    ImGui::Text("%zu px in %zu places", share.pixels, share.components);
  }
}

void probe_panel(const ViewState& state, const Session& session) {
  if (!ImGui::CollapsingHeader("Under the cursor", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const TruthPass* truth = session.truth(state);
  const auto test = session.test();
  if (!state.cursor_px || !test || !session.is_full(state)) {
    ImGui::TextColored(kQuiet, "nothing: point at the picture at rest");
    return;
  }
  const glm::ivec2 px = *state.cursor_px;
  const size_t i = static_cast<size_t>(px.y) * static_cast<size_t>(test->width) + static_cast<size_t>(px.x);
  row("Pixel, triangle", fmt::format("{}, {};  {}", px.x, px.y, test->plane("primitive_id")[i]));
  row("Visibility", plane_text(*test, "visibility", i, "{:.4f}"));
  if (truth == nullptr) return;
  const Image& image = *truth->image;
  const float error = test->plane("visibility")[i] - image.plane("visibility")[i];
  row("  of the truth", fmt::format("{:.4f} +- {:.4f}, {:.0f} samples", image.plane("visibility")[i],
                                    image.plane("visibility_se")[i], image.plane("sample_count")[i]));
  row("Error", fmt::format("{:+.4f}", error));
  row("Nearest blocker", plane_text(image, "blocker_distance_min", i, "{:.4g} world"));
  const Judged* judged = session.judged(state);
  if (judged == nullptr) return;
  if (!judged->score.fault_classes.empty())
    row("Fault", std::string(name_of(judged->score.fault_classes[i])));
  penumbra_rows(*judged, px);
}

void passes_panel(ViewState& state, const Session& session) {
  state.wants_times = ImGui::CollapsingHeader("Passes and textures (5)");
  if (!state.wants_times) return;
  const Drawing* drawing = session.drawing();
  if (drawing != nullptr && !drawing->times_ms.empty()) {
    const double all_ms = std::accumulate(drawing->times_ms.begin(), drawing->times_ms.end(), 0.0);
    row("All passes", fmt::format("{:.3f} ms, {}", all_ms, drawing->timer));
    for (size_t i = 0; i < drawing->passes.size(); ++i) {
      const std::string text = fmt::format("{:.3f} ms", drawing->times_ms[i]);
      ImGui::ProgressBar(static_cast<float>(drawing->times_ms[i] / std::max(all_ms, 1e-9)), {150, 0},
                         text.c_str());
      ImGui::SameLine();
      ImGui::TextUnformatted(drawing->passes[i].c_str());
    }
    row("Textures", fmt::format("{:.1f} MiB", double(drawing->frame.memory_bytes) / (1 << 20)));
  }
  ImGui::Separator();
  for (const PassDeclaration& pass : state.shown().passes) {
    const auto joined = [](const std::vector<std::string>& names) {
      std::string text;
      for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
      return text;
    };
    ImGui::TextWrapped("%s: %s -> %s", pass.id.c_str(),
                       pass.reads.empty() ? "triangles" : joined(pass.reads).c_str(),
                       joined(pass.writes).c_str());
  }
  ImGui::Separator();
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

}  // namespace umbrameter
