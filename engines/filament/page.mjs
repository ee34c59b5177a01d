// SPDX-License-Identifier: Apache-2.0
// Filament: one white lit material of its glTF loader, one light, drawn with and without its shadow.
import {farPlane, nearPlane} from "../web/camera.mjs";
import {nearestLight} from "../web/light.mjs";
import {loadScript} from "../web/script.mjs";
import {timeFrames} from "../web/timer.mjs";
import {bodiesOf, destroyBodies, fromColours, towards} from "./bodies.mjs";
import {ShadowSettings, TYPES} from "./settings.mjs";

const FRAMES_TO_SETTLE = 2;  // the first may still lack a shader
const RANGE_SLACK = 1.2;     // of a light's range: its falloff reaches 0 there

let Filament, engine, gl, loader, renderer, swapChain, bodies;

async function versionOf(folder) {
  const answer = await fetch(`${folder}/package.json`);
  return (await answer.json()).version;
}

export async function open(canvas) {
  const folder = "../modules/filament";
  await loadScript(`${folder}/filament.js`, "Filament");
  await new Promise(resolve => window.Filament.init([], resolve));
  Filament = window.Filament;
  gl = canvas.getContext("webgl2", {antialias: false, alpha: false});
  if (!gl.getExtension("EXT_color_buffer_float")) throw new Error("WebGL2 cannot draw floats here");
  // Its shaders for the web are those for phones. Where a device has 16-bit floats for them, pictures would be rounded to these.
  const compile = gl.shaderSource;
  gl.shaderSource = (shader, text) => compile.call(gl, shader, text.replaceAll("mediump", "highp"));
  // A hint that costs nothing to leave out: here Chromium forgets all layers of a map when one is invalidated.
  gl.invalidateFramebuffer = () => {};
  engine = Filament.Engine.create(canvas);
  swapChain = engine.createSwapChain();
  renderer = engine.createRenderer();
  renderer.setClearOptions({clearColor: [0, 0, 0, 0], clear: true});
  loader = engine.createAssetLoader();
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  return {version: `Filament ${await versionOf(folder)}`, device: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)};
}

// A float target whose WebGL texture is known: the engine gives scripts no pixels.
function targetOf(width, height) {
  const {Texture, Texture$InternalFormat: Format, Texture$Usage: Usage, RenderTarget, RenderTarget$AttachmentPoint: Point} = Filament;
  let glTexture = null;
  const allocate = gl.texStorage2D;
  gl.texStorage2D = (target, levels, format, ...size) => {
    if (format === gl.RGBA32F) glTexture = gl.getParameter(gl.TEXTURE_BINDING_2D);
    return allocate.call(gl, target, levels, format, ...size);
  };
  const texture = (format, usage) => Texture.Builder().width(width).height(height).levels(1).format(format).usage(usage).build(engine);
  const color = texture(Format.RGBA32F, Usage.COLOR_ATTACHMENT.value | Usage.SAMPLEABLE.value);
  const depth = texture(Format.DEPTH32F, Usage.DEPTH_ATTACHMENT.value);
  const target = RenderTarget.Builder().texture(Point.COLOR, color).texture(Point.DEPTH, depth).build(engine);
  engine.execute();
  gl.texStorage2D = allocate;
  if (glTexture === null) throw new Error("the engine made no float texture");
  return {target, color, depth, glTexture};
}

function readPixels(texture, width, height) {
  const before = gl.getParameter(gl.FRAMEBUFFER_BINDING);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const pixels = new Float32Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
  gl.bindFramebuffer(gl.FRAMEBUFFER, before);
  gl.deleteFramebuffer(frame);
  return pixels;
}

