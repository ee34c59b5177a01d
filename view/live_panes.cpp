// SPDX-License-Identifier: Apache-2.0
// The pictures, where they lie, and what is written over them.

#include "view/live_view.h"
#include "view/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr float kControlsWidth_px = 400.0f;
constexpr float kLabelGap_px = 8.0f;
constexpr ImU32 kInk = IM_COL32(240, 242, 246, 255), kShade = IM_COL32(16, 19, 24, 190),
                kProblem = IM_COL32(150, 22, 32, 235), kDivider = IM_COL32(224, 160, 0, 255);

/// Text on a dark plate; its height with the plate.
float draw_label(float x, float y, const std::string& text, ImU32 plate = kShade, float wrap_px = 0.0f) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap_px > 0.0f ? wrap_px : -1.0f);
  list.AddRectFilled({x, y}, {x + size.x + 14, y + size.y + 8}, plate, 3.0f);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x + 7, y + 4}, kInk, text.c_str(), nullptr, wrap_px);
  return size.y + 8;
}

ImU32 packed(const Rgb8& colour) {
  return IM_COL32(colour[0], colour[1], colour[2], 255);
}

/// Blue, white, red with the numbers at its ends.
void draw_error_scale(float left, float bottom, double scale) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float top = bottom - 34, width = 180;
  list.AddRectFilled({left, top}, {left + width + 16, bottom}, kShade, 3.0f);
  const ImVec2 begin{left + 8, top + 6}, middle{left + 8 + width / 2, top + 14},
      end{left + 8 + width, top + 14};
  list.AddRectFilledMultiColor(begin, middle, packed(kTooDarkColour), packed(kNoErrorColour),
                               packed(kNoErrorColour), packed(kTooDarkColour));
  list.AddRectFilledMultiColor({middle.x, begin.y}, end, packed(kNoErrorColour), packed(kTooBrightColour),
                               packed(kTooBrightColour), packed(kNoErrorColour));
  const std::string dark = fmt::format("-{:.2g} too dark", scale),
                    bright = fmt::format("too bright +{:.2g}", scale);
  const float small = ImGui::GetFontSize() * 0.8f;
  const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(small, 1000.0f, 0.0f, bright.c_str());
  list.AddText(ImGui::GetFont(), small, {left + 8, top + 17}, kInk, dark.c_str());
  list.AddText(ImGui::GetFont(), small, {left + 8 + width - size.x, top + 17}, kInk, bright.c_str());
}

/// Which colour is which map.
void draw_map_legend(float left, float bottom, const Drawing* drawing) {
  if (drawing == nullptr || !drawing->job.wants_maps) return;
  if (!drawing->maps) {
    draw_label(left, bottom - 26, "one map for the whole picture");
    return;
  }
  const auto index = drawing->maps->plane("Y");
  const int most = index.empty() ? -1 : static_cast<int>(*std::ranges::max_element(index));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const char* title = "maps by their number";
  draw_label(left, bottom - 26, title);
  float x = left + ImGui::CalcTextSize(title).x + 18;
  for (int map = 0; map <= most; ++map, x += 26) {
    list.AddRectFilled({x, bottom - 26}, {x + 24, bottom}, packed(map_colour(static_cast<size_t>(map))),
                       3.0f);
    list.AddText({x + 8, bottom - 21}, IM_COL32(0, 0, 0, 255), std::to_string(map).c_str());
  }
}

}  // namespace

void LiveView::lay_out() {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  area_ = {0.0f, 0.0f, std::max(window.x - (has_panel_ ? kControlsWidth_px : 0.0f), 16.0f),
           std::max(window.y, 16.0f)};
  set_size(state_, static_cast<int>(area_.width), static_cast<int>(area_.height));
}

