// SPDX-License-Identifier: Apache-2.0
#include "view/live_view.h"

#include "view/panels.h"
#include "view/script_run.h"

#include <algorithm>
#include <fstream>

#include <malloc.h>
#include <unistd.h>

namespace umbrameter {
namespace {

constexpr int kPanelWidth_px = 400;
constexpr double kIdleWait_s = 0.25, kBusyWait_s = 0.033, kScriptWait_s = 0.033;

ViewState first_state(const ViewSetup& setup) {
  ViewState state;
  state.techniques = setup.techniques;
  state.diagonal_world = setup.scene.bounds_world.diagonal();
  state.camera = state.first_camera = setup.scene.camera;
  state.lights = state.first_lights = setup.scene.lights;
  state.light = setup.scene.active_light;
  choose_technique(state, setup.technique);
  const Technique& shown = state.shown();
  state.shown_values() =
      in_world(shown.parameters, resolve_parameters(shown, setup.parameters), state.diagonal_world);
  set_size(state, setup.width_px, setup.height_px);
  state.resource.resource = "visibility";
  return state;
}

/// Those of `values` that mean the same in another scene and are not the default.
ParameterValues portable(const Technique& technique, const ParameterValues& values) {
  ParameterValues kept;
  for (const Parameter& parameter : technique.parameters) {
    const ParameterValue& value = values.at(parameter.name);
    if (!parameter.is_relative_to_scene && value != parameter.default_value) kept[parameter.name] = value;
  }
  return kept;
}

/// The technique where the light lets it, else the first that does.
const Technique& fitting(const std::vector<Technique>& techniques, const Technique& wanted, LightType light) {
  if (wanted.supports(light)) return wanted;
  const auto found =
      std::ranges::find_if(techniques, [&](const Technique& technique) { return technique.supports(light); });
  return found == techniques.end() ? wanted : *found;
}

/// Pictures and maps go back to the system when they are freed. Left alone, glibc raises this limit with every large block
/// freed and puts the next ones between small ones, which hold their pages: hundreds of MiB over 500 techniques.
void give_large_blocks_back() {
#ifdef __GLIBC__
  constexpr int kLarge_bytes = 256 << 10;
  mallopt(M_MMAP_THRESHOLD, kLarge_bytes);
#endif
}

}  // namespace

double resident_mib() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

LiveView::LiveView(ViewSetup setup)
    : setup_(std::move(setup)),
      state_(first_state(setup_)),
      window_(setup_.width_px + kPanelWidth_px, setup_.height_px, "Umbrameter: " + setup_.scene_name, *this),
      session_(std::make_unique<Session>(setup_, Window::wake)),
      scenes_([load = setup_.load_scene] { return open_loading(load); }, Window::wake),
      files_({setup_.techniques_folder, setup_.shaders_folder, state_.shown().folder}),
      fly_speed_world_(0.1 * state_.diagonal_world) {}

ViewReport LiveView::run() {
  ScriptRun script(*this, setup_.script);
  Clock::time_point last = Clock::now();
  while (!window_.wants_to_close()) {
    const double seconds = std::min(seconds_since(last), 0.1);
    last = Clock::now();
    move_by_keys(seconds);
    follow_path(seconds);
    watch_files();
    frame(script.is_done() ? frame_wait_s() : std::min(frame_wait_s(), kScriptWait_s));
    if (!setup_.script.empty() && !script.advance()) break;
  }
  return report();
}

double LiveView::frame_wait_s() const {
  if (!held_.empty() || playing_s_) return 0.008;
  return session_->is_working() || scenes_.is_busy() || session_->is_moving() ? kBusyWait_s : kIdleWait_s;
}

void LiveView::frame(double wait_s) {
  window_.begin_frame(wait_s);
  take_scene();
  lay_out();
  session_->update(state_);
  const TruthPass* truth = session_->truth(state_);
  if (truth != nullptr && truth->promised_se <= kWantedSe && truth_place_version_ != state_.place_version) {
    truth_s_ = truth->wall_time_s;
    truth_place_version_ = state_.place_version;
  }
  repaint();
  draw_panes();
  draw_notes();
  if (has_panel_) draw_panel();
  Picture window;
  const std::vector<SaveRequest> saves = take_saves();
  window_.end_frame(saves.empty() ? nullptr : &window);
  for (const SaveRequest& request : saves) save(request, window);
}

void LiveView::open_scene(const std::string& name) {
  opening_ = name;
  scenes_.ask(name);
}

void LiveView::take_scene() {
  const std::optional<LoadedScene> loaded = scenes_.take();
  if (!loaded) return;
  opening_.clear();
  if (loaded->scene) return show_scene(*loaded);
  if (!setup_.script.empty()) fail_input(loaded->problem);
  say(loaded->problem);
}

/// What was chosen stays as far as it means the same there. The threads of the scene before end behind the window's back.
void LiveView::show_scene(const LoadedScene& loaded) {
  const ViewState before = state_;
  setup_.scene = *loaded.scene;
  setup_.at.reset();  // others stand as their files have them
  setup_.scene_name = loaded.name;
  const Technique& technique = fitting(before.techniques, before.shown(), setup_.scene.light().type);
  setup_.technique = technique.id;
  setup_.parameters =
      technique.id == before.shown().id ? portable(technique, before.shown_values()) : ParameterValues();
  setup_.techniques = before.techniques;
  state_ = first_state(setup_);
  state_.layout = before.layout;
  state_.layer = before.layer;
  state_.split = before.split;
  state_.paint = before.paint;
  state_.paint.white_irradiance = PaintSettings().white_irradiance;
  fly_speed_world_ = 0.1 * state_.diagonal_world;
  path_.clear();
  is_recording_ = false;
  playing_s_.reset();
  saves_.clear();
  painted_.clear();
  truth_place_version_ = 0;
  closing_ = std::async(std::launch::async, [old = std::move(session_)]() mutable { old.reset(); });
  session_ = std::make_unique<Session>(setup_, Window::wake);
  window_.set_title("Umbrameter: " + setup_.scene_name);
}

void LiveView::watch_files() {
  if (!files_.has_changed()) return;
  const auto failure = guarded([&] {
    const std::filesystem::path folder = state_.shown().folder;
    state_.techniques[state_.technique] =
        load_technique(folder, setup_.techniques_folder / "shared", setup_.shaders_folder);
    const Technique& shown = state_.shown();
    ParameterValues kept;  // of the parameters that are still there
    for (const auto& [name, value] : state_.shown_values())
      if (std::ranges::find(shown.parameters, name, &Parameter::name) != shown.parameters.end())
        kept[name] = value;
    state_.shown_values() =
        in_world(shown.parameters, resolve_parameters(shown, kept), state_.diagonal_world);
  });
  ++state_.run_version;
  say(failure ? failure->message : "shaders were read again");
}

ViewReport LiveView::report() const {
  ViewReport report;
  if (const Drawing* drawing = session_->drawing()) report.device = drawing->frame.device;
  const auto& intervals_s = session_->moving_intervals_s();
  report.moving_frames = static_cast<int>(intervals_s.size());
  double sum_s = 0.0;
  for (const double interval_s : intervals_s) sum_s += interval_s;
  if (sum_s > 0.0) report.moving_fps = static_cast<double>(intervals_s.size()) / sum_s;
  if (session_->full_frame_s() > 0.0) report.full_frame_s = session_->full_frame_s();
  if (truth_place_version_ == state_.place_version) report.truth_s = truth_s_;
  if (const TruthPass* truth = session_->truth(state_))
    report.truth_se_rms = truth->se_rms, report.truth_se_max = truth->se_max;
  const Judged* judged = session_->judged(state_);
  if (judged != nullptr && judged->score.error && judged->score.error->rmse)
    report.rmse = judged->score.error->rmse->value;
  report.problem = session_->problem();
  report.switches = switches_;
  report.memory_first_mib = memory_first_mib_;
  report.memory_last_mib = resident_mib();
  return report;
}

ViewReport run_view(ViewSetup setup) {
  give_large_blocks_back();
  return LiveView(std::move(setup)).run();
}

}  // namespace umbrameter
