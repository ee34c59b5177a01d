// SPDX-License-Identifier: Apache-2.0
// Where a camera's near and far plane may stand without cutting anything that is seen.
import {dot, length, minus, normalized} from "./page.mjs";

// Before anything is drawn: no vertex is farther.
export function farPlane({eye_world}, points) {
  let farthest = 0;
  for (const point of points) farthest = Math.max(farthest, length(minus(point, eye_world)));
  return 1.01 * farthest;
}

// From a picture of positions: a bit before the nearest surface. Depth buffers need it as far away as can be.
export function nearPlane({eye_world, at_world, near_world}, position) {
  const axis = normalized(minus(at_world, eye_world));
  let nearest = Infinity;
  for (let i = 0; i < position.length; i += 4) {
    if (position[i + 3] === 0) continue;
    nearest = Math.min(nearest, dot(minus([position[i], position[i + 1], position[i + 2]], eye_world), axis));
  }
  return Number.isFinite(nearest) ? Math.max(near_world, 0.9 * nearest) : near_world;
}
