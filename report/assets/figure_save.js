// SPDX-License-Identifier: Apache-2.0
// Draws a figure's sheet (figure.js) as PNG or SVG and saves it; and what a viewer shows, as it is.

function cropOf({bitmap, from}) {
  const crop = document.createElement("canvas");
  crop.width = from.width;
  crop.height = from.height;
  crop.getContext("2d").drawImage(bitmap, from.x, from.y, from.width, from.height, 0, 0, from.width, from.height);
  return crop;
}

const sheetPainters = {
  image(context, item) {
    context.imageSmoothingEnabled = item.w * context.getTransform().a < item.from.width;
    context.imageSmoothingQuality = "high";
    context.drawImage(cropOf(item), item.x, item.y, item.w, item.h);
  },
  frame(context, item) {
    context.strokeStyle = item.colour;
    context.lineWidth = item.thickness;
    context.strokeRect(item.x, item.y, item.w, item.h);
  },
  text(context, item) {
    context.font = `${item.weight ?? "normal"} ${item.size}px sans-serif`;
    context.textAlign = item.anchor === "middle" ? "center" : item.anchor ?? "left";
    context.fillStyle = item.colour;
    context.fillText(item.text, item.x, item.y);
  },
};

// White paper; a sheet's px becomes `factor` pixels.
function sheetCanvas(sheet, factor) {
  const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
  canvas.width = Math.round(factor * sheet.width);
  canvas.height = Math.round(factor * sheet.height);
  context.fillStyle = "#fff";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.scale(factor, factor);
  for (const item of sheet.items) sheetPainters[item.kind](context, item);
  return canvas;
}

// The page's own empty <svg> lends its namespace, so that no address stands in the page.
function svgElement(name, attributes, text) {
  const element = document.createElementNS(document.getElementById("svg-model").content.firstElementChild.namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  if (text !== undefined) element.textContent = text;
  return element;
}

const svgParts = {
  image: item => svgElement("image", {x: item.x, y: item.y, width: item.w, height: item.h, preserveAspectRatio: "none", href: cropOf(item).toDataURL("image/png"),
                                       style: item.w > item.from.width ? "image-rendering: pixelated" : ""}),
  frame: item => svgElement("rect", {x: item.x, y: item.y, width: item.w, height: item.h, fill: "none", stroke: item.colour, "stroke-width": item.thickness}),
  text: item => svgElement("text", {x: item.x, y: item.y, "font-family": "sans-serif", "font-size": item.size, "font-weight": item.weight ?? "normal",
                                     "text-anchor": item.anchor ?? "start", fill: item.colour}, item.text),
};

function sheetSvg(sheet) {
  const svg = svgElement("svg", {width: sheet.width, height: sheet.height, viewBox: `0 0 ${sheet.width} ${sheet.height}`});
  svg.append(svgElement("rect", {width: sheet.width, height: sheet.height, fill: "#fff"}));
  for (const item of sheet.items) svg.append(svgParts[item.kind](item));
  return new XMLSerializer().serializeToString(svg);
}

function download(name, blob) {
  const link = document.createElement("a");
  link.download = name.replaceAll(/[^\w.-]+/g, "-");
  link.href = URL.createObjectURL(blob);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// One pixel of the pictures is at least one of the file's.
function sheetFactor(viewer) {
  return Math.min(Math.max(figureWindow(viewer).width / kCell_px, 1.5), 4);
}

function fillFigureRuns(viewer) {
  const box = part(viewer, "figure-runs"), shown = [viewer.runIndex, viewer.otherIndex];
  box.replaceChildren(...viewer.entry.runs.flatMap((run, index) => {
    if (!run) return [];
    const label = document.createElement("label"), input = document.createElement("input");
    input.type = "checkbox";
    input.value = index;
    input.checked = shown.includes(index);
    label.append(input, runLabel(viewer, index));
    return [label];
  }));
}

// The figure of the runs that are ticked.
async function saveFigure(viewer, kind) {
  const runs = Array.from(part(viewer, "figure-runs").querySelectorAll("input:checked"), input => Number(input.value));
  const isTicked = name => part(viewer, `figure-${name}`).checked;
  const sheet = await viewerFigure(viewer, runs, {hasErrors: isTicked("errors"), hasInset: isTicked("inset"), hasTimes: isTicked("times")});
  const name = `${viewer.scene.name}-figure.${kind}`;
  if (kind === "png") return sheetCanvas(sheet, sheetFactor(viewer)).toBlob(blob => download(name, blob), "image/png");
  download(name, new Blob([sheetSvg(sheet)], {type: "image/svg+xml"}));
}

// What is seen, with its context, as one PNG.
function savePicture(viewer) {
  const canvases = kPanes[viewer.mode].map(pane => viewer.root.querySelector(`[data-pane="${pane}"] canvas`));
  const lines = [...contextLines(viewer), part(viewer, "scale").textContent].filter(text => text);
  const kLine = 18, kMargin = 8;
  const sheet = document.createElement("canvas");
  sheet.width = canvases.reduce((sum, canvas) => sum + canvas.width + kMargin, kMargin);
  sheet.height = canvases[0].height + 3 * kMargin + (lines.length + 1) * kLine;
  const context = sheet.getContext("2d");
  context.fillStyle = "#fff";
  context.fillRect(0, 0, sheet.width, sheet.height);
  context.fillStyle = "#000";
  context.font = "13px sans-serif";
  let left = kMargin;
  kPanes[viewer.mode].forEach((pane, k) => {
    context.fillText(paneTitle(viewer, pane), left, kLine);
    context.drawImage(canvases[k], left, kLine + kMargin);
    left += canvases[k].width + kMargin;
  });
  lines.forEach((line, k) => context.fillText(line, kMargin, canvases[0].height + 2 * kMargin + (k + 2) * kLine, sheet.width - 2 * kMargin));
  sheet.toBlob(blob => download(`${viewer.scene.name}-${runLabel(viewer, viewer.runIndex)}.png`, blob), "image/png");
}
