// SPDX-License-Identifier: Apache-2.0
#pragma once
// What our own source text was when this was built, by what it can change (cmake/code_hashes.cmake writes them).

namespace umbrameter {

extern const char* const kReferenceCodeHash;  // core, scenes, reference
extern const char* const kRealtimeCodeHash;   // core, scenes, realtime, engines
extern const char* const kScoringCodeHash;    // core, metrics, lab, the rows of results that measure

}  // namespace umbrameter
