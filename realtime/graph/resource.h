// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[resource]]`: a texture that passes write and read.

#include "realtime/graph/expression.h"
#include "realtime/graph/texture.h"

#include <string>
#include <vector>

namespace umbrameter {

struct ResourceDeclaration {
  std::string name;
  std::string format;  // a name of texture_formats() in realtime/harness/objects.h
  TextureKind kind = TextureKind::flat;
  Expression width, height;
  Expression layers;                       // of an array
  Expression levels, samples, anisotropy;  // 1 when left out
  TextureFilter filter = TextureFilter::nearest;
  TextureWrap wrap = TextureWrap::border;
  std::vector<double> border{0.0};
  bool compare = false;  // depth comparison sampler (sampler2DShadow and its kin, GEQUAL: reversed depth)
  Expression condition;
  FileLocation where;
};

}  // namespace umbrameter
