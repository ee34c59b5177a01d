// SPDX-License-Identifier: Apache-2.0
// What `bench` measured: time against error with the recommended run, and the truth's own curve, as plots.

const benchCharts = [];

// The median with its interval; with what there is where too few frames were timed for one; null without any.
function benchTime(run) {
  if (run.time_ms) return run.time_ms;
  const total = run.pass_times?.at(-1);
  return total ? {value: total.median_ms, low: total.median_ms, high: total.median_ms, frames: total.frames} : null;
}

function drawBench(owner) {
  const {bench} = owner, colours = themeColours();
  const timed = bench.runs.map(run => ({run, time: benchTime(run)})).filter(({run, time}) => time && run.rmse);
  if (timed.length === 0) return;
  const points = timed.map(({run, time}) => ({x: time.value, y: run.rmse.value, label: run.label, isOnFront: run.is_on_front,
                                              bars: {x: [time.low, time.high], y: [run.rmse.low, run.rmse.high]}}));
  const best = points.filter(point => point.label === bench.recommended).map(({x, y, label}) => ({x, y, label}));
  const ring = {label: `recommended: ${bench.recommended}`, data: best, pointStyle: "circle", pointRadius: 11, borderColor: colours.third, backgroundColor: "transparent", borderWidth: 2};
  putChart(owner, "bench", timesConfig(points, point => point.isOnFront ?? !isBehind(point, points), () => false, best.length > 0 ? [ring] : [], {}));
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
