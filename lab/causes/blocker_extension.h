// SPDX-License-Identifier: Apache-2.0
#pragma once
// The truth's blockers as a substitution may know them: how far they are, but not whether there are any.

#include "core/image.h"

namespace umbrameter {

/// The planes blocker_offset of `truth`; a pixel none of whose rays is blocked has those of the nearest pixel that has any. Told
/// that nothing blocks, a technique would know what is fully lit, and any acne would be the search's. Zero everywhere where
/// nothing is blocked.
Image extended_blockers(const Image& truth);

}  // namespace umbrameter
