// SPDX-License-Identifier: Apache-2.0
// The lit picture: visibility times the irradiance of the unshadowed light, on white surfaces, encoded as sRGB.

const kAmbientShare = 0.05;    // of the light, so that shapes in shadow can be told apart
const kBackdrop = [92, 104, 122];

function toSrgb(linear) {
  const value = Math.min(Math.max(linear, 0), 1);
  return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
}

// The irradiance that is drawn white at exposure 0: nearly the largest.
function litScale(scene) {
  if (!scene.unshadowed) return 1;
  const sorted = scene.unshadowed.filter((value, i) => scene.hit[i] === 1 && value > 0).sort();
  return sorted.length ? sorted[Math.floor(0.98 * (sorted.length - 1))] || 1 : 1;
}

// A pixel's colour; without the unshadowed irradiance the visibility alone.
function litColour(planes, scene, white, exposure_stops = 0) {
  const gain = 0.85 * 2 ** exposure_stops / white;
  return i => {
    if (scene.hit[i] === 0) return kBackdrop;
    const unshadowed = scene.unshadowed ? scene.unshadowed[i] : 1;
    const visibility = Math.min(Math.max(planes.visibility[i], 0), 1);
    const level = toSrgb(gain * unshadowed * visibility + kAmbientShare * 2 ** exposure_stops * (scene.unshadowed ? 0.4 + 0.6 * unshadowed / white : 1));
    return [level, level, level];
  };
}
