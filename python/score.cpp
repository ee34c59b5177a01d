// SPDX-License-Identifier: Apache-2.0
#include "study/score.h"

#include "core/error.h"
#include "python/bindings.h"
#include "study/picture_score.h"
#include "study/results_json.h"

#include <nlohmann/json.hpp>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>

namespace umbrameter::python {
namespace {

/// The record as `umbrameter score --json` has it, and the fault class of every pixel.
struct ScoreAnswer {
  std::string json;
  int width = 0;
  int height = 0;
  std::vector<FaultClass> fault_classes;  // empty when there is no diagnosis
};

ScoreAnswer answer(const Image& picture, const Image& truth, const std::array<double, 3>& eye_world,
                   const std::string& metrics, std::optional<double> limit_rmse,
                   const std::string& quantity) {
  if (!picture.has("visibility")) fail_input("the picture has no channel 'visibility'");
  require_same_size(picture, truth, "picture and truth");
  require_finite(picture, "visibility");
  EnginePicture scored;
  scored.name = "picture";
  scored.test = picture;
  scored.values.known.assign(picture.pixel_count(), 1);
  scored.values.rounding_sd.assign(picture.pixel_count(), 0.0f);
  ScoreSettings settings;
  settings.metrics = choose_metrics(metrics);
  settings.limit_rmse = limit_rmse;
  const PictureScore result = score_picture(scored, truth, {eye_world[0], eye_world[1], eye_world[2]},
                                            settings, parse_shadow_quantity(quantity));
  if (result.score.no_diagnosis)
    throw Error(result.score.no_diagnosis->kind, result.score.no_diagnosis->message);
  return {picture_json(result, "picture", "truth").dump(), truth.width, truth.height,
          result.score.fault_classes};
}

}  // namespace

void add_score(py::module_& module) {
  py::class_<ScoreAnswer>(module, "ScoreAnswer")
      .def_readonly("json", &ScoreAnswer::json)
      .def_property_readonly("fault_map", [](const py::object& self) -> py::object {
        const auto& answer = self.cast<const ScoreAnswer&>();
        if (answer.fault_classes.empty()) return py::none();
        return py::array(py::dtype::of<uint8_t>(), {answer.height, answer.width}, {},
                         reinterpret_cast<const uint8_t*>(answer.fault_classes.data()), self);
      });
  std::vector<std::string> names;
  for (size_t i = 0; i < kFaultClasses; ++i) names.emplace_back(name_of(static_cast<FaultClass>(i)));
  module.attr("fault_names") = py::tuple(py::cast(names));
  module.def("eye_of", [](const Image& truth) {
    const glm::dvec3 eye = eye_of(truth, "truth");
    return std::array<double, 3>{eye.x, eye.y, eye.z};
  });
  module.def("score", &answer, py::arg("picture"), py::arg("truth"), py::arg("eye_world"), py::arg("metrics"),
             py::arg("limit_rmse"), py::arg("quantity"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace umbrameter::python
