// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a frame finds of the one before it: its textures and buffers, under "previous.<name>" where passes read them so.

#include "realtime/executor/contents.h"

namespace umbrameter {

/// Gives `next`, which is not attached yet, the textures of `earlier`, so that no frame needs new ones: what passes read as
/// previous.<name> is what `earlier` left in <name>, and <name> takes the memory of what that was before. Error{input} for
/// a texture that changes its shape from frame to frame.
void hand_over(const Technique& technique, const Plan& earlier, Plan& next);

/// Marks the steps of `next` that would draw once more what textures of `earlier`, handed over, hold.
void keep_unchanged(const RunContents& earlier, const RunContents& contents, Plan& next);

/// Clears what the first frame, attached, would find of one before it to 0.
void clear_previous(const Technique& technique, const Plan& first);

}  // namespace umbrameter
