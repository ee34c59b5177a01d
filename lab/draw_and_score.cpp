// SPDX-License-Identifier: Apache-2.0
#include "lab/draw_and_score.h"

#include <future>

namespace umbrameter {

void draw_and_score(size_t count, const std::function<Frame(size_t)>& draw,
                    const std::function<bool(size_t, const Frame&)>& score) {
  std::future<bool> last;  // its destructor waits
  for (size_t i = 0; i < count; ++i) {
    Frame frame = draw(i);
    if (last.valid() && !last.get()) return;
    last = std::async(std::launch::async, [&score, i, frame = std::move(frame)] { return score(i, frame); });
  }
  if (last.valid()) last.get();
}

}  // namespace umbrameter
