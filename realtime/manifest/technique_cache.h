// SPDX-License-Identifier: Apache-2.0
#pragma once
// Techniques read once and again only when one of their files changed: a tuner asks for the same one hundreds of times.

#include "realtime/manifest/technique.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace umbrameter {

class TechniqueCache {
 public:
  TechniqueCache(std::filesystem::path techniques_folder, std::filesystem::path shaders_folder)
      : techniques_folder_(std::move(techniques_folder)), shaders_folder_(std::move(shaders_folder)) {}

  /// As find_technique. A file counts as changed when its time or size differs, or it came or went.
  std::shared_ptr<const Technique> find(const std::string& id_or_path);

 private:
  struct Known {
    std::string files;  // names, times and sizes
    std::shared_ptr<const Technique> technique;
  };

  std::string files_of(const std::filesystem::path& folder) const;

  std::filesystem::path techniques_folder_, shaders_folder_;
  std::map<std::string, Known> known_;
};

}  // namespace umbrameter
