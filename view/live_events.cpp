// SPDX-License-Identifier: Apache-2.0
// Keys and mouse.

#include "view/camera_control.h"
#include "view/light_edit.h"
#include "view/live_view.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kRadiansPerPixel = 0.005;
constexpr double kDollyPerStep = 0.9;
constexpr double kFast = 4.0;           // with Shift
constexpr double kSplitReach_px = 8.0;  // of the divider

bool is_fly_key(int key) {
  constexpr int kKeys[] = {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_E};
  return std::ranges::find(kKeys, key) != std::end(kKeys);
}

template <class Choice>
Choice next_of(Choice choice, size_t count) {
  return static_cast<Choice>((static_cast<size_t>(choice) + 1) % count);
}

}  // namespace

void LiveView::on_key(int key, int action, int mods) {
  if (action == GLFW_RELEASE) {
    held_.erase(key);
    return;
  }
  if ((mods & GLFW_MOD_CONTROL) != 0) {
    if (key == GLFW_KEY_Q && action == GLFW_PRESS) window_.close();
    if (key == GLFW_KEY_S && action == GLFW_PRESS) saves_.push_back({Saved::scene, {}});
    return;
  }
  if (is_fly_key(key) || key == GLFW_KEY_LEFT_SHIFT) held_.insert(key);
  const size_t count = state_.techniques.size();
  const auto show = [&](Layer layer) { state_.layer = state_.layer == layer ? Layer::lit : layer; };
  switch (key) {
    case GLFW_KEY_PAGE_DOWN:
      choose_technique(state_, (state_.technique + 1) % count);
      ++switches_;
      break;
    case GLFW_KEY_PAGE_UP:
      choose_technique(state_, (state_.technique + count - 1) % count);
      ++switches_;
      break;
    case GLFW_KEY_1:
    case GLFW_KEY_2:
    case GLFW_KEY_3:
    case GLFW_KEY_4:
    case GLFW_KEY_5:
      state_.layout = static_cast<Layout>(key - GLFW_KEY_1);
      break;
    case GLFW_KEY_L:
      state_.layer = Layer::lit;
      break;
    case GLFW_KEY_V:
      show(Layer::visibility);
      break;
    case GLFW_KEY_X:
      show(Layer::error);
      break;
    case GLFW_KEY_F:
      show(Layer::faults);
      break;
    case GLFW_KEY_N:
      show(Layer::normals);
      break;
    case GLFW_KEY_C:
      show(Layer::maps);
      break;
    case GLFW_KEY_T:
      state_.paint.has_edges = !state_.paint.has_edges;
      break;
    case GLFW_KEY_SPACE:
      state_.light_follows = !state_.light_follows;
      if (state_.light_follows) set_light(state_, at_camera(state_.shown_light(), state_.camera));
      break;
    case GLFW_KEY_COMMA:
      set_light(state_, resized(state_.shown_light(), kDollyPerStep));
      break;
    case GLFW_KEY_PERIOD:
      set_light(state_, resized(state_.shown_light(), 1.0 / kDollyPerStep));
      break;
    case GLFW_KEY_HOME:
      set_camera(state_, state_.first_camera);
      break;
    case GLFW_KEY_TAB:
      has_panel_ = !has_panel_;
      break;
    case GLFW_KEY_H:
    case GLFW_KEY_F1:
      has_help_ = !has_help_;
      break;
    case GLFW_KEY_F2:
      saves_.push_back({(mods & GLFW_MOD_SHIFT) != 0 ? Saved::window : Saved::picture, {}});
      break;
    case GLFW_KEY_R:
      start_recording_or_stop();
      break;
    case GLFW_KEY_P:
      if (!path_.empty()) playing_s_ = playing_s_ ? std::nullopt : std::optional(0.0);
      break;
    default:
      break;
  }
}

void LiveView::on_button(int button, int action) {
  if (action == GLFW_RELEASE) {
    if (dragging_ == button) dragging_.reset();
    return;
  }
  if (!is_over_pictures()) return;
  dragging_ = button;
  const double divider = area_.left + state_.split * area_.width;
  drags_split_ = state_.layout == Layout::split && button == GLFW_MOUSE_BUTTON_LEFT &&
                 std::abs(last_x_ - divider) <= kSplitReach_px;
}

