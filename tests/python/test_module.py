#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Python module as its users call it. Without it the module could import and still give other numbers than the
program, copy what it need not, hide an error's sentence, hold Python's lock, or not stop at Ctrl-C.

test_module.py UMBRAMETER: the program to compare with; PYTHONPATH names the module's folder."""
import ast
import base64
import json
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import umbrameter as um

PROGRAM = ""
SIZE = {"width": 96, "height": 54}


def program(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


class Module(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = um.load_scene("plate")
        cls.truth = um.truth(cls.scene, samples=64, **SIZE)
        try:
            cls.picture = um.render(cls.scene, "hard", **SIZE)
        except um.MachineError as error:
            raise unittest.SkipTest(f"no usable GL: {error}")

    def test_the_module_s_own_example_runs(self):
        lines = [line[4:] for line in um.__doc__.splitlines() if line.startswith("    ")]
        self.assertGreaterEqual(len(lines), 6)
        subprocess.run([sys.executable, "-c", "\n".join(lines)], check=True)

    def test_says_the_same_as_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            truth, picture = os.path.join(folder, "truth.exr"), os.path.join(folder, "picture.exr")
            size = ["--width", "96", "--height", "54"]
            program("reference", "plate", "--spp", "64", *size, "-o", truth)
            program("render", "plate", "--technique", "hard", *size, "-o", picture)
            told = json.loads(program("score", picture, "--reference", truth, "--quantity", "visibility", "--json"))
            np.testing.assert_array_equal(um.read(truth)["visibility"], self.truth["visibility"])
            np.testing.assert_array_equal(um.read(picture)["visibility"], self.picture["visibility"])
        score = um.score(self.picture, self.truth)
        for part in ("error", "parity", "faults", "penumbra", "significance"):
            self.assertEqual(score.record[part], told[part], part)
        self.assertEqual(score.rmse.value, told["error"]["rmse"]["value"])
        self.assertLess(score.rmse.low, score.rmse.value)
        self.assertLess(score.rmse.value, score.rmse.high)

    def test_fault_map_and_numbers_agree(self):
        score = um.score(self.picture, self.truth)
        self.assertEqual(score.fault_map.shape, (54, 96))
        for index, name in enumerate(um.FAULTS):
            self.assertEqual(np.count_nonzero(score.fault_map == index), score.fault(name)["pixels"], name)
        self.assertIn(score.worst_fault, um.FAULTS)
        with self.assertRaisesRegex(um.InputError, "no fault is called 'acme'"):
            score.fault("acme")

    def test_a_stranger_s_array_is_scored(self):
        noisy = np.clip(self.truth["visibility"] + 0.25, 0.0, 1.0)
        score = um.score(noisy, self.truth, metrics="error")
        self.assertIsNone(score.fault_map)
        expected = np.where(self.truth["unshadowed_irradiance"] > 0, noisy - self.truth["visibility"], np.nan)
        self.assertAlmostEqual(score.bias, np.nanmean(expected), delta=2e-3)
        ratio = um.score(self.truth["irradiance_ratio"], self.truth, metrics="error", quantity="irradiance")
        self.assertAlmostEqual(ratio.bias, 0.0, delta=1e-6)
        perfect = um.score(self.truth, self.truth, metrics="error")
        self.assertEqual(perfect.bias, 0.0)

    def test_arrays_share_the_picture_s_memory_and_outlive_it(self):
        a, b = self.truth["visibility"], self.truth["visibility"]
        self.assertEqual(a.__array_interface__["data"], b.__array_interface__["data"])
        self.assertFalse(a.flags.writeable)
        kept = um.truth(self.scene, samples=8, width=16, height=9)["visibility"]
        self.assertTrue(np.isfinite(kept).all())
        self.assertEqual(self.scene.triangles.shape[1], 3)
        self.assertEqual(self.scene.instance_count, 0)
        self.assertLess(self.scene.triangles.max(), len(self.scene.positions_world))

    def test_parameters_and_presets(self):
        by_text = um.render(self.scene, "pcf:filter_width_texels=5", **SIZE)
        by_name = um.render(self.scene, "pcf", filter_width_texels=5, **SIZE)
        np.testing.assert_array_equal(by_text["visibility"], by_name["visibility"])
        self.assertEqual(by_name.parameters["filter_width_texels"], 5)
        known = {t["id"]: t for t in um.techniques()}
        self.assertGreaterEqual(len(known), 20)
        preset = next(iter(known["pcss"]["presets"]))
        self.assertNotEqual(um.render(self.scene, "pcss", preset=preset, **SIZE).parameters,
                            um.render(self.scene, "pcss", **SIZE).parameters)

    def test_one_of_several_lights_must_be_chosen(self):
        lamp = '[[light]]\nname = "{}"\ntype = "rect"\ncenter = [{}, 4, 0]\ndirection = [0, -1, 0]\nsize = [1, 1]\n'
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "two.toml"
            file.write_text('title = "Two"\n[camera]\neye = [0, 2, 4]\nat = [0, 0, 0]\n' + lamp.format("left", -1)
                            + lamp.format("right", 1) + '[[mesh]]\nshape = "plane"\nsize = [8, 8]\n')
            with self.assertRaisesRegex(um.InputError, "2 lights and none is chosen.*left, right"):
                um.load_scene(file)
            hashes = {um.load_scene(file, light=name).hash for name in ("left", "right", "1")}
            self.assertEqual(len(hashes), 2)
            with self.assertRaisesRegex(um.InputError, "left"):
                um.load_scene(file, light="lef")

    def test_scenes_are_shown_at_a_moment(self):
        times, places = struct.pack("<2f", 0, 1), struct.pack("<6f", 0, 0, 0, 4, 0, 0)
        data = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + times + places
        views = [(0, 36, "VEC3", 3), (36, 8, "SCALAR", 2), (44, 24, "VEC3", 2)]
        gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "animations": [{"name": "go", "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                                "samplers": [{"input": 1, "output": 2}]}],
                "accessors": [{"bufferView": i, "componentType": 5126, "count": count, "type": kind}
                              for i, (_, _, kind, count) in enumerate(views)],
                "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": length} for start, length, _, _ in views],
                "buffers": [{"byteLength": len(data),
                             "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "go.gltf"
            file.write_text(json.dumps(gltf))
            scene = um.load_scene(file, time_s=0.25)
            self.assertEqual(scene.positions_world[:, 0].min(), 1.0)
            self.assertEqual(scene.animated, [{"mesh": "go", "file": "go.gltf", "animation": "go", "time_s": 0.25}])
            self.assertEqual(um.load_scene(file).animated, [])
            with self.assertRaisesRegex(um.InputError, "no animation is called 'stop'"):
                um.load_scene(file, time_s=0.25, animation="stop")
            with self.assertRaisesRegex(um.InputError, "'animation' goes with 'time_s'"):
                um.load_scene(file, animation="go")

    def test_errors_say_the_program_s_sentence(self):
        for call, arguments in (
                (lambda: um.load_scene("plaet"), ["reference", "plaet"]),
                (lambda: um.render(self.scene, "pcss", taps=3), ["render", "plate", "--technique", "pcss:taps=3"])):
            with self.assertRaises(um.InputError) as caught:
                call()
            run = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
            self.assertEqual(run.returncode, 2)
            self.assertEqual(run.stderr.strip(), f"umbrameter: error: {caught.exception}")
        self.assertTrue(issubclass(um.InputError, ValueError))
        with self.assertRaisesRegex(um.InputError, "54 rows and 96 columns|size"):
            um.score(np.zeros((10, 10)), self.truth)
        with self.assertRaisesRegex(um.InputError, "nan|NaN|finite"):
            um.score(np.full((54, 96), np.nan), self.truth)

    def test_python_goes_on_while_the_truth_is_traced(self):
        steps, done = 0, threading.Event()

        def trace():
            um.truth(self.scene, samples=1024, threads=1, width=320, height=180)
            done.set()

        worker = threading.Thread(target=trace)
        worker.start()
        while not done.wait(0.001):
            steps += 1
        worker.join()
        self.assertGreater(steps, 10)

    def test_ctrl_c_stops_the_truth(self):
        code = ("import umbrameter as um, sys\n"
                "scene = um.load_scene('colonnade')\n"
                "print('ready', flush=True)\n"
                "try:\n"
                "    um.truth(scene, samples=1 << 16, width=1920, height=1080)\n"
                "except KeyboardInterrupt:\n"
                "    um.truth(scene, samples=8, width=16, height=9)\n"
                "    sys.exit(7)\n")
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "ready\n")
        time.sleep(1.0)
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.wait(timeout=120), 7)
        child.stdout.close()

    def test_penumbra_profiles_are_the_record_s(self):
        score = um.score(self.picture, self.truth)
        profiles = score.profiles()
        accepted = profiles[profiles["outcome"] == um.PROFILE_OUTCOMES.index("accepted")]
        told = score.record["penumbra"]
        self.assertGreater(told["accepted"], 0)
        self.assertEqual(len(accepted), told["accepted"])
        self.assertEqual(np.count_nonzero(accepted["is_partial"]), told["partial"])
        for index, name in enumerate(um.PROFILE_OUTCOMES):
            self.assertEqual(np.count_nonzero(profiles["outcome"] == index), told["profiles"][name], name)
        self.assertAlmostEqual(np.median(accepted["width_octaves"]), told["width_octaves"]["median"], places=6)
        self.assertEqual(np.count_nonzero(score.scored), score.record["error"]["scored_pixels"])

    def test_a_walk_crosses_the_penumbra(self):
        score = um.score(self.picture, self.truth)
        profiles = score.profiles()
        widest = profiles[np.argmax(np.where(profiles["outcome"] == 0, profiles["reference_width_px"], 0.0))]
        walk = score.walk(int(widest["x"]), int(widest["y"]))
        visibility = self.truth["visibility"][walk.rows, walk.columns]
        self.assertLess(visibility[0], 0.05)
        self.assertGreater(visibility[-1], 0.95)
        self.assertTrue((np.diff(walk.distance_world) > 0).all())
        self.assertEqual(np.count_nonzero(walk.distance_world == 0.0), 1)
        with self.assertRaisesRegex(um.InputError, "is not in a picture of 96 x 54 px"):
            score.walk(96, 0)
        with self.assertRaisesRegex(um.InputError, "no penumbra passes through pixel"):
            score.walk(90, 51)

    def test_the_pages_examples_run(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        for page, least in (("README.md", 1), ("docs/api.md", 2)):
            blocks = re.findall(r"^```python\n(.*?)^```", (root / page).read_text(), re.M | re.S)
            self.assertGreaterEqual(len(blocks), least, page)
            for block in blocks:
                with tempfile.TemporaryDirectory() as folder:
                    subprocess.run([sys.executable, "-c", block], check=True, cwd=folder, stdout=subprocess.DEVNULL)

    def test_stubs_say_what_is_there(self):
        stub = pathlib.Path(um.__file__).with_name("_core.pyi").read_text()
        said, there = {}, um._core
        for node in ast.parse(stub).body:
            if isinstance(node, ast.ClassDef):
                said[node.name] = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
            elif isinstance(node, ast.FunctionDef):
                said[node.name] = node
            elif isinstance(node, ast.AnnAssign):
                said[node.target.id] = None
        self.assertEqual({n for n in dir(there) if not n.startswith("_")}, set(said))
        compared = 0
        for name, node in said.items():
            methods = node if isinstance(node, dict) else {}
            if methods:
                self.assertEqual({m for m in dir(getattr(there, name)) if not m.startswith("_")}, set(methods) - {"__init__"}, name)
            functions = methods if isinstance(node, dict) else ({} if node is None else {"": node})
            for method, function in functions.items():
                real = getattr(getattr(there, name), method) if method else getattr(there, name)
                if isinstance(real, property):
                    self.assertEqual([d.id for d in function.decorator_list], ["property"], f"{name}.{method}")
                    continue
                arguments = re.match(r"\w+\((.*)\)", real.__doc__).group(1)
                names = re.findall(r"(?:^|, )(\w+): ", re.sub(r"\[[^]]*\]", "", arguments))
                stubbed = [argument.arg for argument in function.args.args]
                if all(name != "arg0" for name in names):
                    self.assertEqual(names, stubbed, f"{name}.{method}")
                self.assertEqual(len(names), len(stubbed), f"{name}.{method}")
                compared += 1
        self.assertGreater(compared, 12)
        for name in um.__all__:
            self.assertTrue(hasattr(um, name), name)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
