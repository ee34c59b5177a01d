// SPDX-License-Identifier: Apache-2.0
// The nearest light without a size, and how its shadow map is fitted: around what the camera sees, and deep enough for all
// that may cast a shadow on it, as a careful user would.
import {nearestDistance} from "./distance.mjs";
import {cross, dot, length, minus, normalized, plus, times} from "./page.mjs";

const WIDEST_RAD = 80 * Math.PI / 180;  // of a cone's half angle: beyond, a single map has no texels left
const NARROWEST_RAD = 0.5 * Math.PI / 180;
const SLACK = 1.02;

// `position`: a picture of positions, alpha 0 where nothing is hit.
// {kind: "sun", direction, right, up, center, half: [x, y], near, far}: a box of light, seen from `center`;
// {kind: "spot", position, direction, up, angle_rad, near, far, reach}: a cone, `angle_rad` is half of it; or
// {kind: "point", position, near, far, reach}. Directions point away from the light; near and far are measured along it, or
// around the point; nothing seen is farther away than `reach`.
export function nearestLight(light, mesh, position) {
  const seen = [];
  for (let i = 0; i < position.length; i += 4) {
    if (position[i + 3] !== 0) seen.push([position[i], position[i + 1], position[i + 2]]);
  }
  if (seen.length === 0) throw new Error("the camera sees nothing");
  return light.type === "sun" ? sunLight(light, mesh, seen) : lampLight(light, mesh, seen);
}

function lampLight(light, mesh, seen) {
  const position = light.center_world;
  const is_round = light.type === "sphere";
  const arms = seen.map(point => minus(point, position));
  const direction = is_round
    ? normalized(arms.map(normalized).reduce((sum, arm) => plus(sum, arm), [0, 0, 0]))
    : light.direction_world;
  let widest = NARROWEST_RAD, reach = 0, far = 0;
  for (const arm of arms) {
    const depth = dot(arm, direction), distance = length(arm);
    reach = Math.max(reach, distance);
    if (!is_round && depth <= 0) continue;  // behind a lamp that shines to one side
    widest = Math.max(widest, Math.acos(Math.max(-1, Math.min(1, depth / (distance || 1)))));
    far = Math.max(far, depth);
  }
  const nearest = nearestDistance(position, mesh.position);
  if (is_round && widest > WIDEST_RAD)  // a face of the cube sees its corners at 1 / sqrt(3) of their distance
    return {kind: "point", position, near: Math.max(nearest / Math.sqrt(3) / SLACK, reach * 1e-3), far: reach * SLACK, reach};
  const angle_rad = Math.min(widest * SLACK, WIDEST_RAD);
  const to_corner_rad = Math.atan(Math.SQRT2 * Math.tan(angle_rad));
  const near = Math.max(nearest * Math.cos(to_corner_rad) / SLACK, far * 1e-3);
  const up = is_round ? anyAcross(direction) : light.bitangent_world;
  return {kind: "spot", position, direction, up, angle_rad, near, far: far * SLACK, reach};
}

function sunLight(light, mesh, seen) {
  const direction = light.direction_world, right = light.tangent_world, up = light.bitangent_world;
  const extent = (points, axis) => {
    let low = Infinity, high = -Infinity;
    for (const point of points) {
      low = Math.min(low, dot(point, axis));
      high = Math.max(high, dot(point, axis));
    }
    return [low, high];
  };
  const x = extent(seen, right), y = extent(seen, up);
  const first = extent(mesh.points, direction)[0], last = extent(seen, direction)[1];
  const depth = SLACK * (last - first) || 1;
  const middle = [0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]), 0.5 * (first + last) - depth];
  const center = [right, up, direction].reduce((sum, axis, i) => plus(sum, times(middle[i], axis)), [0, 0, 0]);
  const half = [x, y].map(([low, high]) => SLACK * 0.5 * (high - low) || 1);
  return {kind: "sun", direction, right, up, center, half, near: 0.5 * depth, far: 1.5 * depth};
}

function anyAcross(direction) {
  const other = Math.abs(direction[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  return normalized(cross(direction, other));
}
