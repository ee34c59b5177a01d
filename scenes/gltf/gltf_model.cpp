// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_model.h"

#include "core/error.h"
#include "core/files.h"
#include "scenes/file_ending.h"
#include "scenes/gltf/gltf_animation.h"

#define TINYGLTF_IMPLEMENTATION
#include "scenes/gltf/tinygltf.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace umbrameter {
namespace {

constexpr size_t kMaxFileBytes = size_t{4} << 30;

/// Needed to understand geometry, and read; whatever else is required is not.
constexpr std::array<std::string_view, 3> kKnownExtensions = {"KHR_lights_punctual", "KHR_mesh_quantization",
                                                              "KHR_texture_transform"};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& message,
                       const std::string& hint = {}) {
  fail_input(message, {path.string()}, hint);
}

uint32_t word_at(const std::string& bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// tinygltf's own words for a file that is cut off are of little help.
void check_container(const std::filesystem::path& path, const std::string& bytes) {
  constexpr size_t kHeader = 20;
  if (!has_ending(path.string(), ".glb")) return;
  if (bytes.size() < kHeader || !bytes.starts_with("glTF"))
    fail(path, "this is no GLB file: it does not begin with 'glTF'");
  if (word_at(bytes, 4) != 2)
    fail(path, fmt::format("version {} of glTF is not read", word_at(bytes, 4)), "only 2 is");
  const uint32_t stated = word_at(bytes, 8);
  if (stated > bytes.size())
    fail(path, fmt::format("the file is cut off: it has {} of {} bytes", bytes.size(), stated));
  if (size_t{word_at(bytes, 12)} + kHeader > stated)
    fail(path, "its JSON reaches beyond the end of the file");
}

/// Keeps a picture's file as it is; scenes/read_mask.h looks at it if it matters.
bool keep_picture(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int count, void*) {
  image->image.assign(bytes, bytes + count);
  return true;
}

size_t count_of(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// tinygltf drops channels that lack something, and goes on.
void note_dropped_channels(const std::string& said, GltfFile& file) {
  if (const size_t count = count_of(said, "`node` field is missing in animation"); count > 0)
    file.warnings.push_back(fmt::format("{}: {} animation channel{} without a node {} left out",
                                        file.path.filename().string(), count, count == 1 ? "" : "s",
                                        count == 1 ? "is" : "are"));
  if (count_of(said, "`sampler` field is missing in animation") > 0)
    file.animation_problem = "a channel names no sampler";
  if (count_of(said, "`path` field is missing in animation") > 0)
    file.animation_problem = "a channel does not say what it moves";
}

void parse(const std::string& bytes, GltfFile& file) {
  const std::filesystem::path& path = file.path;
  auto model = std::make_shared<tinygltf::Model>();
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_picture, nullptr);
  std::string error, warning;
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  const bool is_binary = has_ending(path.string(), ".glb");
  const auto size = static_cast<unsigned int>(bytes.size());
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  bool is_fine = false;
  try {
    is_fine = is_binary
                  ? loader.LoadBinaryFromMemory(model.get(), &error, &warning, data, size, folder)
                  : loader.LoadASCIIFromString(model.get(), &error, &warning, bytes.data(), size, folder);
  } catch (const nlohmann::json::exception& exception) {
    error = exception.what();
  }
  file.model = model;
  if (is_fine) return note_dropped_channels(error, file);
  std::replace(error.begin(), error.end(), '\n', ' ');
  while (!error.empty() && (error.back() == ' ' || error.back() == '.')) error.pop_back();
  fail(path, fmt::format("not a readable glTF file: {}", error.empty() ? "no reason given" : error));
}

void check_extensions(const std::filesystem::path& path, const tinygltf::Model& model) {
  for (const std::string& name : model.extensionsRequired) {
    const bool is_material = name.starts_with("KHR_materials_");  // colours only
    if (is_material ||
        std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) != kKnownExtensions.end())
      continue;
    fail(path, fmt::format("the file requires extension '{}', which is not read", name),
         "export without compression");
  }
}

GltfPose pose_of(const tinygltf::Node& node) {
  GltfPose pose;
  const std::vector<double>&t = node.translation, &r = node.rotation, &s = node.scale;
  if (t.size() == 3) pose.translation = glm::dvec3(t[0], t[1], t[2]);
  if (r.size() == 4) pose.rotation = glm::dquat(r[3], r[0], r[1], r[2]);
  if (s.size() == 3) pose.scale = glm::dvec3(s[0], s[1], s[2]);
  return pose;
}

glm::dmat4 parent_from_node(const tinygltf::Node& node, const GltfPose& moved) {
  if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
  const GltfPose own = pose_of(node);
  glm::dmat4 matrix(1.0);
  if (const auto& rotation = moved.rotation ? moved.rotation : own.rotation)
    matrix = glm::mat4_cast(*rotation);
  if (const auto& scale = moved.scale ? moved.scale : own.scale) {
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= (*scale)[axis];
  }
  if (const auto& translation = moved.translation ? moved.translation : own.translation)
    matrix[3] = glm::dvec4(*translation, 1.0);
  return matrix;
}

