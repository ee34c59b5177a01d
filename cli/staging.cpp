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

}  // namespace

Staging::Staging(const std::filesystem::path& parent)
    : parent_(parent),
      parent_is_ours_(!std::filesystem::exists(parent)),
      folder_(parent / fmt::format(".umbrameter-{}", getpid())) {
  registration_.emplace(folder_);
  create_folder(folder_);
}

Staging::~Staging() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
  if (parent_is_ours_) std::filesystem::remove(parent_, ignored);  // only when empty
}

StagedFile::StagedFile(std::filesystem::path target, const std::string& extension)
    : target_(checked_target(std::move(target), extension)), staging_(folder_of(target_)) {}

void StagedFile::publish() const {
  rename_into_place(staged(), target_);
}

}  // namespace umbrameter
