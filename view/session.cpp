// SPDX-License-Identifier: Apache-2.0
#include "view/session.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kMovingFrame_s = 0.05;  // wanted of a picture while the camera moves
constexpr int kGreatestDivisor = 4;      // of its sides
constexpr int64_t kMovingMap_texels = 512;
constexpr size_t kKeptIntervals = 1000;
constexpr double kPause_s = 1.0;  // a longer time between two pictures is no motion

Place place_of(const ViewState& state) {
  return {state.camera, state.shown_light(), state.width_px, state.height_px, state.place_version};
}

/// The scene with the chosen light alone, so that both renderers' caches go by its geometry and not by what moves.
Scene with_one_light(Scene scene) {
  scene.lights = {scene.light()};
  scene.active_light = 0;
  return scene;
}

/// What else is wanted of a picture than the picture.
std::string extras_key(const ViewState& state) {
  std::string key = state.wants_times ? "times " : "";
  if (state.layer == Layer::maps) key += "maps ";
  if (state.layout != Layout::resource) return key;
  return key + fmt::format("{}:{}:{}", state.resource.resource, state.resource.layer, state.resource.level);
}

/// A map's side, whatever the technique calls it.
bool is_map_side(const Parameter& parameter) {
  return parameter.type == ParameterType::integer && parameter.scale == ParameterScale::pow2 &&
         parameter.unit == "texels";
}

/// With maps no larger than kMovingMap_texels: on a rasteriser in software they take most of the time.
ParameterValues with_small_maps(const ViewState& state) {
  ParameterValues values = state.shown_values();
  for (const Parameter& parameter : state.shown().parameters) {
    if (!is_map_side(parameter)) continue;
    int64_t& side_texels = std::get<int64_t>(values.at(parameter.name));
    side_texels = std::max(std::min(side_texels, kMovingMap_texels), static_cast<int64_t>(parameter.min));
  }
  return values;
}

}  // namespace

Session::Session(const ViewSetup& setup, const std::function<void()>& tell)
    : draws_([scene = with_one_light(setup.scene),
              open = setup.open_renderer] { return open_drawing(scene, open); },
             tell),
      truths_([scene = with_one_light(setup.scene),
               threads = setup.threads] { return open_truth(scene, threads); },
              tell),
      judges_([] { return open_judging(); }, tell) {}

const TruthPass* Session::truth(const ViewState& state) const {
  return truth_ && truth_->place.version == state.place_version ? &*truth_ : nullptr;
}

const Judged* Session::judged(const ViewState& state) const {
  const bool is_shown = judged_ && judged_->job.place_version == state.place_version &&
                        judged_->job.run_version == state.run_version;
  return is_shown ? &*judged_ : nullptr;
}

bool Session::is_full(const ViewState& state) const {
  return drawing_ && drawing_->job.place.version == state.place_version &&
         drawing_->job.run_version == state.run_version && drawing_->job.request.width_px == state.width_px;
}

bool Session::has_failed(const ViewState& state) const {
  return !problem_.empty() && failed_run_version_ == state.run_version &&
         failed_place_version_ == state.place_version;
}

bool Session::update(const ViewState& state) {
  if (state.place_version != asked_place_) last_motion_ = Clock::now();
  bool is_new = take_drawing(state);
  is_new = take_truth() || is_new;
  is_new = take_judged() || is_new;
  ask_drawing(state);
  ask_truth(state);
  ask_judge(state);
  return is_new;
}

