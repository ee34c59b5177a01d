// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene with its truth and pictures of it, of several seeds and of the scene changed, as the gate sees them.

#include "lab/examine.h"
#include "lab/validation.h"
#include "metrics/faults/resolved.h"
#include "results/picture_quality.h"

#include <map>
#include <string>

namespace umbrameter {

struct PictureRenderers {
  Renderer& reference;
  Renderer& reference_other_threads;  // the same with another number of threads
  Renderer& realtime;
};

struct TechniqueChoice {
  std::string technique;  // id or folder
  ParameterValues parameters;
};

/// `parameters` over those of `choice`.
TechniqueChoice with(TechniqueChoice choice, const ParameterValues& parameters);

/// Everything is made once; what is returned by reference lives as long as this.
class ScenePictures {
 public:
  /// Size and seed are those of `picture`; its samples are the reference renderer's own.
  ScenePictures(SceneJob job, const PictureQuality& picture, PictureRenderers renderers, Progress& progress);

  const std::string& name() const { return job_.name; }
  const Scene& scene() const { return job_.scene; }
  /// Of its truths and pictures unless they name another: the first, or the last `repeat`'s.
  uint64_t seed() const { return seed_; }
  const glm::dvec3& eye_world() const { return job_.scene.camera.eye_world; }

  /// Truths and pictures that name no seed are of this one from here on.
  void repeat(uint64_t seed) { seed_ = seed; }

  const Image& truth();
  /// The truth again with other samples: a picture without a fault.
  const Image& exact();
  const Examined& examined_exact();
  /// The truth of another scene under this one's name: visibility, its halves and its blockers alone. Elsewhere,
  /// where a changed scene shows another surface, this one's truth stays.
  Image truth_of_shadows(const Scene& changed);
  Image truth_of(const Scene& changed, uint64_t seed);
  Image truth_with_other_threads();

  const Image& picture(const TechniqueChoice& choice);
  const Examined& examined(const TechniqueChoice& choice);
  Image picture(const TechniqueChoice& choice, uint64_t seed);
  /// By the map that `choice` draws.
  Unresolved unresolved(const TechniqueChoice& choice);
  /// The shadows that `choice` draws of a changed scene, on the surfaces of this one.
  Image picture_of_shadows(const TechniqueChoice& choice, const Scene& changed);
  /// The same on the surfaces of another picture of this scene; `blocker_truth` as RenderRequest's.
  Image shadows_of(const TechniqueChoice& choice, const Scene& changed, const Image& surfaces,
                   const Image* blocker_truth = nullptr);

 private:
  std::string key_of(const std::string& what) const;
  Image render(Renderer& renderer, const Scene& scene, uint64_t seed, const TechniqueChoice& choice,
               const Image* blocker_truth = nullptr);

  SceneJob job_;
  RenderRequest request_;
  PictureRenderers renderers_;
  Progress& progress_;
  uint64_t seed_;
  std::map<std::string, Image> pictures_;
  std::map<std::string, Examined> examined_;
};

}  // namespace umbrameter
