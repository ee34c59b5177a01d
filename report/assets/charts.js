// SPDX-License-Identifier: Apache-2.0
// Plots (Chart.js). Every plot's numbers are also in the table or among the runs' numbers.

function themeColours() {
  const style = getComputedStyle(document.documentElement);
  const colour = name => style.getPropertyValue("--" + name).trim();
  return {ink: colour("ink"), quiet: colour("quiet"), line: colour("line"), second: colour("plot-2"), third: colour("plot-3"), band: colour("band")};
}

function axis(title, more) {
  const colours = themeColours();
  return {title: {display: true, text: title, color: colours.ink}, grid: {color: colours.line}, ticks: {color: colours.quiet}, ...more};
}

// Where `value` lies; what a logarithmic axis cannot show lies at its end.
function pixelOn(scale, value) {
  if (scale.type !== "logarithmic" || value > 0) return scale.getPixelForValue(value);
  return scale.axis === "x" ? scale.left : scale.bottom;
}

// Bars of a point's low..high in x and y.
const intervalBars = {
  id: "intervalBars",
  beforeDatasetsDraw(chart) {
    const {ctx, chartArea, scales: {x, y}} = chart;
    ctx.save();
    ctx.beginPath();
    ctx.rect(chartArea.left, chartArea.top, chartArea.width, chartArea.height);
    ctx.clip();
    chart.data.datasets.forEach(set => set.data.forEach(point => {
      if (!point?.bars) return;
      const [x0, x1, y0, y1] = [pixelOn(x, point.bars.x[0]), pixelOn(x, point.bars.x[1]),
                                pixelOn(y, point.bars.y[0]), pixelOn(y, point.bars.y[1])];
      const xm = pixelOn(x, point.x), ym = pixelOn(y, point.y);
      ctx.strokeStyle = set.borderColor;
      ctx.lineWidth = 1;
      ctx.beginPath();
      ctx.moveTo(x0, ym);
      ctx.lineTo(x1, ym);
      ctx.moveTo(xm, y0);
      ctx.lineTo(xm, y1);
      ctx.stroke();
    }));
    ctx.restore();
  },
};

// Names beside the points of sets with `hasNames`, as long as they do not cover each other.
const pointNames = {
  id: "pointNames",
  afterDatasetsDraw(chart) {
    const {ctx, chartArea, scales: {x, y}} = chart, kHeight_px = 12, kGap_px = 8, taken = [];
    ctx.font = "11px system-ui, sans-serif";
    ctx.fillStyle = themeColours().ink;
    for (const set of chart.data.datasets.filter(data => data.hasNames)) {
      for (const point of set.data) {
        const width = ctx.measureText(point.label).width, right = pixelOn(x, point.x) + kGap_px;
        const left = right + width > chartArea.right ? right - 2 * kGap_px - width : right, bottom = pixelOn(y, point.y) - 4;
        const covers = box => left < box.right && left + width > box.left && bottom - kHeight_px < box.bottom && bottom > box.bottom - kHeight_px;
        if (left < chartArea.left || taken.some(covers)) continue;
        taken.push({left, right: left + width, bottom});
        ctx.fillText(point.label, left, bottom);
      }
    }
  },
};

// The safe window of a bias sweep, shaded.
const safeWindow = {
  id: "safeWindow",
  beforeDatasetsDraw(chart) {
    const range = chart.options.safeRange;
    if (!range) return;
    const {ctx, chartArea, scales: {x}} = chart;
    const left = x.getPixelForValue(range[0]), right = x.getPixelForValue(range[1]);
    ctx.fillStyle = themeColours().band;
    ctx.fillRect(left, chartArea.top, Math.max(right - left, 2), chartArea.bottom - chartArea.top);
  },
};

function chartOptions(given) {
  const legend = {labels: {color: themeColours().ink, usePointStyle: true, boxWidth: 22, boxHeight: 7, filter: item => item.text !== ""}};
  return {animation: false, responsive: true, maintainAspectRatio: false, ...given,
          plugins: {legend, ...given.plugins, tooltip: {filter: item => !item.dataset.isQuiet, ...given.plugins?.tooltip}}};
}

