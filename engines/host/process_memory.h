// SPDX-License-Identifier: Apache-2.0
#pragma once
// How much memory a process group holds.

#include <cstdint>

#include <sys/types.h>

namespace umbrameter {

/// Sum over all processes of the group, from /proc; memory that they share counts once for each.
uint64_t resident_bytes_of_group(pid_t group);

}  // namespace umbrameter
