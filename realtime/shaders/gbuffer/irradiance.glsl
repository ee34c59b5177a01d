// Irradiance of the whole light without anything in its way: the mean of scenes/light.h LightSample::irradiance_weight
// over points spread evenly in the measure geometric visibility averages over.

const int kLightPoints = 256;

// Two points a vec4, for rect in [-1,1]^2, for the other lights in the unit disk.
layout(std140, binding = 2) uniform LightPointsBlock { vec4 light_points[kLightPoints / 2]; };

const int kRect = 0, kDisk = 1, kSphere = 2, kSun = 3;
const float kPi = 3.14159265358979;

// Irradiance weight times the solid angle or area that the lateral coordinates span, over the measure of `light_points`.
float flat_weight(vec2 lateral, vec3 to_center_world, vec3 n_world, float area_world) {
  vec3 to_point = to_center_world + lateral.x * frame.light_extent.x * frame.light_tangent_world.xyz +
                  lateral.y * frame.light_extent.y * frame.light_bitangent_world.xyz;
  float distance_squared = dot(to_point, to_point);
  float cos_receiver = max(0.0, dot(n_world, to_point));
  float cos_light = max(0.0, -dot(frame.light_direction_world.xyz, to_point));
  return area_world * cos_receiver * cos_light / (distance_squared * distance_squared);
}

float sun_weight(vec2 lateral, vec3 n_world) {
  vec2 offset = frame.light_extent.x * lateral;
  vec3 to_light = offset.x * frame.light_tangent_world.xyz + offset.y * frame.light_bitangent_world.xyz -
                  frame.light_direction_world.xyz;
  return max(0.0, dot(n_world, normalize(to_light)));
}

// The cone a sphere subtends, as a disk of tan(half angle) around its axis.
struct SphereCone {
  vec3 axis_world, tangent_world, bitangent_world;
  float tan_half_angle;
};

SphereCone cone_of_sphere(vec3 to_center_world, float radius_world) {
  SphereCone cone;
  float distance_squared = dot(to_center_world, to_center_world);
  cone.axis_world = to_center_world * inversesqrt(distance_squared);
  cone.tan_half_angle = radius_world * inversesqrt(distance_squared - radius_world * radius_world);
  vec3 other = abs(cone.axis_world.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  cone.tangent_world = normalize(cross(other, cone.axis_world));
  cone.bitangent_world = cross(cone.axis_world, cone.tangent_world);
  return cone;
}

// Solid angle of an element of the tan plane is its area / length^3.
float sphere_weight(vec2 lateral, SphereCone cone, vec3 n_world) {
  vec2 offset = cone.tan_half_angle * lateral;
  vec3 direction = cone.axis_world + offset.x * cone.tangent_world + offset.y * cone.bitangent_world;
  float length_squared = dot(direction, direction);
  float disk_area = kPi * cone.tan_half_angle * cone.tan_half_angle;
  return disk_area * max(0.0, dot(n_world, direction)) / (length_squared * length_squared);
}

vec2 light_point(int i) { return (i & 1) == 0 ? light_points[i / 2].xy : light_points[i / 2].zw; }

float unshadowed_irradiance(vec3 p_world, vec3 n_world) {
  vec3 to_center_world = frame.light_center_world.xyz - p_world;
  int type = frame.light_type.x;
  float radius_world = frame.light_extent.x;
  if (type == kSphere && dot(to_center_world, to_center_world) <= radius_world * radius_world) return 0.0;
  float sum = 0.0;
  if (type == kSun) {
    for (int i = 0; i < kLightPoints; ++i) sum += sun_weight(light_point(i), n_world);
  } else if (type == kSphere) {
    SphereCone cone = cone_of_sphere(to_center_world, radius_world);
    for (int i = 0; i < kLightPoints; ++i) sum += sphere_weight(light_point(i), cone, n_world);
  } else {
    vec2 extent = frame.light_extent.xy;
    float area_world = (type == kRect ? 4.0 : kPi) * extent.x * extent.y;
    for (int i = 0; i < kLightPoints; ++i) sum += flat_weight(light_point(i), to_center_world, n_world, area_world);
  }
  return sum / float(kLightPoints);
}
