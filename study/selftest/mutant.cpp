#include "study/selftest/mutant.h"

#include "core/error.h"
#include "core/files.h"

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

fs::path source_of(const fs::path& folder, const std::string& file, const SelftestSettings& settings) {
  return fs::exists(folder / file) ? folder / file : settings.shaders_folder / "lib" / file;
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
  for (const fs::directory_entry& entry :
       fs::directory_iterator(settings.techniques_folder / choice.technique)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".png" || extension == ".md") continue;
    write_file_atomically(folder / entry.path().filename(), read_file(entry.path()));
  }
  for (const Patch& patch : patches) {
    write_file_atomically(folder / patch.file,
                          patched(read_file(source_of(folder, patch.file, settings)), patch));
  }
  return {folder.string(), choice.parameters};
}

}  // namespace umbrameter
