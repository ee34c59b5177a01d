// SPDX-License-Identifier: Apache-2.0
// umbrameter-exact REQUEST: answers what `umbrameter` asks in the file REQUEST, a line a receiver as each is done.

#include "core/version.h"
#include "reference/exact/exact_light.h"
#include "reference/exact_request.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>

#include <sys/prctl.h>

namespace umbrameter {
namespace {

constexpr const char* kAbout =
    "umbrameter-exact {}: exact visibility for 'umbrameter reference --exact-check'.\n"
    "usage: umbrameter-exact REQUEST\n"
    "This program links CGAL's arrangements and is distributed under the GNU General Public License,\n"
    "version 3 or later; its own sources are under the Apache License 2.0.\n";

void answer(const ExactRequest& request) {
  const TriangleTree tree(request.scene);
  std::mutex one_line;
  tbb::task_arena arena(request.threads > 0 ? request.threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(size_t{0}, request.receivers.size(), [&](size_t i) {
      const std::string line = to_line(i, exact_light(tree, request.receivers[i], request.scene.light()));
      const std::scoped_lock lock(one_line);
      if (std::puts(line.c_str()) < 0 || std::fflush(stdout) != 0)
        fail_environment("cannot write to standard output");
    });
  });
}

}  // namespace
}  // namespace umbrameter

int main(int argc, char** argv) {
  using namespace umbrameter;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (argc != 2 || argv[1][0] == '-') {
    const bool is_asked =
        argc == 2 && (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "--version") == 0);
    fmt::print(is_asked ? stdout : stderr, kAbout, kVersion);
    return is_asked ? 0 : 2;
  }
  try {
    answer(read_exact_request(argv[1]));
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "umbrameter-exact: error: {}\n", error.what());
    return error.kind() == ErrorKind::input ? 2 : error.kind() == ErrorKind::environment ? 3 : 4;
  } catch (const std::exception& error) {
    fmt::print(stderr, "umbrameter-exact: error: internal: {}\n", error.what());
    return 4;
  }
}
