// SPDX-License-Identifier: Apache-2.0
#include "cli/regress_prove.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/staging.h"
#include "core/error.h"
#include "reference/reference.h"
#include "report/regress_output.h"
#include "study/regress/prove.h"
#include "study/selftest/fault_list.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

constexpr int kProofSamples = 256;
constexpr double kProofTarget = 0.95;  // of the faults named

/// The scenes that the faults are in, but for those whose models are missing.
std::vector<std::string> fault_scenes(const SceneSearch& search) {
  std::vector<std::string> names;
  const std::vector<FaultCase> faults = fault_list();
  for (const SceneEntry& entry : list_scenes(search)) {
    if (entry.missing_assets.empty() &&
        std::ranges::find(faults, entry.name, &FaultCase::scene) != faults.end())
      names.push_back(entry.name);
  }
  return names;
}

}  // namespace

int prove_regress(const std::vector<std::string>& scenes, const GlobalOptions& global) {
  const Home home = find_home();
  std::vector<SceneJob> jobs;
  for (const std::string& name : scenes.empty() ? fault_scenes(scene_search(global, home)) : scenes)
    jobs.push_back(load_scene_job(name, scene_search(global, home)));
  const Staging staging(std::filesystem::temp_directory_path());
  const auto realtime = open_realtime_renderer(global, home);
  const auto reference = make_reference_renderer({kProofSamples, {}, global.threads});
  SelftestSettings settings;
  settings.techniques_folder = home.techniques;
  settings.shaders_folder = home.shaders;
  settings.scratch_folder = staging.folder();
  ProgressBar progress;
  const std::vector<ProvedFault> faults = prove_faults(
      fault_list(), jobs, settings, {*reference, *reference, *realtime}, kProofSamples, {}, progress);
  if (faults.empty()) fail_input("no fault is written for these scenes");
  print_answer(proof_markdown(faults));
  const auto found = std::ranges::count_if(faults, &ProvedFault::is_found);
  const auto named = std::ranges::count_if(faults, &ProvedFault::is_named);
  const auto all = static_cast<double>(faults.size());
  if (static_cast<double>(found) == all && static_cast<double>(named) >= kProofTarget * all) return kExitFine;
  print_error(fmt::format("{} of {} faults found, {} named", found, faults.size(), named));
  return kExitGateFailed;
}

}  // namespace umbrameter
