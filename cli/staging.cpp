// SPDX-License-Identifier: Apache-2.0
#include "cli/staging.h"

#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>

#include <unistd.h>

namespace umbrameter {
namespace {

std::filesystem::path checked_target(std::filesystem::path target, const std::string& extension) {
  if (target.extension() != extension) {
    fail_input(fmt::format("the output '{}' does not end in '{}'", target.string(), extension));
  }
  if (std::filesystem::is_directory(target))
    fail_input(fmt::format("the output '{}' is a folder", target.string()));
  return target;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// A folder of this process in `parent`, and those of its parents that do not exist yet.
TemporaryPlace hidden_place(const std::filesystem::path& parent) {
  TemporaryPlace place{parent / fmt::format(".umbrameter-{}", getpid()), {}};
  for (auto missing = parent; !missing.empty() && !std::filesystem::exists(missing);
       missing = missing.parent_path()) {
    place.made_parents.push_back(missing);
  }
  return place;
}

}  // namespace

void check_results_folder(const std::filesystem::path& out) {
  if (std::filesystem::exists(out) && !std::filesystem::is_directory(out))
    fail_input(fmt::format("the output '{}' is not a folder", out.string()));
  if (!std::filesystem::exists(out / "images") || std::filesystem::exists(out / "results.json")) return;
  fail_input(fmt::format("'{}' exists and is not of an earlier validation", (out / "images").string()), {},
             "choose another --out");
}

Staging::Staging(TemporaryPlace place) : place_(std::move(place)), registration_(place_) {}

// Delegates, so that the destructor runs when the folder cannot be made.
Staging::Staging(const std::filesystem::path& parent) : Staging(hidden_place(parent)) {
  create_folder(place_.folder);
}

Staging::~Staging() {
  remove_place(place_);
}

StagedFile::StagedFile(std::filesystem::path target, const std::string& extension)
    : target_(checked_target(std::move(target), extension)), staging_(folder_of(target_)) {}

void StagedFile::publish() const {
  rename_into_place(staged(), target_);
}

}  // namespace umbrameter
