// SPDX-License-Identifier: Apache-2.0
#include "view/style.h"

#include <imgui.h>

#include <filesystem>

namespace umbrameter {
namespace {

constexpr float kFontSize_px = 15.0f;
constexpr const char* kFont =
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";  // Debian's fonts-dejavu-core

ImVec4 colour(int red, int green, int blue, float alpha = 1.0f) {
  const auto share = [](int byte) { return static_cast<float>(byte) / 255.0f; };
  return {share(red), share(green), share(blue), alpha};
}

void set_font(float scale) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  std::error_code ignored;
  if (std::filesystem::exists(kFont, ignored)) {
    fonts.AddFontFromFileTTF(kFont, kFontSize_px * scale);
  } else {
    fonts.AddFontDefault();
    ImGui::GetIO().FontGlobalScale = scale;
  }
}

}  // namespace

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGui::GetIO().IniFilename = nullptr;  // nothing is written beside what one asks for
  set_font(scale);
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.ChildRounding = 0.0f;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3.0f;
  style.WindowBorderSize = 0.0f;
  style.WindowPadding = {12, 10};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {8, 6};
  style.ScrollbarSize = 12.0f;
  ImVec4* colours = style.Colors;
  colours[ImGuiCol_WindowBg] = colour(29, 33, 40);
  colours[ImGuiCol_PopupBg] = colour(36, 41, 50);
  colours[ImGuiCol_FrameBg] = colour(45, 51, 62);
  colours[ImGuiCol_FrameBgHovered] = colour(56, 64, 78);
  colours[ImGuiCol_FrameBgActive] = colour(66, 76, 94);
  colours[ImGuiCol_Header] = colour(41, 48, 60);
  colours[ImGuiCol_HeaderHovered] = colour(52, 62, 80);
  colours[ImGuiCol_HeaderActive] = colour(60, 72, 94);
  colours[ImGuiCol_Button] = colour(50, 58, 72);
  colours[ImGuiCol_ButtonHovered] = colour(64, 76, 98);
  colours[ImGuiCol_ButtonActive] = colour(28, 95, 184);
  colours[ImGuiCol_SliderGrab] = colour(96, 150, 224);
  colours[ImGuiCol_SliderGrabActive] = colour(127, 178, 255);
  colours[ImGuiCol_CheckMark] = colour(127, 178, 255);
  colours[ImGuiCol_Text] = colour(230, 232, 236);
  colours[ImGuiCol_TextDisabled] = colour(150, 158, 172);
  colours[ImGuiCol_Separator] = colour(58, 64, 75);
  style.ScaleAllSizes(scale);
}

}  // namespace umbrameter
