// SPDX-License-Identifier: Apache-2.0
// How near a point lies to triangles.

const clamped = value => Math.max(0, Math.min(1, value));

// Squared distance of the origin to the segment from a to b.
function toSegment(a, b) {
  const d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const size = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  const t = size === 0 ? 0 : clamped(-(a[0] * d[0] + a[1] * d[1] + a[2] * d[2]) / size);
  const p = [a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]];
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Squared distance of the origin to a triangle: to its plane where the foot lies inside, else to an edge.
function toTriangle(a, b, c) {
  const n = cross([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
  const size = dot(n, n);
  const is_inside = size > 0 && [[a, b], [b, c], [c, a]].every(([p, q]) => dot(cross(p, q), n) >= 0);
  if (is_inside) return dot(a, n) ** 2 / size;
  return Math.min(toSegment(a, b), toSegment(b, c), toSegment(c, a));
}

// `positions`: nine numbers a triangle.
export function nearestDistance(point, positions) {
  let nearest = Infinity;
  for (let i = 0; i < positions.length; i += 9) {
    const corner = k => [0, 1, 2].map(axis => positions[i + 3 * k + axis] - point[axis]);
    nearest = Math.min(nearest, toTriangle(corner(0), corner(1), corner(2)));
  }
  return Math.sqrt(nearest);
}
