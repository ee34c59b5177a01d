// SPDX-License-Identifier: Apache-2.0
// What a cell of the overview may show: every number that results.json has of a run, in the groups of docs/metrics.md.

function totalMs(run) {
  return run.pass_times.at(-1)?.median_ms ?? null;
}

function worstFault(run) {
  const name = run.faults?.worst;
  return name ? {name, part: run.faults.classes[name].mean_abs_error} : null;
}

const kFixed3 = value => value.toFixed(3);
const kShare = value => `${(100 * value).toFixed(1)} %`;

// `value`: null where it was not measured. `wrong`: how far that is from right, for the colour; left out where the number says it.
function overviewMetric(group, label, value, text = kFixed3, wrong = Math.abs) {
  return {group, label, value: run => value(run) ?? null, text, wrong};
}

const overviewMetrics = {
  rmse: overviewMetric("Error", "RMSE of V", run => run.error?.rmse?.value),
  lit_rmse: overviewMetric("Error", "RMSE of the lit picture", run => run.lit_rmse),
  penumbra: overviewMetric("Error", "RMSE in penumbrae", run => run.error?.penumbra?.rmse),
  lit: overviewMetric("Error", "RMSE where it is lit", run => run.error?.lit?.rmse),
  umbra: overviewMetric("Error", "RMSE in umbrae", run => run.error?.umbra?.rmse),
  bias: overviewMetric("Error", "|mean error|", run => run.error && Math.abs(run.error.bias)),
  over: overviewMetric("Error", "mean too dark", run => run.error?.over_shadowing),
  under: overviewMetric("Error", "mean too bright", run => run.error?.under_shadowing),
  largest: overviewMetric("Error", "largest |error|", run => run.error?.max_error),
  wrong_pixels: overviewMetric("Error", "wrong pixels", run => run.significance?.tested ? (run.significance.too_dark + run.significance.too_bright) / run.significance.tested : null, kShare),
  width: overviewMetric("Penumbrae", "width / true width", run => run.penumbra?.width_octaves && 2 ** run.penumbra.width_octaves.median, value => significantText(value, 2), value => Math.abs(Math.log2(value))),
  offset: overviewMetric("Penumbrae", "edge's shift, in true widths", run => run.penumbra?.offset_widths?.median, value => numberText(value, 2, true)),
  hardening: overviewMetric("Penumbrae", "contact hardening (1: right)", run => run.contact_hardening?.slope, value => value.toFixed(2), value => Math.abs(1 - value)),
  noise: overviewMetric("Penumbrae", "noise", run => run.causes?.noise),
  banding: overviewMetric("Penumbrae", "banding", run => run.causes?.banding),
  fault: overviewMetric("Faults", "worst fault's part of the mean |error|", run => run.faults && (worstFault(run)?.part ?? 0)),
  ...Object.fromEntries(page.palette.faults.slice(2).map(fault => [`fault_${fault.name}`,  // after: not scored, explained
    overviewMetric("Faults", fault.name.replaceAll("_", " "), run => run.faults?.classes[fault.name]?.mean_abs_error)])),
  flip: overviewMetric("Similarity", "FLIP", run => run.similarity?.flip_mean),
  hdr_flip: overviewMetric("Similarity", "HDR-FLIP", run => run.similarity?.hdr_flip_mean),
  ssim: overviewMetric("Similarity", "SSIM", run => run.similarity?.ssim, kFixed3, value => 1 - value),
  psnr: overviewMetric("Similarity", "PSNR, dB", run => run.similarity?.psnr_db, value => value.toFixed(1), value => 10 ** (-value / 20)),
  flicker: overviewMetric("Over time", "flicker beyond the truth's", run => run.temporal?.camera?.excess),
  popping: overviewMetric("Over time", "popping under a moving light", run => run.temporal?.light?.rms),
  time: overviewMetric("Cost", "time of a frame, ms", run => run.error && totalMs(run), value => significantText(value, 2)),
  memory: overviewMetric("Cost", "textures, MiB", run => run.error && run.memory_bytes / 1048576, value => significantText(value, 2)),
};

// A choice for each metric that any run has, in groups.
function fillMetricMenu(select) {
  const runs = results.scenes.flatMap(scene => scene.techniques), groups = new Map();
  for (const [name, metric] of Object.entries(overviewMetrics)) {
    if (!runs.some(run => metric.value(run) !== null)) continue;
    if (!groups.has(metric.group)) {
      groups.set(metric.group, element("optgroup", {label: metric.group}));
      select.append(groups.get(metric.group));
    }
    addOption(groups.get(metric.group), name, metric.label);
  }
}
