// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parameters of techniques and engines as Python's dictionaries.

#include "core/parameters.h"
#include "python/bindings.h"

#include <vector>

namespace umbrameter::python {

/// A dictionary each: name, type, default, min, max, choices, unit and doc.
py::list parameter_entries(const std::vector<Parameter>& parameters);

}  // namespace umbrameter::python