// Makes `role`'s plot, or gives it new numbers. `owner` has root and charts.
function putChart(owner, role, config) {
  const old = owner.charts[role];
  if (old) {
    old.data = config.data;
    old.options = chartOptions(config.options);
    old.update("none");
    return;
  }
  const canvas = owner.root.querySelector(`canvas[data-role="${role}"]`);
  owner.charts[role] = new Chart(canvas, {...config, options: chartOptions(config.options), plugins: [intervalBars, safeWindow, pointNames]});
}

function timePoint(run, index) {
  const total = run.pass_times.at(-1), rmse = run.error?.rmse;
  if (!total || !rmse) return null;
  return {x: total.median_ms, y: rmse.value, label: run.label, run: index,
          bars: {x: [total.median_ms - total.mad_ms, total.median_ms + total.mad_ms], y: [rmse.low, rmse.high]}};
}

// Dominated: another's intervals of time and RMSE both lie below its own.
function isDominated(point, all) {
  return all.some(other => other.bars.x[1] < point.bars.x[0] && other.bars.y[1] < point.bars.y[0]);
}

// The axis of errors: logarithmic where all of them are positive.
function errorAxis(title, points) {
  if (points.every(point => point.y > 0)) return axis(title, {type: "logarithmic"});
  return axis(title, {min: Math.min(0, ...points.map(point => point.bars.y[0])), suggestedMax: Math.max(...points.map(point => point.bars.y[1]))});
}

// Of points sorted by time those that are closer to the truth than all before: the front's steps.
function stepsOf(sorted) {
  const steps = [];
  for (const {x, y} of sorted) if (steps.length === 0 || y < steps.at(-1).y) steps.push({x, y});
  return steps;
}

// Time against error: the front filled and its steps joined, the rest hollow, `marked` ones larger. `more`: further sets.
function timesConfig(points, isOnFront, isMarked, more, options) {
  const colours = themeColours();
  const front = points.filter(isOnFront).sort((a, b) => a.x - b.x), rest = points.filter(point => !isOnFront(point));
  const set = (label, data, style) => ({label, data, pointRadius: data.map(point => isMarked(point) ? 8 : 5), ...style});
  const sets = [
    set("front", front, {borderColor: colours.second, backgroundColor: colours.second, pointStyle: "circle", hasNames: true}),
    set("dominated", rest, {borderColor: colours.quiet, backgroundColor: "transparent", pointStyle: "rectRot"}),
    ...more,
    {label: "", data: stepsOf(front), type: "line", stepped: true, borderWidth: 1, pointRadius: 0, borderColor: colours.second, backgroundColor: "transparent", isQuiet: true},
  ];
  return {
    type: "scatter",
    data: {datasets: sets.filter(one => one.data.length > 0)},
    options: {
      scales: {x: axis("time of a frame, ms", {type: "logarithmic"}), y: errorAxis("RMSE of V", points)},
      plugins: {tooltip: {callbacks: {label: item => `${item.raw.label}: ${significantText(item.raw.x, 3)} ms, RMSE ${item.raw.y.toFixed(5)}`}}},
      ...options,
    },
  };
}

function drawTimes(viewer) {
  const points = viewer.scene.techniques.map(timePoint).filter(point => point);
  part(viewer, "times-box").hidden = points.length === 0;
  if (points.length === 0) return;
  const isOnFront = point => !isDominated(point, points);
  viewer.front = points.filter(isOnFront).map(point => point.label);
  putChart(viewer, "times", timesConfig(points, isOnFront, point => point.run === viewer.runIndex, [], {
    onClick: (event, hits, chart) => { if (hits[0]) show(viewer, chart.data.datasets[hits[0].datasetIndex].data[hits[0].index].run, viewer.otherIndex); },
  }));
}

