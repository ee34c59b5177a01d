// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parts of umbrameter._core, one file each.

#include <pybind11/pybind11.h>

namespace umbrameter::python {

namespace py = pybind11;

void add_images(py::module_& module);
void add_scenes(py::module_& module);
void add_renderers(py::module_& module);
void add_engines(py::module_& module);
void add_score(py::module_& module);
void add_profiles(py::module_& module);

}  // namespace umbrameter::python
