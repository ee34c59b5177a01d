// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_model.h"

#include "core/error.h"
#include "core/files.h"
#include "scenes/file_ending.h"

#define TINYGLTF_IMPLEMENTATION
#include "scenes/gltf/tinygltf.h"

#include <glm/gtc/quaternion.hpp>
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

std::shared_ptr<const tinygltf::Model> parse(const std::filesystem::path& path, const std::string& bytes) {
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
  if (is_fine) return model;
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

glm::dmat4 parent_from_node(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
  glm::dmat4 matrix(1.0);
  if (node.rotation.size() == 4)
    matrix =
        glm::mat4_cast(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
  if (node.scale.size() == 3) {
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= node.scale[static_cast<size_t>(axis)];
  }
  if (node.translation.size() == 3)
    matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
  return matrix;
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
void collect_nodes(GltfFile& file) {
  const tinygltf::Model& model = *file.model;
  std::vector<bool> is_seen(model.nodes.size(), false);
  std::vector<GltfNode> waiting;
  for (const int root : roots_of(model)) waiting.push_back({root, glm::dmat4(1.0)});
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
    const glm::dmat4 world = next.world_from_node * parent_from_node(node);
    if (!is_finite(world))
      fail(file.path, fmt::format("the transform of {} is not finite", gltf_node_name(file, next.node)));
    file.nodes.push_back({next.node, world});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      waiting.push_back({*child, world});
  }
}

void collect_side_files(GltfFile& file) {
  const auto add = [&](const std::string& uri) {
    if (!uri.empty() && !uri.starts_with("data:")) file.side_files.push_back(file.path.parent_path() / uri);
  };
  for (const tinygltf::Buffer& buffer : file.model->buffers) add(buffer.uri);
  for (const tinygltf::Image& image : file.model->images) add(image.uri);
}

/// Where an accessor's elements stand.
struct Elements {
  const unsigned char* first = nullptr;
  size_t count = 0;
  size_t stride = 0;
  int component_type = 0;
  int components = 0;
  bool is_normalized = false;
};

Elements elements_of(const GltfFile& file, int index, const std::string& what) {
  const tinygltf::Model& model = *file.model;
  const auto refuse = [&](const std::string& why) {
    fail(file.path, fmt::format("accessor {} ({}) {}", index, what, why));
  };
  if (index < 0 || static_cast<size_t>(index) >= model.accessors.size()) refuse("does not exist");
  const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(index)];
  if (accessor.sparse.isSparse) refuse("is sparse, which is not read");
  if (accessor.bufferView < 0 || static_cast<size_t>(accessor.bufferView) >= model.bufferViews.size())
    refuse("has no buffer view");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
  if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= model.buffers.size()) refuse("has no buffer");
  const std::vector<unsigned char>& bytes = model.buffers[static_cast<size_t>(view.buffer)].data;
  const int stride = accessor.ByteStride(view);
  const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
  const int component_bytes =
      tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType));
  if (stride <= 0 || components <= 0 || components > 4 || component_bytes <= 0)
    refuse("has a type that is not read");
  const size_t element = static_cast<size_t>(components) * static_cast<size_t>(component_bytes);
  const size_t start = view.byteOffset + accessor.byteOffset;
  const size_t view_end = view.byteOffset + view.byteLength;
  const bool is_empty = accessor.count == 0;
  const bool overflows = accessor.count > kMaxFileBytes || start > bytes.size() || view_end > bytes.size();
  if (overflows ||
      (!is_empty && start + (accessor.count - 1) * static_cast<size_t>(stride) + element > view_end))
    refuse(fmt::format("wants {} elements, more than its buffer holds", accessor.count));
  return {bytes.data() + start,   accessor.count, static_cast<size_t>(stride),
          accessor.componentType, components,     accessor.normalized};
}

template <class T>
double component(const unsigned char* at, bool is_normalized) {
  T value{};
  std::memcpy(&value, at, sizeof value);
  if constexpr (std::is_floating_point_v<T>) return static_cast<double>(value);
  const auto number = static_cast<double>(value);
  return is_normalized ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
}

double component_at(const Elements& elements, const unsigned char* element, int i) {
  const auto at = [&]<class T>(T) {
    return component<T>(element + static_cast<size_t>(i) * sizeof(T), elements.is_normalized);
  };
  switch (elements.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return at(int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return at(uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return at(int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return at(uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return at(uint32_t{});
    default:
      return at(float{});
  }
}

}  // namespace

bool is_gltf(const std::string& name) {
  return has_ending(name, ".gltf") || has_ending(name, ".glb");
}

GltfFile open_gltf(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  if (bytes.size() > kMaxFileBytes) fail(path, "the file is larger than 4 GiB");
  check_container(path, bytes);
  GltfFile file{path, parse(path, bytes), {}, {}};
  check_extensions(path, *file.model);
  collect_nodes(file);
  collect_side_files(file);
  return file;
}

std::vector<glm::dvec4> read_gltf_vectors(const GltfFile& file, int accessor, const std::string& what) {
  const Elements elements = elements_of(file, accessor, what);
  std::vector<glm::dvec4> vectors(elements.count, glm::dvec4(0.0));
  for (size_t i = 0; i < elements.count; ++i) {
    const unsigned char* element = elements.first + i * elements.stride;
    for (int c = 0; c < elements.components; ++c) vectors[i][c] = component_at(elements, element, c);
  }
  return vectors;
}

std::vector<uint32_t> read_gltf_indices(const GltfFile& file, int accessor) {
  const Elements elements = elements_of(file, accessor, "indices");
  const bool is_whole = elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                        elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                        elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (!is_whole || elements.components != 1)
    fail(file.path, fmt::format("accessor {} holds no indices", accessor));
  std::vector<uint32_t> indices(elements.count);
  for (size_t i = 0; i < elements.count; ++i)
    indices[i] = static_cast<uint32_t>(component_at(elements, elements.first + i * elements.stride, 0));
  return indices;
}

std::string gltf_node_name(const GltfFile& file, int node) {
  const auto& nodes = file.model->nodes;
  if (node >= 0 && static_cast<size_t>(node) < nodes.size() && !nodes[static_cast<size_t>(node)].name.empty())
    return fmt::format("node '{}'", nodes[static_cast<size_t>(node)].name);
  return fmt::format("node {}", node);
}

}  // namespace umbrameter
