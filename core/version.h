// SPDX-License-Identifier: Apache-2.0
#pragma once
// Version and commit of this build, taken when it is built (cmake/umbrameter_version.cmake).

namespace umbrameter {

extern const char* const kVersion;
/// `git describe --always --dirty` of the sources, "unknown" where they are not in a checkout.
extern const char* const kCommit;

}  // namespace umbrameter
