// SPDX-License-Identifier: Apache-2.0
// What `regress check` found: before and after of every case, with the gates' numbers.

function checkSummary(check) {
  return `${check.suite}: ${check.cases.length} cases, ${check.pass} pass, ${check.better} better, ${check.undecided} undecided, ${check.fail} fail; ` +
      `${check.width_px} x ${check.height_px} px, seed ${check.seed}`;
}

// The case's run in this page; and, where the page has pictures of before, the view that slides between both.
function caseAddress(one) {
  const scene = results.scenes.findIndex(found => found.name === one.scene);
  const run = results.scenes[scene]?.techniques.findIndex(found => found.label === one.label) ?? -1;
  if (run < 0) return null;
  const before = results.scenes[scene].techniques.findIndex(found => found.label === one.label + kBeforeMark);
  return `#scene-${scene + 1}-run-${run + 1}` + (before < 0 ? "" : `?mode=slider&other=${before}`);
}

const kBeforeMark = " (before)";  // at the end of a label: report/before.h

function caseRow(one) {
  const address = caseAddress(one), severities = one.gate.map(measure => measure.severity ?? 0);
  const worst = severities.length ? Math.max(...severities) : null;
  return [nameCell(one.scene), textCell(address ? element("a", {href: address}, one.label) : one.label),
          textCell(one.outcome + (one.kind ? `: ${one.kind.replaceAll("_", " ")}` : ""), `outcome ${one.outcome}`),
          numberCell("rmse_before", one.before?.rmse?.value, intervalText(one.before?.rmse)), numberCell("rmse_now", one.now?.rmse?.value, intervalText(one.now?.rmse)),
          numberCell("severity", worst, worst === null ? "n/a" : worst.toFixed(2)),
          textCell(foldedText([one.message, ...one.notes].filter(text => text).join("; ")), "remarks"),
          numberCell("samples", one.samples_per_pixel, one.added_samples_per_pixel > 0 ? `${one.samples_per_pixel} (${one.added_samples_per_pixel} added)` : String(one.samples_per_pixel)),
          numberCell("pictures", one.pictures, String(one.pictures))];
}

function gateDetails(one) {
  if (one.gate.length === 0) return null;
  const name = `${one.scene}, ${one.label}`;
  const rows = one.gate.map(measure => [nameCell(measure.class.replaceAll("_", " ")), ...["baseline", "value", "allowed", "severity"].map(
      key => numberCell(key, measure[key], significantText(measure[key])))]);
  return element("details", {class: "facts"}, element("summary", {}, `${name}: gate`), makeTable(`Gate of ${name}`, ["Class", "#Before", "#Now", "#Allowed", "#Used"], rows));
}

function makeRegress() {
  const section = document.getElementById("regress"), verdict = document.getElementById("regress-verdict");
  section.hidden = page.regressions.length === 0;
  for (const check of page.regressions) {
    const summary = checkSummary(check);
    verdict.append(element("p", {class: check.passes ? "passes" : "problem"}, `${check.passes ? "Passes" : "Fails"}: ${summary}.`));
    const order = ["fail", "undecided", "better", "pass"], cases = [...check.cases].sort((a, b) => order.indexOf(a.outcome) - order.indexOf(b.outcome));
    section.append(makeTable("Before and after", ["Scene", "Run", "Verdict", "#RMSE before [95 %]", "#RMSE now [95 %]", "#Allowance used", "Remarks", "#Samples per pixel", "#Pictures"], cases.map(caseRow)),
                   ...cases.map(gateDetails).filter(one => one));
  }
}
