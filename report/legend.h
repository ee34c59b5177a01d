// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the pictures' colours and scales mean, and how exact the pixels inside the page are.

#include <string>

namespace umbrameter {

std::string legend();

}  // namespace umbrameter
