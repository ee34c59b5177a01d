// SPDX-License-Identifier: Apache-2.0
// What `tune` found: objective, acne and peter panning over a bias, with the window where both are harmless.

const sweepCharts = [];

function windowText(sweep) {
  if (!sweep.window) return "The safe window was not found: the search was cut off.";
  const {low, high, empty} = sweep.window;
  if (empty) return "No value is safe: what ends the acne already detaches the shadow.";
  return `Safe from ${low} to ${high} ${sweep.unit}.`;
}

function drawSweep(owner) {
  const {sweep} = owner, colours = themeColours();
  const line = (label, values, style) => ({label, data: sweep.values.map((x, k) => ({x, y: values[k]})), borderWidth: 2, pointRadius: 2, backgroundColor: "transparent", ...style});
  putChart(owner, "sweep", {
    type: "line",
    data: {datasets: [line("objective", sweep.objective, {borderColor: colours.ink}),
                      line("acne", sweep.acne, {borderColor: colours.second, borderDash: [6, 3]}),
                      line("peter panning", sweep.peter_panning, {borderColor: colours.third, borderDash: [2, 2]})]},
    options: {safeRange: !sweep.window || sweep.window.empty ? null : [sweep.window.low, sweep.window.high],
              scales: {x: axis(`${sweep.parameter}, ${sweep.unit}`, {type: "linear"}), y: axis("objective and its parts")}},
  });
}

function makeSweeps() {
  const section = document.getElementById("sweeps");
  section.hidden = page.bias_sweeps.length === 0;
  for (const sweep of page.bias_sweeps) {
    const root = document.getElementById("sweep").content.cloneNode(true).firstElementChild;
    const owner = [sweep.scene, sweep.technique].filter(text => text).join(", ") || sweep.file;
    root.querySelector("figcaption").textContent = `${owner}: ${sweep.parameter}${sweep.beside ? `, the rest as ${sweep.beside}` : ""} (${sweep.file})`;
    root.querySelector("p").textContent = windowText(sweep);
    root.querySelector("canvas").setAttribute("aria-label", `Bias sweep of ${owner}`);
    section.append(root);
    sweepCharts.push({root, charts: {}, sweep});
    drawSweep(sweepCharts.at(-1));
  }
}
