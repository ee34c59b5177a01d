// SPDX-License-Identifier: Apache-2.0
#pragma once
// Truths in a store: how one is described, kept and found again, whoever rendered it. Not here: under which key
// (lab/keys.h) and when it is asked for.

#include "core/renderer.h"
#include "results/json/record.h"
#include "store/store.h"

#include <filesystem>
#include <optional>
#include <string>

namespace umbrameter {

/// What is said of a rendered truth, without files. Error{input} when a plane of core/renderer.h is missing.
ReferenceResult describe_truth(const Frame& frame);

struct RenderedTruth {
  Frame frame;  // with metadata
  ReferenceResult result;
  double duration_s = 0.0;
};

/// The truth of a view. Throws what the renderer and describe_truth() do.
RenderedTruth render_truth(Renderer& reference, const Scene& scene, const RenderRequest& request,
                           Progress& progress);

/// The truth as it was rendered, all planes, with the time it took then. Absent when the store has none that is sound.
std::optional<Frame> find_truth(Store& store, const std::string& key);

/// Puts it into the store; `head` gets the time it took. `scratch`: an existing folder for a file in the making.
void keep_truth(Store& store, const std::string& key, RecordHead head, const RenderedTruth& truth,
                const std::filesystem::path& scratch);

/// Puts parity into the store under a parity_key(); its picture is an object there.
void keep_parity(Store& store, const std::string& key, const ParityNumbers& parity);

/// Keeps the image as an object; returns its name for an entry.
std::string keep_image(Store& store, const Image& image, const std::filesystem::path& scratch);

}  // namespace umbrameter