void LiveView::on_move(double x, double y) {
  const double across = x - last_x_, down = y - last_y_;
  last_x_ = x;
  last_y_ = y;
  state_.cursor_px.reset();
  for (const Pane& pane : shown_) {
    const double left = (x - pane.left) / pane.width, top = (y - pane.top) / pane.height;
    if (left >= 0.0 && left < 1.0 && top >= 0.0 && top < 1.0)
      state_.cursor_px = glm::ivec2(int(left * state_.width_px), int(top * state_.height_px));
  }
  if (!dragging_) return;
  if (drags_split_) {
    state_.split = std::clamp((x - area_.left) / std::max(double(area_.width), 1.0), 0.0, 1.0);
    return;
  }
  const double yaw_rad = across * kRadiansPerPixel, pitch_rad = -down * kRadiansPerPixel;
  switch (*dragging_) {
    case GLFW_MOUSE_BUTTON_LEFT:
      if (held_.contains(GLFW_KEY_LEFT_SHIFT))
        set_light(state_, swung(state_.shown_light(), state_.camera, yaw_rad, pitch_rad));
      else
        set_camera(state_, orbited(state_.camera, yaw_rad, pitch_rad));
      break;
    case GLFW_MOUSE_BUTTON_RIGHT:
      set_camera(state_, looked_around(state_.camera, yaw_rad, pitch_rad));
      break;
    case GLFW_MOUSE_BUTTON_MIDDLE: {
      const double reach_world = glm::distance(state_.camera.eye_world, state_.camera.at_world);
      const double step_world = reach_world / std::max(area_.height, 1.0f);
      set_camera(state_, flown(state_.camera, {-across * step_world, down * step_world, 0.0}));
      break;
    }
    default:
      break;
  }
}

bool LiveView::is_over_pictures() const {
  const double across = last_x_ - area_.left, down = last_y_ - area_.top;
  return across >= 0.0 && across < area_.width && down >= 0.0 && down < area_.height;
}

void LiveView::on_scroll(double steps) {
  if (is_over_pictures()) set_camera(state_, dollied(state_.camera, std::pow(kDollyPerStep, steps)));
}

void LiveView::on_drop(const std::string& file) {
  open_scene(file);
}

void LiveView::move_by_keys(double seconds) {
  const auto is_held = [&](int key) { return held_.contains(key) ? 1.0 : 0.0; };
  const glm::dvec3 along{is_held(GLFW_KEY_D) - is_held(GLFW_KEY_A), is_held(GLFW_KEY_E) - is_held(GLFW_KEY_Q),
                         is_held(GLFW_KEY_W) - is_held(GLFW_KEY_S)};
  if (along == glm::dvec3(0.0)) return;
  const double speed_world = fly_speed_world_ * (is_held(GLFW_KEY_LEFT_SHIFT) > 0.0 ? kFast : 1.0);
  set_camera(state_, flown(state_.camera, along * speed_world * seconds));
}

void LiveView::start_recording_or_stop() {
  is_recording_ = !is_recording_;
  playing_s_.reset();
  if (is_recording_) {
    path_ = {{0.0, state_.camera}};
    recording_since_ = Clock::now();
    say("recording the camera; R again stops");
    return;
  }
  path_.push_back({std::max(seconds_since(recording_since_), path_.back().time_s + 1e-3), state_.camera});
  say(fmt::format("{} cameras recorded; P plays them", path_.size()));
}

void LiveView::follow_path(double seconds) {
  if (is_recording_) {
    const double time_s = seconds_since(recording_since_);
    if (time_s - path_.back().time_s >= 0.05) path_.push_back({time_s, state_.camera});
  }
  if (!playing_s_) return;
  *playing_s_ += seconds;
  set_camera(state_, camera_at(path_, *playing_s_));
  if (*playing_s_ >= path_.back().time_s) playing_s_.reset();
}

}  // namespace umbrameter
