// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[view]]`: a camera at the light.

#include "realtime/graph/expression.h"

#include <string>

namespace umbrameter {

/// Where a view looks from: the light's centre, or a point of the scrambled Sobol set on the light.
enum class ViewOrigin { light_center, light_sample };

struct ViewDeclaration {
  std::string name;
  ViewOrigin from = ViewOrigin::light_center;
  Expression sample;            // of light_sample: which point
  std::string fit = "visible";  // a name of light_fits(), or a choice parameter of such names
  Expression snap;              // not 0: the map moves in whole texels only
  Expression size;              // texels a side, for the texel size
  FileLocation where;
};

}  // namespace umbrameter
