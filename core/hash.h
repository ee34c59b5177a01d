// SPDX-License-Identifier: Apache-2.0
#pragma once
// Content hashes (XXH3, 128 bit) for scenes, shader texts and result keys.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace umbrameter {

/// Feeds values in order; equal sequences give equal hashes on every machine of the same endianness.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  Hasher& bytes(const void* data, size_t size);
  Hasher& text(std::string_view value);  // length first, so that "ab","c" differs from "a","bc"
  template <class T>
  Hasher& values(std::span<const T> items) {
    static_assert(std::is_trivially_copyable_v<T>);
    return bytes(items.data(), items.size_bytes());
  }
  Hasher& number(double value);
  /// 32 lower-case hex digits.
  std::string hex() const;

 private:
  void* state_;
};

std::string hash_text(std::string_view value);

}  // namespace umbrameter
