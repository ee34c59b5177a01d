// SPDX-License-Identifier: Apache-2.0
// What the window writes to files.

#include "core/files.h"
#include "core/image_io.h"
#include "results/metadata.h"
#include "view/live_view.h"
#include "view/scene_text.h"

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

std::vector<Parameter> parameters_in_world(const ViewState& state) {
  std::vector<Parameter> parameters;
  for (const Parameter& parameter : state.shown().parameters)
    parameters.push_back(in_world(parameter, state.diagonal_world));
  return parameters;
}

std::string_view ending_of(Saved what) {
  switch (what) {
    case Saved::picture:
    case Saved::window:
      return ".png";
    case Saved::preset:
      return ".preset.toml";
    case Saved::study:
      return ".study.toml";
    case Saved::path:
      return ".path.toml";
    case Saved::scene:
      return ".toml";
  }
  return {};
}

}  // namespace

/// Those that can be done now: a picture waits until it is the one of what is chosen.
std::vector<SaveRequest> LiveView::take_saves() {
  const bool is_full = session_->is_full(state_) || session_->has_failed(state_);
  std::vector<SaveRequest> now, later;
  for (SaveRequest& request : saves_)
    (request.what != Saved::picture || is_full ? now : later).push_back(std::move(request));
  saves_ = std::move(later);
  return now;
}

/// The first of stem-1, stem-2, ... that is not there.
fs::path LiveView::free_name(std::string_view stem, std::string_view ending) const {
  for (int number = 1;; ++number) {
    const fs::path file = setup_.folder / fmt::format("{}-{}{}", stem, number, ending);
    if (!fs::exists(file)) return file;
  }
}

void LiveView::save(const SaveRequest& request, const Picture& window) {
  const std::string technique = state_.shown().id;
  const std::string stem = file_name_of(setup_.scene_name) + "-" + technique;
  const fs::path file =
      request.file.empty() ? free_name(stem, ending_of(request.what)) : setup_.folder / request.file;
  const std::vector<Parameter> parameters = parameters_in_world(state_);
  const auto failure = guarded([&] {
    switch (request.what) {
      case Saved::picture:
        write_picture(file, state_.layout == Layout::truth ? truth_picture_ : test_picture_);
        break;
      case Saved::window:
        write_picture(file, window);
        break;
      case Saved::scene:
        write_file_atomically(file,
                              scene_toml(setup_.scene, setup_.at, file, state_.camera, state_.shown_light()));
        break;
      case Saved::preset:
        write_file_atomically(file, view_preset_toml(technique, parameters, state_.shown_values()));
        break;
      case Saved::study: {
        const fs::path scene =
            request.file.empty() ? free_name(stem, ".toml") : fs::path(file).replace_extension(".scene.toml");
        write_file_atomically(
            scene, scene_toml(setup_.scene, setup_.at, scene, state_.camera, state_.shown_light()));
        write_file_atomically(
            file, view_study_toml(scene.filename().string(), technique, parameters, state_.shown_values(),
                                  state_.width_px, state_.height_px));
        break;
      }
      case Saved::path:
        write_file_atomically(file, camera_path_toml(path_));
        break;
    }
  });
  if (!failure) return say("saved " + file.string());
  if (!setup_.script.empty()) throw Error(failure->kind, failure->message);
  say(failure->message);
}

}  // namespace umbrameter
