// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[resource]]`: a texture that passes write and read. Buffers: realtime/graph/buffer.h.

#include "realtime/graph/expression.h"
#include "realtime/graph/texture.h"

#include <string>
#include <vector>

namespace umbrameter {

struct ResourceDeclaration {
  std::string name;
  /// Names of texture_formats() in realtime/harness/objects.h. Several are the choices of `format_parameter`, alike but for
  /// their bits.
  std::vector<std::string> formats;
  std::string format_parameter;
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

  /// The format that the parameters choose.
  const std::string& format(const ExpressionVariables& variables) const {
    return format_parameter.empty() ? formats.front()
                                    : formats.at(static_cast<size_t>(variables.at(format_parameter)));
  }
};

}  // namespace umbrameter
