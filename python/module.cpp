// SPDX-License-Identifier: Apache-2.0
// umbrameter._core: the rooms as Python sees them. Defaults, texts and records are in umbrameter/__init__.py.

#include "python/bindings.h"

#include "core/data_folder.h"
#include "core/error.h"
#include "core/version.h"

#include <dlfcn.h>

namespace umbrameter::python {
namespace {

PyObject* new_exception(py::module_& module, const char* name, const py::tuple& bases) {
  PyObject* type = PyErr_NewException(("umbrameter." + std::string(name)).c_str(), bases.ptr(), nullptr);
  module.attr(name) = py::reinterpret_borrow<py::object>(type);
  return type;
}

/// The one exception type of C++, by who has to act; KeyboardInterrupt for cancelled.
void add_exceptions(py::module_& module) {
  static PyObject* any = new_exception(module, "Error", py::make_tuple(py::handle(PyExc_RuntimeError)));
  static PyObject* input =
      new_exception(module, "InputError", py::make_tuple(py::handle(any), py::handle(PyExc_ValueError)));
  static PyObject* machine = new_exception(module, "MachineError", py::make_tuple(py::handle(any)));
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      switch (error.kind()) {
        case ErrorKind::input:
          PyErr_SetString(input, error.what());
          return;
        case ErrorKind::environment:
          PyErr_SetString(machine, error.what());
          return;
        case ErrorKind::internal:
          PyErr_SetString(any, error.what());
          return;
        case ErrorKind::cancelled:
          PyErr_SetNone(PyExc_KeyboardInterrupt);
          return;
      }
    }
  });
}

/// This library's file: the program is Python's, the data lie beside this.
std::filesystem::path module_file() {
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&module_file), &info) == 0 || info.dli_fname == nullptr)
    fail_environment("the module does not know its own file");
  return std::filesystem::canonical(info.dli_fname);
}

}  // namespace
}  // namespace umbrameter::python

PYBIND11_MODULE(_core, module) {
  using namespace umbrameter;
  using namespace umbrameter::python;
  module.attr("version") = kVersion;
  module.attr("commit") = kCommit;
  add_exceptions(module);
  // .../lib/python3/dist-packages/umbrameter/_core.so and <build>/python/umbrameter/_core.so
  module.attr("file") = module_file().string();
  module.def("data_folder", [] { return find_data_folder(module_file(), 5).string(); });
  add_images(module);
  add_scenes(module);
  add_renderers(module);
  add_engines(module);
  add_score(module);
  add_profiles(module);
}
