// SPDX-License-Identifier: Apache-2.0
#pragma once
// Second opinions for people.

#include "metrics/error/lit_similarity.h"
#include "results/diagnosis_format.h"

namespace umbrameter {

TermLines similarity_lines(const Similarity& similarity);

}  // namespace umbrameter
