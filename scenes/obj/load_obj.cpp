// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/load_obj.h"

#include "core/error.h"
#include "scenes/obj/obj_builder.h"

#include <istream>

// The only place that sees tinyobjloader; its warnings are not ours.
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

namespace umbrameter {
namespace {

ObjBuilder& builder(void* user_data) {
  return *static_cast<ObjBuilder*>(user_data);
}

void add_face(void* user_data, tinyobj::index_t* indices, int count) {
  std::vector<ObjCorner> corners;
  for (int i = 0; i < count; ++i) corners.push_back({indices[i].vertex_index, indices[i].normal_index});
  builder(user_data).add_face(corners);
}

std::string trimmed(const std::string& name) {
  const size_t first = name.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return name.substr(first, name.find_last_not_of(" \t") - first + 1);
}

tinyobj::callback_t callbacks() {
  tinyobj::callback_t result;
  result.vertex_cb = [](void* data, double x, double y, double z, double) {
    builder(data).add_position({x, y, z});
  };
  result.normal_cb = [](void* data, double x, double y, double z) { builder(data).add_normal({x, y, z}); };
  result.index_cb = add_face;
  result.usemtl_cb = [](void* data, const char* name, int) { builder(data).set_material(trimmed(name)); };
  result.object_cb = [](void* data, const char* name) { builder(data).set_object(trimmed(name)); };
  result.group_cb = [](void* data, const char** names, int count) {
    std::string joined;
    for (int i = 0; i < count; ++i) joined += (i > 0 ? " " : "") + std::string(names[i]);
    builder(data).set_group(joined);
  };
  return result;
}

}  // namespace

MeshData load_obj(const std::filesystem::path& path, const ObjFilter& filter,
                  std::vector<std::string>& warnings) {
  ObjLines lines(open_bytes(path), path.string());
  std::istream stream(&lines);
  stream.exceptions(std::ios::badbit);  // lets our own errors through
  ObjBuilder result(lines, filter);
  tinyobj::LoadObjWithCallback(stream, callbacks(), &result);
  return result.finish(warnings);
}

}  // namespace umbrameter
