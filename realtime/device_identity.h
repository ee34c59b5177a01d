// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which device a real-time renderer draws on, known before it draws.

#include "core/renderer.h"

#include <string>

namespace umbrameter {

/// Name and version of the device and its driver: pictures of equal identities are comparable bit by bit. `renderer` is one of
/// make_realtime_renderer().
std::string device_identity(const Renderer& renderer);

}  // namespace umbrameter
