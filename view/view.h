// SPDX-License-Identifier: Apache-2.0
#pragma once
// The live window: a technique and the truth side by side while one flies, turns and tunes (docs/view.md).

#include "core/renderer.h"
#include "realtime/manifest/technique.h"
#include "scenes/scene.h"
#include "view/script.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A scene that can be opened by its name.
struct SceneChoice {
  std::string name, title;
  std::string missing;  // what it needs and is not there; empty: nothing
};

struct ViewSetup {
  Scene scene;                           // with all its lights; the active one is shown first
  std::string scene_name;                // for titles and file names
  std::optional<AnimationTime> at = {};  // that the command line chose for this scene
  std::vector<SceneChoice> scenes;
  std::function<Scene(const std::string&)> load_scene;  // by name or file; called on a thread of its own
  std::vector<Technique> techniques;
  std::string technique;                                     // the id of the first one
  ParameterValues parameters;                                // of that one
  std::function<std::unique_ptr<Renderer>()> open_renderer;  // real time; called on the thread that draws
  std::filesystem::path techniques_folder, shaders_folder;   // files saved there are drawn at once
  int threads = 0;                                           // of the truth; 0 = all
  int width_px = 960, height_px = 540;                       // of the picture at the start
  std::filesystem::path folder;                              // where files are saved
  std::vector<ScriptStep> script;  // done one after the other; none: a person sits there
};

/// What the window measured of itself.
struct ViewReport {
  std::string device;  // that draws the techniques
  int moving_frames = 0;
  std::optional<double> moving_fps;    // pictures a second while the camera moved
  std::optional<double> full_frame_s;  // the last picture at full size, readback included
  std::optional<double> truth_s;       // until the last place's truth had the samples that promise kWantedSe
  std::optional<double> truth_se_rms, truth_se_max;  // standard errors of the last truth
  std::optional<double> rmse;                        // of the last technique
  std::string problem;  // why the last picture could not be drawn; empty when it could
  int switches = 0;     // of techniques
  double memory_first_mib = 0.0,
         memory_last_mib = 0.0;  // resident: at the first switch after `mark`, and at the end
};
inline constexpr double kWantedSe = 0.02;

/// Opens the window and comes back when it is closed or the script ends. Error{environment} without a display or GL;
/// Error{input} for a script that cannot be followed.
ViewReport run_view(ViewSetup setup);

}  // namespace umbrameter
