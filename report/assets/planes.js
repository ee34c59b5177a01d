// SPDX-License-Identifier: Apache-2.0
"use strict";
// The page's numbers and pixels. Pixels stay packed (report/plane_code.h) until someone looks at them.

const page = JSON.parse(document.getElementById("report-data").textContent);
const results = page.results;

// Packed planes from a script file beside the page: their promises' resolvers by id.
const awaitedFiles = new Map();
window.take_planes = (id, planes) => {
  awaitedFiles.get(id)?.resolve(planes);
  awaitedFiles.delete(id);
};

// Pixels stand behind the scripts, so that numbers are seen before all of them are read.
const allRead = new Promise(done => {
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", done, {once: true});
  else done();
});

async function packedPlanes(id) {
  await allRead;
  const block = document.getElementById(id);
  if (block) return JSON.parse(block.textContent);
  return new Promise((resolve, reject) => {
    awaitedFiles.set(id, {resolve});
    const script = document.createElement("script");
    script.src = encodeURIComponent(page.data_folder) + "/" + id + ".js";
    script.onerror = () => reject(new Error(`${page.data_folder}/${id}.js is missing; keep that folder beside this page`));
    document.head.append(script);
  });
}

function bytesOf(base64) {
  const letters = atob(base64), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

// Without Blob and Response, which go through another process each time.
async function inflate(base64) {
  const {writable, readable} = new DecompressionStream("deflate"), writer = writable.getWriter(), reader = readable.getReader(), parts = [];
  const written = writer.write(bytesOf(base64)).then(() => writer.close());
  for (let part = await reader.read(); !part.done; part = await reader.read()) parts.push(part.value);
  await written;
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  parts.reduce((at, part) => { whole.set(part, at); return at + part.length; }, 0);
  return whole;
}

function halfToNumber(half) {
  const exponent = half >> 10, mantissa = half & 1023;
  if (exponent === 31) return Infinity;
  return exponent === 0 ? mantissa * 2 ** -24 : (1 + mantissa / 1024) * 2 ** (exponent - 15);
}

function decodeWords(bytes, code) {
  const values = new Float32Array(bytes.length / 2);
  let word = 0;
  for (let i = 0; i < values.length; ++i) {
    const stored = bytes[2 * i] | bytes[2 * i + 1] << 8;
    word = code.delta ? word + (stored >> 1 ^ -(stored & 1)) & 0xFFFF : stored;
    values[i] = code.step === 0 ? halfToNumber(word) : code.low + code.step * word;
  }
  return values;
}

async function unpack(codes, packed, names) {
  const planes = await Promise.all(names.map(async name => {
    const bytes = await inflate(packed[name]);
    return codes[name].bytes ? bytes : decodeWords(bytes, codes[name]);
  }));
  return Object.fromEntries(names.map((name, k) => [name, planes[k]]));
}

// {name: Float32Array, or Uint8Array of classes} of a scene or run of page.scenes: all planes, or those of `wanted` that it has.
async function decodePlanes(entry, wanted = Object.keys(entry.planes)) {
  return unpack(entry.planes, await packedPlanes(entry.id), wanted.filter(name => entry.planes[name]));
}

// Decoded planes of a scene, once for all who look at it.
const keptScenes = new Map();
function scenePlanes(sceneIndex) {
  if (!keptScenes.has(sceneIndex)) keptScenes.set(sceneIndex, decodePlanes(page.scenes[sceneIndex]));
  return keptScenes.get(sceneIndex);
}

// What a lit picture of the truth needs; all that a crop decodes.
function litPlanes(sceneIndex) {
  return keptScenes.get(sceneIndex) ?? decodePlanes(page.scenes[sceneIndex], ["visibility", "hit", "unshadowed"]);
}

// Decoded planes of the runs looked at last; a scene's own stay as long as its viewer.
const kKeptRuns = 6;
const keptRuns = new Map();
function runPlanes(entry) {
  const planes = keptRuns.get(entry.id) ?? decodePlanes(entry);
  keptRuns.delete(entry.id);
  keptRuns.set(entry.id, planes);
  if (keptRuns.size > kKeptRuns) keptRuns.delete(keptRuns.keys().next().value);
  return planes;
}
