// SPDX-License-Identifier: Apache-2.0
#pragma once
// Statements of pbrt that change the current transform.

#include "scenes/pbrt/pbrt_tokens.h"

#include <glm/mat4x4.hpp>

#include <map>
#include <optional>
#include <string>

namespace umbrameter {

/// Coordinate systems by name.
using PbrtSystems = std::map<std::string, glm::dmat4>;

/// `ctm` after `statement`, whose arguments are taken; absent where it is no such statement. Error{input} for numbers that are
/// missing or not finite, vectors without a direction, and systems that are not there.
std::optional<glm::dmat4> read_pbrt_transform(const std::string& statement, const glm::dmat4& ctm,
                                              const PbrtSystems& systems, PbrtTokens& tokens,
                                              const FileLocation& where);

/// A name in quotes, taken.
std::string pbrt_word(PbrtTokens& tokens, const FileLocation& where);

}  // namespace umbrameter
