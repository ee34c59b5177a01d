// SPDX-License-Identifier: Apache-2.0
#pragma once
// The small arithmetic of manifests: numbers, names, + - * /, comparisons, && || !, ?:, and
// min max ceil floor log2 pow abs. Nothing else.

#include "core/error.h"

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace umbrameter {

using ExpressionVariables = std::map<std::string, double, std::less<>>;

/// Value of `text`. A name may contain dots (light.width, screen.height). Error{input} at `where` for a
/// syntax error, an unknown name (with the nearest known one), division by zero or a result that is not
/// finite.
double evaluate_expression(std::string_view text, const ExpressionVariables& variables,
                           const FileLocation& where = {});

/// The names an expression uses; Error{input} when it does not parse.
std::set<std::string> expression_names(std::string_view text, const FileLocation& where = {});

}  // namespace umbrameter
