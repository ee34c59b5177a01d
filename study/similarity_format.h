// SPDX-License-Identifier: Apache-2.0
#pragma once
// Second opinions for people.

#include "study/diagnosis_format.h"
#include "study/similarity.h"

namespace umbrameter {

TermLines similarity_lines(const Similarity& similarity);

}  // namespace umbrameter
