// SPDX-License-Identifier: Apache-2.0
// The stability map of `stress` and the values behind it, as tables; how one walks the map is stress.js.

function unitOf(axis) {
  return axis.unit === "1" ? "" : axis.unit;
}

// "leak at 1e+05": the first value beyond the range; its sentence when there is more to say.
function breakText(end) {
  return `${end.words} at ${end.value}${end.how.includes(" ") ? `: ${end.how}` : ""}`;
}

function rangeDetail(range, unit) {
  const who = `${range.row}, ${range.axis}: `;
  if (!range.applies) return `${who}not applicable: ${range.why_not}`;
  const ends = [range.break_before, range.break_after].filter(end => end).map(end => `; ${breakText(end)}`).join("");
  return `${who}holds ${range.first === range.last ? `at ${range.first}` : `from ${range.first} to ${range.last}`}${unit ? ` ${unit}` : ""} ` +
      `(${range.held} of ${range.values} values)${ends}`;
}

// From blue, all values hold, to orange with fewer.
function rangeCell(range, axis, anchor) {
  if (!range) return element("td", {role: "gridcell", class: "none"}, "-");
  const detail = rangeDetail(range, unitOf(axis)), share = range.values > 0 ? range.held / range.values : 0;
  const attributes = {role: "gridcell", tabindex: -1, "data-axis": anchor, "data-detail": detail, title: detail};
  if (!range.applies) return element("td", {...attributes, class: "none"}, "-");
  return element("td", {...attributes, style: `background: ${shareColour(share)}`}, range.held === range.values ? "all" : `${range.held}/${range.values}`);
}

// Colour-blind safe: orange 0 over pale grey to blue 1, see-through, so that ink is readable in both themes.
function shareColour(share) {
  const colour = share < 0.5 ? mix([230, 97, 1], [150, 150, 150], 2 * share) : mix([150, 150, 150], [30, 110, 200], 2 * share - 1);
  return `rgb(${colour} / 0.55)`.replaceAll(",", " ");
}

function stressMap(stress, anchorOf) {
  const ranges = new Map(stress.ranges.map(range => [`${range.row}\n${range.axis}`, range]));
  const head = element("tr", {}, element("th", {scope: "col"}, "Technique"),
                       ...stress.axes.map(axis => element("th", {scope: "col", class: "upright"}, element("span", {}, axis.name.replaceAll("_", " ")))));
  const rows = stress.rows.map(row => element("tr", {}, nameCell(row), ...stress.axes.map(axis => rangeCell(ranges.get(`${row}\n${axis.name}`), axis, anchorOf(axis)))));
  return element("div", {class: "table-scroll"}, element("table", {class: "map", role: "grid", "aria-label": "Stability map"}, element("thead", {}, head), element("tbody", {}, ...rows)));
}

function stressValue(cell) {
  if (!cell) return element("td", {class: "none"}, "-");
  const rmse = cell.rmse ? errorText(cell.rmse.value) : "", words = cell.outcome !== "ok" || !rmse ? cell.words : "";
  return element("td", {class: cell.outcome, title: cell.how && cell.how !== cell.words ? cell.how : null}, [rmse, words].filter(text => text).join(" "));
}

function stressAxis(stress, axis, anchor) {
  const unit = unitOf(axis), cells = new Map(stress.cells.filter(cell => cell.axis === axis.name).map(cell => [`${cell.row}\n${cell.value}`, cell]));
  const head = element("tr", {}, element("th", {scope: "col"}, "Technique"),
                       ...axis.values.map((value, k) => element("th", {scope: "col"}, value + (k === axis.nominal ? " (nominal)" : ""))));
  const rows = stress.rows.map(row => element("tr", {}, nameCell(row), ...axis.values.map((value, k) => stressValue(cells.get(`${row}\n${k}`)))));
  return element("details", {class: "facts", id: anchor}, element("summary", {}, `${axis.name.replaceAll("_", " ")}${unit ? ` (${unit})` : ""}: ${axis.doc}`),
                 scrollBox(`Axis ${axis.name}`, element("table", {class: "map"}, element("thead", {}, head), element("tbody", {}, ...rows))));
}

function makeStress() {
  const section = document.getElementById("stress");
  section.hidden = page.stresses.length === 0;
  page.stresses.forEach((stress, index) => {
    const anchorOf = axis => `stress-${index + 1}-${axis.name}`, broken = stress.violations;
    section.append(element("h3", {}, stress.title || stress.file),
                   element("p", {class: "context"}, `${stress.file}: umbrameter ${stress.version} (${stress.commit}); ${stress.device}; ${stress.width_px} x ${stress.height_px} px, ` +
                           `${stress.samples_per_pixel} samples per pixel, seed ${stress.seed}`));
    if (broken.length > 0) section.append(element("p", {class: "problem"}, `Against the rules: ${broken.length}`), warningList(broken));
    section.append(stressMap(stress, anchorOf),
                   element("p", {class: "map-detail", role: "status"}, "Point at a cell, or Tab to the map and use the arrows: its range, the first value that breaks it, and how. Enter unfolds the axis."),
                   ...stress.axes.map(axis => stressAxis(stress, axis, anchorOf(axis))));
  });
}
