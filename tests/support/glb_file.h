// SPDX-License-Identifier: Apache-2.0
#pragma once
// GLB files made in a test: JSON to be edited, and numbers that land in its one buffer.

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace umbrameter {

/// The two chunks of a GLB; `bytes` are a multiple of four.
inline std::string glb_of(const nlohmann::json& json, const std::string& bytes) {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string file = "glTF";
  const auto word = [&file](size_t value) {
    const auto number = static_cast<uint32_t>(value);
    file.append(reinterpret_cast<const char*>(&number), 4);
  };
  word(2);
  word(12 + 8 + text.size() + 8 + bytes.size());
  word(text.size());
  file += "JSON" + text;
  word(bytes.size());
  file += std::string("BIN\0", 4) + bytes;
  return file;
}

struct GlbFile {
  nlohmann::json json =
      nlohmann::json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [], "meshes": [], "accessors": [], "bufferViews": [], "buffers": []})");
  std::string bytes;

  /// Accessors of floats, bytes and shorts ("SCALAR", "VEC3", "MAT4", ...); each says its index.
  int add(const std::vector<float>& values, const std::string& type) {
    return add_values(values, type, 5126);
  }
  int add(const std::vector<uint8_t>& values, const std::string& type) {
    return add_values(values, type, 5121);
  }
  int add(const std::vector<uint16_t>& values, const std::string& type) {
    return add_values(values, type, 5123);
  }

  /// A square in the xy plane from 0 to 1 that faces +z.
  void add_square_mesh() {
    const int positions = add(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    const int indices = add(std::vector<uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR");
    json["meshes"].push_back(
        {{"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}});
  }

  nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

  /// A channel of animation `animation`, which is made where it is not there.
  void animate(int node, const std::string& path, const std::vector<float>& times_s,
               const std::vector<float>& values, const std::string& type,
               const std::string& interpolation = "LINEAR", size_t animation = 0,
               const std::string& name = "move") {
    if (!json.contains("animations")) json["animations"] = nlohmann::json::array();
    while (json["animations"].size() <= animation)
      json["animations"].push_back(
          {{"name", name}, {"channels", nlohmann::json::array()}, {"samplers", nlohmann::json::array()}});
    nlohmann::json& target = json["animations"][animation];
    const int input = add(times_s, "SCALAR"), output = add(values, type);
    target["channels"].push_back(
        {{"sampler", target["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    target["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
  }

  std::string glb() const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", bytes.size()}}};
    return glb_of(whole, bytes);
  }

 private:
  template <class T>
  int add_values(const std::vector<T>& values, const std::string& type, int component_type) {
    const size_t components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<size_t>(type[3] - '0');
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"count", values.size() / components},
                                 {"type", type}});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    bytes.resize((bytes.size() + 3) / 4 * 4);
    return static_cast<int>(json["accessors"].size()) - 1;
  }
};

}  // namespace umbrameter
