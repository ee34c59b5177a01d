// SPDX-License-Identifier: Apache-2.0
// What lies over a viewer's pictures: pixel values when they are large enough, the profile's line; and the legend below them.

const kReadablePixel_px = 34;  // CSS px of an image pixel that holds a number

// A pixel's number as short as can be: .42, 1, -.08.
function shortNumber(value, digits = 2) {
  return value.toFixed(digits).replace(/^(-?)0\./, "$1.").replace(/^-?\.?0+$/, "0").replace(/^(-?\d+)\.0+$/, "$1");
}

function paneValue(viewer, pane) {
  const {shown} = viewer;
  if (pane === "map") return i => layers[viewer.layer].value(shown, i);
  return i => shown.scene.hit[i] === 1 ? shortNumber(shown[pane].visibility[i], 3) : "";
}

function paneColour(viewer, pane) {
  const {shown} = viewer;
  if (pane === "map") return i => layers[viewer.layer].colour(shown, i);
  const plain = pictureColour(viewer, shown[pane]);
  return pane === "run" ? overlaidColour(shown, viewer.overlays, plain) : plain;
}

// Numbers in the pixels of `pane` from the column of the canvas `from` to `to`.
function drawValues(context, viewer, pane, from, to) {
  const {scale, left, top} = placement(viewer, context.canvas), ratio = window.devicePixelRatio || 1;
  if (scale < kReadablePixel_px * ratio) return;
  const sight = pixelsInSight(viewer), value = paneValue(viewer, pane), colour = paneColour(viewer, pane);
  context.font = `${Math.round(Math.min(scale / 3.4, 14 * ratio))}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (let y = sight.top; y < sight.bottom; ++y) {
    for (let x = sight.left; x < sight.right; ++x) {
      const i = y * viewer.entry.width + x, at = left + scale * (x + 0.5);
      if (at < from || at >= to) continue;
      context.fillStyle = inkOn(colour(i));
      context.fillText(value(i), at, top + scale * (y + 0.5), scale);
    }
  }
}

// Where the plot under the pictures was measured.
function drawProfileLine(context, viewer) {
  const line = viewer.profile?.line;
  if (!line) return;
  const {scale, left, top} = placement(viewer, context.canvas), {width} = viewer.entry;
  const at = i => [left + scale * (i % width + 0.5), top + scale * (Math.floor(i / width) + 0.5)];
  for (const [colour, thickness] of [["#000a", 3], ["#ffd34d", 1.5]]) {
    context.strokeStyle = colour;
    context.lineWidth = thickness;
    context.beginPath();
    context.moveTo(...at(line[0]));
    context.lineTo(...at(line[1]));
    context.stroke();
  }
}

function swatchItem(colour, text) {
  const item = document.createElement("li"), swatch = document.createElement("span");
  swatch.className = "swatch";
  swatch.style.background = `rgb(${colour})`;
  item.append(swatch, text);
  return item;
}

function rampItem(ramp) {
  const item = document.createElement("li"), bar = document.createElement("span");
  bar.className = "ramp-small";
  bar.style.background = `linear-gradient(to right, ${ramp.colours.map(colour => `rgb(${colour})`).join(", ")})`;
  item.append(ramp.low, bar, ramp.high);
  return item;
}

// What the colours in sight mean: the map's scale, and the classes laid over the technique.
function fillViewerLegend(viewer, isMapSeen) {
  const {shown, runIndex} = viewer, layer = layers[viewer.layer];
  const classes = viewer.scene.techniques[runIndex].faults?.classes ?? {};
  const items = [];
  if (isMapSeen && layer.ramp) items.push(rampItem(layer.ramp(shown)));
  if (isMapSeen && viewer.layer === "parity") items.push(...palette.parity.map(one => swatchItem(one.colour, one.text)));
  palette.faults.forEach((fault, index) => {
    const pixels = classes[fault.name]?.pixels ?? 0;
    const isSeen = viewer.overlays.has(index) || isMapSeen && viewer.layer === "faults" && index >= 2 && pixels > 0;
    if (isSeen) items.push(swatchItem(fault.colour, `${fault.text} (${pixels} px)`));
  });
  part(viewer, "legend").replaceChildren(...items);
}
