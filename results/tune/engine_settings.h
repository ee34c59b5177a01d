// SPDX-License-Identifier: Apache-2.0
#pragma once
// What engines' light settings call the parameters that we tune. Not here: how an engine computes with them.

#include "core/parameters.h"

#include <string>
#include <string_view>

namespace umbrameter {

/// The settings of engines that stand for the parameter, as a line to read; empty where no engine's light settings have it.
std::string_view engine_settings_of(std::string_view parameter);

/// Whether this value needs no such setting: what a shader without the parameter does.
bool is_neutral(const Parameter& parameter, const ParameterValue& value);

}  // namespace umbrameter
