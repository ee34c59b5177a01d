// SPDX-License-Identifier: Apache-2.0
// Babylon.js: one white StandardMaterial, one light, drawn with and without its ShadowGenerator.
import {farPlane, nearPlane} from "../web/camera.mjs";
import {nearestLight} from "../web/light.mjs";
import {loadScript} from "../web/script.mjs";
import {timeFrames} from "../web/timer.mjs";

let BABYLON, engine;

const FILTERS = {none: "FILTER_NONE", poisson: "FILTER_POISSONSAMPLING", esm: "FILTER_EXPONENTIALSHADOWMAP",
                 blur_esm: "FILTER_BLUREXPONENTIALSHADOWMAP", close_esm: "FILTER_CLOSEEXPONENTIALSHADOWMAP",
                 blur_close_esm: "FILTER_BLURCLOSEEXPONENTIALSHADOWMAP", pcf: "FILTER_PCF", pcss: "FILTER_PCSS"};
const QUALITIES = {high: "QUALITY_HIGH", medium: "QUALITY_MEDIUM", low: "QUALITY_LOW"};

// World position, and the geometric normal towards the camera.
function addSurfaceShaders() {
  BABYLON.Effect.ShadersStore.surfacesVertexShader = `
    attribute vec3 position;
    attribute vec3 faceNormal;
    uniform mat4 viewProjection;
    varying vec3 at;
    varying vec3 face;
    void main() {
      at = position;
      face = faceNormal;
      gl_Position = viewProjection * vec4(position, 1.0);
    }`;
  for (const [name, what] of [["position", "at"], ["normal", "dot(face, eye - at) < 0.0 ? -face : face"]]) {
    BABYLON.Effect.ShadersStore[`${name}FragmentShader`] = `
      varying vec3 at;
      varying vec3 face;
      uniform vec3 eye;
      void main() { gl_FragColor = vec4(${what}, 1.0); }`;
  }
}

export async function open(canvas) {
  BABYLON = await loadScript("../modules/babylonjs/babylon.js", "BABYLON");
  engine = new BABYLON.Engine(canvas, false, {audioEngine: false}, false);
  if (!engine.getCaps().textureFloatRender) throw new Error("WebGL2 cannot draw floats here");
  addSurfaceShaders();
  return {version: `Babylon.js ${BABYLON.Engine.Version}`, device: engine.getGlInfo().renderer};
}

const vector = v => new BABYLON.Vector3(...v);

function meshOf(scene, mesh) {
  const body = new BABYLON.Mesh("scene", scene);
  const data = new BABYLON.VertexData();
  data.positions = mesh.position;
  data.normals = mesh.normal;
  // The engine's front faces are clockwise.
  data.indices = Uint32Array.from({length: mesh.position.length / 3}, (_, i) => i - i % 3 + [0, 2, 1][i % 3]);
  data.applyToMesh(body);
  body.setVerticesBuffer(new BABYLON.VertexBuffer(engine, mesh.faceNormal, "faceNormal", false, false, 3));
  body.alwaysSelectAsActiveMesh = true;
  body.receiveShadows = true;
  return body;
}

function cameraOf(scene, description, points) {
  const camera = new BABYLON.TargetCamera("camera", vector(description.eye_world), scene);
  camera.upVector = vector(description.up_world);
  camera.setTarget(vector(description.at_world));
  camera.fov = description.vertical_fov_deg * Math.PI / 180;
  camera.minZ = description.near_world;
  camera.maxZ = farPlane(description, points);
  return camera;
}

function lightOf(scene, fit) {
  let light;
  if (fit.kind === "sun") {
    light = new BABYLON.DirectionalLight("light", vector(fit.direction), scene);
    light.position = vector(fit.center);
    light.autoUpdateExtends = false;
    light.shadowOrthoScale = 0;
    const [x, y] = boxInItsOwnAxes(light, fit);
    Object.assign(light, {orthoLeft: x[0], orthoRight: x[1], orthoBottom: y[0], orthoTop: y[1]});
  } else if (fit.kind === "spot") {
    light = new BABYLON.SpotLight("light", vector(fit.position), vector(fit.direction), 2 * fit.angle_rad, 0, scene);
  } else {
    light = new BABYLON.PointLight("light", vector(fit.position), scene);
  }
  light.specular = BABYLON.Color3.Black();
  light.shadowMinZ = fit.near;
  light.shadowMaxZ = fit.far;
  return light;
}

