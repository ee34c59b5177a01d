// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/read_pbrt.h"

#include "core/names.h"
#include "scenes/foreign/lamps.h"
#include "scenes/pbrt/pbrt_camera.h"
#include "scenes/pbrt/pbrt_shapes.h"
#include "scenes/pbrt/pbrt_transforms.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using glm::dmat4;
using glm::dvec3;

// Appearance and settings: nothing that a shadow depends on.
constexpr std::array<std::string_view, 12> kOtherStatements = {
    "Sampler",         "Integrator",     "PixelFilter", "Accelerator",       "Option",
    "ColorSpace",      "TransformTimes", "Renderer",    "SurfaceIntegrator", "VolumeIntegrator",
    "MakeNamedMedium", "MediumInterface"};
constexpr std::array<std::string_view, 4> kNoSurface = {"interface", "none", "null", ""};
constexpr std::array<std::string_view, 4> kPbrtGlass = {"dielectric", "thindielectric", "glass",
                                                        "roughdielectric"};
constexpr size_t kMaxStates = 10'000;
constexpr size_t kMaxPbrtShapes = 2'000'000;

template <size_t N>
bool holds(const std::array<std::string_view, N>& list, const std::string& text) {
  return std::ranges::find(list, text) != list.end();
}

class PbrtReader {
 public:
  explicit PbrtReader(const fs::path& path) : tokens_(path), shapes_(scene_) { scene_.path = path; }

  ForeignScene run() {
    while (const auto token = tokens_.next()) {
      where_ = token->where;
      if (token->is_string)
        fail_input(fmt::format("'{}' stands where a statement should", token->text), where_);
      if (!read_transform(token->text) && !read_block(token->text) && !read_object(token->text))
        fail_input(fmt::format("'{}' is no statement of pbrt", token->text), where_);
    }
    if (!states_.empty()) fail_input("a block has no end", states_.back().where);
    if (object_ != nullptr) fail_input("an object has no end", {scene_.path.string()});
    if (camera_)
      add_pbrt_camera(camera_->parameters, ours_from_world_ * camera_->world_from_camera, film_, scene_);
    scene_.side_files.insert(scene_.side_files.end(), tokens_.files().begin() + 1, tokens_.files().end());
    return std::move(scene_);
  }

 private:
  struct State {
    dmat4 ctm{1.0};
    bool reverses = false;
    bool is_at_start = true;  // ActiveTransform EndTime: what moves there is not ours
    std::optional<PbrtParameters> shines = {};
    std::string material = {}, material_name = {};
  };
  struct Block {
    State before;
    std::string kind;
    FileLocation where;
  };
  struct ObjectShape {
    size_t mesh = 0;
    std::string name;
    dmat4 object_from_mesh{1.0};
  };
  struct CameraStatement {
    PbrtParameters parameters;
    dmat4 world_from_camera;
  };

  std::string word() { return pbrt_word(tokens_, where_); }
  PbrtParameters parameters() { return {tokens_, where_}; }

  bool read_transform(const std::string& statement) {
    const auto next = read_pbrt_transform(statement, state_.ctm, systems_, tokens_, where_);
    if (next && state_.is_at_start) state_.ctm = *next;
    return next.has_value();
  }

  void begin(const std::string& kind) {
    if (states_.size() == kMaxStates) fail_input("blocks are nested deeper than 10,000", where_);
    states_.push_back({state_, kind, where_});
  }
  void end(const std::string& kind) {
    if (states_.empty() || states_.back().kind != kind)
      fail_input(fmt::format("'{}End' has no begin", kind), where_);
    const dmat4 ctm = states_.back().before.ctm;
    if (kind == "Transform")
      state_.ctm = ctm;
    else
      state_ = std::move(states_.back().before);
    states_.pop_back();
  }

