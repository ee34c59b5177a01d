#include "project_point.glsl"

void main() { project_from(view_point); }
