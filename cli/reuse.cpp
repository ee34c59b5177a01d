// SPDX-License-Identifier: Apache-2.0
#include "cli/reuse.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/reference_renderer.h"
#include "cli/run_renderer.h"
#include "cli/staging.h"
#include "core/error.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

Makers makers_of(const Renderer& realtime) {
  return {kReferenceMaker, run_identity(realtime), hash_folder(find_home().shaders)};
}

/// As long as the cache that it is given to.
std::shared_ptr<const std::filesystem::path> scratch_in(const std::filesystem::path& folder) {
  if (folder.empty()) return nullptr;
  const auto staging = std::make_shared<const Staging>(folder);
  return {staging, &staging->folder()};
}

}  // namespace

VerbCache open_cache(const GlobalOptions& options, const std::filesystem::path& folder, bool reuse) {
  const auto open = [&options](const PictureQuality& picture) {
    return open_reference_renderer(options, picture);
  };
  return VerbCache({open, kReferenceMaker, makers_of, hash_of_technique},
                   {folder, scratch_in(folder), reuse});
}

std::string hash_of_technique(const std::string& id_or_path) {
  return find_run(id_or_path, find_home()).hash;
}

std::string reused_line(const ReusedTruths& reused) {
  return fmt::format("{} truth{} reused, about {:.2g} s saved", reused.count, reused.count == 1 ? "" : "s",
                     reused.saved_s);
}

std::optional<std::string> reused_frames_line(size_t count) {
  if (count == 0) return std::nullopt;
  return fmt::format("{} stored picture{} of runs reused", count, count == 1 ? "" : "s");
}

void require_store(bool no_reuse, const GlobalOptions& options) {
  if (no_reuse && options.out.empty())
    fail_input("--no-reuse needs --out", {}, "without a store nothing is reused");
}

void print_reuse(VerbCache& cache) {
  print_warnings(cache.take_warnings());
  const ReusedTruths truths = cache.take_reused();
  if (truths.count > 0) print_note(reused_line(truths));
  if (const auto line = reused_frames_line(cache.take_reused_frames())) print_note(*line);
  const size_t answers = cache.answers().take_reused();
  if (answers > 0) print_note(fmt::format("{} stored answer{} reused", answers, answers == 1 ? "" : "s"));
}

}  // namespace umbrameter
