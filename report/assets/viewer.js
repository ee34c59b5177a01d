// SPDX-License-Identifier: Apache-2.0
// One viewer a scene: what it shows, and how that is chosen. Drawing is viewer_draw.js, keys are viewer_keys.js.

const viewers = new Map();  // by scene index
const kReference = -1;      // as `otherIndex`
const kModes = ["panes", "flip", "slider", "difference"];

function part(viewer, role) {
  return viewer.root.querySelector(`[data-role="${role}"]`);
}

function addOption(select, value, text) {
  const option = document.createElement("option");
  option.value = value;
  option.textContent = text;
  select.append(option);
}

function runLabel(viewer, index) {
  return index === kReference ? "Reference" : viewer.scene.techniques[index].label;
}

function fillChoices(viewer) {
  addOption(part(viewer, "other"), kReference, "Reference");
  viewer.entry.runs.forEach((run, index) => {
    if (!run) return;
    addOption(part(viewer, "run"), index, runLabel(viewer, index));
    addOption(part(viewer, "other"), index, runLabel(viewer, index));
  });
}

function fillOverlays(viewer) {
  const box = part(viewer, "overlays");
  const classes = viewer.scene.techniques[viewer.runIndex]?.faults?.classes ?? {};
  box.replaceChildren(...palette.faults.flatMap((fault, index) => {
    if (index < 2) return [];  // unscored, explained: no fault
    const pixels = classes[fault.name]?.pixels ?? 0;
    const label = document.createElement("label"), input = document.createElement("input");
    const swatch = document.createElement("span");
    input.type = "checkbox";
    input.checked = viewer.overlays.has(index);
    input.disabled = pixels === 0;
    input.addEventListener("change", () => toggleOverlay(viewer, index));
    swatch.className = "swatch";
    swatch.style.background = `rgb(${fault.colour})`;
    label.title = fault.text;
    label.append(input, swatch, `${fault.name.replaceAll("_", " ")} ${pixels} px`);
    return [label];
  }));
}

function fillLayers(viewer) {
  const select = part(viewer, "layer");
  select.replaceChildren();
  for (const [name, layer] of Object.entries(layers)) {
    if (layer.has(viewer.shown)) addOption(select, name, layer.label);
  }
  const names = Array.from(select.options, option => option.value);
  if (!names.includes(viewer.layer)) viewer.layer = names[0];
  select.value = viewer.layer;
}

function toggleOverlay(viewer, index) {
  if (!viewer.overlays.delete(index)) viewer.overlays.add(index);
  fillOverlays(viewer);
  viewer.bitmaps.run = null;
  draw(viewer);
}

function farthest(distances) {
  let most = 0;
  for (const distance of distances ?? []) if (distance > most && distance < Infinity) most = distance;
  return most;
}

// The pixel next to the middle that is halfway into a penumbra; the middle without any.
function middlePenumbra(viewer, visibility) {
  const {width, height} = viewer.entry;
  let best = {x: width >> 1, y: height >> 1, distance: Infinity};
  visibility.forEach((r, i) => {
    if (Math.abs(r - 0.5) > 0.1) return;
    const x = i % width, y = Math.floor(i / width), distance = Math.hypot(x - width / 2, y - height / 2);
    if (distance < best.distance) best = {x, y, distance};
  });
  return {x: best.x, y: best.y};
}

