// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "core/image.h"
#include "core/image_io.h"
#include "python/bindings.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace umbrameter::python {
namespace {

using Plane = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Shares the image's memory and keeps `owner` alive; not to be written, as others may see the image, too.
py::array plane_view(const py::object& owner, const Image& image, const std::string& channel) {
  const auto plane = image.plane(channel);
  py::array view(py::dtype::of<float>(), {image.height, image.width}, {}, plane.data(), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

void set_plane(Image& image, const std::string& channel, const Plane& values) {
  if (values.ndim() != 2 || values.shape(0) != image.height || values.shape(1) != image.width) {
    fail_input(fmt::format("channel '{}' must be an array of {} rows and {} columns", channel, image.height,
                           image.width));
  }
  std::copy_n(values.data(), image.pixel_count(), image.add_plane(channel).begin());
}

}  // namespace

void add_images(py::module_& module) {
  py::class_<Image>(module, "Image")
      .def(py::init([](int width, int height) {
             if (width < 1 || height < 1) fail_input(fmt::format("an image of {} x {} px", width, height));
             return Image(width, height);
           }),
           py::arg("width"), py::arg("height"))
      .def_readonly("width", &Image::width)
      .def_readonly("height", &Image::height)
      .def_property_readonly("channels",
                             [](const Image& image) {
                               std::vector<std::string> names;
                               for (const auto& [name, plane] : image.planes) names.push_back(name);
                               return names;
                             })
      .def_property_readonly("metadata",
                             [](const Image& image) {
                               py::dict all;
                               for (const auto& [key, text] : image.metadata) all[py::str(key)] = text;
                               return all;
                             })
      .def("plane",
           [](const py::object& self, const std::string& channel) {
             return plane_view(self, self.cast<const Image&>(), channel);
           })
      .def("set_plane", &set_plane, py::arg("channel"), py::arg("values"))
      .def(
          "write", [](const Image& image, const std::string& file) { write_exr(file, image); },
          py::call_guard<py::gil_scoped_release>());
  module.def(
      "read_image", [](const std::string& file) { return read_image(file); },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace umbrameter::python
