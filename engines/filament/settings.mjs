// SPDX-License-Identifier: Apache-2.0
// The shadow settings of a view and its lights. The npm package binds no function for them (LightManager.shadowOptions is
// bound to a type that is not): they go through ViewerGui, which applies its own Settings to a view and a scene. Those are bytes
// of the engine's memory, found by their defaults and checked against the engine's own JSON of them.

export const TYPES = ["PCF", "VSM", "DPCF", "PCSS", "PCFd"];  // View::ShadowType, in order
const SEARCHED_BYTES = 16384;

// LightManager::ShadowOptions (Options.h), from mapSize on: [byte, kind, default].
const SHADOW_OPTIONS = {
  mapSize: [0, "u32", 1024], shadowCascades: [4, "u8", 1], constantBias: [20, "f32", 0.001], normalBias: [24, "f32", 1], shadowNearHint: [32, "f32", 1],
  shadowFarHint: [36, "f32", 100], stable: [40, "u8", 0], lispsm: [41, "u8", 1], polygonOffsetConstant: [44, "f32", 0.5],
  polygonOffsetSlope: [48, "f32", 2], maxShadowDistance: [56, "f32", 0.3], elvsm: [60, "u8", 0], blurWidth: [64, "f32", 0],
  shadowBulbRadius: [68, "f32", 0.02],
};
// View::VsmShadowOptions, from anisotropy on.
const VSM_OPTIONS = {
  anisotropy: [0, "u8", 0], mipmapping: [1, "u8", 0], msaaSamples: [2, "u8", 1], highPrecision: [3, "u8", 0],
  minVarianceScale: [4, "f32", 0.5], lightBleedReduction: [8, "f32", 0.15],
};

export class ShadowSettings {
  // The view and the lights of the scene, those that are added later, too, get what apply() is told.
  constructor(Filament, engine, scene, view) {
    this.Filament = Filament;
    this.gui = new Filament.ViewerGui(engine, scene, view, 1);
    this.engine = engine;
    this.guiView = engine.createView();
    this.guiView.setViewport([0, 0, 1, 1]);
    this.serializer = new Filament.JsonSerializer();
    const lights = this.find("shadow options", SHADOW_OPTIONS), vsm = this.find("VSM options", VSM_OPTIONS);
    this.places = {...lights, ...vsm};
    const place = (name, at, kind) => { this.places[name] = {at, kind}; };
    place("enableShadows", lights.mapSize.at - 4, "u8");
    place("enableSunlight", lights.mapSize.at - 3, "u8");
    place("penumbraScale", lights.shadowBulbRadius.at + 20, "f32");  // after the rotation of cascades
    place("penumbraRatioScale", lights.shadowBulbRadius.at + 24, "f32");
    place("shadowType", this.findType(vsm.anisotropy.at), "u8");
    this.check();
  }

  read({at, kind}) {
    const memory = new DataView(this.Filament.HEAPU8.buffer);
    return kind === "f32" ? memory.getFloat32(at, true) : kind === "u32" ? memory.getUint32(at, true) : memory.getUint8(at);
  }

  write({at, kind}, value) {
    const memory = new DataView(this.Filament.HEAPU8.buffer);
    if (kind === "f32") memory.setFloat32(at, value, true);
    else if (kind === "u32") memory.setUint32(at, value, true);
    else memory.setUint8(at, Number(value));
  }

  // The one place in the object where all of a group's defaults stand.
  find(what, group) {
    const found = [], start = this.gui.$$.ptr;
    for (let base = start; base < start + SEARCHED_BYTES; base += 4) {
      const is_here = Object.values(group).every(([byte, kind, value]) =>
        this.read({at: base + byte, kind}) === (kind === "f32" ? Math.fround(value) : value));
      if (is_here) found.push(base);
    }
    if (found.length !== 1) throw new Error(`${found.length} places in the engine's memory look like its ${what}`);
    return Object.fromEntries(Object.entries(group).map(([name, [byte, kind]]) => [name, {at: found[0] + byte, kind}]));
  }

  // Its settings of the view begin with FXAA, temporal dithering, PCF and post-processing, a byte each.
  findType(end) {
    for (let at = this.gui.$$.ptr; at < end; at += 4) {
      const is_here = [1, 1, 0, 1].every((value, i) => this.read({at: at + i, kind: "u8"}) === value);
      if (!is_here) continue;
      const type = {at: at + 2, kind: "u8"};
      this.write(type, 1);
      const is_read = this.json().includes('"shadowType": "VSM"');
      this.write(type, 0);
      if (is_read) return type.at;
    }
    throw new Error("no place in the engine's memory is read as its type of shadows");
  }

  json() {
    const copy = this.gui.getSettings();
    const text = this.serializer.writeJson(copy);
    copy.delete();
    return text;
  }

  // What is written must be what the engine reads.
  check() {
    const trials = {mapSize: 333, blurWidth: 3.25, shadowBulbRadius: 0.375, penumbraScale: 5.5, penumbraRatioScale: 6.5,
                    lightBleedReduction: 0.625, minVarianceScale: 0.875, enableSunlight: 0, elvsm: 1, mipmapping: 1, highPrecision: 1};
    for (const [name, value] of Object.entries(trials)) {
      const place = this.places[name], before = this.read(place);
      this.write(place, value);
      const text = place.kind === "u8" ? String(Boolean(value)) : String(value);
      if (!this.json().includes(`"${name}": ${text}`)) throw new Error(`the engine does not read ${name} where it is written`);
      this.write(place, before);
    }
  }

  apply(values) {
    for (const [name, value] of Object.entries({...values, enableSunlight: false})) this.write(this.places[name], value);
    this.gui.renderUserInterface(0.1, this.guiView, 1);
  }

  delete() {
    this.gui.delete();
    this.serializer.delete();
    this.engine.destroyView(this.guiView);
  }
}
