# SPDX-License-Identifier: Apache-2.0
"""test_animated.py SOURCE_FOLDER PROGRAM: an animated scene from Blender's own exporters, as GLB and as FBX, has Blender's evaluated
vertices at three moments, and its cameras and lights. Exits with 3, skipped, where there is no Blender."""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
CLOSE = 1e-5  # metres: keys are floats, and those of rotations in FBX degrees


def umbrameter(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.returncode}: {done.stderr}")
    return done


def distance(p, q):
    return math.dist(p, q)


class Animated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-P",
                        SOURCE / "tests/blender/make_animated.py", "--", cls.folder], check=True, stdout=subprocess.DEVNULL)
        cls.truth = json.loads((cls.folder / "truth.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def exported(self, file, time_s, light):
        """scene.json, and the positions of what `scene export` writes."""
        out = self.folder / f"{file}-{time_s:.6f}-{light}"
        at = ["--time", repr(time_s), "--animation", "all"] if time_s is not None else []
        umbrameter("scene", "export", self.folder / file, *at, "--light", light, "--width", 160, "--height", 90, "--out", out)
        lines = (out / "scene.obj").read_text().splitlines()
        return json.loads((out / "scene.json").read_text()), [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("v ")]

    def worst(self, positions, wanted):
        """How far any vertex of Blender's is from ours, and any of ours from Blender's."""
        ours, theirs = sorted(set(positions)), [tuple(p) for mesh in wanted.values() for p in mesh]
        there = max(min(distance(p, q) for q in ours) for p in theirs)
        return max(there, max(min(distance(p, q) for q in theirs) for p in ours))

    def test_vertices_are_those_that_blender_evaluates(self):
        moved = {}
        for file, first_frame in (("animated.glb", 0), ("animated.fbx", 1)):
            for frame, wanted in self.truth["frames"].items():
                time_s = (int(frame) - first_frame) / self.truth["fps"]
                scene, positions = self.exported(file, time_s, "bulb")
                worst = self.worst(positions, wanted)
                print(f"{file} frame {frame}: {len(set(positions))} vertices, worst distance {worst:.2e} m")
                self.assertLess(worst, CLOSE, (file, frame))
                moved.setdefault(file, set()).add(scene["hash"])
        self.assertEqual([len(hashes) for hashes in moved.values()], [3, 3])

    def test_a_wrong_frame_is_noticed(self):
        _, positions = self.exported("animated.glb", 9 / self.truth["fps"], "bulb")
        self.assertGreater(self.worst(positions, self.truth["frames"]["20"]), 0.1)

    def test_the_fbx_has_blenders_cameras_and_lights(self):
        views = self.truth["views"]
        for light, kind in (("bulb", "sphere"), ("sky", "sun"), ("torch", "disk"), ("panel", "rect")):
            scene, _ = self.exported("animated.fbx", 0.0, light)
            found = scene["light"]
            self.assertEqual(found["type"], kind)
            if kind != "sphere":
                self.assertLess(distance(found["direction_world"], views[light]["forward"]), 1e-5, light)
            if kind != "sun":
                self.assertLess(distance(found["center_world"], views[light]["place"]), 1e-5, light)
        self.assertEqual(self.exported("animated.fbx", 0.0, "bulb")[0]["light"]["radius_world"], 0.25)
        self.assertEqual(self.exported("animated.fbx", 0.0, "panel")[0]["light"]["size_world"], [1.5, 0.5])
        self.assertEqual(self.exported("animated.fbx", 0.0, "sky")[0]["light"]["angular_diameter_deg"], 2.0)
        camera, eye = scene["camera"], views["eye"]
        self.assertLess(distance(camera["eye_world"], eye["place"]), 1e-5)
        forward = [(a - e) / distance(camera["at_world"], camera["eye_world"]) for a, e in zip(camera["at_world"], camera["eye_world"])]
        self.assertLess(distance(forward, eye["forward"]), 1e-5)
        self.assertLess(distance(camera["up_world"], eye["up"]), 1e-5)
        self.assertAlmostEqual(camera["vertical_fov_deg"], eye["fov_deg"], places=3)

    def test_both_files_say_what_they_leave_out(self):
        for file, wanted in (("animated.glb", ["spot 'torch' is a disk", "it has 2 cameras"]),
                             ("animated.fbx", ["spot 'torch' is a disk", "it has 2 cameras", "straight lines"])):
            said = umbrameter("scene", "check", self.folder / file, "--time", "0.5", "--animation", "all").stdout
            for part in wanted:
                self.assertIn(part, said, file)


if __name__ == "__main__":
    if shutil.which("blender") is None:
        print("test_animated: blender is not installed: skipped")
        sys.exit(3)
    unittest.main(argv=sys.argv[:1], verbosity=2)
