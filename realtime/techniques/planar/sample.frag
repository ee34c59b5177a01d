// SPDX-License-Identifier: Apache-2.0
// One light sample's share of the mean.
#include "plane_visibility.glsl"

void main() { out_visibility = plane_visibility(view_point) / float(i_count); }
