// SPDX-License-Identifier: Apache-2.0
#pragma once
// An engine's files as a frame's planes. Floats only: EXR, HDR, PFM.

#include "core/image.h"
#include "scenes/scene.h"

#include <filesystem>
#include <map>
#include <string>

namespace umbrameter {

/// Files by what they show (engines/host/protocol.h).
using EngineFiles = std::map<std::string, std::filesystem::path>;

/// "visibility" from a picture of it or from the pair lit / unlit, "known" where that ratio says nothing (0) and where it does (1),
/// and as far as they are there position.x/y/z and normal.x/y/z. Position is NaN where nothing is hit; then primitive_id is
/// -1, elsewhere kUnknownPrimitive, so that places and normals must agree with the truth's. Error{environment} for pictures of
/// another size, with NaN or infinite light, cut off, or missing.
Image read_engine_picture(const EngineFiles& files, int width_px, int height_px);

/// No triangle has this number.
inline constexpr float kUnknownPrimitive = static_cast<float>(kMaxTriangles);

}  // namespace umbrameter