function drawHardening(viewer) {
  const entry = viewer.entry.runs[viewer.runIndex], hardening = viewer.scene.techniques[viewer.runIndex].contact_hardening;
  const box = part(viewer, "hardening-box");
  box.hidden = entry.widths.length === 0;
  if (box.hidden) return;
  const colours = themeColours(), widths = entry.widths, low = widths[0][0], high = widths.at(-1)[0];
  const middle = Math.log2(widths[widths.length >> 1][0]);
  const fitted = x => 2 ** (middle + hardening.intercept_octaves + hardening.slope * (Math.log2(x) - middle));
  const line = (label, of, style) => ({type: "line", label, data: [low, high].map(x => ({x, y: of(x)})), pointRadius: 0, pointStyle: "line", backgroundColor: "transparent", ...style});
  const sets = [{label: `profiles (${widths.length} of ${entry.profiles})`, data: widths.map(([x, y]) => ({x, y})), borderColor: colours.second, backgroundColor: "transparent", pointRadius: 2},
                line("right", x => x, {borderColor: colours.ink, borderWidth: 1, borderDash: [4, 4]})];
  if (hardening.identifiable) sets.push(line(`slope ${hardening.slope.toFixed(2)}`, fitted, {borderColor: colours.third, borderWidth: 2}));
  putChart(viewer, "hardening", {type: "scatter", data: {datasets: sets}, options: {
    scales: {x: axis("true penumbra width, world units", {type: "logarithmic"}), y: axis("the technique's", {type: "logarithmic"})}}});
}

function binLabel(bins, k) {
  if (bins[k].from_px === null) return "no map";
  const to = bins[k + 1]?.from_px;
  return to === null || to === undefined ? `${bins[k].from_px} px and more` : `${bins[k].from_px} to ${to} px`;
}

function drawCauses(viewer) {
  const {faults, causes} = viewer.scene.techniques[viewer.runIndex];
  part(viewer, "causes-box").hidden = !faults;
  if (!faults) return;
  const classes = palette.faults.filter(fault => fault.name !== "unscored" && faults.classes[fault.name].mean_abs_error > 0);
  const bins = causes.by_footprint.map((bin, k) => ({label: "texel " + binLabel(causes.by_footprint, k), value: bin.mean_abs_error})).filter(bin => bin.value > 0);
  const colours = themeColours();
  const bars = [...classes.map(fault => ({label: fault.name.replaceAll("_", " "), value: faults.classes[fault.name].mean_abs_error, colour: `rgb(${fault.colour})`})),
                ...bins.map(bin => ({...bin, colour: colours.quiet}))];
  putChart(viewer, "causes", {
    type: "bar",
    data: {labels: bars.map(bar => bar.label), datasets: [{label: "", data: bars.map(bar => bar.value), backgroundColor: bars.map(bar => bar.colour), borderColor: colours.ink, borderWidth: 1}]},
    options: {indexAxis: "y", scales: {x: axis("part of mean |V - R|"), y: axis("", {ticks: {autoSkip: false, color: colours.quiet, font: {size: 10}}})}},
  });
}

function drawTemporal(viewer) {
  const runs = viewer.scene.techniques.filter(run => run.temporal);
  part(viewer, "temporal-box").hidden = runs.length === 0;
  if (runs.length === 0) return;
  const colours = themeColours();
  const set = (label, of, colour) => ({label, data: runs.map(of), backgroundColor: colour});
  putChart(viewer, "temporal", {
    type: "bar",
    data: {labels: runs.map(run => run.label), datasets: [
      set("flicker beyond the truth's, moving camera", run => run.temporal.camera.excess, colours.second),
      set("change of error, moving light", run => run.temporal.light.rms, colours.third),
      set("spread over seeds", run => run.temporal.seed_noise, colours.quiet)]},
    options: {scales: {x: axis(""), y: axis("visibility")}},
  });
}

function drawSceneCharts(viewer) {
  drawTimes(viewer);
  drawHardening(viewer);
  drawCauses(viewer);
  drawTemporal(viewer);
}