// Decodes and shows a run beside the reference or another run; the last call wins.
async function show(viewer, runIndex, otherIndex) {
  const request = ++viewer.request;
  viewer.runIndex = runIndex;
  viewer.otherIndex = otherIndex;
  const message = part(viewer, "message");
  try {
    const scene = await scenePlanes(viewer.sceneIndex);
    const run = await runPlanes(viewer.entry.runs[runIndex]);
    const other = otherIndex === kReference ? scene : await runPlanes(viewer.entry.runs[otherIndex]);
    if (request !== viewer.request) return;
    viewer.cursor ??= middlePenumbra(viewer, scene.visibility);
    viewer.white ??= litScale(scene);
    viewer.shown = {scene, run, other, white: viewer.white, errorScale: viewer.errorScale, isReference: otherIndex === kReference, farthestBlocker: farthest(scene.blocker_distance),
                    threshold: viewer.scene.techniques[runIndex].significance?.threshold_z ?? null};
  } catch (error) {
    message.textContent = String(error.message);
    return;
  }
  message.textContent = "";
  viewer.bitmaps = {};
  part(viewer, "run").value = runIndex;
  part(viewer, "other").value = otherIndex;
  fillLayers(viewer);
  fillOverlays(viewer);
  fillFigureRuns(viewer);
  part(viewer, "context").textContent = contextLines(viewer).join("\n");
  draw(viewer);
  drawSceneCharts(viewer);
  viewer.root.dataset.ready = `${runIndex} ${otherIndex}`;
}

function parametersText(parameters) {
  return Object.entries(parameters).map(([name, value]) => `${name}=${value}`).join(" ");
}

// What made the pictures; goes under them and into saved ones.
function contextLines(viewer) {
  const {scene, runIndex, otherIndex} = viewer;
  const run = scene.techniques[runIndex];
  const lines = [
    `${scene.name}: scene hash ${scene.hash}; seed ${results.seed}; ${results.width_px} x ${results.height_px} px; ` +
        `umbrameter ${results.version} (${results.commit})`,
    `Reference: ${scene.reference.device}; ${scene.reference.mean_sample_count.toFixed(0)} samples per pixel`,
    `${run.label}: technique ${run.technique}, hash ${run.hash}; ${parametersText(run.parameters)}; ${run.device}`,
  ];
  if (otherIndex === kReference) return lines;
  const other = scene.techniques[otherIndex];
  return [...lines, `Compared with ${other.label}: hash ${other.hash}; ${parametersText(other.parameters)}; ${other.device}`];
}

function setMode(viewer, mode) {
  viewer.mode = mode;
  viewer.root.dataset.mode = mode;
  for (const button of viewer.root.querySelectorAll("[data-mode]")) {
    button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
  }
  part(viewer, "divider-box").hidden = mode !== "slider";
  part(viewer, "flip").hidden = mode !== "flip";
  draw(viewer);
}

function step(viewer, direction) {
  const there = viewer.entry.runs.flatMap((run, index) => run ? [index] : []);
  const at = there.indexOf(viewer.runIndex) + direction;
  show(viewer, there[(at + there.length) % there.length], viewer.otherIndex);
}

function makeViewer(sceneIndex) {
  if (viewers.has(sceneIndex)) return viewers.get(sceneIndex);
  const entry = page.scenes[sceneIndex];
  if (!entry?.runs.some(run => run)) return null;
  const best = bestAffordable(results.scenes[sceneIndex], kAffordableFactor);
  const first = entry.runs[best] ? best : entry.runs.findIndex(run => run);
  const stage = document.querySelector(`.stage[data-scene="${sceneIndex}"]`);
  stage.append(document.getElementById("viewer").content.cloneNode(true));
  const viewer = {
    root: stage.querySelector(".viewer"), entry, sceneIndex, scene: results.scenes[sceneIndex], request: 0, runIndex: first,
    otherIndex: kReference, mode: "panes", layer: "error", isFlipped: false, divider: 0.5, overlays: new Set(),
    view: {x: entry.width / 2, y: entry.height / 2, zoom: 1},
    cursor: null, shown: null, bitmaps: {}, white: null, charts: {},
    picture: entry.planes.unshadowed ? "lit" : "visibility", exposure_stops: 0, errorScale: palette.error_scale,
  };
  viewers.set(sceneIndex, viewer);
  viewer.root.setAttribute("aria-label", `Pictures of ${viewer.scene.name}; press ? for keys`);
  viewer.root.style.setProperty("--aspect", `${entry.width} / ${entry.height}`);
  fillChoices(viewer);
  part(viewer, "picture-box").hidden = !entry.planes.unshadowed;
  listen(viewer);
  setMode(viewer, "panes");
  show(viewer, first, kReference);
  return viewer;
}
