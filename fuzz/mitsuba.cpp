// SPDX-License-Identifier: Apache-2.0
// Mitsuba files: any bytes are a scene or a sentence. They may name mesh.obj, mask.png and themselves.

#include "fuzz/fuzz_foreign.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return umbrameter::fuzz::read_foreign("fuzz.xml", {data, size});
}
