// SPDX-License-Identifier: Apache-2.0
// What `bench` measured: time against error with the recommended run, and the truth's own curve, as plots.

const benchCharts = [];

function drawBench(owner) {
  const {bench} = owner, colours = themeColours();
  const points = bench.runs.filter(run => run.time_ms && run.rmse).map(run => ({x: run.time_ms.value, y: run.rmse.value, label: run.label, isOnFront: run.is_on_front,
                                         bars: {x: [run.time_ms.low, run.time_ms.high], y: [run.rmse.low, run.rmse.high]}}));
  const best = points.filter(point => point.label === bench.recommended).map(({x, y, label}) => ({x, y, label}));
  const ring = {label: `recommended: ${bench.recommended}`, data: best, pointStyle: "circle", pointRadius: 11, borderColor: colours.third, backgroundColor: "transparent", borderWidth: 2};
  putChart(owner, "bench", timesConfig(points, point => point.isOnFront, () => false, best.length > 0 ? [ring] : [], {}));
}

// RMSE against processor time, both logarithmic. The exponent is of the number of samples, not of time.
function drawTruthCurve(owner) {
  const {truth} = owner.bench;
  if (!truth) return;
  const colours = themeColours(), inks = [colours.second, colours.third, colours.ink, colours.quiet];
  const points = truth.points.filter(point => point.cpu_s > 0 && point.rmse > 0).sort((a, b) => a.cpu_s - b.cpu_s);
  if (points.length === 0) return;
  const kinds = [...new Set(points.map(point => point.kind))];
  const falls = typeof truth.exponent === "number" ? `samples: RMSE as their number to the power ${truth.exponent.toFixed(2)}` : "samples";
  const sets = kinds.map((kind, k) => ({
    label: kind === "samples" ? falls : kind, showLine: true, borderWidth: 1, pointRadius: 4, borderColor: inks[k % inks.length], backgroundColor: inks[k % inks.length],
    data: points.filter(point => point.kind === kind).map(point => ({
      x: point.cpu_s, y: point.rmse, label: `${kind} ${point.setting}`,
      bars: {x: [point.cpu_s - point.cpu_mad_s, point.cpu_s + point.cpu_mad_s], y: [point.rmse_low, point.rmse_high]}}))}));
  putChart(owner, "truth", {
    type: "scatter", data: {datasets: sets},
    options: {
      scales: {x: axis("processor time, s", {type: "logarithmic"}), y: axis("RMSE of R", {type: "logarithmic"})},
      plugins: {tooltip: {callbacks: {label: item => `${item.raw.label}: ${item.raw.x.toPrecision(3)} s, RMSE ${item.raw.y.toPrecision(3)}`}}},
    },
  });
}
