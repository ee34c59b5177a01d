// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a run's textures hold, told by what was drawn into them: equal keys mean equal texels, whichever run drew them.

#include "realtime/executor/plan.h"

#include <map>
#include <string>
#include <vector>

namespace umbrameter {

/// A texture or buffer that a step reads, draws into or blends with, and the key of what it holds just before.
struct TextureUse {
  std::string name;
  std::string content;  // empty: not known
};

struct StepUse {
  size_t step = 0;                 // in Plan::steps
  std::vector<TextureUse> reads;   // what it samples
  std::vector<TextureUse> writes;  // what it draws into: where it writes a part, the rest stays
};

struct RunContents {
  std::vector<StepUse> steps;               // in the order in which a plan's first frame draws them
  std::map<std::string, std::string> last;  // of every texture that is written, after that frame
};

/// `picture_key` tells scene, camera, light and size apart. A key takes in all that decides what a pass draws: shaders, the
/// uniforms that they name, fixed-function state, the shapes of targets, and the keys of what it reads.
RunContents find_contents(const Plan& plan, const RunInputs& inputs, const std::string& picture_key);

}  // namespace umbrameter
