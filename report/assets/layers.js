// SPDX-License-Identifier: Apache-2.0
// Pixels into pictures, at fixed scales that the legend states.

const kZScale = 6;            // sigmas at the ends of the z map's colours
const kSeScale = 0.05;        // standard error at white
const palette = page.palette;

function mix(from, to, share) {
  return from.map((value, k) => Math.round(value + share * (to[k] - value)));
}

// Blue too dark, white right, red too bright; clipped at +-1.
function signedColour(share) {
  const end = share < 0 ? palette.too_dark : palette.too_bright;
  return mix(palette.no_error, end, Math.min(Math.abs(share), 1));
}

function grey(share) {
  const level = Math.round(255 * Math.min(Math.max(share, 0), 1));
  return [level, level, level];
}

function signedRamp(low, high) {
  return {low, high, colours: [palette.too_dark, palette.no_error, palette.too_bright]};
}

// `shown`: planes of scene, run and what it is compared with. Each layer: is it there, its scale in words and, where it has
// one, as a ramp; a pixel's colour, and its number as text.
const layers = {
  error: {
    label: "Signed error",
    scale: shown => `${shown.isReference ? "V - R" : "V - other"}, blue -${errorScale(shown)} too dark to red +${errorScale(shown)} too bright`,
    has: shown => Boolean(shown.run.scored),
    ramp: shown => signedRamp(`-${errorScale(shown)} too dark`, `+${errorScale(shown)} too bright`),
    value: (shown, i) => shown.run.scored[i] === 0 ? "" : shortNumber(shown.run.visibility[i] - shown.other.visibility[i], 3),
    colour: (shown, i) => shown.run.scored[i] === 0 ? palette.unscored
        : signedColour((shown.run.visibility[i] - shown.other.visibility[i]) / errorScale(shown)),
  },
  z: {
    label: "z map (significance)",
    scale: shown => `z of V - R against the reference's noise, blue -${kZScale} to red +${kZScale} sigmas` +
        (shown.threshold ? `; from ${shown.threshold.toFixed(2)} on a pixel is called wrong, paler ones are not` : ""),
    has: shown => Boolean(shown.run.scored && shown.scene.visibility_se),
    ramp: () => signedRamp(`-${kZScale} sigmas`, `+${kZScale} sigmas`),
    value: (shown, i) => shown.run.scored[i] === 0 ? "" : shortNumber(deviateAt(shown, i), 1),
    colour: (shown, i) => {
      if (shown.run.scored[i] === 0) return palette.unscored;
      const z = deviateAt(shown, i);
      const isCalled = shown.threshold && Math.abs(z) >= shown.threshold;
      return isCalled ? signedColour(z / kZScale) : mix(palette.no_error, signedColour(z / kZScale), 0.35);
    },
  },
  faults: {
    label: "Fault classes",
    scale: () => "the class of every wrong pixel, in the legend's colours",
    has: shown => Boolean(shown.run.faults),
    value: (shown, i) => shown.run.faults[i] < 2 ? "" : palette.faults[shown.run.faults[i]].name.slice(0, 4),
    colour: (shown, i) => palette.faults[shown.run.faults[i]].colour,
  },
  se: {
    label: "Standard error of R",
    scale: () => `black 0 to white ${kSeScale}`,
    has: shown => Boolean(shown.scene.visibility_se),
    ramp: () => ({low: "0", high: String(kSeScale), colours: [grey(0), grey(1)]}),
    value: (shown, i) => shown.scene.hit[i] === 0 ? "" : shortNumber(shown.scene.visibility_se[i], 4),
    colour: (shown, i) => shown.scene.hit[i] === 0 ? palette.background : grey(shown.scene.visibility_se[i] / kSeScale),
  },
  blocker: {
    label: "Blocker distance",
    scale: shown => `black 0 to white ${shown.farthestBlocker.toPrecision(3)} world units, as a square root; blue: nothing blocks`,
    has: shown => Boolean(shown.scene.blocker_distance),
    ramp: shown => ({low: "0", high: `${shown.farthestBlocker.toPrecision(3)} world units`, colours: [0, 0.5, 0.71, 0.87, 1].map(grey)}),
    value: (shown, i) => shown.scene.blocker_distance[i] > 0 ? shown.scene.blocker_distance[i].toPrecision(2) : "",
    colour: (shown, i) => shown.scene.blocker_distance[i] > 0
        ? grey(Math.sqrt(shown.scene.blocker_distance[i] / shown.farthestBlocker)) : palette.background,
  },
  parity: {
    label: "Parity of the two renderers",
    scale: () => "the class of every pixel, in the legend's colours",
    has: shown => Boolean(shown.scene.parity),
    value: () => "",
    colour: (shown, i) => palette.parity[shown.scene.parity[i]].colour,
  },
};

function deviateAt(shown, i) {
  return normalDeviate(shown.run.visibility[i], shown.scene.visibility[i], shown.scene.visibility_se[i]);
}

function visibilityColour(planes, hit) {
  return i => hit[i] === 0 ? palette.background : grey(planes.visibility[i]);
}

// V at the ends of the signed error's colours: as the reader chose, else as the legend says.
function errorScale(shown) {
  return shown.errorScale ?? palette.error_scale;
}

// `plain` with the chosen fault classes over it.
function overlaidColour(shown, chosen, plain) {
  if (!shown.run.faults || chosen.size === 0) return plain;
  return i => chosen.has(shown.run.faults[i]) ? palette.faults[shown.run.faults[i]].colour : plain(i);
}

function paintBitmap(width, height, colourAt) {
  const bitmap = document.createElement("canvas");
  bitmap.width = width;
  bitmap.height = height;
  const context = bitmap.getContext("2d");
  const picture = context.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    const colour = colourAt(i);
    picture.data[4 * i] = colour[0];
    picture.data[4 * i + 1] = colour[1];
    picture.data[4 * i + 2] = colour[2];
    picture.data[4 * i + 3] = 255;
  }
  context.putImageData(picture, 0, 0);
  return bitmap;
}