  bool read_block(const std::string& statement) {
    if (statement == "AttributeBegin" || statement == "TransformBegin") {
      begin(statement.substr(0, statement.size() - 5));
    } else if (statement == "AttributeEnd" || statement == "TransformEnd") {
      end(statement.substr(0, statement.size() - 3));
    } else if (statement == "WorldBegin") {
      state_ = State{};
      systems_["world"] = state_.ctm;
    } else if (statement == "ReverseOrientation") {
      state_.reverses = !state_.reverses;
    } else if (statement == "CoordinateSystem") {
      systems_[word()] = state_.ctm;
    } else if (statement == "ObjectBegin") {
      if (object_ != nullptr) fail_input("an object begins within another", where_);
      begin("Object");
      object_ = &objects_[word()];
      object_->clear();
    } else if (statement == "ObjectEnd") {
      end("Object");
      object_ = nullptr;
    } else if (statement == "ActiveTransform") {
      const auto which = tokens_.next();
      state_.is_at_start = !which || which->text != "EndTime";
      if (!state_.is_at_start)
        scene_.of_meshes.add("motion stands at its start", "motions stand at their start");
    } else if (statement == "Include" || statement == "Import") {
      const fs::path file = scene_.path.parent_path() / word();
      tokens_.open(file, where_);
    } else {
      return statement == "WorldEnd";
    }
    return true;
  }

  bool read_object(const std::string& statement) {
    if (statement == "Camera") {
      read_camera();
    } else if (statement == "Film") {
      word();
      film_ = parameters();
    } else if (statement == "Shape") {
      const std::string type = word();
      add_shape(type, parameters());
    } else if (statement == "ObjectInstance") {
      add_instance(word());
    } else if (statement == "LightSource") {
      const std::string type = word();
      add_lamp(type, parameters());
    } else if (statement == "AreaLightSource") {
      const std::string type = word();
      state_.shines = parameters();
      if (type != "diffuse" && type != "area") scene_.of_views.leave_out("area light", type);
    } else if (statement == "Material") {
      state_.material = word();
      state_.material_name = state_.material;
      parameters();
    } else if (statement == "MakeNamedMaterial") {
      const std::string name = word();
      materials_[name] = parameters().text("type", "");
    } else if (statement == "NamedMaterial") {
      state_.material_name = word();
      const auto known = materials_.find(state_.material_name);
      state_.material = known == materials_.end() ? "diffuse" : known->second;
    } else if (statement == "Texture") {
      const std::string name = word(), type = word(), kind = word();
      const PbrtParameters all = parameters();
      if (type == "float") shapes_.add_texture(name, kind, all);
    } else if (statement == "Attribute") {
      scene_.of_meshes.leave_out("default by 'Attribute'", word());
      parameters();
    } else if (holds(kOtherStatements, statement)) {
      skip_arguments();
    } else {
      return false;
    }
    return true;
  }

  /// Names, numbers and parameters up to the next statement.
  void skip_arguments() {
    while (const PbrtToken* ahead = tokens_.peek()) {
      const bool is_statement = !ahead->is_string && !ahead->text.empty() &&
                                std::isalpha(static_cast<unsigned char>(ahead->text.front())) != 0 &&
                                ahead->text != "true" && ahead->text != "false";
      if (is_statement) return;
      tokens_.next();
    }
  }

  void read_camera() {
    const std::string type = word();
    const PbrtParameters all = parameters();
    const dmat4 camera_from_world = state_.ctm;
    const double side = glm::determinant(glm::dmat3(camera_from_world));
    if (!(std::abs(side) > 0.0)) fail_input("the camera's transform has no inverse", where_);
    const dmat4 world_from_camera = glm::inverse(camera_from_world);
    systems_["camera"] = world_from_camera;
    if (side < 0.0) ours_from_world_ = dmat4(1.0);  // its numbers are right-handed already
    if (type == "perspective")
      camera_ = CameraStatement{all, world_from_camera};
    else
      scene_.of_views.leave_out("camera", type);
  }

