// SPDX-License-Identifier: Apache-2.0
#pragma once
// The sections of the window's panel: each draws itself with ImGui and changes what is chosen.

#include "view/live_view.h"

#include <optional>
#include <string>

namespace umbrameter {

/// Parts of the panel that can be folded.
enum class Section : uint8_t { measured, technique, view, light, camera, cursor, faults, passes, save };
inline constexpr size_t kSections = 9;
/// As scripts call it, and as the panel does.
std::string_view title_of(Section section);
const char* heading_of(Section section);

/// What stands over the technique's picture and over the truth's.
std::string test_label(const ViewState& state, const Session& session);
std::string truth_label(const ViewState& state, const Session& session);

/// The scene that one chose. `opening`: the one that is being read.
std::optional<std::string> scene_menu(const ViewSetup& setup, const std::string& opening);
void summary_panel(const ViewState& state, const Session& session);
void technique_panel(ViewState& state);
void view_panel(ViewState& state, const Session& session);
void light_panel(ViewState& state);
void camera_panel(ViewState& state, double& fly_speed_world);
void probe_panel(const ViewState& state, const Session& session);
void faults_panel(const ViewState& state, const Session& session);
void passes_panel(ViewState& state, const Session& session);
/// What one wants to be saved; a camera path only with cameras in it.
std::optional<Saved> save_panel(size_t path_cameras);

/// Every key, in the middle of the pictures.
void help_overlay(float width, float height);

}  // namespace umbrameter
