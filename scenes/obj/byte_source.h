// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bytes of a mesh file, plain or zstd-compressed, read in blocks.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace umbrameter {

/// Limit of the decompressed size of one mesh file.
inline constexpr uint64_t kMaxMeshFileBytes = uint64_t{4} << 30;

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Fills the front of `block`; returns how much, 0 at the end. Error{input} when the file cannot be read,
  /// is not a whole zstd file, or is larger than kMaxMeshFileBytes.
  virtual size_t read(std::span<char> block) = 0;
};

/// Opens `path`, decompressing when it ends in ".zst". Error{input} when it cannot be opened.
std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path);

}  // namespace umbrameter
