// SPDX-License-Identifier: Apache-2.0
// Does a pixel's error stand out from the reference's noise? The same as metrics/statistics/significance.cpp (docs/metrics.md).

const kFloorVariance = 1e-6;  // the square of what nobody calls an error
const kReplicates = 8;        // from which the reference's standard error was taken

// Standard normal when v is the truth.
function normalDeviate(v, r, se) {
  const variance = se * se;
  if ((r <= 0 || r >= 1) && se > 0) {
    const truth = Math.min(Math.max(v, 0), 1), samples = 0.5 / se;
    return (v - r) / Math.sqrt(Math.max(variance, truth * (1 - truth) / samples) + kFloorVariance);
  }
  const total = variance + kFloorVariance;
  const t = (v - r) / Math.sqrt(total);
  if (variance * variance < 1e-12 * total * total) return t;
  // Wallace 1959: Student's distribution into the normal one.
  const degrees = (kReplicates - 1) * total * total / (variance * variance);
  const z = (8 * degrees + 1) / (8 * degrees + 3) * Math.sqrt(degrees * Math.log1p(t * t / degrees));
  return Math.sign(t) * z;
}

// Least-squares fit that never decreases, by pooling adjacent violators.
function fitNondecreasing(values) {
  const blocks = [];
  for (const value of values) {
    let block = {sum: value, count: 1};
    while (blocks.length > 0 && blocks.at(-1).sum / blocks.at(-1).count > block.sum / block.count) {
      const before = blocks.pop();
      block = {sum: before.sum + block.sum, count: before.count + block.count};
    }
    blocks.push(block);
  }
  return blocks.flatMap(block => Array(block.count).fill(block.sum / block.count));
}

// Where a rise from 0 to 1 crosses `level`; null when it does not.
function crossing(positions, rising, level) {
  for (let i = 1; i < rising.length; ++i) {
    if (rising[i - 1] >= level || rising[i] < level) continue;
    const share = (level - rising[i - 1]) / (rising[i] - rising[i - 1]);
    return positions[i - 1] + share * (positions[i] - positions[i - 1]);
  }
  return null;
}

// The distance from 10 % to 90 % of the fitted rise; null when it does not reach both.
function width_10_90(positions, values) {
  const rising = fitNondecreasing(values);
  const low = crossing(positions, rising, 0.1), high = crossing(positions, rising, 0.9);
  return low === null || high === null ? null : high - low;
}
