# SPDX-License-Identifier: Apache-2.0
"""Inside Blender: answers requests, one JSON object a line, until standard input ends.

blender -b -P serve.py -- cycles|eevee ANSWERS, the number of the file descriptor for answers (launch.py).
"""
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import bpy

import draw_cycles
import draw_eevee
import exported
import pictures
import surfaces

ENGINES = {"cycles": draw_cycles, "eevee": draw_eevee}


class Server:
    def __init__(self, engine):
        self.engine = engine
        self.mesh, self.mesh_hash = None, None

    def mesh_of(self, folder, description):
        if self.mesh_hash != description["mesh_hash"]:
            self.mesh, self.mesh_hash = exported.read_mesh(folder / "scene.obj"), description["mesh_hash"]
        return self.mesh

    def render(self, request):
        folder, out = pathlib.Path(request["scene"]), pathlib.Path(request["out"])
        description = json.loads((folder / "scene.json").read_text(encoding="utf-8"))
        body, light, scene = exported.build(self.mesh_of(folder, description), description)
        exported.set_size(scene, request["width_px"], request["height_px"])
        values = request["parameters"]
        self.engine.set_up(scene, body, light, values, request["seed"])

        eye = scene.camera.matrix_world.translation
        self.engine.set_samples(scene, 1)
        picture, *aovs = pictures.draw(scene, out, ("Image", *surfaces.AOVS))
        drawn = surfaces.from_aovs(eye, picture[:, :, 3] > 0.5, *aovs)
        self.engine.set_samples(scene, values[self.engine.SAMPLES])
        for name, casts in (("lit", True), ("unlit", False)):
            self.engine.set_shadow(light, casts)
            [drawn[name]] = pictures.draw(scene, out)
        for name, pixels in drawn.items():
            pictures.write_pfm(out / f"{name}.pfm", pixels)
        return {"warnings": [], **{name: f"{name}.pfm" for name in drawn}}


def main():
    engine_name, descriptor = sys.argv[sys.argv.index("--") + 1:]
    engine = ENGINES[engine_name]
    with os.fdopen(int(descriptor), "w", encoding="utf-8", buffering=1) as answers:
        def say(answer):
            answers.write(json.dumps(answer) + "\n")

        server = Server(engine)
        say({"ready": True, "version": f"Blender {bpy.app.version_string} {engine.NAME}", "device": engine.DEVICE,
             "is_software": True})
        for line in sys.stdin:
            request = json.loads(line)
            try:
                say({"id": request["id"], **server.render(request)})
            except Exception as error:
                print(repr(error), file=sys.stderr)
                say({"id": request["id"], "error": " ".join(str(error).split("\n")[:2]) or repr(error)})


main()
