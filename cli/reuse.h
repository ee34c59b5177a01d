// SPDX-License-Identifier: Apache-2.0
#pragma once
// How verbs open what they share through the store in --out, and what they say of it.

#include "cli/verbs.h"
#include "lab/verb_cache.h"

#include <optional>
#include <string>

namespace umbrameter {

/// With an empty `folder` nothing is remembered. Error{input} for one that cannot be written. `options` must outlive it.
/// Its makers() are for what open_realtime_renderer() opens.
VerbCache open_cache(const GlobalOptions& options, const std::filesystem::path& folder, bool reuse);

/// HashOfTechnique of techniques and engines.
std::string hash_of_technique(const std::string& id_or_path);

/// "3 truths reused, about 1.2 s saved".
std::string reused_line(const ReusedTruths& reused);

/// "2 stored pictures of runs reused"; absent for none.
std::optional<std::string> reused_frames_line(size_t count);

/// Error{input} for --no-reuse without --out.
void require_store(bool no_reuse, const GlobalOptions& options);

/// Prints what was found damaged and how much was reused, where there is something to say.
void print_reuse(VerbCache& cache);

}  // namespace umbrameter
