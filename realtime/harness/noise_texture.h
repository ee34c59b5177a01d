// SPDX-License-Identifier: Apache-2.0
#pragma once
// The built-in noise that passes may read.

#include "realtime/harness/objects.h"

namespace umbrameter {

/// Blue noise (core/sampling/blue_noise.h): (rank + 1/2) / pixels, as r32f.
Texture make_blue_noise();

}  // namespace umbrameter