PaintInputs LiveView::inputs_of(const Image& image) const {
  PaintInputs inputs{image, nullptr, {}, {}, nullptr};
  const Drawing* drawing = session_->drawing();
  if (drawing != nullptr && &image == session_->test().get()) inputs.maps = drawing->maps.get();
  const TruthPass* truth = session_->truth(state_);
  if (truth == nullptr || truth->image->width != image.width || truth->image->height != image.height)
    return inputs;
  inputs.truth = truth->image.get();
  if (const Judged* judged = session_->judged(state_); judged != nullptr && session_->is_full(state_)) {
    inputs.scored = judged->score.mask;
    inputs.faults = judged->score.fault_classes;
  }
  return inputs;
}

void LiveView::repaint() {
  const std::shared_ptr<const Image> test = session_->test();
  if (!test) return;
  const TruthPass* truth = session_->truth(state_);
  const Judged* judged = session_->judged(state_);
  const Drawing* drawing = session_->drawing();
  const std::string wanted =
      fmt::format("{} {} {} {} {} {} {} {} {} {} {}", static_cast<const void*>(test.get()),
                  truth ? static_cast<const void*>(truth->image.get()) : nullptr,
                  static_cast<const void*>(drawing->maps.get()), judged ? judged->job.truth_pass : -1,
                  judged ? judged->profiles.size() : 0, static_cast<int>(state_.layer),
                  state_.paint.exposure_stops, state_.paint.error_scale, state_.paint.has_edges,
                  session_->is_full(state_), static_cast<int>(state_.layout));
  if (wanted == painted_) return;
  painted_ = wanted;
  if (session_->is_full(state_) || state_.paint.white_irradiance == 1.0)
    state_.paint.white_irradiance = white_irradiance(*test);
  test_picture_ = paint(state_.layer, inputs_of(*test), state_.paint);
  test_texture_.set(test_picture_, test->width < state_.width_px);
  if (truth != nullptr) {
    const bool is_of_both =
        state_.layer == Layer::error || state_.layer == Layer::faults || state_.layer == Layer::maps;
    truth_picture_ = paint(is_of_both ? Layer::lit : state_.layer, inputs_of(*truth->image), state_.paint);
    truth_texture_.set(truth_picture_, false);
  }
  if (state_.layout != Layout::resource || !drawing->resource) return;
  const ResourcePicture resource = paint_resource(*drawing->resource);
  resource_texture_.set(resource.picture, false);
  resource_min_ = resource.min;
  resource_max_ = resource.max;
}

/// The part `from` to `to` of the texture's width, in its place in the pane, into which the whole just fits.
void LiveView::draw_pane(const Pane& pane, PictureTexture& texture, const char* title, float from, float to) {
  if (texture.handle() == nullptr) return;
  const auto width = static_cast<float>(texture.width_px()), height = static_cast<float>(texture.height_px());
  const bool is_whole =
      std::abs(pane.width / pane.height - width / height) < 0.01f * pane.width / pane.height;
  const float scale = std::min(pane.width / width, pane.height / height);
  const float shown_width = is_whole ? pane.width : std::floor(width * scale),
              shown_height = is_whole ? pane.height : std::floor(height * scale);
  const float left = std::floor(pane.left + (pane.width - shown_width) / 2),
              top = std::floor(pane.top + (pane.height - shown_height) / 2);
  shown_.push_back({left, top, shown_width, shown_height});
  ImGui::GetBackgroundDrawList()->AddImage(texture.handle(), {left + from * shown_width, top},
                                           {left + to * shown_width, top + shown_height}, {from, 0}, {to, 1});
  if (title != nullptr)
    draw_label(std::max(pane.left, left) + kLabelGap_px, std::max(pane.top, top) + kLabelGap_px, title);
}

