// SPDX-License-Identifier: Apache-2.0
#pragma once
// The score of a picture as JSON: what `score --json` and Python say.

#include "lab/pictures/picture_score.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbrameter {

/// The score of a picture with the files it compared.
nlohmann::ordered_json picture_json(const PictureScore& picture, const std::string& test_file,
                                    const std::string& reference_file);

}  // namespace umbrameter
