// SPDX-License-Identifier: Apache-2.0
#pragma once
// Output appears whole or not at all: it is made in a hidden folder beside its place and moved at the end.

#include "cli/interruption.h"

#include <filesystem>
#include <string>

namespace umbrameter {

/// A hidden folder in `parent` (made when missing). What is left of it goes when this does, and so do parents
/// that were made for it and are empty. Error{input} when the place cannot be written, which is found
/// before any work is done.
class Staging {
 public:
  explicit Staging(const std::filesystem::path& parent);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const std::filesystem::path& folder() const { return place_.folder; }

 private:
  explicit Staging(TemporaryPlace place);

  TemporaryPlace place_;
  RemovedOnInterruption registration_;
};

/// Only a folder that earlier results left there may be replaced: Error{input} for anything else at `out`.
void check_results_folder(const std::filesystem::path& out);

/// One image file to be written: checks name and place at once. Write to `staged()`, then `publish()`.
class StagedFile {
 public:
  /// Error{input} unless `target` ends in `extension` and is not a folder.
  StagedFile(std::filesystem::path target, const std::string& extension);
  std::filesystem::path staged() const { return staging_.folder() / target_.filename(); }
  const std::filesystem::path& target() const { return target_; }
  void publish() const;

 private:
  std::filesystem::path target_;
  Staging staging_;
};

}  // namespace umbrameter
