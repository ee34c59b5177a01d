// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_shape.h"

#include "scenes/read_values.h"
#include "scenes/shapes.h"

#include <array>

namespace umbrameter {
namespace {

constexpr int kMaxSegments = 4096;
constexpr int kMaxSphereSegments = 1024;
constexpr int kMaxCount = 10000;

MeshData read_plane(TomlReader& reader) {
  return make_plane(read_lengths2(reader, "size"));
}

MeshData read_box(TomlReader& reader) {
  return make_box(read_lengths3(reader, "size"));
}

MeshData read_plate(TomlReader& reader) {
  const glm::dvec2 size = read_lengths2(reader, "size");
  return make_plate(size, read_length(reader, "thickness", 0.0));
}

MeshData read_sphere(TomlReader& reader) {
  const double radius = read_length(reader, "radius");
  const int segments = read_count(reader, "segments", 4, kMaxSphereSegments, 64);
  return make_sphere(radius, segments, reader.boolean("smooth", false));
}

MeshData read_disk(TomlReader& reader) {
  const double radius = read_length(reader, "radius");
  return make_disk(radius, read_count(reader, "segments", 3, kMaxSegments, 256));
}

MeshData read_comb(TomlReader& reader) {
  const int count = read_count(reader, "count", 1, kMaxCount);
  const double bar = read_length(reader, "bar");
  const double period = read_length(reader, "period");
  if (period <= bar) {
    reader.fail("period", fmt::format("'period' = {} leaves no gap between bars {} wide", period, bar));
  }
  return make_comb(count, period, bar, read_length(reader, "length"));
}

MeshData read_wire(TomlReader& reader) {
  const double radius = read_length(reader, "radius");
  const double length = read_length(reader, "length");
  return make_wire(radius, length, read_count(reader, "segments", 3, kMaxSegments, 16));
}

MeshData read_stairs(TomlReader& reader) {
  const int count = read_count(reader, "count", 1, kMaxCount);
  return make_stairs(count, read_lengths3(reader, "size"));
}

MeshData read_colonnade(TomlReader& reader) {
  const int count = read_count(reader, "count", 1, 1000);
  const double spacing = read_length(reader, "spacing");
  const double radius = read_length(reader, "radius");
  if (count > 1 && spacing <= 2 * radius) {
    reader.fail("spacing", fmt::format("'spacing' = {} makes columns of radius {} overlap", spacing, radius));
  }
  const double height = read_length(reader, "height");
  const int segments = read_count(reader, "segments", 3, kMaxSegments, 48);
  const glm::dvec2 lintel = reader.has("lintel") ? read_lengths2(reader, "lintel") : glm::dvec2(0.0);
  return make_colonnade(count, spacing, radius, height, segments, lintel);
}

struct Shape {
  std::string name;
  MeshData (*read)(TomlReader&);
};

const std::array<Shape, 9> kShapes = {{{"plane", read_plane},
                                       {"box", read_box},
                                       {"sphere", read_sphere},
                                       {"disk", read_disk},
                                       {"plate", read_plate},
                                       {"comb", read_comb},
                                       {"wire", read_wire},
                                       {"stairs", read_stairs},
                                       {"colonnade", read_colonnade}}};

}  // namespace

MeshData read_shape(TomlReader& reader) {
  std::vector<std::string> names;
  for (const Shape& shape : kShapes) names.push_back(shape.name);
  return kShapes[reader.choice("shape", names)].read(reader);
}

}  // namespace umbrameter
