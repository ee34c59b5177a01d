// SPDX-License-Identifier: Apache-2.0
#pragma once
// Two halves of a tuner's work side by side: one picture is scored while the next is drawn.

#include "core/renderer.h"

#include <cstddef>
#include <functional>

namespace umbrameter {

/// Calls `draw(0)`, `draw(1)`, ... on this thread and, one at a time and in order, `score` of what came out on another. A
/// score that is false ends it: one more picture may have been drawn by then, none is scored. What either throws comes out
/// here, once the other is done.
void draw_and_score(size_t count, const std::function<Frame(size_t)>& draw,
                    const std::function<bool(size_t, const Frame&)>& score);

}  // namespace umbrameter