/// What the animation says, else the node, else its mesh.
std::vector<double> weights_of(const tinygltf::Model& model, const tinygltf::Node& node,
                               const GltfPose& moved) {
  if (moved.weights) return *moved.weights;
  if (!node.weights.empty()) return node.weights;
  const bool has_mesh = node.mesh >= 0 && static_cast<size_t>(node.mesh) < model.meshes.size();
  return has_mesh ? model.meshes[static_cast<size_t>(node.mesh)].weights : std::vector<double>();
}

bool is_finite(const glm::dmat4& matrix) {
  const double* values = glm::value_ptr(matrix);
  return std::all_of(values, values + 16, [](double value) { return std::isfinite(value); });
}

std::vector<int> roots_of(const tinygltf::Model& model) {
  if (model.defaultScene >= 0 && static_cast<size_t>(model.defaultScene) < model.scenes.size())
    return model.scenes[static_cast<size_t>(model.defaultScene)].nodes;
  std::vector<int> roots;
  for (const tinygltf::Scene& scene : model.scenes)
    roots.insert(roots.end(), scene.nodes.begin(), scene.nodes.end());
  return roots;
}

/// Depth first without recursion: a chain of nodes may be long.
void collect_nodes(GltfFile& file, const std::vector<GltfPose>& poses) {
  const tinygltf::Model& model = *file.model;
  std::vector<bool> is_seen(model.nodes.size(), false);
  std::vector<GltfNode> waiting;
  for (const int root : roots_of(model)) waiting.push_back({root});
  std::reverse(waiting.begin(), waiting.end());
  while (!waiting.empty()) {
    const GltfNode next = waiting.back();
    waiting.pop_back();
    if (next.node < 0 || static_cast<size_t>(next.node) >= model.nodes.size())
      fail(file.path, fmt::format("node {} is named, but there are {}", next.node, model.nodes.size()));
    const auto index = static_cast<size_t>(next.node);
    if (is_seen[index])
      fail(file.path,
           fmt::format("{} is its own ancestor or has two parents", gltf_node_name(file, next.node)));
    is_seen[index] = true;
    const tinygltf::Node& node = model.nodes[index];
    const glm::dmat4 world = next.world_from_node * parent_from_node(node, poses[index]);
    const bool is_moved = next.is_moved || poses[index].moves();
    if (!is_finite(world))
      fail(file.path, fmt::format("the transform of {} is not finite", gltf_node_name(file, next.node)));
    file.nodes.push_back({next.node, world, is_moved});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      waiting.push_back({*child, world, is_moved});
  }
}

void collect_side_files(GltfFile& file) {
  const auto add = [&](const std::string& uri) {
    if (!uri.empty() && !uri.starts_with("data:")) file.side_files.push_back(file.path.parent_path() / uri);
  };
  for (const tinygltf::Buffer& buffer : file.model->buffers) add(buffer.uri);
  for (const tinygltf::Image& image : file.model->images) add(image.uri);
}

}  // namespace

bool is_gltf(const std::string& name) {
  return has_ending(name, ".gltf") || has_ending(name, ".glb");
}

GltfFile open_gltf(const std::filesystem::path& path, const std::optional<AnimationTime>& at) {
  const std::string bytes = read_file(path);
  if (bytes.size() > kMaxFileBytes) fail(path, "the file is larger than 4 GiB");
  check_container(path, bytes);
  GltfFile file;
  file.path = path;
  parse(bytes, file);
  const tinygltf::Model& model = *file.model;
  check_extensions(path, model);
  const std::vector<GltfPose> poses = at ? pose_gltf(file, *at) : std::vector<GltfPose>(model.nodes.size());
  if (!at) warn_of_animations(gltf_animation_names(file), path, file.warnings);
  for (size_t i = 0; i < model.nodes.size(); ++i)
    file.morph_weights.push_back(weights_of(model, model.nodes[i], poses[i]));
  collect_nodes(file, poses);
  collect_side_files(file);
  return file;
}

std::vector<std::string> gltf_animation_names(const GltfFile& file) {
  std::vector<std::string> names;
  for (const tinygltf::Animation& animation : file.model->animations)
    names.push_back(animation.name.empty() ? fmt::format("animation {}", names.size() + 1) : animation.name);
  return names;
}

std::string gltf_node_name(const GltfFile& file, int node) {
  const auto& nodes = file.model->nodes;
  if (node >= 0 && static_cast<size_t>(node) < nodes.size() && !nodes[static_cast<size_t>(node)].name.empty())
    return fmt::format("node '{}'", nodes[static_cast<size_t>(node)].name);
  return fmt::format("node {}", node);
}

}  // namespace umbrameter
