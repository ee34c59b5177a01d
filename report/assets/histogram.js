// SPDX-License-Identifier: Apache-2.0
// How many of the pixels in sight have which error, counted on a logarithmic axis.

const kHistogramBins = 41;      // odd, so that one is about 0
const kHistogramWait_ms = 120;  // while the view moves

// Scored pixels in the rectangle by their error over `scale`; what lies beyond the ends is in the outermost bins.
function countErrors(shown, width, sight, scale) {
  const counts = new Array(kHistogramBins).fill(0), half = kHistogramBins / 2;
  let scored = 0, beyond = 0, sum = 0;
  for (let y = sight.top; y < sight.bottom; ++y) {
    for (let x = sight.left; x < sight.right; ++x) {
      const i = y * width + x;
      if (shown.run.scored?.[i] !== 1) continue;
      const error = shown.run.visibility[i] - shown.other.visibility[i];
      ++scored;
      sum += error;
      if (Math.abs(error) > scale) ++beyond;
      ++counts[Math.min(Math.max(Math.floor(half + half * error / scale), 0), kHistogramBins - 1)];
    }
  }
  return {counts, scored, beyond, mean: scored > 0 ? sum / scored : 0};
}

// The image's pixels that the panes show.
function pixelsInSight(viewer) {
  const {view, entry} = viewer, halfWidth = entry.width / 2 / view.zoom, halfHeight = entry.height / 2 / view.zoom;
  return {left: Math.max(Math.floor(view.x - halfWidth), 0), right: Math.min(Math.ceil(view.x + halfWidth), entry.width),
          top: Math.max(Math.floor(view.y - halfHeight), 0), bottom: Math.min(Math.ceil(view.y + halfHeight), entry.height)};
}

function histogramText(histogram, scale, isWhole) {
  const {scored, beyond, mean} = histogram;
  if (scored === 0) return "No scored pixel is in sight.";
  const middle = histogram.counts[kHistogramBins >> 1], width = scale / kHistogramBins;
  return `${scored} scored pixels ${isWhole ? "of the picture" : "in sight"}: mean ${numberText(mean, 4, true)}, ` +
      `${(100 * middle / scored).toFixed(1)} % within ±${width.toPrecision(2)}, ${(100 * beyond / scored).toFixed(1)} % beyond ±${scale}.`;
}

function drawHistogram(viewer) {
  const {shown, entry} = viewer;
  const box = part(viewer, "histogram-box");
  box.hidden = !shown?.run.scored;
  if (box.hidden) return;
  const scale = errorScale(shown), colours = themeColours();
  viewer.histogram = countErrors(shown, entry.width, pixelsInSight(viewer), scale);
  part(viewer, "histogram-text").textContent = histogramText(viewer.histogram, scale, viewer.view.zoom === 1);
  const share = k => (k + 0.5) / kHistogramBins * 2 - 1;
  const {counts} = viewer.histogram;
  putChart(viewer, "histogram", {
    type: "bar",
    data: {labels: counts.map((count, k) => (scale * share(k)).toFixed(3)),
           datasets: [{label: "", data: counts.map(count => count || null), backgroundColor: counts.map((count, k) => `rgb(${signedColour(share(k))})`),
                       borderColor: colours.quiet, borderWidth: 1, barPercentage: 1, categoryPercentage: 1}]},
    options: {scales: {x: axis(shown.isReference ? "V - R" : "V - other", {grid: {display: false}, ticks: {color: colours.quiet, autoSkip: false, maxRotation: 0, callback: (value, k) => k % 10 === 0 ? String(scale * (k - 20) / 20) : ""}}),
                       y: axis("pixels", {type: "logarithmic", min: 0.5, ticks: {color: colours.quiet, callback: value => Number.isInteger(Math.log10(value)) ? value : ""}})}},
  });
}

// After the view has come to rest; at once when other pictures are shown.
function scheduleHistogram(viewer) {
  const {view} = viewer, key = [viewer.runIndex, viewer.otherIndex, errorScale(viewer.shown), view.x, view.y, view.zoom, isDark].join();
  if (viewer.histogramKey === key) return;
  viewer.histogramKey = key;
  clearTimeout(viewer.histogramTimer);
  viewer.histogramTimer = setTimeout(() => drawHistogram(viewer), viewer.histogram ? kHistogramWait_ms : 0);
}