void LiveView::draw_panes() {
  shown_.clear();
  const bool has_truth = session_->truth(state_) != nullptr;
  const std::string test = test_label(state_, *session_), truth = truth_label(state_, *session_);
  const auto split = static_cast<float>(state_.split);
  const float half = std::floor(area_.width / 2);
  const Pane left{area_.left, area_.top, half - 1, area_.height},
      right{area_.left + half + 1, area_.top, area_.width - half - 1, area_.height};
  switch (state_.layout) {
    case Layout::technique:
      draw_pane(area_, test_texture_, test.c_str(), 0, 1);
      break;
    case Layout::truth:
      draw_pane(area_, has_truth ? truth_texture_ : test_texture_, truth.c_str(), 0, 1);
      break;
    case Layout::side_by_side:
      draw_pane(left, test_texture_, test.c_str(), 0, 1);
      draw_pane(right, has_truth ? truth_texture_ : test_texture_, truth.c_str(), 0, 1);
      break;
    case Layout::split: {
      draw_pane(area_, test_texture_, test.c_str(), 0, 1);
      if (has_truth) draw_pane(area_, truth_texture_, nullptr, split, 1);
      const float x = std::round(area_.left + split * area_.width);
      ImGui::GetBackgroundDrawList()->AddRectFilled({x - 1, area_.top}, {x + 2, area_.top + area_.height},
                                                    kDivider);
      const float width = ImGui::CalcTextSize(truth.c_str()).x + 14;
      draw_label(area_.left + area_.width - width - kLabelGap_px, area_.top + kLabelGap_px, truth);
      break;
    }
    case Layout::resource: {
      const std::string title = fmt::format(
          "{}, layer {}, level {}: {} x {} texels, black {:.4g} to white {:.4g}", state_.resource.resource,
          state_.resource.layer, state_.resource.level, resource_texture_.width_px(),
          resource_texture_.height_px(), resource_min_, resource_max_);
      draw_pane(area_, resource_texture_, title.c_str(), 0, 1);
      break;
    }
  }
}

void LiveView::draw_notes() {
  float bottom = area_.top + area_.height - kLabelGap_px;
  if (state_.layer == Layer::error && state_.layout != Layout::truth && state_.layout != Layout::resource)
    draw_error_scale(area_.left + kLabelGap_px, bottom, state_.paint.error_scale);
  if (state_.layer == Layer::maps && state_.layout != Layout::truth && state_.layout != Layout::resource)
    draw_map_legend(area_.left + kLabelGap_px, bottom, session_->drawing());
  if (!session_->problem().empty())
    draw_label(area_.left + kLabelGap_px, area_.top + 44, session_->problem(), kProblem, area_.width - 40);
  const bool is_opening = !opening_.empty();
  if (is_opening || Clock::now() < note_until_) {
    const std::string note = is_opening ? "reading " + opening_ : note_;
    const float width = ImGui::CalcTextSize(note.c_str()).x + 14;
    draw_label(area_.left + std::max((area_.width - width) / 2, kLabelGap_px), bottom - 30, note);
  }
  if (has_help_) help_overlay(area_.width, area_.height);
}

void LiveView::draw_panel() {
  ImGui::SetNextWindowPos({area_.left + area_.width, 0});
  ImGui::SetNextWindowSize({kControlsWidth_px, ImGui::GetIO().DisplaySize.y});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus;
  ImGui::Begin("panel", nullptr, kFlags);
  if (const std::optional<size_t> only = std::exchange(only_section_, std::nullopt)) {
    for (size_t i = 0; i < kSections; ++i)
      ImGui::GetStateStorage()->SetInt(ImGui::GetID(heading_of(static_cast<Section>(i))), i == *only ? 1 : 0);
  }
  const size_t technique = state_.technique;
  if (const std::optional<std::string> wanted = scene_menu(setup_, opening_)) open_scene(*wanted);
  summary_panel(state_, *session_);
  technique_panel(state_);
  view_panel(state_, *session_);
  light_panel(state_);
  camera_panel(state_, fly_speed_world_);
  probe_panel(state_, *session_);
  faults_panel(state_, *session_);
  passes_panel(state_, *session_);
  if (const std::optional<Saved> wanted = save_panel(path_.size())) saves_.push_back({*wanted, {}});
  ImGui::End();
  if (state_.technique != technique) ++switches_;
}

}  // namespace umbrameter
