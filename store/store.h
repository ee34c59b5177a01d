// SPDX-License-Identifier: Apache-2.0
#pragma once
// The results folder that remembers: store.sqlite beside content-addressed images (docs/store.md). An entry is a JSON
// text under a key that stands for everything that can change it. Several processes may write at once.

#include "store/database.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

inline constexpr int kStoreSchema = 1;
inline constexpr const char* kStoreFile = "store.sqlite";

/// What an entry is about.
/// `device` and `page` are of one machine: they do not go along when stores are merged.
enum class EntryKind { run, reference, parity, verdict, scene, device, page, answer, frame };
std::string_view to_text(EntryKind kind);
std::optional<EntryKind> read_kind(std::string_view text);

struct Entry {
  std::string key;
  EntryKind kind = EntryKind::run;
  std::string json;  // names of images are those of objects
};

class Store {
 public:
  /// Opens the store in `folder`, or (write) makes one. A damaged database is set aside as store.sqlite.damaged, what
  /// can still be read of it is kept, and a warning says so. Error{input} for a store of another schema or (read) none,
  /// Error{environment} when the place cannot be used.
  Store(const std::filesystem::path& folder, Database::Mode mode);

  /// The entry, as it was put. One that was altered, or whose images are missing or altered, is dropped with a warning
  /// and absent.
  std::optional<std::string> find(const std::string& key);

  /// Adds or replaces an entry; it is on the disk when this returns.
  void put(const Entry& entry);

  /// Keeps the image; returns its name for the entry that will be put.
  std::string keep(const std::filesystem::path& image);

  std::filesystem::path path_of(const std::string& object) const { return folder_ / object; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Every sound entry of the kind, by key.
  std::vector<Entry> entries(EntryKind kind);

  /// What was found damaged so far; each is said once.
  std::vector<std::string> take_warnings();

 private:
  bool has_intact_images(const std::string& json);
  bool is_remembered(const std::string& object);
  void remember(const std::string& object);
  void drop(const std::string& key, std::string_view why);

  std::filesystem::path folder_;
  Database::Mode mode_;
  std::vector<std::string> warnings_;
  Database database_;
};

/// Whether there is a store in `folder`.
bool has_store(const std::filesystem::path& folder);

/// The names of objects that stand as texts of their own in a JSON text, in order.
std::vector<std::string> object_names(std::string_view json);

}  // namespace umbrameter
