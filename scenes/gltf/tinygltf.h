// SPDX-License-Identifier: Apache-2.0
#pragma once
// tinygltf without its picture loaders; its warnings are not ours. Its implementation is in gltf_model.cpp.

#include <nlohmann/json.hpp>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_JSON
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wnull-dereference"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop
