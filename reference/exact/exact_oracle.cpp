// SPDX-License-Identifier: Apache-2.0
#include "reference/exact/exact_oracle.h"

#include "reference/exact/exact_light.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace umbrameter {

ExactOracle exact_oracle() {
  return [](const Scene& scene, std::span<const ExactReceiver> receivers, int threads, Progress& progress) {
    const TriangleTree tree(scene);
    std::vector<ExactLight> answers(receivers.size());
    progress.begin("exact check", receivers.size());
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute([&] {
      tbb::parallel_for(size_t{0}, receivers.size(), [&](size_t i) {
        answers[i] = exact_light(tree, receivers[i], scene.light());
        progress.advance(1);
      });
    });
    progress.end();
    return answers;
  };
}

}  // namespace umbrameter
