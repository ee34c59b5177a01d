// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tuned parameters as axes of the unit cube: which ones there are, and what a place on one means.

#include "core/parameters.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

using SearchSpace = std::vector<Parameter>;
using Point = std::vector<double>;  // [0,1] per axis
/// Whether a parameter acts on a picture beside complete values; none given: every one does.
using IsActive = std::function<bool(const Parameter&, const ParameterValues&)>;

/// Numbers have an order; choices and booleans are tried one by one.
bool is_ordered(const Parameter& parameter);

/// Counts of work (unit taps, samples, count or px) only ever improve with cost: tuned when named, not by themselves.
bool is_cost_like(const Parameter& parameter);

/// The named parameters, or without names all that a tuner may change and that are not like a cost. Error{input} for
/// unknown names, names given twice, and for a technique that has nothing to tune.
SearchSpace choose_search_space(std::span<const Parameter> parameters, std::span<const std::string> names,
                                std::string_view technique);

/// Distinct values of a choice, a boolean or a number of whole steps; 0 for what is continuous.
int level_count(const Parameter& axis);

/// The value at `position` in [0,1]. Reals have three digits, so that what is written down is what was measured.
ParameterValue value_at(const Parameter& axis, double position);
/// Where the value lies, in the middle of its level.
double position_of(const Parameter& axis, const ParameterValue& value);

/// The value one step (a level, or a twentieth of the axis) to either side; absent at the end and without order.
std::optional<ParameterValue> neighbour(const Parameter& axis, const ParameterValue& value, int direction);

/// One value per axis, the others as in `base`.
ParameterValues values_at(const SearchSpace& space, const Point& point, const ParameterValues& base);
Point point_of(const SearchSpace& space, const ParameterValues& values);

/// `values` with every axis that does not act beside them back at `base`: of all sets with the same picture the one that
/// is rendered.
ParameterValues without_inactive(const SearchSpace& space, const IsActive& is_active,
                                 const ParameterValues& values, const ParameterValues& base);

}  // namespace umbrameter
