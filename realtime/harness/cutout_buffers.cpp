// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/cutout_buffers.h"

#include "realtime/harness/wrapped_main.h"
#include "scenes/instances.h"

#include <bit>
#include <cstddef>
#include <vector>

namespace umbrameter {
namespace {

struct CutoutVertex {
  glm::vec3 p_world;  // of an instance: in its mesh's space
  glm::vec2 uv;
  uint32_t mask;  // word in the storage buffer
};

constexpr size_t kRecordWords = 7;

size_t mask_words(const AlphaMask& mask) {
  return 2 + mask.bits.size();
}

/// The holes of the scene's own triangles, or of a mesh.
struct HoleSource {
  const SharedList<Cutout>& cutouts;
  const SharedList<AlphaMask>& masks;
  const SharedList<glm::vec3>& positions;
  const SharedList<glm::uvec3>& triangles;
  size_t first_mask = 0;  // among all
};

std::vector<HoleSource> hole_sources(const Scene& scene) {
  std::vector<HoleSource> sources{{scene.cutouts, scene.masks, scene.positions_world, scene.triangles}};
  size_t masks = scene.masks.size();
  for (const auto& mesh : scene.instanced) {
    sources.push_back({mesh->cutouts, mesh->masks, mesh->positions, mesh->triangles, masks});
    masks += mesh->masks.size();
  }
  return sources;
}

/// Where each mask starts.
std::vector<uint32_t> mask_places(std::span<const HoleSource> sources) {
  size_t cutouts = 0;
  for (const HoleSource& source : sources) cutouts += source.cutouts.size();
  std::vector<uint32_t> places;
  size_t next = cutout_word(static_cast<uint32_t>(cutouts));
  for (const HoleSource& source : sources) {
    for (const AlphaMask& mask : source.masks) {
      places.push_back(static_cast<uint32_t>(next));
      next += mask_words(mask);
    }
  }
  return places;
}

void add_records(const HoleSource& source, std::span<const uint32_t> places, std::vector<uint32_t>& words) {
  for (const Cutout& cutout : source.cutouts) {
    for (const glm::vec2& uv : cutout.uv) {
      words.push_back(std::bit_cast<uint32_t>(uv.x));
      words.push_back(std::bit_cast<uint32_t>(uv.y));
    }
    words.push_back(places[source.first_mask + cutout.mask]);
  }
}

std::vector<uint32_t> make_words(const Scene& scene) {
  const std::vector<HoleSource> sources = hole_sources(scene);
  const std::vector<uint32_t> places = mask_places(sources);
  std::vector<uint32_t> words{scene.first_cutout()};
  for (const HoleSource& source : sources) add_records(source, places, words);
  for (const HoleSource& source : sources) {
    for (const AlphaMask& mask : source.masks) {
      words.push_back(mask.width);
      words.push_back(mask.height);
      words.insert(words.end(), mask.bits.begin(), mask.bits.end());
    }
  }
  return words;
}

std::vector<CutoutVertex> make_vertices(const Scene& scene) {
  const std::vector<HoleSource> sources = hole_sources(scene);
  const std::vector<uint32_t> places = mask_places(sources);
  std::vector<CutoutVertex> vertices;
  for (const HoleSource& source : sources) {
    const size_t first = source.triangles.size() - source.cutouts.size();
    for (size_t i = 0; i < source.cutouts.size(); ++i) {
      const glm::uvec3& triangle = source.triangles[first + i];
      const Cutout& cutout = source.cutouts[i];
      for (int c = 0; c < 3; ++c)
        vertices.push_back({source.positions[triangle[c]], cutout.uv[static_cast<size_t>(c)],
                            places[source.first_mask + cutout.mask]});
    }
  }
  return vertices;
}

}  // namespace

uint32_t cutout_word(uint32_t cutout) {
  return static_cast<uint32_t>(1 + kRecordWords * cutout);
}

VertexArray make_cutout_vertex_array(const Buffer& vertices) {
  VertexArray array = make_empty_vertex_array();
  for (const GLuint location : {0u, 1u, 2u}) {
    glEnableVertexArrayAttrib(array.id(), location);
    glVertexArrayAttribBinding(array.id(), location, 0);
  }
  glVertexArrayAttribFormat(array.id(), 0, 3, GL_FLOAT, GL_FALSE, offsetof(CutoutVertex, p_world));
  glVertexArrayAttribFormat(array.id(), 1, 2, GL_FLOAT, GL_FALSE, offsetof(CutoutVertex, uv));
  glVertexArrayAttribIFormat(array.id(), 2, 1, GL_UNSIGNED_INT, offsetof(CutoutVertex, mask));
  glVertexArrayVertexBuffer(array.id(), 0, vertices.id(), 0, sizeof(CutoutVertex));
  return array;
}

CutoutBuffers::CutoutBuffers(const Scene& scene)
    : words_(Buffer::of(std::span<const uint32_t>(make_words(scene)))),
      vertices_(Buffer::of(std::span<const CutoutVertex>(make_vertices(scene)))),
      array_(make_cutout_vertex_array(vertices_)),
      vertex_count_(static_cast<GLsizei>(3 * scene.cutouts.size())) {}

void CutoutBuffers::bind_storage() const {
  bind_storage_buffer(kCutoutsBinding, words_);
}

void CutoutBuffers::draw() const {
  bind_storage();
  glBindVertexArray(array_.id());
  glDrawArrays(GL_TRIANGLES, 0, vertex_count_);
}

std::string cutout_vertex_prelude(const std::string& before_main) {
  return "layout(location = 1) in vec2 cutout_uv_of_vertex;\n"
         "layout(location = 2) in uint cutout_mask_of_vertex;\n"
         "out vec2 cutout_uv;\nflat out uint cutout_mask;\n" +
         wrapped_main(before_main, "cutout_uv = cutout_uv_of_vertex; cutout_mask = cutout_mask_of_vertex;");
}

std::string cutout_fragment_prelude() {
  return "#include \"cutout.glsl\"\nin vec2 cutout_uv;\nflat in uint cutout_mask;\n" +
         wrapped_main("", "if (is_hole(cutout_mask, cutout_uv)) discard;");
}

}  // namespace umbrameter
