// SPDX-License-Identifier: Apache-2.0
#include "project_point.glsl"

void main() { project_from(view_center); }
