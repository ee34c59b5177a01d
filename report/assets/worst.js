// SPDX-License-Identifier: Apache-2.0
// The three worst places: where a technique's largest fault is, as crops of truth, technique and error.

const kWorstPlaces = 3;
const kCropShare = 0.22;  // of the picture's width

// Runs by the error of their worst fault, each scene and each technique once.
function worstRuns() {
  const all = results.scenes.flatMap((scene, sceneIndex) => scene.techniques.flatMap((run, runIndex) => {
    const fault = worstFault(run);
    return fault && !isEarlier(run) && page.scenes[sceneIndex]?.runs[runIndex] ? [{scene: sceneIndex, run: runIndex, technique: run.technique, fault}] : [];
  })).sort((a, b) => b.fault.part - a.fault.part);
  const chosen = [];
  for (const place of all) {
    if (chosen.length === kWorstPlaces) break;
    if (!chosen.some(other => other.scene === place.scene || other.technique === place.technique)) chosen.push(place);
  }
  return chosen;
}

// The window of `size` with the largest sum of |V - R| over pixels of the class; by running sums.
function worstWindow(entry, planes, run, classIndex, size) {
  const {width, height} = entry, sums = new Float64Array((width + 1) * (height + 1));
  for (let y = 0; y < height; ++y) {
    for (let x = 0, line = 0; x < width; ++x) {
      const i = y * width + x;
      if (run.faults[i] === classIndex) line += Math.abs(run.visibility[i] - planes.visibility[i]);
      sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + line;
    }
  }
  let best = {x: 0, y: 0, sum: -1};
  for (let y = 0; y + size.height <= height; y += 2) {
    for (let x = 0; x + size.width <= width; x += 2) {
      const at = (dx, dy) => sums[(y + dy) * (width + 1) + x + dx];
      const sum = at(size.width, size.height) - at(0, size.height) - at(size.width, 0) + at(0, 0);
      if (sum > best.sum) best = {x, y, sum};
    }
  }
  return best;
}

// The window's pixels alone, of a picture `width` wide.
function cropCanvas(colourAt, window, size, width, label) {
  const canvas = paintBitmap(size.width, size.height, i => colourAt((window.y + Math.floor(i / size.width)) * width + window.x + i % size.width));
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", label);
  return canvas;
}

const kMendedRatio = 0.98;  // of the objective; tuning that leaves more has mended nothing

// Numbers as short as they can be told apart.
function parameterText(value) {
  return typeof value === "number" ? String(Number(value.toPrecision(3))) : String(value);
}

// What `tune` found for this technique, of this scene where it was tuned on it: which parameter mends it, and by how much.
function tuningSentence(scene, run) {
  const known = page.tunings.filter(tuning => tuning.technique === run.technique && tuning.best.ratio !== null);
  const tuning = known.find(one => one.scenes.includes(scene.name)) ?? known[0];
  if (!tuning) return "";
  const rise = name => {
    const found = tuning.sensitivity.find(one => one.parameter === name);
    return Math.max(found?.rise_below ?? 0, found?.rise_above ?? 0);
  };
  const changed = tuning.tuned.filter(name => name in run.parameters && tuning.best.parameters[name] !== run.parameters[name]).sort((a, b) => rise(b) - rise(a));
  const where = tuning.scenes.includes(scene.name) ? "" : ` on ${tuning.scenes.join(", ")}`;
  if (changed.length === 0 || tuning.best.ratio > kMendedRatio) return `Tuning${where} found no parameters that mend it (${tuning.file}).`;
  const changes = changed.slice(0, 2).map(name => `${name} ${parameterText(run.parameters[name])} to ${parameterText(tuning.best.parameters[name])}`);
  const more = changed.length > 2 ? ` and ${changed.length - 2} more` : "";
  return `Tuning${where} mends it: ${changes.join(", ")}${more} leaves ${(100 * tuning.best.ratio).toFixed(0)} % of the ${tuning.objective} (${tuning.file}).`;
}

// What is wrong, why, and what mends it, as far as each is known.
function worstSentences(scene, run, fault) {
  const text = palette.faults.find(one => one.name === fault.name)?.text ?? fault.name;
  const share = 100 * fault.part / run.error.mae, cause = run.fault_causes?.faults?.find(one => one.fault === fault.name)?.sentence;
  const sentences = [`${text[0].toUpperCase()}${text.slice(1)}; ${share.toFixed(0)} % of the mean |error| ${run.error.mae.toFixed(4)}.`,
                     cause ? `Why: ${cause}.` : "", tuningSentence(scene, run)];
  return sentences.filter(sentence => sentence);
}

async function worstFigure(place) {
  const scene = results.scenes[place.scene], run = scene.techniques[place.run], entry = page.scenes[place.scene];
  const planes = await litPlanes(place.scene), pixels = await runPlanes(entry.runs[place.run]);
  if (!pixels.faults) return null;
  const size = {width: Math.max(Math.round(kCropShare * entry.width), 8)};
  size.height = Math.min(Math.round(0.75 * size.width), entry.height);
  const window = worstWindow(entry, planes, pixels, palette.faults.findIndex(one => one.name === place.fault.name), size);
  const shown = {scene: planes, run: pixels, other: planes, isReference: true};
  const white = litScale(planes);
  const parts = [["truth", litColour(planes, planes, white)], [run.label, litColour(pixels, planes, white)],
                 ["error", i => layers.error.colour(shown, i)]];
  const figure = document.createElement("figure"), caption = document.createElement("figcaption"), link = document.createElement("a");
  const row = document.createElement("div");
  link.href = `#scene-${place.scene + 1}-run-${place.run + 1}`;
  link.textContent = `${run.label} in ${scene.name}: ${place.fault.name.replaceAll("_", " ")}`;
  caption.append(link);
  row.className = "crops";
  for (const [label, colour] of parts) {
    const box = document.createElement("div"), title = document.createElement("span");
    title.textContent = label;
    box.append(cropCanvas(colour, window, size, entry.width, `${label}, ${link.textContent}`), title);
    row.append(box);
  }
  const texts = worstSentences(scene, run, place.fault).map(sentence => {
    const text = document.createElement("p");
    text.textContent = sentence;
    return text;
  });
  figure.append(caption, row, ...texts);
  return figure;
}

async function fillWorstPlaces() {
  const box = document.getElementById("worst-places");
  for (const place of worstRuns()) {
    const figure = await worstFigure(place);
    if (figure) box.append(figure);
  }
  document.getElementById("worst").hidden = box.children.length === 0;
}
