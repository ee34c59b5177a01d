// SPDX-License-Identifier: Apache-2.0
// One binary glTF of triangles with one double-sided material: what the engine's own loader and its ready materials take.

const FLOAT = 5126;
const kinds = {POSITION: ["VEC3", 3], NORMAL: ["VEC3", 3], COLOR_0: ["VEC4", 4]};

function extent(values) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < values.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], values[i]);
    high[i % 3] = Math.max(high[i % 3], values[i]);
  }
  return {min: low, max: high};
}

// `attributes`: Float32Arrays by their glTF names; `material`: a glTF material.
export function glbOf(attributes, material) {
  const names = Object.keys(attributes);
  const views = [], accessors = [], parts = [];
  let size = 0;
  for (const name of names) {
    const values = attributes[name], [type, components] = kinds[name];
    views.push({buffer: 0, byteOffset: size, byteLength: values.byteLength, target: 34962});
    accessors.push({bufferView: views.length - 1, componentType: FLOAT, count: values.length / components, type,
                    ...(name === "POSITION" ? extent(values) : {})});
    parts.push(new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
    size += values.byteLength;
  }
  const json = {
    asset: {version: "2.0"}, scene: 0, scenes: [{nodes: [0]}], nodes: [{mesh: 0, name: "scene"}],
    meshes: [{primitives: [{attributes: Object.fromEntries(names.map((name, i) => [name, i])), material: 0}]}],
    materials: [{doubleSided: true, ...material}], accessors, bufferViews: views, buffers: [{byteLength: size}],
    extensionsUsed: Object.keys(material.extensions ?? {}),
  };
  if (json.extensionsUsed.length === 0) delete json.extensionsUsed;
  let text = JSON.stringify(json);
  text += " ".repeat((4 - text.length % 4) % 4);
  const head = new TextEncoder().encode(text);
  const glb = new Uint8Array(12 + 8 + head.length + 8 + size);
  const view = new DataView(glb.buffer);
  [0x46546c67, 2, glb.length, head.length, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true));
  glb.set(head, 20);
  view.setUint32(20 + head.length, size, true);
  view.setUint32(24 + head.length, 0x004e4942, true);
  let at = 28 + head.length;
  for (const part of parts) {
    glb.set(part, at);
    at += part.length;
  }
  return glb;
}
