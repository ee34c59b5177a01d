// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[view]]`: a camera at the light.

#include "realtime/graph/expression.h"

#include <array>
#include <optional>
#include <string>

namespace umbrameter {

/// Where a view looks from.
enum class ViewOrigin {
  light_center,
  light_sample,  // a point of the scrambled Sobol set on the light
  light_face,    // the light's centre, through a face of the cube around it
  light_half     // the light's centre, through a paraboloid that holds half of all directions
};

struct ViewDeclaration {
  std::string name;
  ViewOrigin from = ViewOrigin::light_center;
  Expression index;             // of light_sample: which point; of light_face and light_half: which one
  std::string fit = "visible";  // a name of light_fits(), or a choice parameter of such names
  Expression snap;              // not 0: the map moves in whole texels only
  Expression size;              // texels a side, for the texel size
  std::optional<std::array<Expression, 2>> offset_texels;  // moves the map aside
  /// A family of views: how many, and what their other expressions call the index. None: a single view.
  Expression count;
  std::string variable;
  /// Covers the part of the camera's frustum between these distances along its axis only.
  std::optional<std::array<Expression, 2>> slice_world;
  FileLocation where;

  bool is_family() const { return !count.is_empty(); }
};

}  // namespace umbrameter
