// SPDX-License-Identifier: Apache-2.0
#include "engines/host/manifest.h"
#include "python/bindings.h"
#include "python/parameters.h"

#include <pybind11/stl.h>

namespace umbrameter::python {
namespace {

py::dict entry_of(const Engine& engine) {
  py::list presets;
  for (const EnginePreset& preset : engine.presets) presets.append(preset.name);
  py::dict lights;
  for (const auto& [type, becomes] : engine.lights) lights[py::str(std::string(to_text(type)))] = becomes;
  std::vector<std::string> missing;
  for (const std::filesystem::path& file : engine.missing) missing.push_back(file.string());
  py::dict entry;
  entry["id"] = engine.id;
  entry["title"] = engine.title;
  entry["summary"] = engine.summary;
  entry["form"] = std::string(to_text(engine.form));
  entry["quantity"] = std::string(to_text(engine.quantity));
  entry["lights"] = lights;
  entry["parameters"] = parameter_entries(engine.parameters);
  entry["presets"] = presets;
  entry["known_failures"] = engine.known_failures;
  entry["missing"] = missing;
  return entry;
}

py::list list_all(const std::string& engines, const std::string& installed) {
  std::vector<Engine> found;
  {
    const py::gil_scoped_release unlocked;
    found = list_engines({engines, installed});
  }
  py::list all;
  for (const Engine& engine : found) all.append(entry_of(engine));
  return all;
}

}  // namespace

void add_engines(py::module_& module) {
  module.def("list_engines", &list_all, py::arg("engines"), py::arg("installed"));
  module.def(
      "is_engine",
      [](const std::string& id_or_path, const std::string& engines, const std::string& installed) {
        return !find_engine_folder(id_or_path, {engines, installed}).empty();
      },
      py::arg("id_or_path"), py::arg("engines"), py::arg("installed"));
}

}  // namespace umbrameter::python
