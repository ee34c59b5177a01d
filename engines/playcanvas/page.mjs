// SPDX-License-Identifier: Apache-2.0
// PlayCanvas: one white StandardMaterial, one light component without clustering, drawn with and without its shadow.
import * as pc from "../modules/playcanvas/build/playcanvas.mjs";
import {farPlane, nearPlane} from "../web/camera.mjs";
import {nearestLight} from "../web/light.mjs";
import {timeFrames} from "../web/timer.mjs";

const TYPES = {pcf1: pc.SHADOW_PCF1_32F, pcf3: pc.SHADOW_PCF3_32F, pcf5: pc.SHADOW_PCF5_32F, pcss: pc.SHADOW_PCSS_32F,
               vsm16: pc.SHADOW_VSM_16F, vsm32: pc.SHADOW_VSM_32F};
const KINDS = {sun: "directional", spot: "spot", point: "omni"};
// Of a light's range: its falloff reaches 0 there.
const RANGE_SLACK = 1.2;

let app;

export async function open(canvas) {
  app = new pc.Application(canvas, {graphicsDeviceOptions: {antialias: false}});
  app.autoRender = false;
  app.start();
  app.scene.clusteredLightingEnabled = false;
  app.scene.ambientLight = new pc.Color(0, 0, 0);
  if (!app.graphicsDevice.textureFloatRenderable) throw new Error("WebGL2 cannot draw floats here");
  return {version: `PlayCanvas ${pc.version}`, device: app.graphicsDevice.unmaskedRenderer};
}

// World position, and the geometric normal towards the camera.
function surfaceMaterial(name, what, eye) {
  const material = new pc.ShaderMaterial({
    uniqueName: `surfaces-${name}`,
    attributes: {vertex_position: pc.SEMANTIC_POSITION, faceNormal: pc.SEMANTIC_TEXCOORD1},
    vertexGLSL: `
      attribute vec3 vertex_position;
      attribute vec3 faceNormal;
      uniform mat4 matrix_viewProjection;
      varying vec3 at;
      varying vec3 face;
      void main(void) {
        at = vertex_position;
        face = faceNormal;
        gl_Position = matrix_viewProjection * vec4(vertex_position, 1.0);
      }`,
    fragmentGLSL: `
      varying vec3 at;
      varying vec3 face;
      uniform vec3 eye;
      void main(void) { gl_FragColor = vec4(${what}, 1.0); }`,
  });
  material.cull = pc.CULLFACE_NONE;
  material.setParameter("eye", eye);
  material.update();
  return material;
}

function whiteMaterial() {
  const material = new pc.StandardMaterial();
  material.diffuse = new pc.Color(1, 1, 1);
  material.specular = new pc.Color(0, 0, 0);
  material.useMetalness = false;
  material.cull = pc.CULLFACE_NONE;
  material.shadowCatcher = false;
  material.twoSidedLighting = true;
  material.update();
  return material;
}

function bodyOf(mesh, material) {
  const drawn = new pc.Mesh(app.graphicsDevice);
  drawn.setPositions(mesh.position);
  drawn.setNormals(mesh.normal);
  drawn.setVertexStream(pc.SEMANTIC_TEXCOORD1, mesh.faceNormal, 3);
  drawn.setIndices(Uint32Array.from({length: mesh.position.length / 3}, (_, i) => i));
  drawn.update();
  const instance = new pc.MeshInstance(drawn, material);
  instance.cull = false;
  const entity = new pc.Entity("scene");
  entity.addComponent("render", {meshInstances: [instance], castShadows: true, receiveShadows: true});
  return {entity, instance};
}

function cameraOf(description, points, target) {
  const {eye_world, at_world, up_world, vertical_fov_deg, near_world} = description;
  const entity = new pc.Entity("camera");
  entity.addComponent("camera", {
    fov: vertical_fov_deg, nearClip: near_world, farClip: farPlane(description, points), clearColor: new pc.Color(0, 0, 0, 0),
    toneMapping: pc.TONEMAP_NONE, gammaCorrection: pc.GAMMA_NONE,
  });
  entity.camera.renderTarget = target;
  entity.setPosition(...eye_world);
  entity.lookAt(new pc.Vec3(...at_world), new pc.Vec3(...up_world));
  return entity;
}

function lightOf(fit, values, distance) {
  const entity = new pc.Entity("light");
  const range = RANGE_SLACK * (fit.reach ?? fit.far);
  entity.addComponent("light", {
    type: KINDS[fit.kind], intensity: 1, castShadows: false, shadowType: TYPES[values.type],
    ...(fit.kind === "sun" ? {shadowDistance: distance, numCascades: values.numCascades} : {range, falloffMode: pc.LIGHTFALLOFF_LINEAR}),
    ...(fit.kind === "spot" ? {innerConeAngle: fit.angle_rad * pc.math.RAD_TO_DEG, outerConeAngle: fit.angle_rad * pc.math.RAD_TO_DEG} : {}),
  });
  for (const name of ["shadowResolution", "shadowBias", "normalOffsetBias", "penumbraSize", "penumbraFalloff", "shadowSamples",
                      "shadowBlockerSamples", "vsmBlurSize", "vsmBias"]) entity.light[name] = values[name];
  entity.setPosition(...(fit.position ?? fit.center));
  if (fit.direction) {  // lights shine along their own -y
    const to = new pc.Vec3(...fit.direction);
    entity.setRotation(new pc.Quat().setFromDirections(new pc.Vec3(0, -1, 0), to));
  }
  return entity;
}

function submit() {
  app.update(0);
  app.render();
}

async function draw(target, body, material, width, height) {
  body.instance.material = material;
  submit();
  return target.colorBuffer.read(0, 0, width, height, {renderTarget: target, immediate: true});
}

export async function render(request) {
  const {width_px: width, height_px: height, parameters: values, scene: description, mesh, known} = request;
  const colorBuffer = new pc.Texture(app.graphicsDevice, {
    width, height, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false, minFilter: pc.FILTER_NEAREST, magFilter: pc.FILTER_NEAREST});
  const target = new pc.RenderTarget({colorBuffer, depth: true, samples: 1});
  const places = surfaceMaterial("position", "at", description.camera.eye_world);
  const facings = surfaceMaterial("normal", "dot(face, eye - at) < 0.0 ? -face : face", description.camera.eye_world);
  const white = whiteMaterial();
  const body = bodyOf(mesh, places);
  const camera = cameraOf(description.camera, mesh.points, target);
  app.root.addChild(body.entity);
  app.root.addChild(camera);
  let light;
  try {
    const near = known?.near ?? nearPlane(description.camera, await draw(target, body, places, width, height));
    camera.camera.nearClip = near;
    const position = known?.position ?? await draw(target, body, places, width, height);
    const normal = known?.normal ?? await draw(target, body, facings, width, height);
    light = lightOf(nearestLight(description.light, mesh, position), values, camera.camera.farClip);
    app.root.addChild(light);
    const unlit = known?.unlit ?? await draw(target, body, white, width, height);
    light.light.castShadows = true;
    const lit = await draw(target, body, white, width, height);
    const times = await timeFrames(app.graphicsDevice.gl, request, submit);
    return {lit, unlit, position, normal, near, ...times};
  } finally {
    for (const entity of [body.entity, camera, light]) entity?.destroy();
    target.destroyTextureBuffers();
    target.destroy();
  }
}
