// SPDX-License-Identifier: Apache-2.0
// The scene three times, each with a ready material of the engine's glTF loader: white and lit, and unlit with positions and
// geometric normals as colours of its vertices.
import {glbOf} from "./gltf.mjs";

const UNLIT = {extensions: {KHR_materials_unlit: {}}};
const WHITE = {pbrMetallicRoughness: {metallicFactor: 0, roughnessFactor: 1}};

// Colours in [0, 1] of values in [low, low + size].
function coloursOf(values, low, size) {
  const colours = new Float32Array(values.length / 3 * 4).fill(1);
  for (let i = 0; i < values.length; ++i) colours[4 * Math.floor(i / 3) + i % 3] = (values[i] - low[i % 3]) / size;
  return colours;
}

// The same backwards, in place, of a picture.
export function fromColours(picture, {low, size}) {
  for (let i = 0; i < picture.length; ++i) if (i % 4 !== 3) picture[i] = low[i % 4] + size * picture[i];
  return picture;
}

// Normals of a picture towards the camera.
export function towards(normal, position, eye) {
  for (let i = 0; i < normal.length; i += 4) {
    let cosine = 0;
    for (let k = 0; k < 3; ++k) cosine += normal[i + k] * (eye[k] - position[i + k]);
    if (cosine < 0) for (let k = 0; k < 3; ++k) normal[i + k] *= -1;
  }
  return normal;
}

async function bodyOf(engine, loader, attributes, material) {
  const asset = loader.createAsset(glbOf(attributes, material));
  await new Promise(resolve => asset.loadResources(resolve, null, "", 1));
  const scene = engine.createScene();
  scene.addEntities(asset.getRenderableEntities());
  return {asset, scene};
}

export async function bodiesOf(engine, loader, mesh) {
  const {position: POSITION, normal: NORMAL} = mesh;
  const low = [0, 1, 2].map(k => mesh.points.reduce((least, point) => Math.min(least, point[k]), Infinity));
  const high = [0, 1, 2].map(k => mesh.points.reduce((most, point) => Math.max(most, point[k]), -Infinity));
  const place = {low, size: Math.max(...high.map((value, k) => value - low[k])) || 1}, facing = {low: [-1, -1, -1], size: 2};
  const coloured = async (values, range) =>
    ({...await bodyOf(engine, loader, {POSITION, NORMAL, COLOR_0: coloursOf(values, range.low, range.size)}, UNLIT), range});
  return {
    hash: mesh.hash, white: await bodyOf(engine, loader, {POSITION, NORMAL}, WHITE),
    positions: await coloured(POSITION, place), normals: await coloured(mesh.faceNormal, facing),
  };
}

export function destroyBodies(engine, loader, bodies) {
  for (const {asset, scene} of [bodies.white, bodies.positions, bodies.normals]) {
    engine.destroyScene(scene);
    loader.destroyAsset(asset);
  }
}
