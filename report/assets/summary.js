// SPDX-License-Identifier: Apache-2.0
// The page's first words, the table of all runs, the legend, and what was skipped.

const kShortTable = 40;  // rows that are shown unfolded

// Column, heading and kind of the summary table's cells; the words are report/table.h's.
const kColumns = [["total_ms", "#Time"], ["rmse", "#RMSE [95 %]"], ["penumbra_rmse", "#Penumbra RMSE"], ["worst_fault", "#Worst fault"], ["verdict", "Verdict"],
                  ["wrong_pixels", "#Wrong pixels"], ["bias", "#Mean error"], ["over_shadowing", "#Over-shadowing"], ["under_shadowing", "#Under-shadowing"],
                  ["penumbra_share", "#Penumbra share"], ["memory_bytes", "#Memory"]];

function columnCell(row, column) {
  return column === "verdict" ? element("td", {"data-column": column}, row.verdict) : numberCell(column, row[column][0], row[column][1]);
}

// A run without an error says why across the columns that it lacks.
function rowCells(row) {
  if (row.missing === undefined) return kColumns.map(([column]) => columnCell(row, column));
  return [columnCell(row, "total_ms"), element("td", {colspan: kColumns.length - 2, class: "problem"}, row.missing), columnCell(row, "memory_bytes")];
}

function summaryRow(sceneIndex, runIndex) {
  const scene = results.scenes[sceneIndex], run = scene.techniques[runIndex], anchor = `#scene-${sceneIndex + 1}`;
  return element("tr", {"data-scene": scene.name, "data-technique": run.label}, nameCell(element("a", {href: anchor}, scene.name)),
                 element("td", {}, element("a", {href: `${anchor}-run-${runIndex + 1}`}, run.label)), ...rowCells(page.texts.scenes[sceneIndex].rows[runIndex]));
}

function fillSummary() {
  const {summary} = page.texts, verdicts = document.getElementById("verdicts");
  verdicts.append(...summary.problems.map(text => element("p", {class: "problem"}, text)), element("p", {}, summary.counts));
  const troubled = summary.scenes.flatMap((problem, index) => problem ? [element("li", {}, element("a", {href: `#scene-${index + 1}`}, results.scenes[index].name), `: ${problem}`)] : []);
  if (troubled.length > 0) verdicts.append(element("ul", {}, ...troubled));
  const folded = document.getElementById("all-runs");
  folded.addEventListener("toggle", fillAllRuns);
  folded.open = results.scenes.reduce((sum, scene) => sum + scene.techniques.length, 0) <= kShortTable;
  if (folded.open) fillAllRuns();
}

// The table of all runs, once, when it is unfolded or printed.
function fillAllRuns() {
  if (document.getElementById("results") || !page.texts) return;
  const heads = ["Scene", "Technique", ...kColumns.map(([, heading]) => heading)], box = makeTable("Summary table", heads, []), table = box.querySelector("table");
  table.id = "results";
  results.scenes.forEach((scene, s) => scene.techniques.forEach((run, k) => table.tBodies[0].append(summaryRow(s, k))));
  document.getElementById("all-runs").append(box);
  listenToHeadings(table);
  listenToFilter(table);
}

function swatchList(entries) {
  return element("ul", {class: "swatches"}, ...entries.map(entry => swatchItem(entry.colour, entry.text)));
}

function fillLegend() {
  const scale = palette.error_scale, ramp = [palette.too_dark, palette.no_error, palette.too_bright].map(colour => `rgb(${colour})`);
  document.getElementById("legend").append(
      element("p", {}, "Visibility: grey, byte = 255 V; black sees nothing of the light, white all of it."),
      element("p", {}, "Signed error V - R, the same scale everywhere at first; beyond it the colour is clipped and the share is stated:"),
      element("div", {class: "ramp", style: `background:linear-gradient(to right,${ramp})`, role: "img", "aria-label": "blue too dark, white no error, red too bright"}),
      element("div", {class: "ramp-ends"}, element("span", {}, `-${scale} too dark`), element("span", {}, "0"), element("span", {}, `+${scale} too bright`)),
      swatchList([{colour: palette.background, text: "nothing hit"}, {colour: palette.unscored, text: "not scored"}]),
      element("p", {}, "Parity:"), swatchList(palette.parity), element("p", {}, "Faults:"), swatchList(palette.faults), element("p", {}, page.texts.pixel_steps));
}

function fillSkipped() {
  const {skipped} = page.texts;
  document.getElementById("skipped").append(skipped.length ? element("ul", {}, ...skipped.map(text => element("li", {}, text))) : element("p", {}, "Nothing was skipped."));
}

// What the page is of: runs against the truth, or what another command left alone.
function pageTitle() {
  const kAll = "Shadow techniques against the truth";
  if (page.texts) return kAll;
  const titles = [...page.regressions.map(check => `Regression: ${check.suite}`), ...page.benches.map(study => study.title || study.file),
                  ...new Set(page.tunings.map(tuning => `${tuning.technique} tuned on ${tuning.scenes.join(", ")}`)), ...page.stresses.map(map => map.title)];
  return titles.length === 1 ? titles[0] : kAll;
}

// Everything that results.json gives in words; the parts stay hidden without it.
function fillTexts() {
  document.getElementById("context").textContent = page.texts?.context ?? "";
  document.getElementById("context").hidden = !page.texts;
  document.title = document.querySelector("h1").textContent = pageTitle();
  for (const id of ["summary", "legend", "skipped"]) document.getElementById(id).hidden = !page.texts;
  if (!page.texts) return;
  fillSummary();
  results.scenes.forEach((scene, index) => document.getElementById("scenes").before(sceneSection(scene, index)));
  fillLegend();
  fillSkipped();
}
