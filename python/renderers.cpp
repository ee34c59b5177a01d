// SPDX-License-Identifier: Apache-2.0
#include "python/bindings.h"
#include "python/interruption.h"
#include "python/parameters.h"
#include "realtime/manifest/technique.h"
#include "realtime/realtime.h"
#include "reference/reference.h"
#include "results/metadata.h"

#include <pybind11/stl.h>

#include <algorithm>

namespace umbrameter::python {
namespace {

/// Values as Python has them: bool, int, float, str. "preset" chooses one.
ParameterValues overrides_of(const Technique& technique,
                             const std::map<std::string, ParameterValue>& values) {
  ParameterValues overrides;
  for (const auto& [name, value] : values) {
    const bool is_pseudo = name == "preset" || name.starts_with("stage.");
    overrides[name] =
        is_pseudo
            ? value
            : parse_parameter_value(find_parameter(technique.parameters, name, technique.id), to_text(value));
  }
  return overrides;
}

/// GL contexts belong to one thread, so each has its own.
Renderer& realtime_of_this_thread(const std::string& data, const std::string& device) {
  thread_local std::string key;
  thread_local std::unique_ptr<Renderer> renderer;
  const std::string wanted = data + '\n' + device;
  if (renderer && key == wanted) return *renderer;
  renderer.reset();
  const std::filesystem::path root(data);
  renderer = make_realtime_renderer({.techniques_folder = root / "realtime" / "techniques",
                                     .shaders_folder = root / "realtime" / "shaders",
                                     .device = device});
  key = wanted;
  return *renderer;
}

Frame render_truth(const std::shared_ptr<Scene>& scene, const RenderRequest& request,
                   const ReferenceSettings& settings) {
  const Interruptible interruptible;
  InterruptibleProgress progress;
  Frame frame = make_reference_renderer(settings)->render(*scene, request, progress);
  InterruptibleProgress::check();
  add_metadata(frame, *scene, request);
  return frame;
}

Frame render_technique(const std::shared_ptr<Scene>& scene, RenderRequest request,
                       const std::map<std::string, ParameterValue>& parameters, const std::string& data,
                       const std::string& device) {
  const Technique technique =
      find_technique(request.technique, std::filesystem::path(data) / "realtime" / "techniques");
  if (!technique.supports(scene->light().type)) {
    fail_input(fmt::format("technique '{}' does not support the {} light of scene '{}'", technique.id,
                           to_text(scene->light().type), scene->name));
  }
  request.parameters = resolve_parameters(technique, overrides_of(technique, parameters));
  const Interruptible interruptible;
  InterruptibleProgress progress;
  Frame frame = realtime_of_this_thread(data, device).render(*scene, request, progress);
  InterruptibleProgress::check();
  add_metadata(frame, *scene, request);
  return frame;
}

py::list list_all(const std::string& data) {
  py::list all;
  for (const Technique& technique :
       list_techniques(std::filesystem::path(data) / "realtime" / "techniques")) {
    py::list presets, lights;
    for (const Preset& preset : technique.presets) presets.append(preset.name);
    for (const LightType light : technique.lights) lights.append(std::string(to_text(light)));
    py::dict entry;
    entry["id"] = technique.id;
    entry["title"] = technique.title;
    entry["summary"] = technique.summary;
    entry["lights"] = lights;
    entry["parameters"] = parameter_entries(technique.parameters);
    entry["presets"] = presets;
    all.append(entry);
  }
  return all;
}

}  // namespace

py::list parameter_entries(const std::vector<Parameter>& parameters) {
  py::list all;
  for (const Parameter& p : parameters) {
    py::dict parameter;
    parameter["name"] = p.name;
    parameter["type"] = std::string(to_text(p.type));
    parameter["default"] = p.default_value;
    parameter["min"] = p.min;
    parameter["max"] = p.max;
    parameter["choices"] = p.choices;
    parameter["unit"] = p.unit;
    parameter["doc"] = p.doc;
    all.append(parameter);
  }
  return all;
}

void add_renderers(py::module_& module) {
  py::class_<Frame>(module, "Frame")
      .def_property_readonly(
          "image", [](Frame& frame) -> Image& { return frame.image; },
          py::return_value_policy::reference_internal)
      .def_readonly("device", &Frame::device)
      .def_readonly("is_software", &Frame::is_software)
      .def_readonly("memory_bytes", &Frame::memory_bytes)
      .def_readonly("wall_time_s", &Frame::wall_time_s)
      .def_readonly("warnings", &Frame::warnings)
      .def_readonly("left_out", &Frame::left_out)
      .def_property_readonly("parameters", [](const Frame& frame) {
        return std::map<std::string, ParameterValue>(frame.parameters.begin(), frame.parameters.end());
      });
  module.def("list_techniques", &list_all, py::arg("data"));
  module.def(
      "truth",
      [](const std::shared_ptr<Scene>& scene, int width, int height, int samples,
         std::optional<double> target_se, uint64_t seed, int threads) {
        return render_truth(
            scene, {.width_px = width, .height_px = height, .seed = seed, .technique = {}, .parameters = {}},
            {.samples_per_pixel = samples, .target_se = target_se, .threads = threads});
      },
      py::arg("scene"), py::arg("width"), py::arg("height"), py::arg("samples"), py::arg("target_se"),
      py::arg("seed"), py::arg("threads"), py::call_guard<py::gil_scoped_release>());
  module.def(
      "render",
      [](const std::shared_ptr<Scene>& scene, const std::string& technique,
         const std::map<std::string, ParameterValue>& parameters, int width, int height, uint64_t seed,
         const std::string& data, const std::string& device) {
        return render_technique(
            scene,
            {.width_px = width, .height_px = height, .seed = seed, .technique = technique, .parameters = {}},
            parameters, data, device);
      },
      py::arg("scene"), py::arg("technique"), py::arg("parameters"), py::arg("width"), py::arg("height"),
      py::arg("seed"), py::arg("data"), py::arg("device"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace umbrameter::python