// The engine turns the box as it likes: the extent of the scene's box along the light's view axes.
function boxInItsOwnAxes(light, fit) {
  const view = BABYLON.Matrix.LookAtRH(light.position, light.position.add(light.direction), BABYLON.Vector3.Up());
  const right = vector(fit.right), up = vector(fit.up);
  const x = [Infinity, -Infinity], y = [Infinity, -Infinity];
  for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
    const corner = light.position.add(right.scale(a * fit.half[0])).add(up.scale(b * fit.half[1]));
    const p = BABYLON.Vector3.TransformCoordinates(corner, view);
    x[0] = Math.min(x[0], p.x); x[1] = Math.max(x[1], p.x);
    y[0] = Math.min(y[0], p.y); y[1] = Math.max(y[1], p.y);
  }
  return [x, y];
}

function shadowOf(light, body, values) {
  const shadow = new BABYLON.ShadowGenerator(values.mapSize, light);
  shadow.filter = BABYLON.ShadowGenerator[FILTERS[values.type]];
  shadow.filteringQuality = BABYLON.ShadowGenerator[QUALITIES[values.filteringQuality]];
  for (const name of ["bias", "normalBias", "blurScale", "blurBoxOffset", "useKernelBlur", "contactHardeningLightSizeUVRatio", "forceBackFacesOnly"])
    shadow[name] = values[name];
  if (values.useKernelBlur) shadow.blurKernel = values.blurKernel;
  if (values.depthScale > 0) shadow.depthScale = values.depthScale;
  shadow.addShadowCaster(body);
  return shadow;
}

function surfaceMaterial(scene, name, eye) {
  const material = new BABYLON.ShaderMaterial(name, scene, {vertex: "surfaces", fragment: name},
    {attributes: ["position", "faceNormal"], uniforms: ["viewProjection", "eye"]});
  material.backFaceCulling = false;
  material.setVector3("eye", vector(eye));
  return material;
}

function whiteMaterial(scene) {
  const material = new BABYLON.StandardMaterial("white", scene);
  material.diffuseColor = BABYLON.Color3.White();
  material.specularColor = BABYLON.Color3.Black();
  material.backFaceCulling = false;
  material.twoSidedLighting = true;
  return material;
}

// As whenReadyAsync(), which asks again only after a tenth of a second: longer than a picture takes.
async function whenReady(scene) {
  let is_told = false;
  scene.executeWhenReady(() => { is_told = true; });
  while (!is_told && !scene.isReady()) await new Promise(resolve => setTimeout(resolve, 1));
}

async function draw(scene, target, body, material) {
  body.material = material;
  await whenReady(scene);
  scene.render();
  return target.readPixels();
}

export async function render(request) {
  const {width_px: width, height_px: height, parameters: values, scene: description, mesh, known} = request;
  const scene = new BABYLON.Scene(engine);
  try {
    scene.useRightHandedSystem = true;
    scene.clearColor = new BABYLON.Color4(0, 0, 0, 0);
    scene.imageProcessingConfiguration.isEnabled = false;
    const body = meshOf(scene, mesh);
    const camera = cameraOf(scene, description.camera, mesh.points);
    const target = new BABYLON.RenderTargetTexture("picture", {width, height}, scene,
      {type: BABYLON.Constants.TEXTURETYPE_FLOAT, samplingMode: BABYLON.Texture.NEAREST_SAMPLINGMODE, generateMipMaps: false});
    camera.outputRenderTarget = target;
    const places = surfaceMaterial(scene, "position", description.camera.eye_world);
    const near = known?.near ?? nearPlane(description.camera, await draw(scene, target, body, places));
    camera.minZ = near;
    const position = known?.position ?? await draw(scene, target, body, places);
    const normal = known?.normal ?? await draw(scene, target, body, surfaceMaterial(scene, "normal", description.camera.eye_world));
    const white = whiteMaterial(scene);
    const light = lightOf(scene, nearestLight(description.light, mesh, position));
    const unlit = known?.unlit ?? await draw(scene, target, body, white);
    shadowOf(light, body, values);
    const lit = await draw(scene, target, body, white);
    const times = await timeFrames(engine._gl, request, () => scene.render());
    return {lit, unlit, position, normal, near, ...times};
  } finally {
    scene.dispose();
  }
}
