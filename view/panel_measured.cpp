// SPDX-License-Identifier: Apache-2.0
// What was measured: labels, summary, faults, the probe under the cursor.

#include "results/catalogue.h"
#include "view/panel_row.h"
#include "view/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace umbrameter {
namespace {

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

/// The catalogue's errors and similarities; penumbrae and faults have panels of their own.
void metric_rows(const Score& score) {
  const TechniqueResult result = result_of(score);
  for (const Metric& metric : metric_catalogue()) {
    if ((metric.group != "error" && metric.group != "similarity") || metric.key == "rmse" ||
        !metric.of(result))
      continue;
    panel_row(metric.label.c_str(), format_metric(metric, result));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", metric.doc.c_str());
  }
}

std::string offset_text(double widths) {
  if (std::abs(widths) < 0.005) return "where the true ones do";
  return fmt::format("{:.2f} true widths too far {}", std::abs(widths), widths > 0.0 ? "out" : "in");
}

/// Of all penumbrae in the window: how wide and where they are, and whether they widen as the true ones do.
void penumbra_rows(const Diagnosis& diagnosis) {
  const PenumbraNumbers& penumbra = diagnosis.penumbra;
  if (!penumbra.width_octaves) return panel_row("Penumbrae", "none that can be measured");
  panel_row("Penumbrae' widths", fmt::format("{:.2f} x the true ones, {} places",
                                             std::exp2(penumbra.width_octaves->median), penumbra.accepted()));
  if (penumbra.offset_widths) panel_row("  their edges lie", offset_text(penumbra.offset_widths->median));
  const ContactHardening& hardening = diagnosis.contact_hardening;
  panel_row("Contact hardening", hardening.slope ? fmt::format("{:.2f} (1: as the truth)", *hardening.slope)
                                                 : "too few widths to tell");
}

void error_rows(const Score& score, int truth_pass) {
  if (!score.error) {
    panel_row("RMSE", "not scored: the surfaces differ");
    return;
  }
  const VisibilityError& error = *score.error;
  panel_row("RMSE of visibility", error.rmse ? interval_text(*error.rmse) : "nothing to score");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "Root mean square of V - R over the %zu scored pixels in the window, the truth's noise taken\n"
        "out, with its 95 %% interval. Pass %d of the truth.",
        error.scored_pixels, truth_pass + 1);
  metric_rows(score);
  if (score.diagnosis) penumbra_rows(*score.diagnosis);
}

/// Pixel values that a plane has, "n/a" without it.
std::string plane_text(const Image& image, const char* name, size_t i, const char* format) {
  return image.has(name) ? fmt::format(fmt::runtime(format), image.plane(name)[i]) : "n/a";
}

std::string fault_text(FaultClass fault) {
  if (fault == FaultClass::unscored) return "not scored";
  return fault == FaultClass::explained ? "none, or a slight one" : std::string(name_of(fault));
}

void probed_penumbra_rows(const Judged& judged, const glm::ivec2& cursor_px) {
  const PenumbraProfile* profile = profile_near(judged.profiles, cursor_px.x, cursor_px.y);
  if (profile == nullptr) {
    panel_row("Penumbra", judged.profiles.empty() ? "not measured yet" : "none here");
    return;
  }
  panel_row("Penumbra, true width", fmt::format("{:.4g} world, {:.1f} px", profile->reference_width_world,
                                                profile->reference_width_px));
  panel_row("  of the technique", fmt::format("{:.4g} world, {:.2f} x the true one",
                                              profile->test_width_world, std::exp2(profile->width_octaves)));
  panel_row("  its edge lies", fmt::format("{:.3g} world {}", std::abs(profile->offset_world),
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
  if (!ImGui::CollapsingHeader(heading_of(Section::measured), ImGuiTreeNodeFlags_DefaultOpen)) return;
  panel_row("Picture", fmt::format("{} x {} px", state.width_px, state.height_px));
  if (session.moving_intervals_s().empty()) {
    panel_row("While moving", "not moved yet");
  } else {
    panel_row("While moving",
              fmt::format("{:.1f} pictures a second", 1.0 / mean_of_last(session.moving_intervals_s(), 20)));
  }
  const TruthPass* truth = session.truth(state);
  panel_row("Truth", truth == nullptr ? std::string("not there yet")
                                      : fmt::format("{} of {}, se {:.4f}, max {:.3f}", truth->pass + 1,
                                                    truth->passes, truth->se_rms, truth->se_max));
  if (const Judged* judged = session.judged(state)) {
    error_rows(judged->score, judged->job.truth_pass);
  } else {
    panel_row("RMSE of visibility", "needs the truth");
  }
  if (!session.judge_problem().empty()) ImGui::TextWrapped("%s", session.judge_problem().c_str());
}

void faults_panel(const ViewState& state, const Session& session) {
  if (!ImGui::CollapsingHeader(heading_of(Section::faults))) return;
  const Judged* judged = session.judged(state);
  if (judged == nullptr || !judged->score.diagnosis) {
    ImGui::TextColored(kQuietInk, "told apart once the truth's second pass is there");
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
  if (!ImGui::CollapsingHeader(heading_of(Section::cursor), ImGuiTreeNodeFlags_DefaultOpen)) return;
  const TruthPass* truth = session.truth(state);
  const auto test = session.test();
  if (!state.cursor_px || !test || !session.is_full(state)) {
    ImGui::TextColored(kQuietInk, "nothing: point at the picture at rest");
    return;
  }
  const glm::ivec2 px = *state.cursor_px;
  const size_t i = static_cast<size_t>(px.y) * static_cast<size_t>(test->width) + static_cast<size_t>(px.x);
  panel_row("Pixel, triangle", fmt::format("{}, {};  {}", px.x, px.y, test->plane("primitive_id")[i]));
  panel_row("Visibility", plane_text(*test, "visibility", i, "{:.4f}"));
  if (const Drawing* drawing = session.drawing(); drawing != nullptr && drawing->maps) {
    const float map = drawing->maps->plane("Y")[i];
    panel_row("Map", map < 0.0f ? std::string("none") : fmt::format("number {:.0f}", map));
  }
  if (truth == nullptr) return;
  const Image& image = *truth->image;
  const float error = test->plane("visibility")[i] - image.plane("visibility")[i];
  const float samples = image.plane("sample_count")[i];
  panel_row(
      "  of the truth",
      fmt::format("{:.4f} +- {:.4f}, {}", image.plane("visibility")[i], image.plane("visibility_se")[i],
                  samples > 0.0f ? fmt::format("{:.0f} samples", samples) : std::string("without a ray")));
  panel_row("Error", fmt::format("{:+.4f}", error));
  const bool is_blocked = image.has("blocker_distance_min") && image.plane("blocker_distance_min")[i] > 0.0f;
  if (image.has("blocker_distance_min"))
    panel_row("Nearest blocker", is_blocked ? plane_text(image, "blocker_distance_min", i, "{:.4g} world")
                                            : std::string("nothing blocks"));
  const Judged* judged = session.judged(state);
  if (judged == nullptr) return;
  if (!judged->score.fault_classes.empty()) panel_row("Fault", fault_text(judged->score.fault_classes[i]));
  probed_penumbra_rows(*judged, px);
}

}  // namespace umbrameter
