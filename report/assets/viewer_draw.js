// SPDX-License-Identifier: Apache-2.0
// Draws a viewer's panes: all at one pan and zoom, with a cross at the cursor.

const kPanes = {panes: ["other", "run", "map"], flip: ["run"], slider: ["run"], difference: ["map"]};

// The lit picture, or visibility as grey.
function pictureColour(viewer, planes) {
  const {scene, white} = viewer.shown;
  return viewer.picture === "lit" ? litColour(planes, scene, white, viewer.exposure_stops) : visibilityColour(planes, scene.hit);
}

function bitmapOf(viewer, pane) {
  const {entry, shown} = viewer;
  const colours = {
    other: () => pictureColour(viewer, shown.other),
    run: () => overlaidColour(shown, viewer.overlays, pictureColour(viewer, shown.run)),
    map: () => i => layers[viewer.layer].colour(shown, i),
  };
  viewer.bitmaps[pane] ??= paintBitmap(entry.width, entry.height, colours[pane]());
  return viewer.bitmaps[pane];
}

function fitToScreen(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

// Device pixels an image pixel, and where the image's origin lies.
function placement(viewer, canvas) {
  const scale = canvas.width / viewer.entry.width * viewer.view.zoom;
  return {scale, left: canvas.width / 2 - scale * viewer.view.x, top: canvas.height / 2 - scale * viewer.view.y};
}

function drawBitmap(context, viewer, bitmap) {
  const {scale, left, top} = placement(viewer, context.canvas);
  context.imageSmoothingEnabled = scale < 1;
  context.drawImage(bitmap, left, top, scale * bitmap.width, scale * bitmap.height);
}

function drawCross(context, viewer) {
  const {scale, left, top} = placement(viewer, context.canvas);
  const x = left + scale * (viewer.cursor.x + 0.5), y = top + scale * (viewer.cursor.y + 0.5);
  const gap = Math.max(scale / 2, 3) + 1, reach = gap + 10;
  for (const [colour, width] of [["#000", 3], ["#fff", 1]]) {  // seen on any picture
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + gap * dx, y + gap * dy);
      context.lineTo(x + reach * dx, y + reach * dy);
    }
    context.stroke();
  }
}

function drawSplit(context, viewer) {
  const {width, height} = context.canvas, x = Math.round(viewer.divider * width);
  drawBitmap(context, viewer, bitmapOf(viewer, "run"));
  context.save();
  context.beginPath();
  context.rect(0, 0, x, height);
  context.clip();
  context.clearRect(0, 0, width, height);
  drawBitmap(context, viewer, bitmapOf(viewer, "other"));
  context.restore();
  drawValues(context, viewer, "other", 0, x);
  drawValues(context, viewer, "run", x, width);
  context.fillStyle = "#e0a000";
  context.fillRect(x - 1, 0, 3, height);
}

function paneTitle(viewer, pane) {
  const run = runLabel(viewer, viewer.runIndex), other = runLabel(viewer, viewer.otherIndex);
  if (viewer.mode === "slider") return `${other} | ${run}`;
  if (viewer.mode === "flip") return viewer.isFlipped ? other : run;
  return {other, run, map: layers[viewer.layer].label}[pane];
}

function drawPane(viewer, pane) {
  const box = viewer.root.querySelector(`[data-pane="${pane}"]`), canvas = box.querySelector("canvas");
  box.querySelector(".pane-title").textContent = paneTitle(viewer, pane);
  canvas.setAttribute("aria-label", `${paneTitle(viewer, pane)}, ${viewer.scene.name}`);
  fitToScreen(canvas);
  if (canvas.width === 0 || canvas.height === 0) return;
  const context = canvas.getContext("2d");
  context.clearRect(0, 0, canvas.width, canvas.height);
  const seen = viewer.mode === "flip" && viewer.isFlipped ? "other" : pane;
  if (viewer.mode === "slider") {
    drawSplit(context, viewer);
  } else {
    drawBitmap(context, viewer, bitmapOf(viewer, seen));
    drawValues(context, viewer, seen, 0, canvas.width);
  }
  drawProfileLine(context, viewer);
  drawCross(context, viewer);
}

function drawNow(viewer) {
  viewer.isDrawing = false;
  const visible = kPanes[viewer.mode];
  for (const box of viewer.root.querySelectorAll("[data-pane]")) box.hidden = !visible.includes(box.dataset.pane);
  if (!viewer.shown) return;
  drawProfile(viewer);
  for (const pane of visible) drawPane(viewer, pane);
  const isMapSeen = visible.includes("map");
  part(viewer, "scale").textContent = isMapSeen ? "Map: " + layers[viewer.layer].scale(viewer.shown) + "." : "";
  fillViewerLegend(viewer, isMapSeen);
  readOut(viewer);
  scheduleHistogram(viewer);
}

// At most once a frame.
function draw(viewer) {
  if (viewer.isDrawing) return;
  viewer.isDrawing = true;
  requestAnimationFrame(() => drawNow(viewer));
}

function numberText(value, digits, signed) {
  if (value === undefined || value === null) return "n/a";
  return (signed && value >= 0 ? "+" : "") + value.toFixed(digits);
}

// What the pixel under the cursor says, by field.
function pixelValues(viewer) {
  const {shown, cursor, entry} = viewer, i = cursor.y * entry.width + cursor.x;
  const isHit = shown.scene.hit[i] === 1, isScored = shown.run.scored?.[i] === 1;
  const blocker = shown.scene.blocker_distance?.[i];
  return {
    pixel: `${cursor.x}, ${cursor.y}`,
    v: isHit ? numberText(shown.run.visibility[i], 4) : "n/a",
    r: isHit ? numberText(shown.scene.visibility[i], 4) : "n/a",
    other: shown.isReference || !isHit ? "n/a" : numberText(shown.other.visibility[i], 4),
    error: isHit ? numberText(shown.run.visibility[i] - shown.scene.visibility[i], 4, true) : "n/a",
    se: isHit ? numberText(shown.scene.visibility_se?.[i], 5) : "n/a",
    z: isScored && shown.scene.visibility_se ? numberText(deviateAt(shown, i), 1, true) : "n/a",
    blocker: blocker === undefined ? "n/a" : blocker > 0 ? `${blocker.toPrecision(4)} world units` : "nothing blocks",
    fault: shown.run.faults ? palette.faults[shown.run.faults[i]].text : isScored ? "not diagnosed" : "not scored",
  };
}

function readOut(viewer) {
  for (const [name, text] of Object.entries(pixelValues(viewer))) {
    viewer.root.querySelector(`[data-read="${name}"]`).textContent = text;
  }
}