function lightOf(fit) {
  const {LightManager, LightManager$Type: Type, EntityManager} = Filament;
  const light = EntityManager.get().create();
  const builder = LightManager.Builder({sun: Type.DIRECTIONAL, spot: Type.SPOT, point: Type.POINT}[fit.kind]);
  builder.color([1, 1, 1]).intensity(fit.kind === "sun" ? 1 : 1000).castShadows(true);
  if (fit.direction) builder.direction(fit.direction);
  if (fit.position) builder.position(fit.position).falloff(fit.reach * RANGE_SLACK);
  if (fit.kind === "spot") builder.spotLightCone(fit.angle_rad, fit.angle_rad);
  builder.build(engine, light);
  return light;
}

function shadowValues(values) {
  const plain = Object.entries(values).filter(([name]) => name !== "type").map(([name, value]) => [name.split(".").pop(), value]);
  return {...Object.fromEntries(plain), shadowType: TYPES.findIndex(name => name.toLowerCase() === values.type)};
}

// No post-processing, no anti-aliasing, and nothing else that ViewerGui's own defaults switch on.
function plainView(view) {
  view.setPostProcessingEnabled(false);
  view.setMultiSampleAntiAliasingOptions({enabled: false, sampleCount: 1});
  view.setAmbientOcclusionOptions({enabled: false});
  view.setBloomOptions({enabled: false});
}

export async function render(request) {
  const {width_px: width, height_px: height, parameters: values, scene: description, mesh, known} = request;
  if (bodies?.hash !== mesh.hash) {
    if (bodies) destroyBodies(engine, loader, bodies);
    bodies = await bodiesOf(engine, loader, mesh);
  }
  const out = targetOf(width, height), view = engine.createView(), cameraEntity = Filament.EntityManager.get().create();
  view.setViewport([0, 0, width, height]);
  view.setRenderTarget(out.target);
  const camera = engine.createCamera(cameraEntity), {eye_world, at_world, up_world, vertical_fov_deg, near_world} = description.camera;
  const far = farPlane(description.camera, mesh.points);
  const setNear = near => camera.setProjectionFov(vertical_fov_deg, width / height, near, far, Filament.Camera$Fov.VERTICAL);
  camera.lookAt(eye_world, at_world, up_world);
  camera.setExposureDirect(1);
  view.setCamera(camera);
  plainView(view);

  const submit = () => {
    renderer.renderStandaloneView(view);
    engine.execute();
  };
  const draw = async ({scene}) => {
    view.setScene(scene);
    for (let i = 0; i < FRAMES_TO_SETTLE; ++i) {
      submit();
      await new Promise(resolve => setTimeout(resolve, 0));
    }
    return readPixels(out.glTexture, width, height);
  };

  setNear(near_world);
  const positions = async () => fromColours(await draw(bodies.positions), bodies.positions.range);
  setNear(known?.near ?? nearPlane(description.camera, await positions()));
  const position = known?.position ?? await positions();
  const near = known?.near ?? nearPlane(description.camera, position);
  const normal = known?.normal ?? towards(fromColours(await draw(bodies.normals), bodies.normals.range), position, eye_world);
  const light = lightOf(nearestLight(description.light, mesh, position)), {scene} = bodies.white;
  scene.addEntity(light);
  const shadows = new ShadowSettings(Filament, engine, scene, view);
  try {
    shadows.apply(shadowValues(values));
    setNear(near);  // its lens is another
    camera.setExposureDirect(1);
    plainView(view);
    const lit = await draw(bodies.white);
    const times = await timeFrames(gl, request, submit);
    const manager = engine.getLightManager(), instance = manager.getInstance(light);
    manager.setShadowCaster(instance, false);
    instance.delete();
    const unlit = known?.unlit ?? await draw(bodies.white);
    return {lit, unlit, position, normal, near, ...times};
  } finally {
    scene.remove(light);
    shadows.delete();
    engine.destroyEntity(light);
    engine.destroyView(view);
    engine.destroyCameraComponent(cameraEntity);
    engine.destroyRenderTarget(out.target);
    for (const texture of [out.color, out.depth]) engine.destroyTexture(texture);
    engine.execute();
  }
}
