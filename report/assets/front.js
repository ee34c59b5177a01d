// SPDX-License-Identifier: Apache-2.0
// Over all scenes: which techniques are worth their time, and who is best for it in each scene.

const frontOwner = {root: document.getElementById("front"), charts: {}, isWanted: false};  // below the first screen: drawn last

function quartiles(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return [0.25, 0.5, 0.75].map(share => percentile(sorted, share));
}

// A point for every label that was scored and timed in as many scenes as any: medians with their quartiles.
function frontPoints(rows) {
  const measured = rows.map(row => ({label: row.label, runs: row.places.flatMap((run, scene) => {
    const one = results.scenes[scene].techniques[run];
    return one && rmseOf(one) !== null && totalMs(one) !== null ? [one] : [];
  })}));
  const most = Math.max(0, ...measured.map(row => row.runs.length));
  const complete = measured.filter(row => most > 0 && row.runs.length === most);
  const points = complete.map(({label, runs}) => {
    const time = quartiles(runs.map(totalMs)), rmse = quartiles(runs.map(rmseOf));
    return {label, x: time[1], y: rmse[1], bars: {x: [time[0], time[2]], y: [rmse[0], rmse[2]]}};
  });
  return {points, scenes: most, leftOut: measured.length - complete.length};
}

function isBehind(point, points) {
  return points.some(other => other.x <= point.x && other.y <= point.y && (other.x < point.x || other.y < point.y));
}

function drawFront() {
  if (!frontOwner.isWanted) return;
  const {points, scenes, leftOut} = frontPoints(overviewRows());
  frontOwner.root.hidden = points.length < 2;
  if (frontOwner.root.hidden) return;
  putChart(frontOwner, "front", timesConfig(points, point => !isBehind(point, points), () => false, [], {}));
  document.getElementById("front-note").textContent =
      `Medians over ${scenes} scene${scenes === 1 ? "" : "s"}; bars from the lower to the upper quartile.` +
      (leftOut > 0 ? ` ${leftOut} that were not measured in all of them are left out.` : "");
}

function bestText(scene, index) {
  if (index < 0) return "n/a";
  const run = scene.techniques[index], time = totalMs(run);
  return `${run.label}: ${rmseOf(run).toFixed(3)}${time === null ? "" : `, ${significantText(time, 3)} ms`}`;
}

function fillBestTable(factor) {
  document.getElementById("best-table").tBodies[0].replaceChildren(...results.scenes.map((scene, index) => {
    return element("tr", {}, nameCell(element("a", {href: `#scene-${index + 1}`}, scene.name)), ...[factor, Infinity].map(most => textCell(bestText(scene, bestAffordable(scene, most)))));
  }));
}
