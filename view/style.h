// SPDX-License-Identifier: Apache-2.0
#pragma once
// How the window's panels look.

namespace umbrameter {

/// Colours, spacing and font of the current ImGui context; `scale` is the screen's.
void set_style(float scale);

}  // namespace umbrameter
