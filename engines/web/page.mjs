// SPDX-License-Identifier: Apache-2.0
// What every web engine's page shares: the scene, pictures as PFM files, and the call of the engine's own module.
//
// ../engine/page.mjs exports
//   open(canvas)    -> {version, device}; async
//   render(request) -> {lit, unlit, position, normal, near}, and maybe warnings, frame_ms and timer (timer.mjs); async. `request` has
//                      width_px, height_px, seed, parameters, timed_frames and timed_seconds, which may be undefined, scene
//                      (scene.json), mesh (below) and known; each picture is a Float32Array of RGBA, row 0 at the bottom; position
//                      has alpha 0 where nothing is hit; near is the camera's near plane.
// `known` is what render answered for the same scene, camera and size with other parameters, or undefined: all but lit is the same.
import * as engine from "../engine/page.mjs";

const MOST_KNOWN = 16;  // pictures of a tuner's cameras

let mesh = {hash: null};
const known = new Map();  // by size and scene.json, the oldest first

// Triangles without indices: positions, shading normals (geometric ones where the scene has none) and geometric normals.
function readMesh(hash, text) {
  const points = [], normals = [], corners = [], cornerNormals = [];
  for (const line of text.split("\n")) {
    const [kind, ...rest] = line.split(" ");
    if (kind === "v") points.push(rest.map(Number));
    if (kind === "vn") normals.push(rest.map(Number));
    if (kind !== "f") continue;
    for (const corner of rest) {
      const [point, , normal] = corner.split("/");
      corners.push(Number(point) - 1);
      cornerNormals.push(normal === undefined ? -1 : Number(normal) - 1);
    }
  }
  const position = new Float32Array(corners.length * 3), faceNormal = new Float32Array(corners.length * 3);
  const normal = new Float32Array(corners.length * 3);
  for (let first = 0; first < corners.length; first += 3) {
    const [a, b, c] = [0, 1, 2].map(k => points[corners[first + k]]);
    const face = normalized(cross(minus(b, a), minus(c, a)));
    for (let k = 0; k < 3; ++k) {
      const at = 3 * (first + k);
      position.set(points[corners[first + k]], at);
      faceNormal.set(face, at);
      normal.set(cornerNormals[first + k] < 0 ? face : normals[cornerNormals[first + k]], at);
    }
  }
  return {hash, position, normal, faceNormal, points};
}

async function loadText(path) {
  const answer = await fetch(path, {cache: "no-store"});
  if (!answer.ok) throw new Error(`${path} is not there`);
  return answer.text();
}

// PFM: RGB floats, little-endian, bottom row first.
async function post(name, rgba, width, height) {
  const head = new TextEncoder().encode(`PF\n${width} ${height}\n-1.0\n`);
  const rgb = new Float32Array(width * height * 3);
  for (let i = 0; i < width * height; ++i) {
    for (let k = 0; k < 3; ++k) rgb[3 * i + k] = rgba[4 * i + k];
  }
  const answer = await fetch(`../out/${name}`, {method: "POST", body: new Blob([head, rgb])});
  if (!answer.ok) throw new Error(`${name} could not be written`);
}

export async function open() {
  return engine.open(document.getElementById("canvas"));
}

export async function render(request) {
  const text = await loadText("../scene/scene.json"), scene = JSON.parse(text);
  if (scene.mesh_hash !== mesh.hash) mesh = readMesh(scene.mesh_hash, await loadText("../scene/scene.obj"));
  const {width_px: width, height_px: height} = request;
  const key = `${width} ${height} ${text}`;
  const pictures = await engine.render({...request, scene, mesh, known: known.get(key)});
  const {unlit, position, normal, near} = pictures;
  known.set(key, {unlit, position, normal, near});
  if (known.size > MOST_KNOWN) known.delete(known.keys().next().value);
  const answer = {warnings: pictures.warnings ?? [], frame_ms: pictures.frame_ms, timer: pictures.timer};
  for (let i = 0; i < width * height; ++i) {
    if (pictures.position[4 * i + 3] === 0) pictures.position.fill(NaN, 4 * i, 4 * i + 3);
  }
  const names = ["lit", "unlit", "position", "normal"];
  for (const what of names) answer[what] = `${what}.pfm`;
  await Promise.all(names.map(what => post(answer[what], pictures[what], width, height)));
  return answer;
}

// Vectors as arrays of three.
export const minus = (a, b) => a.map((value, i) => value - b[i]);
export const plus = (a, b) => a.map((value, i) => value + b[i]);
export const times = (s, a) => a.map(value => s * value);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = a => Math.hypot(...a);
export const normalized = a => times(1 / (length(a) || 1), a);
