// SPDX-License-Identifier: Apache-2.0
#pragma once
// A line of the panel: "name   value", the values in one column.

#include <imgui.h>

#include <string>

namespace umbrameter {

inline const ImVec4 kQuietInk{0.59f, 0.62f, 0.67f, 1.0f};

inline void panel_row(const char* name, const std::string& value) {
  ImGui::TextColored(kQuietInk, "%s", name);
  ImGui::SameLine(170.0f);
  ImGui::TextUnformatted(value.c_str());
}

}  // namespace umbrameter
