// SPDX-License-Identifier: Apache-2.0
#include "plane_visibility.glsl"

void main() { out_visibility = plane_visibility(view_center); }
