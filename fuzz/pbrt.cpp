// SPDX-License-Identifier: Apache-2.0
// pbrt files: any bytes are a scene or a sentence. They may name mask.png and themselves.

#include "fuzz/fuzz_foreign.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return umbrameter::fuzz::read_foreign("fuzz.pbrt", {data, size});
}
