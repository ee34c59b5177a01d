// SPDX-License-Identifier: Apache-2.0
// What `tune` found: the best parameters, and objective, acne and peter panning over a bias with the window where both are
// harmless.

const sweepCharts = [];

function windowText(sweep) {
  if (!sweep.window) return "The safe window was not found: the search was cut off.";
  const {low, high, empty} = sweep.window;
  if (empty) return "No value is safe: what ends the acne already detaches the shadow.";
  return `Safe from ${low} to ${high} ${sweep.unit}.`;
}

// Values tried are spaced evenly, for a search tries most of them close together: where `value` lies among them.
function placeAmong(values, value) {
  const above = values.findIndex(one => one >= value);
  if (above <= 0) return above < 0 ? values.length - 1 : 0;
  return above - 1 + (value - values[above - 1]) / (values[above] - values[above - 1]);
}

function drawSweep(owner) {
  const {sweep} = owner, colours = themeColours();
  const line = (label, values, style) => ({label, data: sweep.values.map((x, k) => ({x: k, y: values[k]})), borderWidth: 2, pointRadius: 2, backgroundColor: "transparent", ...style});
  putChart(owner, "sweep", {
    type: "line",
    data: {datasets: [line("objective", sweep.objective, {borderColor: colours.ink}),
                      line("acne", sweep.acne, {borderColor: colours.second, borderDash: [6, 3]}),
                      line("peter panning", sweep.peter_panning, {borderColor: colours.third, borderDash: [2, 2]})]},
    options: {safeRange: !sweep.window || sweep.window.empty ? null : [sweep.window.low, sweep.window.high].map(end => placeAmong(sweep.values, end)),
              scales: {x: axis(`${sweep.parameter}, ${sweep.unit}`, {type: "linear", ticks: {color: colours.quiet, stepSize: 1, autoSkip: true, maxRotation: 0,
                                                                                                callback: k => k in sweep.values ? significantText(sweep.values[k], 3) : ""}}),
                       y: axis("objective and its parts")}},
  });
}

// Candidates of a search beside each other: the objective over the defaults', on the views it was tuned on and on others.
function tuningTable(tuning) {
  const ratio = value => numberCell("ratio", value, value === null || value === undefined ? "n/a" : value.toFixed(3));
  const given = tuning.others.find(one => one.name.split(", ").includes("default"))?.parameters ?? {};
  const changes = one => Object.entries(one.parameters).filter(([name, value]) => name in given && given[name] !== value).map(([name, value]) => `${name}=${parameterText(value)}`).join(" ");
  const rows = [tuning.best, ...tuning.others].map(one => [nameCell(one.name), ratio(one.ratio), ratio(one.held_out_ratio), textCell(one.same_cost ? "same" : "its own"),
                                                           textCell(changes(one) || "none", "context")]);
  return makeTable(`What tuning ${tuning.technique} found`, ["Parameters", "#Objective over the defaults'", "#On other cameras", "Cost", "Changes to the defaults"], rows);
}

function makeSweeps() {
  const section = document.getElementById("sweeps");
  section.hidden = page.bias_sweeps.length === 0 && page.tunings.length === 0;
  for (const tuning of page.tunings) {
    document.getElementById("tunings").append(element("h3", {}, `${tuning.technique} on ${tuning.scenes.join(", ")} (${tuning.file}), by ${tuning.objective}`), tuningTable(tuning));
  }
  for (const sweep of page.bias_sweeps) {
    const root = document.getElementById("sweep").content.cloneNode(true).firstElementChild;
    const owner = [sweep.scene, sweep.technique].filter(text => text).join(", ") || sweep.file;
    root.querySelector("figcaption").textContent = `${owner}: ${sweep.parameter}${sweep.beside ? `, the rest as ${sweep.beside}` : ""} (${sweep.file})`;
    root.querySelector("p").textContent = windowText(sweep);
    root.querySelector("canvas").setAttribute("aria-label", `Bias sweep of ${owner}`);
    document.getElementById("bias-sweeps").append(root);
    sweepCharts.push({root, charts: {}, sweep});
    drawSweep(sweepCharts.at(-1));
  }
}
