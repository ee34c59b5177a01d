// SPDX-License-Identifier: Apache-2.0
// The penumbra under the cursor: V and R along R's steepest ascent on the receiver, with R's error band.

const kMaxWalk = 512;      // px to either side
const kPlateau = 0.01;     // this near to 0 or 1 the walk is out of the penumbra
const kMargin = 6;         // px walked beyond it
const kFarApart = 6;       // a pixel's step many times the first one's: another surface

function positionAt(scene, i) {
  return ["position.x", "position.y", "position.z"].map(name => scene[name][i]);
}

function minus(a, b) {
  return a.map((value, k) => value - b[k]);
}

function dot(a, b) {
  return a.reduce((sum, value, k) => sum + value * b[k], 0);
}

// R's slope per px in a window of `radius`, by central moments over scored pixels.
function slopeOf(values, usable, width, height, x, y, radius) {
  let gx = 0, gy = 0, count = 0;
  for (let dy = -radius; dy <= radius; ++dy) {
    for (let dx = -radius; dx <= radius; ++dx) {
      const px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px >= width || py >= height || !usable(py * width + px)) continue;
      gx += dx * values[py * width + px];
      gy += dy * values[py * width + px];
      count += dx * dx;
    }
  }
  return count === 0 ? [0, 0] : [gx / count, gy / count];
}

// World steps of one pixel to the right and one down; null where positions are not known.
function pixelSteps(viewer, x, y) {
  const {shown: {scene}, entry: {width, height}} = viewer;
  if (!scene["position.x"] || x < 1 || y < 1 || x + 1 >= width || y + 1 >= height) return null;
  const i = y * width + x;
  const right = minus(positionAt(scene, i + 1), positionAt(scene, i - 1)).map(value => value / 2);
  const down = minus(positionAt(scene, i + width), positionAt(scene, i - width)).map(value => value / 2);
  return {right, down};
}

// Steepest ascent on the receiver, as an image direction: the metric's inverse times the slope in px.
function ascentDirection(slope, steps) {
  if (!steps) return slope;
  const a = dot(steps.right, steps.right), b = dot(steps.right, steps.down), d = dot(steps.down, steps.down);
  const determinant = a * d - b * b;
  if (!(determinant > 1e-12 * a * d)) return slope;
  return [(d * slope[0] - b * slope[1]) / determinant, (a * slope[1] - b * slope[0]) / determinant];
}

function walk(viewer, usable, direction, side, stepLength) {
  const {shown: {scene, run}, cursor, entry: {width, height}} = viewer;
  const pixels = [];
  let before = cursor.y * width + cursor.x, beyond = 0;
  for (let k = 1; k <= kMaxWalk && beyond < kMargin; ++k) {
    const x = Math.round(cursor.x + side * k * direction[0]), y = Math.round(cursor.y + side * k * direction[1]);
    if (x < 0 || y < 0 || x >= width || y >= height) break;
    const i = y * width + x;
    if (!usable(i)) break;
    if (stepLength > 0) {
      const jump = minus(positionAt(scene, i), positionAt(scene, before));
      if (Math.sqrt(dot(jump, jump)) > kFarApart * stepLength) break;
    }
    pixels.push(i);
    before = i;
    const isOut = planes => planes.visibility[i] > 1 - kPlateau || planes.visibility[i] < kPlateau;
    beyond = isOut(scene) && isOut(run) ? beyond + 1 : 0;
  }
  return pixels;
}

// {unit, points: [{i, s, r, se, v, other}], line (first and last pixel), widths} along the profile; null where R is flat.
function measureProfile(viewer) {
  const {shown, cursor, entry: {width, height}} = viewer, {scene, run} = shown;
  const usable = i => scene.hit[i] === 1 && (!run.scored || run.scored[i] === 1);
  const at = cursor.y * width + cursor.x;
  if (!usable(at)) return null;
  let slope = [0, 0];
  for (const radius of [1, 2, 4, 8]) {  // grown to a quarter of the ramp, so that noise averages out
    slope = slopeOf(scene.visibility, usable, width, height, cursor.x, cursor.y, radius);
    if (Math.hypot(...slope) * 4 * radius > 1) break;
  }
  if (Math.hypot(...slope) < 1e-3) return null;
  const steps = pixelSteps(viewer, cursor.x, cursor.y);
  const ascent = ascentDirection(slope, steps), longest = Math.max(...ascent.map(Math.abs));
  const direction = ascent.map(value => value / longest);
  const world = steps && steps.right.map((value, k) => direction[0] * value + direction[1] * steps.down[k]);
  const stepLength = world ? Math.sqrt(dot(world, world)) : 0;
  const pixels = [...walk(viewer, usable, direction, -1, stepLength).reverse(), at, ...walk(viewer, usable, direction, 1, stepLength)];
  const origin = world && positionAt(scene, at);
  const place = i => world ? dot(minus(positionAt(scene, i), origin), world) / stepLength
      : (i % width - cursor.x) * direction[0] + (Math.floor(i / width) - cursor.y) * direction[1];
  const points = pixels.map(i => ({i, s: place(i), r: scene.visibility[i], se: scene.visibility_se?.[i] ?? 0, v: run.visibility[i],
                                   other: shown.isReference ? null : shown.other.visibility[i]}));
  points.sort((a, b) => a.s - b.s);
  const places = points.map(point => point.s);
  return {unit: world ? "world units" : "px", points, line: [points[0].i, points.at(-1).i],
          width_r: width_10_90(places, points.map(point => point.r)), width_v: width_10_90(places, points.map(point => point.v))};
}

function profileText(viewer, profile) {
  const {cursor} = viewer;
  if (!profile) return `No penumbra profile at ${cursor.x}, ${cursor.y}: R is flat there, or the pixel is not scored.`;
  const length = width => width === null ? "not reached" : `${width.toPrecision(3)} ${profile.unit}`;
  const octaves = profile.width_r > 0 && profile.width_v > 0 ? `, ${numberText(Math.log2(profile.width_v / profile.width_r), 2, true)} octaves` : "";
  return `Penumbra through ${cursor.x}, ${cursor.y}, 10 % to 90 %: R ${length(profile.width_r)}, V ${length(profile.width_v)}${octaves}. Band: R's 95 % interval.`;
}

function drawProfile(viewer) {
  const profile = measureProfile(viewer);
  viewer.profile = profile;
  part(viewer, "profile-text").textContent = profileText(viewer, profile);
  const points = profile?.points ?? [], colours = themeColours();
  const line = (label, of, style) => ({label, data: points.map(point => ({x: point.s, y: of(point)})), pointRadius: 0, pointStyle: "line", borderWidth: 2, backgroundColor: "transparent", clip: 4, ...style});
  const band = side => line("", point => point.r + side * 1.96 * point.se, {borderWidth: 0, backgroundColor: colours.band, isQuiet: true});
  const sets = [
    line("R", point => point.r, {borderColor: colours.ink}),
    line("V", point => point.v, {borderColor: colours.second, borderDash: [6, 3]}),
    {...band(-1), fill: "+1"}, band(1),
  ];
  if (viewer.shown && !viewer.shown.isReference) sets.push(line(runLabel(viewer, viewer.otherIndex), point => point.other, {borderColor: colours.third, borderDash: [2, 2]}));
  putChart(viewer, "profile", {
    type: "line", data: {datasets: sets},
    options: {scales: {x: axis(`along the ascent, ${profile?.unit ?? "world units"}`, {type: "linear"}), y: axis("visibility", {min: 0, max: 1})}},
  });
}
