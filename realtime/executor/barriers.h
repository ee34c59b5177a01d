// SPDX-License-Identifier: Apache-2.0
#pragma once
// What shaders store is seen by later passes only behind barriers (OpenGL 4.5, 7.13.2). They follow from what passes read
// and write.

#include "realtime/executor/plan.h"

namespace umbrameter {

/// Sets the barriers of all steps that are drawn and of the frame's end: as few as are needed, none without compute passes.
void place_barriers(Plan& plan);

}  // namespace umbrameter
