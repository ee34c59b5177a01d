// SPDX-License-Identifier: Apache-2.0
#pragma once
// tune.json; its keys are described in docs/tuning.md.

#include "study/tune/tune.h"

#include <string>

namespace umbrameter {

std::string to_json_text(const TunePlan& plan, const TuneResult& result);

}  // namespace umbrameter
