// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/byte_source.h"

#include "core/error.h"
#include "scenes/file_ending.h"

#include <zstd.h>

#include <fstream>
#include <vector>

namespace umbrameter {
namespace {

class FileSource final : public ByteSource {
 public:
  explicit FileSource(const std::filesystem::path& path) : path_(path), stream_(path, std::ios::binary) {
    if (!stream_ || std::filesystem::is_directory(path)) fail("cannot open the mesh file");
  }

  size_t read(std::span<char> block) override {
    stream_.read(block.data(), static_cast<std::streamsize>(block.size()));
    if (stream_.bad()) fail("cannot read the mesh file");
    const auto count = static_cast<size_t>(stream_.gcount());
    total_ += count;
    if (total_ > kMaxMeshFileBytes) fail("the mesh file is larger than 4 GiB");
    return count;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {path_.string()}); }

  std::filesystem::path path_;
  std::ifstream stream_;
  uint64_t total_ = 0;
};

class ZstdSource final : public ByteSource {
 public:
  explicit ZstdSource(const std::filesystem::path& path)
      : path_(path),
        file_(path),
        stream_(ZSTD_createDStream(), ZSTD_freeDStream),
        packed_(ZSTD_DStreamInSize()) {
    UMBRAMETER_ASSERT(stream_ != nullptr, "no zstd decompressor");
  }

  size_t read(std::span<char> block) override {
    ZSTD_outBuffer out{block.data(), block.size(), 0};
    while (out.pos < out.size) {
      if (input_.pos == input_.size && !refill()) break;
      const size_t needed = ZSTD_decompressStream(stream_.get(), &out, &input_);
      if (ZSTD_isError(needed)) fail(fmt::format("the zstd data is broken: {}", ZSTD_getErrorName(needed)));
      frame_is_open_ = needed != 0;
    }
    total_ += out.pos;
    if (total_ > kMaxMeshFileBytes) fail("the mesh file is larger than 4 GiB when decompressed");
    return out.pos;
  }

 private:
  bool refill() {
    const size_t count = file_.read(packed_);
    if (count == 0 && frame_is_open_) fail("the zstd data ends early: the file is truncated");
    input_ = {packed_.data(), count, 0};
    return count > 0;
  }
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {path_.string()}); }

  std::filesystem::path path_;
  FileSource file_;
  std::unique_ptr<ZSTD_DStream, size_t (*)(ZSTD_DStream*)> stream_;
  std::vector<char> packed_;
  ZSTD_inBuffer input_{nullptr, 0, 0};
  bool frame_is_open_ = true;  // an empty file is not a whole frame
  uint64_t total_ = 0;
};

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::filesystem::path& path) {
  if (has_ending(path.string(), ".zst")) return std::make_unique<ZstdSource>(path);
  return std::make_unique<FileSource>(path);
}

}  // namespace umbrameter
