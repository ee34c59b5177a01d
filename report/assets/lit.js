// SPDX-License-Identifier: Apache-2.0
// The lit picture: visibility times the irradiance of the unshadowed light, on white surfaces, encoded as sRGB.

const kAmbientShare = 0.05;    // of the light, so that shapes in shadow can be told apart
const kBackdrop = [92, 104, 122];

// By a table: a picture has a hundred thousand pixels and more.
const kSrgb = Uint8Array.from({length: 65536}, (_, i) => {
  const value = i / 65535;
  return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
});

function toSrgb(linear) {
  return kSrgb[Math.round(65535 * Math.min(Math.max(linear, 0), 1))];
}

const kScalePixels = 8192;  // of a picture are enough to tell its scale

// The irradiance that is drawn white at exposure 0: nearly the largest.
function litScale(scene) {
  if (!scene.unshadowed) return 1;
  const step = Math.floor(scene.unshadowed.length / kScalePixels) | 1, values = [];  // odd: not the same columns in every row
  for (let i = 0; i < scene.unshadowed.length; i += step) {
    if (scene.hit[i] === 1 && scene.unshadowed[i] > 0) values.push(scene.unshadowed[i]);
  }
  values.sort((a, b) => a - b);
  return values.length ? values[Math.floor(0.98 * (values.length - 1))] : 1;
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
