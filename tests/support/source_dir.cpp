// SPDX-License-Identifier: Apache-2.0
#include "tests/support/source_dir.h"

std::filesystem::path source_dir() {
  return UMBRAMETER_SOURCE_DIR;
}
