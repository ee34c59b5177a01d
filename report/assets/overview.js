// SPDX-License-Identifier: Apache-2.0
// The first screen: techniques x scenes as a heat map, which is also the way to every picture, and who is best for the time.

const kAffordableFactor = 10;  // times the fastest run's time; the page's choice to begin with
const kHeatStops = [[0, 32, 77], [48, 70, 107], [104, 104, 112], [155, 140, 115], [207, 179, 97], [255, 234, 70]];  // cividis

function heatColour(share) {
  const at = Math.min(Math.max(share, 0), 1) * (kHeatStops.length - 1), low = Math.min(Math.floor(at), kHeatStops.length - 2);
  return mix(kHeatStops[low], kHeatStops[low + 1], at - low);
}

// Black or white, whichever stands out from `colour`.
function inkOn([r, g, b]) {
  return 0.299 * r + 0.587 * g + 0.114 * b > 118 ? "#000" : "#fff";
}

function percentile(sorted, share) {
  return sorted[Math.round(share * (sorted.length - 1))];
}

// A logarithmic scale over what is shown; the lowest and highest twentieth are clipped.
function heatScale(values) {
  const sorted = values.filter(value => value > 0).sort((a, b) => a - b);
  if (sorted.length === 0) return () => 0;
  const low = Math.log(percentile(sorted, 0.05)), high = Math.log(percentile(sorted, 0.95));
  return value => value <= 0 ? 0 : high > low ? (Math.log(value) - low) / (high - low) : 0.5;
}

function median(values) {
  const sorted = values.filter(value => value !== null).sort((a, b) => a - b);
  return sorted.length ? percentile(sorted, 0.5) : Infinity;
}

// Labels of all runs with their place in each scene (undefined: not run there), best median RMSE first.
function overviewRows() {
  const rows = new Map();
  results.scenes.forEach((scene, sceneIndex) => scene.techniques.forEach((run, runIndex) => {
    if (!rows.has(run.label)) rows.set(run.label, []);
    rows.get(run.label)[sceneIndex] ??= runIndex;
  }));
  const order = ([, places]) => median(places.map((run, scene) => rmseOf(results.scenes[scene].techniques[run])));
  return Array.from(rows).map(row => ({label: row[0], places: row[1], order: order(row)})).sort((a, b) => a.order - b.order);
}

// Of an earlier results folder: shown, but no choice for today.
function isEarlier(run) {
  return run.label?.endsWith(kBeforeMark) ?? false;
}

// Compared as irradiance beside runs compared as visibility: a path tracer's error is of another kind.
function isOtherQuantity(scene, run) {
  return (run.quantity ?? "visibility") !== "visibility" && (scene.quantity ?? "visibility") === "visibility";
}

// The index of the run that is closest to the truth within `factor` times the fastest scored run's time; -1 without any.
function bestAffordable(scene, factor) {
  const scored = scene.techniques.flatMap((run, index) => rmseOf(run) === null || isEarlier(run) || isOtherQuantity(scene, run) ? [] : [{run, index}]);
  const times = scored.map(({run}) => totalMs(run)).filter(time => time !== null);
  const limit = times.length ? factor * Math.min(...times) : Infinity;
  const affordable = scored.filter(({run}) => times.length === 0 || (totalMs(run) ?? Infinity) <= limit);
  return affordable.reduce((best, {run, index}) =>
      best < 0 || rmseOf(run) < rmseOf(scene.techniques[best]) ? index : best, -1);
}

const isTimed = () => results.scenes.some(scene => scene.techniques.some(run => rmseOf(run) !== null && totalMs(run) !== null));

// What the framed runs are: nobody is best for a time that was not measured.
const bestWords = () => isTimed() ? "best for the time" : "closest to the truth";

function cellLabel(scene, run) {
  const fault = worstFault(run), time = totalMs(run);
  return `${run.label} in ${scene.name}: RMSE ${rmseOf(run)?.toFixed(4) ?? "n/a"}${isOtherQuantity(scene, run) ? " of the irradiance ratio" : ""}` +
      (fault ? `, worst fault ${fault.name.replaceAll("_", " ")} ${fault.part.toFixed(4)}` : "") +
      (time === null ? "" : `, ${significantText(time, 3)} ms`);
}

function fillCell(cell, sceneIndex, runIndex, metric, scale, isBest) {
  cell.removeAttribute("style");
  cell.classList.toggle("best", isBest);
  const scene = results.scenes[sceneIndex], run = scene.techniques[runIndex];
  if (!run) return;
  const value = metric.value(run), link = document.createElement("a");
  link.href = `#scene-${sceneIndex + 1}-run-${runIndex + 1}`;
  link.textContent = value === null ? "n/a" : metric.text(value);
  link.title = value === null ? (run.failure?.message ?? `${run.label}: not measured`) : cellLabel(scene, run);
  if (isBest) link.setAttribute("aria-label", `${link.textContent}, ${bestWords()}`);
  if (value !== null) {
    const colour = heatColour(scale(metric.wrong(value)));
    cell.style.background = `rgb(${colour})`;
    link.style.color = inkOn(colour);
  }
  cell.replaceChildren(link);
}

