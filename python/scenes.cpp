// SPDX-License-Identifier: Apache-2.0
#include "python/bindings.h"
#include "scenes/choose_light.h"
#include "scenes/instances.h"
#include "scenes/load_scene.h"

#include <fmt/ranges.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace umbrameter::python {
namespace {

template <class Vector>
py::array rows_of_three(const py::object& owner, const SharedList<Vector>& rows) {
  using Number = typename Vector::value_type;
  py::array view(py::dtype::of<Number>(), {rows.size(), size_t{3}}, {},
                 reinterpret_cast<const Number*>(rows.data()), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

py::tuple three(const glm::dvec3& v) {
  return py::make_tuple(v.x, v.y, v.z);
}

py::list animated_of(const Scene& scene) {
  py::list all;
  for (const AnimatedMesh& mesh : scene.animated) {
    py::dict entry;
    entry["mesh"] = mesh.mesh;
    entry["file"] = mesh.file;
    entry["animation"] = mesh.animation;
    entry["time_s"] = mesh.time_s;
    all.append(entry);
  }
  return all;
}

py::list list_all(const std::string& library, const std::string& assets) {
  py::list all;
  for (const SceneEntry& entry : list_scenes({assets, library, {}})) {
    py::dict scene;
    scene["name"] = entry.name;
    scene["title"] = entry.title;
    scene["file"] = entry.file.string();
    scene["missing_assets"] = entry.missing_assets;
    all.append(scene);
  }
  return all;
}

std::shared_ptr<Scene> load(const std::string& name_or_path, const std::string& library,
                            const std::string& assets, const std::string& light,
                            const std::optional<double>& time_s, const std::string& animation) {
  SceneSearch search{assets, library, {}};
  if (time_s) search.at = AnimationTime{*time_s, animation};
  if (!time_s && !animation.empty()) fail_input("'animation' goes with 'time_s'");
  Scene scene = load_scene(resolve_scene(name_or_path, search), search);
  if (scene.lights.size() > 1) {
    if (light.empty()) {
      std::vector<std::string> names;
      for (const Light& one : scene.lights) names.push_back(one.name);
      fail_input(fmt::format("scene '{}' has {} lights and none is chosen", scene.name, names.size()), {},
                 fmt::format("light= one of {}", fmt::join(names, ", ")));
    }
    const size_t chosen = find_light(scene.lights, light);
    scene = lit_by(std::move(scene), chosen);
  } else if (!light.empty()) {
    find_light(scene.lights, light);
  }
  return std::make_shared<Scene>(std::move(scene));
}

}  // namespace

void add_scenes(py::module_& module) {
  py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene", py::dynamic_attr())
      .def_readonly("name", &Scene::name)
      .def_readonly("title", &Scene::title)
      .def_readonly("hash", &Scene::hash)
      .def_readonly("warnings", &Scene::warnings)
      .def_property_readonly("file", [](const Scene& scene) { return scene.source.file; })
      .def_property_readonly("light", [](const Scene& scene) { return scene.light().name; })
      .def_property_readonly("light_type",
                             [](const Scene& scene) { return std::string(to_text(scene.light().type)); })
      .def_property_readonly("animated", &animated_of)
      .def_property_readonly("eye_world", [](const Scene& scene) { return three(scene.camera.eye_world); })
      .def_property_readonly("instance_count",
                             [](const Scene& scene) { return list_instances(scene).size(); })
      .def_property_readonly("positions_world",
                             [](const py::object& self) {
                               return rows_of_three(self, self.cast<const Scene&>().positions_world);
                             })
      .def_property_readonly("triangles", [](const py::object& self) {
        return rows_of_three(self, self.cast<const Scene&>().triangles);
      });
  module.def("list_scenes", &list_all, py::arg("library"), py::arg("assets"));
  module.def("load_scene", &load, py::arg("name_or_path"), py::arg("library"), py::arg("assets"),
             py::arg("light"), py::arg("time_s"), py::arg("animation"),
             py::call_guard<py::gil_scoped_release>());
}

}  // namespace umbrameter::python
