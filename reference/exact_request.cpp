// SPDX-License-Identifier: Apache-2.0
#include "reference/exact_request.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <type_traits>

namespace umbrameter {
namespace {

constexpr std::array<char, 8> kFormat = {'u', 'm', 'b', 'e', 'x', 'a', 'c', '1'};

class Writer {
 public:
  explicit Writer(std::ofstream& stream) : stream_(stream) {}
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    stream_.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void put_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(uint64_t{values.size()});
    stream_.write(reinterpret_cast<const char*>(values.data()),
                  static_cast<std::streamsize>(values.size() * sizeof(T)));
  }

 private:
  std::ofstream& stream_;
};

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file, std::ios::binary) {
    std::error_code failed;
    left_ = std::filesystem::file_size(file, failed);
    if (!stream_ || failed) fail_input("the request cannot be read", {.file = file.string()});
  }
  template <class T>
  T get() {
    T value{};
    read(&value, sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> get_all() {
    const auto count = get<uint64_t>();
    if (count > left_ / sizeof(T)) fail_input("the request is cut short", {.file = file_.string()});
    std::vector<T> values(count);
    read(values.data(), count * sizeof(T));
    return values;
  }
  [[noreturn]] void fail(const std::string& what) const { fail_input(what, {.file = file_.string()}); }

 private:
  void read(void* into, uint64_t bytes) {
    if (bytes > left_ || !stream_.read(static_cast<char*>(into), static_cast<std::streamsize>(bytes)))
      fail_input("the request is cut short", {.file = file_.string()});
    left_ -= bytes;
  }
  std::filesystem::path file_;
  std::ifstream stream_;
  uint64_t left_ = 0;
};

Light read_light(Reader& reader) {
  Light light;
  const auto type = reader.get<uint32_t>();
  if (type > static_cast<uint32_t>(LightType::sun))
    reader.fail(fmt::format("there is no light of type {}", type));
  light.type = static_cast<LightType>(type);
  for (glm::dvec3* v :
       {&light.center_world, &light.tangent_world, &light.bitangent_world, &light.direction_world})
    *v = reader.get<glm::dvec3>();
  light.size_world = reader.get<glm::dvec2>();
  light.radius_world = reader.get<double>();
  light.half_angle_rad = reader.get<double>();
  return light;
}

void require_indices(const ExactRequest& request, const Reader& reader) {
  const size_t corners = request.scene.positions_world.size();
  for (const glm::uvec3& t : request.scene.triangles) {
    if (t.x >= corners || t.y >= corners || t.z >= corners)
      reader.fail("a triangle has a corner that is not there");
  }
}

}  // namespace

void write_exact_request(const std::filesystem::path& file, const Scene& scene,
                         std::span<const ExactReceiver> receivers, int threads) {
  UMBRAMETER_ASSERT(scene.cutouts.empty() && scene.instanced.empty(),
                    "the exact oracle knows neither holes nor instances");
  std::ofstream stream(file, std::ios::binary);
  Writer writer(stream);
  writer.put(kFormat);
  writer.put(int32_t{threads});
  const Light& light = scene.light();
  writer.put(static_cast<uint32_t>(light.type));
  for (const glm::dvec3& v :
       {light.center_world, light.tangent_world, light.bitangent_world, light.direction_world})
    writer.put(v);
  writer.put(light.size_world);
  writer.put(light.radius_world);
  writer.put(light.half_angle_rad);
  writer.put_all(std::span(scene.positions_world));
  writer.put_all(std::span(scene.triangles));
  writer.put(uint64_t{receivers.size()});
  for (const ExactReceiver& receiver : receivers) {
    for (const glm::dvec3& v : {receiver.p_world, receiver.n_geometric_world, receiver.n_shading_world})
      writer.put(v);
    writer.put_all(std::span(receiver.transparent));
  }
  stream.close();
  if (!stream) fail_environment(fmt::format("'{}' cannot be written", file.string()));
}

ExactRequest read_exact_request(const std::filesystem::path& file) {
  Reader reader(file);
  if (reader.get<std::array<char, 8>>() != kFormat)
    reader.fail("this is no request of this version of umbrameter");
  ExactRequest request;
  request.threads = reader.get<int32_t>();
  request.scene.lights = {read_light(reader)};
  request.scene.positions_world = reader.get_all<glm::vec3>();
  request.scene.triangles = reader.get_all<glm::uvec3>();
  require_indices(request, reader);
  for (auto left = reader.get<uint64_t>(); left > 0; --left) {
    ExactReceiver receiver;
    for (glm::dvec3* v : {&receiver.p_world, &receiver.n_geometric_world, &receiver.n_shading_world})
      *v = reader.get<glm::dvec3>();
    receiver.transparent = reader.get_all<uint32_t>();
    request.receivers.push_back(std::move(receiver));
  }
  return request;
}

std::string to_line(size_t receiver, const ExactLight& answer) {
  const std::string ratio = answer.irradiance_ratio ? fmt::format("{:a}", *answer.irradiance_ratio) : "none";
  return fmt::format("{} {:a} {:a} {} {} {}", receiver, answer.visibility_low, answer.visibility_high, ratio,
                     answer.triangles, answer.edges);
}

std::pair<size_t, ExactLight> from_line(const std::string& line) {
  size_t receiver = 0;
  ExactLight answer;
  char ratio[64];
  int end = 0;
  const int fields =
      std::sscanf(line.c_str(), "%zu %la %la %63s %zu %zu%n", &receiver, &answer.visibility_low,
                  &answer.visibility_high, ratio, &answer.triangles, &answer.edges, &end);
  if (fields != 6 || static_cast<size_t>(end) != line.size())
    fail_input(fmt::format("'{}' is no answer of umbrameter-exact", line));
  if (std::string_view(ratio) != "none") {
    double value = 0.0;
    if (std::sscanf(ratio, "%la%n", &value, &end) != 1 || ratio[end] != '\0')
      fail_input(fmt::format("'{}' is no answer of umbrameter-exact", line));
    answer.irradiance_ratio = value;
  }
  return {receiver, answer};
}

}  // namespace umbrameter
