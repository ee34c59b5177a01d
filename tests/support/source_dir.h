// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the sources are that tests read. Only source_dir.cpp is compiled with the path.

#include <filesystem>

std::filesystem::path source_dir();
