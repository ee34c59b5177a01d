// SPDX-License-Identifier: Apache-2.0
#include "core/hash.h"

#include "core/error.h"

#include <xxhash.h>

namespace umbrameter {

namespace {

XXH3_state_t* xxh(void* state) {
  return static_cast<XXH3_state_t*>(state);
}

}  // namespace

Hasher::Hasher() : state_(XXH3_createState()) {
  UMBRAMETER_ASSERT(state_ != nullptr, "no memory for a hash state");
  XXH3_128bits_reset(xxh(state_));
}

Hasher::~Hasher() {
  XXH3_freeState(xxh(state_));
}

Hasher& Hasher::bytes(const void* data, size_t size) {
  XXH3_128bits_update(xxh(state_), data, size);
  return *this;
}

Hasher& Hasher::text(std::string_view value) {
  const uint64_t size = value.size();
  return bytes(&size, sizeof size).bytes(value.data(), value.size());
}

Hasher& Hasher::number(double value) {
  return bytes(&value, sizeof value);
}

std::string Hasher::hex() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(xxh(state_));
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hash_text(std::string_view value) {
  return Hasher().text(value).hex();
}

}  // namespace umbrameter
