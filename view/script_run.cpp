// SPDX-License-Identifier: Apache-2.0
#include "view/script_run.h"

#include "core/names.h"
#include "view/camera_control.h"
#include "view/panels.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace umbrameter {
namespace {

constexpr double kOrbitStep_rad = 0.01;
constexpr int kDragSteps = 8;
constexpr double kLongest_s = 300.0;  // of a step

std::string_view without(std::string_view text, std::string_view prefix) {
  return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
}

template <class Choice>
Choice choice_of(const ScriptStep& step, size_t count) {
  std::vector<std::string> known;
  for (size_t i = 0; i < count; ++i) {
    std::string title(title_of(static_cast<Choice>(i)));
    std::ranges::transform(title, title.begin(),
                           [](char c) { return c == ' ' ? '_' : char(std::tolower(c)); });
    known.push_back(title);
  }
  const auto found = std::ranges::find(known, step.words[0]);
  if (found != known.end()) return static_cast<Choice>(found - known.begin());
  fail_input(fmt::format("there is no {} '{}'", step.command, step.words[0]), step.where,
             suggest_name(step.words[0], known));
}

}  // namespace

bool ScriptRun::advance() {
  while (!is_done()) {
    const ScriptStep& step = steps_[next_];
    if (is_waiting(step)) {
      if (seconds_since(begun_) < kLongest_s) return true;
      fail_environment(
          fmt::format("{}: '{}' took longer than {} s", to_string(step.where), step.command, kLongest_s),
          view_.session_->problem());
    }
    if (step.command == "close") return false;
    act(step);
    ++next_;
    count_ = 0;
    has_begun_ = false;
    begun_ = Clock::now();
    const bool needs_frame = step.command != "mark" && step.command != "wait";
    if (needs_frame) return true;
  }
  return false;
}

/// For steps that take several pictures: whether to come back after the next one.
bool ScriptRun::is_waiting(const ScriptStep& step) {
  const Session& session = *view_.session_;
  ViewState& state = view_.state_;
  const int begun = std::exchange(has_begun_, true) ? 0 : 1;
  if (step.command == "frames") return count_++ < static_cast<int>(step.number(0));
  if (step.command == "open") {
    if (begun == 1) view_.open_scene(step.words[0]);
    return !view_.opening_.empty();
  }
  if (step.command == "play") {
    if (begun == 1) {
      view_.path_ = read_camera_path(step.words[0], state.camera.near_world);
      view_.playing_s_ = 0.0;
    }
    return view_.playing_s_.has_value();
  }
  if (step.command == "orbit" || step.command == "switch") {
    if (begun == 1) drawings_seen_ = session.drawings() - 1;
    const bool is_shown = step.command == "orbit" ? session.drawings() > drawings_seen_
                                                  : session.is_full(state) || session.has_failed(state);
    if (!is_shown) return true;
    if (count_++ == static_cast<int>(step.number(0))) return false;
    drawings_seen_ = session.drawings();
    begun_ = Clock::now();  // the time limit is of each
    if (step.command == "orbit")
      set_camera(state, orbited(state.camera, kOrbitStep_rad, 0.0));
    else
      view_.window_.send_key(GLFW_KEY_PAGE_DOWN, GLFW_PRESS, 0);
    return true;
  }
  return step.command == "wait" && !is_there(step);
}

bool ScriptRun::is_there(const ScriptStep& step) const {
  const Session& session = *view_.session_;
  const ViewState& state = view_.state_;
  const std::string& what = step.words[0];
  const Judged* judged = session.judged(state);
  if (what == "full") return session.is_full(state) && session.problem().empty();
  if (what == "problem") return !session.problem().empty();
  if (what == "judged") return judged != nullptr;
  if (what == "faults") return judged != nullptr && judged->score.diagnosis;
  if (what == "truth") {
    const double se = step.words.size() > 1 ? step.number(1) : kWantedSe;
    const TruthPass* truth = session.truth(state);
    return truth != nullptr && (truth->promised_se <= se || truth->pass + 1 == truth->passes);
  }
  fail_input(fmt::format("there is nothing to wait for called '{}'", what), step.where,
             "full, truth [SE], judged, faults or problem");
}