function drawOverview() {
  const metric = overviewMetrics[document.getElementById("overview-metric").value];
  const factor = Number(document.getElementById("overview-budget").value);
  const scale = heatScale(results.scenes.flatMap(scene => scene.techniques.map(metric.value).filter(value => value !== null).map(metric.wrong)));
  const best = results.scenes.map(scene => bestAffordable(scene, factor));
  for (const row of document.querySelectorAll("#overview-map tbody tr")) {
    Array.from(row.cells).slice(1).forEach((cell, scene) => {
      const run = cell.dataset.run === "" ? -1 : Number(cell.dataset.run);
      fillCell(cell, scene, run, metric, scale, run >= 0 && run === best[scene]);
    });
  }
  const wins = new Map();
  best.forEach((run, scene) => { if (run >= 0) wins.set(results.scenes[scene].techniques[run].label, (wins.get(results.scenes[scene].techniques[run].label) ?? 0) + 1); });
  const words = Array.from(wins).sort((a, b) => b[1] - a[1]).map(([label, count]) => `${label} in ${count}`);
  document.getElementById("overview-budget").parentElement.hidden = !isTimed();
  const [first, ...rest] = bestWords();
  document.getElementById("overview-best").textContent = words.length === 0 ? "" :
      `${first.toUpperCase()}${rest.join("")} (framed): ${words.join(", ")} of ${results.scenes.length} scene${results.scenes.length === 1 ? "" : "s"}.`;
  fillBestTable(factor);
}

// A small lit picture of the truth at the head of a scene's column; its pixels lie in the page's data.
async function drawThumbnail(canvas, sceneIndex) {
  const small = page.scenes[sceneIndex]?.small;
  if (!small) return;
  const planes = await unpack(small.planes, small.packed, Object.keys(small.planes));
  const picture = paintBitmap(small.width, small.height, litColour(planes, planes, litScale(planes)));
  canvas.width = small.width;
  canvas.height = small.height;
  canvas.getContext("2d").drawImage(picture, 0, 0);
}

// May be broken after what joins its words.
function breakable(name) {
  return name.replaceAll(/[_/:=,]/g, joint => joint + "\u200b");
}

function sceneHead(scene, sceneIndex) {
  const cell = document.createElement("th"), link = document.createElement("a"), canvas = document.createElement("canvas");
  cell.scope = "col";
  link.href = `#scene-${sceneIndex + 1}`;
  canvas.setAttribute("aria-hidden", "true");
  const entry = page.scenes[sceneIndex];
  canvas.width = entry?.small?.width ?? 240;
  canvas.height = entry?.small?.height ?? 135;
  link.append(canvas, breakable(scene.name));
  cell.append(link);
  return cell;
}

function makeOverview() {
  const section = document.getElementById("overview"), table = document.getElementById("overview-map");
  if (results.scenes.length === 0) return;
  section.hidden = false;
  table.style.setProperty("--scenes", results.scenes.length);
  fillMetricMenu(document.getElementById("overview-metric"));
  const head = document.createElement("tr"), corner = document.createElement("th");
  corner.scope = "col";
  corner.textContent = "Technique";
  head.append(corner, ...results.scenes.map(sceneHead));
  table.tHead.append(head);
  for (const row of overviewRows()) {
    const line = document.createElement("tr"), name = document.createElement("th");
    name.scope = "row";
    const isOther = row.places.some((run, index) => run !== undefined && isOtherQuantity(results.scenes[index], results.scenes[index].techniques[run]));
    name.textContent = breakable(row.label) + (isOther ? " (irradiance)" : "");
    line.append(name, ...results.scenes.map((scene, index) => {
      const cell = document.createElement("td");
      cell.dataset.run = row.places[index] ?? "";
      return cell;
    }));
    table.tBodies[0].append(line);
  }
  for (const id of ["overview-metric", "overview-budget"]) document.getElementById(id).addEventListener("input", drawOverview);
  drawOverview();
}

// After the page stands: thumbnails as they are unpacked, then the worst places and the front.
async function fillOverview() {
  await Promise.all(Array.from(document.querySelectorAll("#overview-map thead canvas"), drawThumbnail));
  await fillWorstPlaces();
  frontOwner.isWanted = true;
  drawFront();
  document.getElementById("overview").dataset.ready = "yes";
}