bool Session::take_drawing(const ViewState& state) {
  if (auto failure = draws_.take_failure()) {
    problem_ = failure->message;
    failed_run_version_ = state.run_version;
    failed_place_version_ = state.place_version;
    return true;
  }
  std::optional<Drawing> drawing = draws_.take();
  if (!drawing) return false;
  const Clock::time_point now = Clock::now();
  const double interval_s = std::chrono::duration<double>(now - last_drawing_).count();
  if (is_moving() && drawings_ > 0 && interval_s < kPause_s) moving_intervals_s_.push_back(interval_s);
  if (moving_intervals_s_.size() > kKeptIntervals) moving_intervals_s_.pop_front();
  last_drawing_ = now;
  ++drawings_;
  const RenderRequest& request = drawing->job.request;
  seconds_per_pixel_ = drawing->wall_time_s / (double(request.width_px) * double(request.height_px));
  if (request.width_px == drawing->job.place.width_px) full_frame_s_ = drawing->wall_time_s;
  test_ = std::make_shared<const Image>(std::move(drawing->frame.image));
  drawing_ = std::move(drawing);
  problem_.clear();
  return true;
}

bool Session::take_truth() {
  if (auto failure = truths_.take_failure()) judge_problem_ = failure->message;
  std::optional<TruthPass> pass = truths_.take();
  if (!pass) return false;
  truth_ = std::move(pass);
  return true;
}

bool Session::take_judged() {
  if (auto failure = judges_.take_failure()) judge_problem_ = failure->message;
  std::optional<Judged> judged = judges_.take();
  if (!judged) return false;
  judged_ = std::move(judged);
  judge_problem_.clear();
  return true;
}

/// So small that a picture is done in time, by what the last one took.
int Session::divisor() const {
  if (!is_moving() || !drawing_) return 1;
  const Place& place = drawing_->job.place;
  const double full_s = seconds_per_pixel_ * double(place.width_px) * double(place.height_px);
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(full_s / kMovingFrame_s))), 1, kGreatestDivisor);
}

void Session::ask_drawing(const ViewState& state) {
  if (state.width_px < 1 || state.height_px < 1) return;
  const int smaller = divisor();
  const int width_px = std::max(1, state.width_px / smaller),
            height_px = std::max(1, state.height_px / smaller);
  const std::string extras = extras_key(state);
  const bool is_asked = state.place_version == asked_place_ && state.run_version == asked_run_ &&
                        extras == asked_extras_ && asked_width_px_ == width_px;
  // What moves is drawn one after the other: dropping the waiting one again and again would show nothing.
  if (is_asked || (is_moving() && draws_.is_busy())) return;
  DrawJob job;
  job.place = place_of(state);
  job.run_version = state.run_version;
  job.request = {.width_px = width_px,
                 .height_px = height_px,
                 .technique = state.shown().folder.string(),
                 .parameters = smaller > 1 ? with_small_maps(state) : state.shown_values()};
  job.wants_times = state.wants_times && width_px == state.width_px && !is_moving();
  job.wants_maps = state.layer == Layer::maps;
  if (state.layout == Layout::resource) job.resource = state.resource;
  draws_.ask(std::move(job));
  asked_place_ = state.place_version;
  asked_run_ = state.run_version;
  asked_width_px_ = width_px;
  asked_extras_ = extras;
}

/// The truth has the processor to itself: it begins when the picture is there, and stops when something moves.
void Session::ask_truth(const ViewState& state) {
  if (asked_truth_ == state.place_version) return;
  if (asked_truth_ != 0 && truths_.is_busy()) truths_.cancel();
  if (is_moving() || !(is_full(state) || has_failed(state))) return;
  truths_.ask(place_of(state));
  asked_truth_ = state.place_version;
}

void Session::ask_judge(const ViewState& state) {
  const TruthPass* pass = truth(state);
  if (pass == nullptr || !is_full(state) || !problem_.empty()) return;
  if (judged_place_ == state.place_version && judged_run_ == state.run_version && judged_pass_ == pass->pass)
    return;
  judges_.ask(
      {test_, pass->image, state.camera.eye_world, state.place_version, state.run_version, pass->pass});
  judged_place_ = state.place_version;
  judged_run_ = state.run_version;
  judged_pass_ = pass->pass;
}

}  // namespace umbrameter
