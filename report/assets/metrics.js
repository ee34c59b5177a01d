// SPDX-License-Identifier: Apache-2.0
// What a cell of the overview may show: the rows of the catalogue of metrics (results/catalogue.h), which stand in the page's data.

function totalMs(run) {
  return run.pass_times.at(-1)?.median_ms ?? null;
}

function rmseOf(run) {
  return run.measurements?.rmse ?? null;
}

function worstFault(run) {
  const name = run.faults?.worst;
  return name ? {name, part: run.faults.classes[name].mean_abs_error} : null;
}

const kMetricTexts = {
  error: value => value.toFixed(3),
  signed_error: value => numberText(value, 3, true),
  share: value => `${(100 * value).toFixed(1)} %`,
  number: value => numberText(value, 2, true),
  octaves: value => significantText(2 ** value, 2),
  decibels: value => value.toFixed(1),
  milliseconds: value => significantText(value, 2),
  bytes: value => significantText(value / 1048576, 2),
};

// How far a value is from right, for the colour; 0 is right.
const kWrong = {
  lower: Math.abs,
  nearest_zero: Math.abs,
  nearest_one: value => Math.abs(1 - value),
  higher: value => 10 ** (-value / 20),
};

const kMetricUnits = {milliseconds: ", ms", bytes: ", MiB", decibels: ", dB"};

// `value`: null where it was not measured.
function overviewMetric({key, label, group, better, form}) {
  return {group: group[0].toUpperCase() + group.slice(1), label: label + (kMetricUnits[form] ?? ""),
          value: run => run.measurements?.[key] ?? null, text: kMetricTexts[form], wrong: kWrong[better]};
}

const overviewMetrics = Object.fromEntries(page.metrics.map(row => [row.key, overviewMetric(row)]));

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
