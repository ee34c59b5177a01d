// SPDX-License-Identifier: Apache-2.0
// A figure for a paper or a README: truth and runs side by side, with an enlarged detail and the signed errors. Here it is laid
// out as a list of things to draw; figure_save.js draws them.

const kCell_px = 320;     // width of a picture on the sheet
const kGap_px = 10;
const kText_px = 13;
const kSmall_px = 10.5;
const kInsetShare = 0.2;  // of the window's width
const kInsetColour = "#ff9d00";

const figureInk = {colour: "#111", quiet: "#555"};

// The part of the picture that the panes show, in whole pixels.
function figureWindow(viewer) {
  const sight = pixelsInSight(viewer);
  return {x: sight.left, y: sight.top, width: sight.right - sight.left, height: sight.bottom - sight.top};
}

// Around the cursor, inside `window`, as wide to high as `aspect`.
function insetWindow(cursor, window, aspect) {
  const width = Math.max(Math.round(kInsetShare * window.width), 4), height = Math.min(Math.max(Math.round(width / aspect), 3), window.height);
  const inside = (centre, low, room, size) => Math.min(Math.max(Math.round(centre - size / 2), low), low + room - size);
  return {x: inside(cursor.x, window.x, window.width, width), y: inside(cursor.y, window.y, window.height, height), width, height};
}

const textMeasure = document.createElement("canvas").getContext("2d");
function textWidth(text, size) {
  textMeasure.font = `${size}px sans-serif`;
  return textMeasure.measureText(text).width;
}

// Broken between words so that no line is wider than `width`.
function wrapText(text, size, width) {
  const lines = [];
  for (const word of text.split(/\s+/)) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && textWidth(longer, size) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

const kRampSteps = 255;
function signedRampBitmap() {
  return paintBitmap(kRampSteps, 1, i => signedColour(2 * i / (kRampSteps - 1) - 1));
}

// `columns`: {title, note, picture, error} each, the bitmaps of the whole picture, error null for the truth. `inset`: null for
// none. `scale`: V at the ends of the errors' colours; 0 for no row of errors. Lengths in px of the sheet.
function figureSheet({window, columns, inset, scale, caption}) {
  const items = [], height = kCell_px * window.height / window.width, half = (kCell_px - kGap_px) / 2;
  const insetHeight = inset ? half * inset.height / inset.width : 0;
  const left = column => kGap_px + column * (kCell_px + kGap_px), width = left(columns.length);
  const image = (bitmap, from, x, y, w, h, frame) => items.push({kind: "image", bitmap, from, x, y, w, h},
                                                                {kind: "frame", x, y, w, h, colour: frame, thickness: frame === kInsetColour ? 2 : 0.5});
  const text = (words, x, y, size, style = {}) => items.push({kind: "text", text: words, x, y, size, colour: figureInk.colour, ...style});
  let y = kGap_px;
  columns.forEach((column, k) => {
    image(column.picture, window, left(k), y, kCell_px, height, "#888");
    if (!inset) return;
    const share = kCell_px / window.width;
    items.push({kind: "frame", x: left(k) + share * (inset.x - window.x), y: y + share * (inset.y - window.y), w: share * inset.width, h: share * inset.height, colour: kInsetColour, thickness: 1.5});
  });
  y += height + kText_px + 4;
  columns.forEach((column, k) => {
    text(column.title, left(k), y, kText_px, {weight: "bold"});
    text(column.note, left(k) + kCell_px, y, kText_px, {anchor: "end", colour: figureInk.quiet});
  });
  y += kGap_px;
  if (inset) {
    columns.forEach((column, k) => {
      image(column.picture, inset, left(k), y, half, insetHeight, kInsetColour);
      if (column.error && scale > 0) image(column.error, inset, left(k) + half + kGap_px, y, half, insetHeight, kInsetColour);
    });
    y += insetHeight + kGap_px;
  }
  if (scale > 0) {
    columns.forEach((column, k) => {
      if (column.error) return image(column.error, window, left(k), y, kCell_px, height, "#888");
      const middle = y + height / 2, ends = [[`-${scale} too dark`, "start", 0], ["0", "middle", 0.5], [`+${scale} too bright`, "end", 1]];
      text("Signed error V - R", left(k) + kCell_px / 2, middle - 22, kText_px, {anchor: "middle", weight: "bold"});
      image(signedRampBitmap(), {x: 0, y: 0, width: kRampSteps, height: 1}, left(k) + 20, middle - 10, kCell_px - 40, 14, "#888");
      for (const [words, anchor, at] of ends) text(words, left(k) + 20 + at * (kCell_px - 40), middle + 20, kSmall_px + 1, {anchor});
    });
    y += height + kGap_px;
  }
  for (const paragraph of caption) {
    for (const line of wrapText(paragraph, kSmall_px, width - 2 * kGap_px)) {
      y += kSmall_px + 3;
      text(line, kGap_px, y - 3, kSmall_px, {colour: figureInk.quiet});
    }
  }
  return {width: Math.ceil(width), height: Math.ceil(y + kGap_px / 2), items};
}

function figureNote(run, hasTimes) {
  const rmse = run.error?.rmse, time = hasTimes ? totalMs(run) : null;
  return [rmse ? `RMSE ${rmse.value.toFixed(3)}` : "", time === null ? "" : `${significantText(time, 2)} ms`].filter(text => text).join(", ");
}

function figureCaption(viewer, runs) {
  const {scene} = viewer, device = new Set(runs.map(k => scene.techniques[k].device));
  return [`${scene.title}. ${viewer.picture === "lit" ? "Lit picture" : "Visibility"} at ${results.width_px} x ${results.height_px} px, truth with ${scene.reference.mean_sample_count.toFixed(0)} samples per pixel ` +
          `(${scene.reference.device}); ${Array.from(device).join(", ")}; RMSE of visibility, the truth's noise taken out. ` +
          `Scene ${scene.hash}, seed ${results.seed}, umbrameter ${results.version} (${results.commit}).`];
}

// What saveFigure draws: the truth and `runs` (indices), as the viewer shows them.
async function viewerFigure(viewer, runs, {hasErrors, hasInset, hasTimes}) {
  const {entry, sceneIndex, scene} = viewer, truth = await scenePlanes(sceneIndex);
  const white = litScale(truth), window = figureWindow(viewer);
  const bitmap = colour => paintBitmap(entry.width, entry.height, colour);
  const picture = planes => bitmap(viewer.picture === "lit" ? litColour(planes, truth, white, viewer.exposure_stops) : visibilityColour(planes, truth.hit));
  const columns = [{title: "truth", note: "", picture: picture(truth), error: null}];
  for (const index of runs) {
    const planes = await runPlanes(entry.runs[index]), run = scene.techniques[index];
    const shown = {scene: truth, run: planes, other: truth, isReference: true, errorScale: viewer.errorScale};
    columns.push({title: run.label, note: figureNote(run, hasTimes), picture: picture(planes),
                  error: planes.scored ? bitmap(i => layers.error.colour(shown, i)) : null});
  }
  const inset = hasInset ? insetWindow(viewer.cursor, window, 4 / 3) : null;
  return figureSheet({window, columns, inset, scale: hasErrors ? viewer.errorScale : 0, caption: figureCaption(viewer, runs)});
}
