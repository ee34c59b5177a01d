// SPDX-License-Identifier: Apache-2.0
// The proofs' own tree must not make large scenes too large: all that the reference holds, beside Embree alone.

#include "reference/embree_scene.h"
#include "reference/occluder_tree.h"
#include "tests/support/models.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

template <class T>
uint64_t bytes_of(const SharedList<T>& items) {
  return items.size() * sizeof(T);
}

TEST(MemoryShare, is_at_most_two_and_a_half_times_that_of_embrees_tree_and_mesh) {
  if (!has_models()) GTEST_SKIP() << no_models();
  for (const char* name : {"assets/crytek_sponza.toml", "assets/country_kitchen.toml"}) {
    const Scene scene = load_scene(model_search().library / name, model_search());
    EmbreeScene embree;
    embree.load(scene);
    const uint64_t alone = embree.memory_bytes();
    OccluderTree occluders;
    occluders.build(embree, scene);
    const uint64_t all = embree.memory_bytes() + bytes_of(scene.positions_world) +
                         bytes_of(scene.normals_world) + bytes_of(scene.triangles);
    ASSERT_GT(alone, scene.triangles.size() * sizeof(glm::uvec3)) << name;
    EXPECT_LT(static_cast<double>(all), 2.5 * static_cast<double>(alone)) << name;
  }
}

}  // namespace
}  // namespace umbrameter
