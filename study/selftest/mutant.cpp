// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/mutant.h"

#include "core/error.h"
#include "core/files.h"

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

void copy_texts(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".png" || extension == ".md") continue;
    write_file_atomically(to / entry.path().filename(), read_file(entry.path()));
  }
}

std::string patched(std::string text, const Patch& patch) {
  const size_t at = text.find(patch.from);
  UMBRAMETER_ASSERT(at != std::string::npos && text.find(patch.from, at + 1) == std::string::npos,
                    "'{}' is not once in {}", patch.from, patch.file);
  return text.replace(at, patch.from.size(), patch.to);
}

}  // namespace

TechniqueChoice mutant(const TechniqueChoice& choice, const std::string& name, std::span<const Patch> patches,
                       const SelftestSettings& settings) {
  const fs::path folder = settings.scratch_folder / name;
  create_folder(folder);
  copy_texts(settings.shaders_folder / "lib", folder);  // includes look beside their file first
  copy_texts(settings.techniques_folder / choice.technique, folder);
  for (const Patch& patch : patches) {
    write_file_atomically(folder / patch.file, patched(read_file(folder / patch.file), patch));
  }
  return {folder.string(), choice.parameters};
}

}  // namespace umbrameter
