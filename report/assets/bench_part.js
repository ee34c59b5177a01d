// SPDX-License-Identifier: Apache-2.0
// What `bench` measured, in words and tables; its plots are bench.js.

function benchPlace(run, isRecommended) {
  if (run.failure) return textCell(run.failure.message, "problem");
  if (run.is_on_front === null) return textCell("n/a");
  return textCell((run.is_on_front ? "on the front" : `behind ${run.dominated_by}`) + (isRecommended ? ", recommended" : ""));
}

function benchTimeText(run) {
  const time = benchTime(run);
  if (!time || run.time_ms) return significantInterval(time, 4, " ms");
  return `${significantText(time.value, 3)} ms (${time.frames} frame${time.frames === 1 ? "" : "s"}: no interval)`;
}

function benchRunsTable(scene) {
  return makeTable("Time and error of every run", ["Run", "#Time of a frame [95 %]", "#RMSE [95 %]", "#Memory", "Front", "Seed", "Parameters"], scene.runs.map(run => [
    nameCell(run.label),
    numberCell("time_ms", benchTime(run)?.value, benchTimeText(run)),
    numberCell("rmse", run.rmse?.value, intervalText(run.rmse)),
    numberCell("memory_bytes", run.memory_bytes, bytesText(run.memory_bytes)),
    benchPlace(run, run.label === scene.recommended), textCell(String(run.seed)), textCell(foldedText(parametersText(run.parameters)), "context")]));
}

function paperText({low, high}) {
  if (high === null) return `at least ${significantText(low, 3)}`;
  return low === high ? significantText(low, 3) : `${significantText(low, 3)} to ${significantText(high, 3)}`;
}

// Of both sides; "?" where a technique does not say it.
function comparesText(counts) {
  return (counts ?? [null, null]).map(count => count === null ? "?" : significantText(count, 4)).join(" : ");
}

function benchClaims(scene) {
  if (scene.claims.length === 0) return [];
  const rows = scene.claims.map(claim => [
    nameCell(claim.text), textCell(claim.source), textCell(`${claim.quantity} of ${claim.numerator} / ${claim.denominator}`),
    textCell(comparesText(claim.compares_per_pixel)),
    numberCell("paper", claim.paper.low, paperText(claim.paper)), numberCell("ours", claim.ours?.value, significantInterval(claim.ours, 3, "")),
    textCell(claim.verdict + (claim.reason ? `: ${claim.reason}` : ""))]);
  return [element("h4", {}, "What papers claim"),
          makeTable("What papers claim, and what was measured", ["Claim", "Source", "Ratio", "Compares per pixel", "#Paper", "#Ours [95 %]", "Verdict"], rows)];
}

function benchTruth(scene) {
  if (!scene.truth) return [];
  const rows = scene.truth.points.map(point => [
    nameCell(`${point.kind} ${point.setting}`),
    numberCell("cpu_s", point.cpu_s, `${significantText(point.cpu_s)} ± ${significantText(point.cpu_mad_s, 2)} s`),
    numberCell("rmse", point.rmse, intervalText({value: point.rmse, low: point.rmse_low, high: point.rmse_high})),
    numberCell("rays_per_pixel", point.rays_per_pixel, significantText(point.rays_per_pixel))]);
  return [element("h4", {}, "The truth's own time against error"),
          makeTable("The truth's time against error", ["Setting", "#Processor time", "#RMSE [95 %]", "#Rays per pixel"], rows)];
}

// What was asked and what came of it, of a scene.
function benchAnswers(scene, study) {
  const names = labels => labels.length ? labels.join(", ") : "none";
  const answers = [scene.recommended ? `Recommended, by the least product of time and RMSE: ${scene.recommended}.` : "",
                   scene.best_under ? `Best under ${study.best_under_ms} ms: ${names(scene.best_under)}.` : "",
                   scene.cheapest_below_rmse ? `Cheapest below RMSE ${study.rmse_limit}: ${names(scene.cheapest_below_rmse)}.` : ""];
  return answers.some(text => text) ? element("p", {}, answers.filter(text => text).join(" ")) : null;
}

function benchFigure(scene, study, number) {
  return element("figure", {class: "bench", id: `bench-${number}`}, element("figcaption", {}, `${scene.name}: ${scene.title}`),
                 element("p", {class: "context"}, `${scene.triangles} triangles; ${scene.light} light; scene hash ${scene.hash}; truth by ${scene.reference_device}`),
                 scene.failure ? element("p", {class: "problem"}, scene.failure.message) : null, warningList(scene.warnings), benchAnswers(scene, study),
                 element("div", {class: "plots"}, scene.runs.some(run => benchTime(run) && run.rmse) ? plotBox("bench", "Time against error", study.note) : null, scene.truth ? plotBox("truth", "The truth's own time against error") : null),
                 benchRunsTable(scene), ...benchTruth(scene), ...benchClaims(scene));
}

function benchHeading(study) {
  const best = study.recommended;
  return [pageTitle() === study.title ? null : element("h3", {}, study.title || study.file), study.doc ? element("p", {}, study.doc) : null,
          element("p", {class: "context"}, `${study.file}: study ${study.study}; umbrameter ${study.version} (${study.commit}); ${study.width_px} x ${study.height_px} px, ` +
                  `${study.samples_per_pixel} samples per pixel; up to ${study.wanted_frames} frames per run`),
          best && best.scenes > 1 ? element("p", {}, `Recommended over ${best.scenes} scenes: ${best.label} (time x RMSE is ${significantText(best.cost, 3)} times each scene's least).`) : null]
      .filter(one => one);
}

function makeBenches() {
  const section = document.getElementById("bench");
  section.hidden = page.benches.length === 0;
  for (const study of page.benches) {
    section.append(...benchHeading(study));
    for (const scene of study.scenes) {
      const figure = benchFigure(scene, study, benchCharts.length + 1);
      section.append(figure);
      benchCharts.push({root: figure, charts: {}, bench: scene});
    }
  }
}
