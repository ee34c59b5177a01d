// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fills the uniform blocks of shaders/shared/frame_data.h.

#include "realtime/shaders/shared/frame_data.h"
#include "realtime/views/light_view.h"
#include "scenes/scene.h"

#include <cstdint>
#include <string_view>

namespace umbrameter {

/// Declares `frame` in a shader; needs shaders/shared among the search folders.
inline constexpr std::string_view kFrameBlockGlsl =
    "#include \"frame_data.h\"\nlayout(std140, binding = 0) uniform FrameBlock { FrameData frame; };\n";
inline constexpr unsigned kFrameBinding = 0;

/// For the scene's camera and active light.
FrameData make_frame_data(const Scene& scene, int width_px, int height_px, uint64_t seed);

/// Point `frame` + 1 of the Halton sequence of bases 2 and 3, less a half: in (-0.5, 0.5).
glm::dvec2 frame_jitter(int frame);

/// Of frame `frame`, counted from the first that is drawn; `previous` is the camera of the frame before, or its own.
HistoryData make_history_data(const Camera& previous, int frame, int width_px, int height_px);

LightViewData make_light_view_data(const LightView& view, int texels_a_side);

}  // namespace umbrameter
