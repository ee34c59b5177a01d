// SPDX-License-Identifier: Apache-2.0
// The nearest light without a size, and how its shadow map is fitted: as tightly around the scene as a careful user would.
import {cross, dot, length, minus, normalized, plus, times} from "./page.mjs";

const WIDEST_RAD = 80 * Math.PI / 180;  // of a cone's half angle: beyond, a single map has no texels left
const SLACK = 1.02;

// {kind: "sun", direction, right, up, center, half: [x, y], near, far}: a box of light, `center` lies on its near plane;
// {kind: "spot", position, direction, up, angle_rad, near, far}: a cone, `angle_rad` is half of it; or
// {kind: "point", position, near, far}. Directions point away from the light.
export function nearestLight(light, points) {
  if (light.type === "sun") return sunLight(light, points);
  const position = light.center_world;
  const middle = times(1 / points.length, points.reduce((sum, p) => plus(sum, p), [0, 0, 0]));
  const is_round = light.type === "sphere";
  const direction = is_round ? normalized(minus(middle, position)) : light.direction_world;
  let widest = 0, nearest = Infinity, farthest = 0;
  let depth_near = Infinity, depth_far = 0;
  for (const point of points) {
    const arm = minus(point, position);
    const depth = dot(arm, direction);
    nearest = Math.min(nearest, length(arm));
    farthest = Math.max(farthest, length(arm));
    if (!is_round && depth <= 0) continue;  // behind a lamp that shines to one side
    widest = Math.max(widest, Math.acos(Math.min(1, depth / (length(arm) || 1))));
    depth_near = Math.min(depth_near, depth);
    depth_far = Math.max(depth_far, depth);
  }
  if (is_round && widest > WIDEST_RAD) return {kind: "point", position, near: Math.max(nearest / SLACK / 2, farthest * 1e-3), far: farthest * SLACK};
  // Edges may run nearer to the light than their ends.
  const near = Math.max(Math.min(depth_near / SLACK, nearest / 2), depth_far * 1e-3);
  const up = is_round ? anyAcross(direction) : light.bitangent_world;
  return {kind: "spot", position, direction, up, angle_rad: Math.min(widest * SLACK, WIDEST_RAD), near, far: depth_far * SLACK};
}

function sunLight(light, points) {
  const direction = light.direction_world, right = light.tangent_world, up = light.bitangent_world;
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const point of points) {
    [right, up, direction].forEach((axis, i) => {
      low[i] = Math.min(low[i], dot(point, axis));
      high[i] = Math.max(high[i], dot(point, axis));
    });
  }
  const half = [0, 1].map(i => SLACK * 0.5 * (high[i] - low[i]));
  const depth = SLACK * (high[2] - low[2]) || 1;
  const middle = low.map((value, i) => 0.5 * (value + high[i]));
  const center = [right, up, direction].reduce(
    (sum, axis, i) => plus(sum, times(i === 2 ? middle[2] - depth : middle[i], axis)), [0, 0, 0]);
  return {kind: "sun", direction, right, up, center, half, near: 0.5 * depth, far: 1.5 * depth};
}

function anyAcross(direction) {
  const other = Math.abs(direction[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  return normalized(cross(direction, other));
}
