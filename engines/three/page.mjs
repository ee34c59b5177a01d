// SPDX-License-Identifier: Apache-2.0
// three.js, WebGLRenderer: one white MeshLambertMaterial, one light, drawn with and without its shadow.
import * as THREE from "../modules/three/build/three.module.js";
import {farPlane, nearPlane} from "../web/camera.mjs";
import {nearestLight} from "../web/light.mjs";
import {timeFrames} from "../web/timer.mjs";

const TYPES = {basic: THREE.BasicShadowMap, pcf: THREE.PCFShadowMap, pcfsoft: THREE.PCFSoftShadowMap, vsm: THREE.VSMShadowMap};
const SIDES = {front: THREE.FrontSide, back: THREE.BackSide, double: THREE.DoubleSide};

let renderer, geometry, geometryHash;

// World position, and the geometric normal towards the camera.
const surfaces = what => new THREE.ShaderMaterial({
  side: THREE.DoubleSide,
  vertexShader: `
    attribute vec3 faceNormal;
    varying vec3 at;
    flat varying vec3 face;
    void main() {
      at = position;
      face = faceNormal;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`,
  fragmentShader: `
    varying vec3 at;
    flat varying vec3 face;
    void main() { gl_FragColor = vec4(${what}, 1.0); }`,
});
const positionMaterial = surfaces("at");
const normalMaterial = surfaces("dot(face, cameraPosition - at) < 0.0 ? -face : face");

export async function open(canvas) {
  renderer = new THREE.WebGLRenderer({canvas, antialias: false});
  renderer.toneMapping = THREE.NoToneMapping;
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.setClearColor(0x000000, 0);
  const gl = renderer.getContext();
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  if (!renderer.extensions.has("EXT_color_buffer_float")) throw new Error("WebGL2 cannot draw floats here");
  return {version: `three.js r${THREE.REVISION}`, device: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)};
}

function geometryOf(mesh) {
  if (geometryHash === mesh.hash) return geometry;
  geometry?.dispose();
  geometry = new THREE.BufferGeometry();
  for (const name of ["position", "normal", "faceNormal"])
    geometry.setAttribute(name, new THREE.BufferAttribute(mesh[name], 3));
  geometryHash = mesh.hash;
  return geometry;
}

function cameraOf(description, aspect, points) {
  const {eye_world, at_world, up_world, vertical_fov_deg, near_world} = description;
  const camera = new THREE.PerspectiveCamera(vertical_fov_deg, aspect, near_world, farPlane(description, points));
  camera.position.set(...eye_world);
  camera.up.set(...up_world);
  camera.lookAt(...at_world);
  return camera;
}

function lightOf(fit, values) {
  let light;
  if (fit.kind === "sun") {
    light = new THREE.DirectionalLight(0xffffff, Math.PI);
    light.position.set(...fit.center);
    Object.assign(light.shadow.camera, {left: -fit.half[0], right: fit.half[0], bottom: -fit.half[1], top: fit.half[1]});
    light.target.position.set(...fit.center.map((v, i) => v + fit.direction[i]));
  } else if (fit.kind === "spot") {
    light = new THREE.SpotLight(0xffffff, Math.PI, 0, fit.angle_rad, 0, 0);
    light.position.set(...fit.position);
    light.target.position.set(...fit.position.map((v, i) => v + fit.direction[i]));
  } else {
    light = new THREE.PointLight(0xffffff, Math.PI, 0, 0);
    light.position.set(...fit.position);
  }
  const shadow = light.shadow;
  if (fit.up) shadow.camera.up.set(...fit.up);
  Object.assign(shadow.camera, {near: fit.near, far: fit.far});
  shadow.camera.updateProjectionMatrix();
  shadow.mapSize.set(values["shadow.mapSize"], values["shadow.mapSize"]);
  for (const name of ["bias", "normalBias", "radius", "blurSamples"]) shadow[name] = values[`shadow.${name}`];
  return light;
}

function targetOf(width, height) {
  return new THREE.WebGLRenderTarget(width, height, {
    type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
    depthTexture: new THREE.DepthTexture(width, height, THREE.FloatType),
  });
}

function submit(target, scene, camera, material) {
  scene.overrideMaterial = material;
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(scene, camera);
  scene.overrideMaterial = null;
}

function draw(target, scene, camera, material) {
  submit(target, scene, camera, material);
  const pixels = new Float32Array(4 * target.width * target.height);
  renderer.readRenderTargetPixels(target, 0, 0, target.width, target.height, pixels);
  return pixels;
}

export async function render(request) {
  const {width_px: width, height_px: height, parameters: values, scene: description, mesh, known} = request;
  const target = targetOf(width, height);
  const camera = cameraOf(description.camera, width / height, mesh.points);
  const scene = new THREE.Scene();
  const material = new THREE.MeshLambertMaterial({color: 0xffffff, side: THREE.DoubleSide, shadowSide: SIDES[values.shadowSide]});
  const body = new THREE.Mesh(geometryOf(mesh), material);
  body.frustumCulled = false;
  body.castShadow = body.receiveShadow = true;
  scene.add(body);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = TYPES[values.type];

  camera.near = known?.near ?? nearPlane(description.camera, draw(target, scene, camera, positionMaterial));
  camera.updateProjectionMatrix();
  const position = known?.position ?? draw(target, scene, camera, positionMaterial);
  const normal = known?.normal ?? draw(target, scene, camera, normalMaterial);
  const light = lightOf(nearestLight(description.light, mesh, position), values);
  scene.add(light, light.target ?? new THREE.Object3D());
  light.castShadow = true;
  const lit = draw(target, scene, camera, null);
  const times = await timeFrames(renderer.getContext(), request, () => submit(target, scene, camera, null));
  light.castShadow = false;
  const unlit = known?.unlit ?? draw(target, scene, camera, null);
  renderer.setRenderTarget(null);
  for (const used of [material, light, target.depthTexture, target]) used.dispose();
  return {lit, unlit, position, normal, near: camera.near, ...times};
}
