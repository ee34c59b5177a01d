// SPDX-License-Identifier: Apache-2.0
#include "lab/score.h"

#include "core/error.h"
#include "lab/pictures/picture_json.h"
#include "lab/pictures/picture_score.h"
#include "python/bindings.h"
#include "results/json/run_json.h"
#include "results/pictures/pictures.h"

#include <nlohmann/json.hpp>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>

namespace umbrameter::python {
namespace {

/// The record as `umbrameter score --json` has it, and what it has per pixel; not the pictures.
struct ScoreAnswer {
  std::string json;
  int width = 0;
  int height = 0;
  std::vector<uint8_t> scored;            // empty when the surfaces disagree
  std::vector<FaultClass> fault_classes;  // empty when there is no diagnosis
};

/// A plane of bytes that shares the answer's memory; None when the score lacks it.
template <class Byte>
py::object bytes_view(const py::object& owner, const std::vector<Byte>& bytes) {
  if (bytes.empty()) return py::none();
  const auto& answer = owner.cast<const ScoreAnswer&>();
  py::array view(py::dtype::of<uint8_t>(), {answer.height, answer.width}, {},
                 reinterpret_cast<const uint8_t*>(bytes.data()), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

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
  PictureScore result = score_picture(scored, truth, {eye_world[0], eye_world[1], eye_world[2]}, settings,
                                      parse_shadow_quantity(quantity));
  if (result.score.no_diagnosis)
    throw Error(result.score.no_diagnosis->kind, result.score.no_diagnosis->message);
  return {picture_json(result, "picture", "truth").dump(), truth.width, truth.height,
          std::move(result.score.mask), std::move(result.score.fault_classes)};
}

}  // namespace

void add_score(py::module_& module) {
  py::class_<ScoreAnswer>(module, "ScoreAnswer")
      .def_readonly("json", &ScoreAnswer::json)
      .def_property_readonly("fault_map",
                             [](const py::object& self) {
                               return bytes_view(self, self.cast<const ScoreAnswer&>().fault_classes);
                             })
      .def_property_readonly("scored", [](const py::object& self) {
        return bytes_view(self, self.cast<const ScoreAnswer&>().scored);
      });
  py::list colours;
  for (const FaultLegend& entry : fault_legend())
    colours.append(py::make_tuple(entry.colour[0], entry.colour[1], entry.colour[2]));
  module.attr("fault_colours") = py::tuple(colours);
  std::vector<std::string> names;
  for (size_t i = 0; i < kFaultClasses; ++i) names.emplace_back(name_of(static_cast<FaultClass>(i)));
  module.attr("fault_names") = py::tuple(py::cast(names));
  module.attr("metrics") = catalogue_json().dump();
  module.def("eye_of", [](const Image& truth) {
    const glm::dvec3 eye = eye_of(truth, "truth");
    return std::array<double, 3>{eye.x, eye.y, eye.z};
  });
  module.def("score", &answer, py::arg("picture"), py::arg("truth"), py::arg("eye_world"), py::arg("metrics"),
             py::arg("limit_rmse"), py::arg("quantity"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace umbrameter::python
