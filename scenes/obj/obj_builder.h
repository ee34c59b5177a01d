// SPDX-License-Identifier: Apache-2.0
#pragma once
// Collects the statements of an OBJ file into a mesh; load_obj.cpp calls it from tinyobjloader's callbacks.

#include "scenes/obj/load_obj.h"
#include "scenes/obj/obj_cutouts.h"
#include "scenes/obj/obj_lines.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// One corner of a face as written: 1-based or negative (relative) indices; 0 = none.
struct ObjCorner {
  int position = 0;
  int normal = 0;
  int texture = 0;
};

class ObjBuilder {
 public:
  ObjBuilder(ObjLines& lines, const MeshFilter& filter);

  void add_position(const glm::dvec3& p);
  void add_normal(const glm::dvec3& n);
  void add_texture_point(const glm::dvec2& uv);
  void read_library(const std::string& name) {
    if (filter_.masks == MeshMasks::own) cutouts_.read_library(name, mesh_.triangles.size());
  }
  void add_face(std::span<const ObjCorner> corners);
  void set_material(const std::string& name) { set_name(material_, name); }
  void set_group(const std::string& name) { set_name(group_, name); }
  void set_object(const std::string& name) { set_name(object_, name); }

  MeshData finish(std::vector<std::string>& warnings);

 private:
  void set_name(std::string& slot, const std::string& name);
  bool is_kept() const;
  uint32_t label_index();
  uint32_t resolve(int index, size_t count, const char* what) const;
  void require_names_seen() const;
  glm::vec2 texture_point(const ObjCorner& corner) const;
  void add_triangle(const glm::uvec3& positions, const glm::uvec3& normals);
  void finish_normals(std::vector<std::string>& warnings);
  void group_by_label(MeshData& mesh);
  std::string file_name() const;
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const;

  ObjLines& lines_;
  const MeshFilter& filter_;
  MeshData mesh_;
  std::vector<glm::dvec3> normals_;
  std::vector<glm::uvec3>
      triangle_normals_;  // indices into normals_, kNoNormal: none; empty as long as no face has any
  std::vector<uint32_t> triangle_labels_;

  std::vector<glm::vec2> texture_points_;
  ObjCutouts cutouts_;
  bool has_holes_ = false;  // the material in use

  std::string material_, group_, object_;
  std::set<std::string> seen_;  // every name of a material, group or object
  std::map<std::string, uint32_t> labels_;
  std::vector<std::string> label_names_;
  bool names_changed_ = true;
  bool kept_ = true;
  uint32_t label_ = 0;
};

}  // namespace umbrameter
