// SPDX-License-Identifier: Apache-2.0
#include "report/plane_store.h"

#include "core/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {

PlaneStore::PlaneStore(std::filesystem::path folder, size_t budget_bytes)
    : folder_(std::move(folder)), budget_bytes_(budget_bytes) {}

void PlaneStore::add(const std::string& id, const PackedPlanes& planes) {
  const std::string json = nlohmann::json(planes).dump();  // base64: nothing that could end the script
  if (blocks_.size() + json.size() <= budget_bytes_) {
    blocks_ += fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, json);
    return;
  }
  if (!has_files_) create_folder(folder_);
  has_files_ = true;
  write_file_atomically(folder_ / (id + ".js"), fmt::format("take_planes(\"{}\", {});\n", id, json));
}

}  // namespace umbrameter
