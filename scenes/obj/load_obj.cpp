// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/load_obj.h"

#include "core/error.h"
#include "scenes/obj/obj_builder.h"

#include <istream>

#define TINYOBJLOADER_IMPLEMENTATION
#include "scenes/obj/tinyobj.h"

namespace umbrameter {
namespace {

ObjBuilder& builder(void* user_data) {
  return *static_cast<ObjBuilder*>(user_data);
}

void add_face(void* user_data, tinyobj::index_t* indices, int count) {
  std::vector<ObjCorner> corners;
  for (int i = 0; i < count; ++i)
    corners.push_back({indices[i].vertex_index, indices[i].normal_index, indices[i].texcoord_index});
  builder(user_data).add_face(corners);
}

/// Hands the names of material libraries on; tinyobjloader itself needs none of them.
class LibraryNames final : public tinyobj::MaterialReader {
 public:
  explicit LibraryNames(ObjBuilder& builder) : builder_(builder) {}
  bool operator()(const std::string& name, std::vector<tinyobj::material_t>*, std::map<std::string, int>*,
                  std::string*, std::string*) override {
    builder_.read_library(name);
    return false;  // the statement's next name, too
  }

 private:
  ObjBuilder& builder_;
};

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
  result.texcoord_cb = [](void* data, double u, double v, double) {
    builder(data).add_texture_point({u, v});
  };
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

MeshData load_obj(const std::filesystem::path& path, const MeshFilter& filter,
                  std::vector<std::string>& warnings) {
  ObjLines lines(open_bytes(path), path.string());
  std::istream stream(&lines);
  stream.exceptions(std::ios::badbit);  // lets our own errors through
  ObjBuilder result(lines, filter);
  LibraryNames library_names(result);
  tinyobj::LoadObjWithCallback(stream, callbacks(), &result, &library_names);
  return result.finish(warnings);
}

}  // namespace umbrameter
