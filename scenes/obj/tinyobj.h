// SPDX-License-Identifier: Apache-2.0
#pragma once
// tinyobjloader in double precision; its warnings are not ours. Its implementation is in load_obj.cpp.

#define TINYOBJLOADER_USE_DOUBLE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop
