// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the page's pixels lie: inside it up to a budget, beyond that in script files beside it, which a page opened from
// disk may load where it may not fetch.

#include <filesystem>
#include <map>
#include <string>

namespace umbrameter {

/// Packed planes (report/plane_code.h) by name.
using PackedPlanes = std::map<std::string, std::string>;

/// What stays inside one page: opens in a second or so.
inline constexpr size_t kPageBudget_bytes = 50'000'000;

class PlaneStore {
 public:
  /// Files go into `folder`, which is made when the first one is needed.
  explicit PlaneStore(std::filesystem::path folder, size_t budget_bytes = kPageBudget_bytes);

  /// `id`: letters, digits and '-', once. Files need not be atomic: the page that names them is written after them.
  void add(const std::string& id, const PackedPlanes& planes);

  /// <script> data blocks of what lies inside.
  const std::string& blocks() const { return blocks_; }
  /// True when `id` lies in <folder>/<id>.js.
  bool has_files() const { return has_files_; }
  std::string folder_name() const { return folder_.filename().string(); }

 private:
  std::filesystem::path folder_;
  size_t budget_bytes_;
  std::string blocks_;
  bool has_files_ = false;
};

}  // namespace umbrameter