  void add_shape(const std::string& type, const PbrtParameters& all) {
    if (holds(kNoSurface, state_.material) && !state_.material_name.empty()) {
      scene_.of_meshes.add("shape without a surface is left out", "shapes without a surface are left out");
      return;
    }
    if (holds(kPbrtGlass, state_.material))
      scene_.of_meshes.add("shape of glass is solid", "shapes of glass are solid");
    if (state_.shines && add_area_light(type, all)) return;
    const auto mesh = shapes_.mesh_of(type, all);
    if (!mesh) return;
    const std::string name = state_.material_name.empty() ? type : state_.material_name;
    const dmat4 own = state_.ctm * mesh->shape_from_mesh;
    if (object_ != nullptr)
      object_->push_back({mesh->mesh, name, own});
    else
      show({mesh->mesh, name, {type}, ours_from_world_ * own});
  }

  void show(ForeignShape shape) {
    if (scene_.shapes.size() == kMaxPbrtShapes) fail_input("more than 2,000,000 shapes are shown", where_);
    scene_.shapes.push_back(std::move(shape));
  }

  /// Whether the shape is a light, and thereby no mesh.
  bool add_area_light(const std::string& type, const PbrtParameters& all) {
    if (object_ != nullptr) {
      scene_.of_views.add("emitter in an object is left out", "emitters in objects are left out");
      return false;
    }
    auto light = shapes_.light_of(type, all, ours_from_world_ * state_.ctm, state_.reverses);
    if (!light) {
      scene_.of_views.add(
          "shape that shines is no rectangle, disk or sphere: it is a mesh, not a light",
          "shapes that shine are no rectangles, disks or spheres: they are meshes, not lights");
      return false;
    }
    if (state_.shines->boolean("twosided", false))
      scene_.of_views.add("light shines to one side, not to both", "lights shine to one side, not to both");
    if (state_.shines->find("filename") != nullptr)
      scene_.of_views.add("light of a textured radiance shines evenly",
                          "lights of a textured radiance shine evenly");
    light->name = state_.material_name.empty() ? "area" : state_.material_name;
    scene_.lights.push_back(std::move(*light));
    return true;
  }

  void add_instance(const std::string& name) {
    const auto found = objects_.find(name);
    if (found == objects_.end()) {
      std::vector<std::string> known;
      for (const auto& [other, shapes] : objects_) known.push_back(other);
      fail_input(fmt::format("no object is called '{}'", name), where_, suggest_name(name, known));
    }
    if (object_ != nullptr) fail_input("an object shows another", where_);
    for (const ObjectShape& shape : found->second)
      show({shape.mesh, shape.name, {name}, ours_from_world_ * state_.ctm * shape.object_from_mesh});
  }

  void add_lamp(const std::string& type, const PbrtParameters& all) {
    const dmat4 world = ours_from_world_ * state_.ctm;
    const dvec3 from = all.point("from", dvec3(0.0)), to = all.point("to", dvec3(0, 0, 1));
    const dvec3 center(world * glm::dvec4(from, 1.0)), direction(world * glm::dvec4(to - from, 0.0));
    if (type == "point")
      add_point_lamp(type, center, scene_);
    else if (type == "spot")
      add_spot_lamp(type, center, direction, scene_);
    else if (type == "distant")
      add_distant_lamp(type, direction, scene_);
    else
      scene_.of_views.leave_out("light", type);
  }

  PbrtTokens tokens_;
  ForeignScene scene_;
  PbrtShapes shapes_;
  FileLocation where_;  // of the statement that is read
  State state_;
  std::vector<Block> states_;
  /// pbrt's world is left-handed.
  dmat4 ours_from_world_{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  PbrtSystems systems_;
  std::map<std::string, std::string> materials_;  // by name: type
  std::map<std::string, std::vector<ObjectShape>> objects_;
  std::vector<ObjectShape>* object_ = nullptr;  // being read
  std::optional<CameraStatement> camera_;
  std::optional<PbrtParameters> film_;
};

}  // namespace

ForeignScene read_pbrt(const fs::path& path) {
  return PbrtReader(path).run();
}

}  // namespace umbrameter
