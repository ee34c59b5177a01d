// SPDX-License-Identifier: Apache-2.0
#pragma once
// What our own source text was when this was built, by what it can change (cmake/code_hashes.cmake writes them).

namespace umbrameter {

extern const char* const kReferenceCodeHash;  // core, scenes, reference
extern const char* const kRealtimeCodeHash;   // core, scenes, realtime, engines
extern const char* const kScoringCodeHash;    // core, metrics, lab, the rows of results that measure
// Of what a verb of study makes of these, alone.
extern const char* const kRegressCodeHash;
extern const char* const kSelftestCodeHash;
extern const char* const kTraitsCodeHash;
extern const char* const kStressCodeHash;
extern const char* const kTuneCodeHash;

}  // namespace umbrameter