void ScriptRun::act(const ScriptStep& step) {
  ViewState& state = view_.state_;
  const auto save = [&](Saved what) { view_.saves_.push_back({what, step.words[0]}); };
  const std::string& command = step.command;
  if (command == "key") press(step, true, true);
  if (command == "press") press(step, true, false);
  if (command == "release") press(step, false, true);
  if (command == "drag") drag(step);
  if (command == "scroll") view_.window_.send_scroll(step.number(0));
  if (command == "hover") view_.window_.send_move(step.number(0), step.number(1));
  if (command == "resize") view_.window_.resize(int(step.number(0)), int(step.number(1)));
  if (command == "technique") choose_technique(state, step.words[0]);
  if (command == "set") set_parameter(step);
  if (command == "layout") state.layout = choice_of<Layout>(step, kLayouts);
  if (command == "layer") state.layer = choice_of<Layer>(step, kLayers);
  if (command == "unfold") view_.only_section_ = static_cast<size_t>(choice_of<Section>(step, kSections));
  if (command == "mark") view_.memory_first_mib_ = resident_mib();
  if (command == "window") save(Saved::window);
  if (command == "picture") save(Saved::picture);
  if (command == "scene") save(Saved::scene);
  if (command == "preset") save(Saved::preset);
  if (command == "study") save(Saved::study);
  if (command == "path") save(Saved::path);
}

/// "Q", "SHIFT+F2", "CTRL+S".
void ScriptRun::press(const ScriptStep& step, bool is_down, bool is_up) {
  std::string_view name = step.words[0];
  int mods = 0;
  if (name.starts_with("CTRL+")) mods |= GLFW_MOD_CONTROL;
  name = without(name, "CTRL+");
  if (name.starts_with("SHIFT+")) mods |= GLFW_MOD_SHIFT;
  name = without(name, "SHIFT+");
  const int key = key_of(name);
  if (key < 0)
    fail_input(fmt::format("there is no key '{}'", name), step.where,
               "A to Z, 0 to 9, SPACE, TAB, PAGE_DOWN, F2, ...");
  if (is_down) view_.window_.send_key(key, GLFW_PRESS, mods);
  if (is_up) view_.window_.send_key(key, GLFW_RELEASE, mods);
}

void ScriptRun::drag(const ScriptStep& step) {
  const std::string& name = step.words[0];
  if (name != "left" && name != "right" && name != "middle")
    fail_input(fmt::format("there is no mouse button '{}'", name), step.where, "left, right or middle");
  const int button = name == "left"    ? GLFW_MOUSE_BUTTON_LEFT
                     : name == "right" ? GLFW_MOUSE_BUTTON_RIGHT
                                       : GLFW_MOUSE_BUTTON_MIDDLE;
  const glm::dvec2 from(step.number(1), step.number(2)), to(step.number(3), step.number(4));
  view_.window_.send_button(button, GLFW_PRESS, from.x, from.y);
  for (int i = 1; i <= kDragSteps; ++i) {
    const glm::dvec2 place = from + (to - from) * (double(i) / kDragSteps);
    view_.window_.send_move(place.x, place.y);
  }
  view_.window_.send_button(button, GLFW_RELEASE, to.x, to.y);
}

void ScriptRun::set_parameter(const ScriptStep& step) {
  ViewState& state = view_.state_;
  const Parameter& parameter = find_parameter(state.shown().parameters, step.words[0], state.shown().id);
  const ParameterValue value = parse_parameter_value(parameter, step.words[1], step.where);
  set_value(state, parameter.name, in_world(parameter, value, state.diagonal_world));
}

}  // namespace umbrameter
