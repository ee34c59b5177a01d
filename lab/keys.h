// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a stored result stands under: a hash of everything that can change its numbers, and of nothing else. Labels, titles,
// names of scenes and the number of threads are not in it.

#include "lab/validation.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace umbrameter {

/// What makes the pictures beside our own C++, whose hash is built in (store/code_hashes.h).
struct Makers {
  std::string reference;  // the ray tracer with its version
  std::string realtime;   // the GL device with its driver's version
  std::string
      shaders;  // hash of the folder of shaders: techniques' own hashes leave out those of the G-buffer
};

/// Without `skip_proven` sample counts differ, and nothing else.
std::string reference_key(const Scene& scene, const PictureQuality& picture, const Makers& makers,
                          bool skip_proven = true);
/// Of a scene of which no more is known.
std::string reference_key(const std::string& scene_hash, size_t active_light, const PictureQuality& picture,
                          const Makers& makers, bool skip_proven = true);

/// Of a run scored against the truth of `reference`, a reference_key(). The parameters are the complete set.
std::string run_key(const std::string& reference, const TechniqueRun& run, uint64_t seed,
                    const MetricChoice& metrics, const Makers& makers);

/// Of a picture of real time, whatever it is compared with. `scene_hash`: hash_scene() of the scene as it stands;
/// `technique_hash`: of its files, empty for none.
std::string frame_key(const std::string& scene_hash, size_t active_light, const RenderRequest& request,
                      const std::string& technique_hash, const Makers& makers);

/// Of the G-buffer compared with the truth of `reference`.
std::string parity_key(const std::string& reference, const Makers& makers);

/// Of a run_key()'s run under a motion other than the scene's (ValidationPlan::motion); `run` itself without one.
std::string moved_run_key(const std::string& run, const std::string& motion);

/// Of a run_key()'s run with what `plan` wants beside its numbers: times, sequences, a limit.
std::string validated_run_key(const std::string& run, const ValidationPlan& plan);

/// Of the note under which validated_run_key() a run_key()'s run is kept.
std::string validated_note_key(const std::string& run);

/// Of a verdict between two runs, by their keys.
std::string verdict_key(const std::string& run, const std::string& baseline);

/// Of what mends a run's faults, by its validated_run_key().
std::string causes_key(const std::string& run);

/// Names and bytes of every file below; places do not count.
std::string hash_folder(const std::filesystem::path& folder);

}  // namespace umbrameter
