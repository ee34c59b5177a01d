#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the Python module lets the program do, and the data frames of what verbs leave. Without it a frame could hold other
numbers than the record, a column could be lost, a refusal could lose its sentence, or Ctrl-C could leave a program behind.

test_studies.py UMBRAMETER: the program that belongs to the module; PYTHONPATH names the module's folder."""
import contextlib
import json
import os
import pathlib
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import pandas

import umbrameter as um
from umbrameter import _program

PROGRAM = ""
SMALL = {"width": 96, "height": 54, "spp": 32}
STUDY = """schema = 1
title = "Two techniques"
scenes = ["plate"]
seeds = [1, 2]
frames = 6
[[run]]
technique = "hard"
[[run]]
technique = "pcf"
label = "pcf {filter_width_texels}"
[run.values]
filter_width_texels = [3, 5]
[[claim]]
text = "hard is faster"
source = "nobody"
numerator = "pcf 5"
denominator = "hard"
quantity = "time"
paper = 2.0
unequal_cost = true
"""


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def study(self):
        file = self.folder / "study.toml"
        file.write_text(STUDY)
        return file


class Command(InFolder):
    def test_the_program_is_the_module_s_own(self):
        self.assertEqual(os.path.realpath(_program.program_file()), os.path.realpath(PROGRAM))

    def test_refusals_keep_their_sentence(self):
        run = subprocess.run([PROGRAM, "tune", "plate", "--technique", "pcss:taps=3"], capture_output=True, text=True)
        with self.assertRaises(um.InputError) as caught:
            um.tune("plate", "pcss:taps=3")
        self.assertEqual(run.stderr.strip(), f"umbrameter: error: {caught.exception}")
        with self.assertRaisesRegex(um.MachineError, "not installed|install_engines|missing"):
            os.environ["UMBRAMETER_ENGINES"] = str(self.folder)
            self.addCleanup(os.environ.pop, "UMBRAMETER_ENGINES")
            um.check_engine("three")

    def test_warnings_are_python_s(self):
        file = self.folder / "warned.toml"
        file.write_text('title = "W"\n[camera]\neye = [0, 2, 4]\nat = [0, 0, 0]\n[[light]]\ntype = "rect"\ncenter = [0, 4, 0]\n'
                        'direction = [0, -1, 0]\nsize = [1, 1]\n[[mesh]]\nshape = "plane"\nsize = [8, 8]\n'
                        '[[mesh]]\nfile = "m.obj"\n')
        (self.folder / "m.obj").write_text("v 0 1 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 1 1 2\n")
        said = subprocess.run([PROGRAM, "render", file, "--technique", "hard", "--width", "32", "--height", "18", "-o",
                               self.folder / "a.exr"], capture_output=True, text=True, check=True).stderr
        self.assertIn("umbrameter: warning: ", said)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            um.command("render", file, "--technique", "hard", "--width", 32, "--height", 18, "-o", self.folder / "b.exr")
        self.assertEqual([f"umbrameter: warning: {one.message}" for one in caught],
                         [line for line in said.splitlines() if "warning: " in line])

    def test_ctrl_c_ends_the_program_too(self):
        code = ("import umbrameter as um, sys\nprint('ready', flush=True)\ntry:\n"
                f"    um.tune('colonnade', 'pcss', time_limit='500s', out={str(self.folder / 'tuned')!r})\n"
                "except KeyboardInterrupt:\n    sys.exit(7)\n")
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        self.assertEqual(child.stdout.readline(), "ready\n")
        time.sleep(1.5)
        children = pathlib.Path(f"/proc/{child.pid}/task/{child.pid}/children").read_text().split()
        self.assertEqual(len(children), 1)
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.wait(timeout=60), 7)
        child.stdout.close()
        self.assertFalse(pathlib.Path(f"/proc/{children[0]}").exists())
        self.assertFalse((self.folder / "tuned" / "tune.json").exists())


class Sweep(InFolder):
    def test_frames_are_the_export(self):
        frames = um.sweep(self.study(), self.folder / "store", time=True, **SMALL)
        csv = self.folder / "runs.csv"
        csv.write_text(subprocess.run([PROGRAM, "export", self.folder / "store", "--csv"], capture_output=True, text=True,
                                      check=True).stdout)
        exported = pandas.read_csv(csv)
        self.assertEqual(len(frames.runs), 6)
        # Verdicts are made of stored images by `export`; a store's entries do not hold them.
        columns = [name for name in exported if not name.startswith(("verdict", "mse_difference", "baseline"))]
        self.assertGreater(len(columns), 25)
        columns.remove("target_se")
        for name in columns:
            self.assertIn(name, frames.runs)
            ours = frames.runs[name]
            if pandas.api.types.is_numeric_dtype(exported[name]) and not exported[name].isna().all():
                pandas.testing.assert_series_equal(ours.astype(float), exported[name].astype(float), rtol=1e-5, check_names=False)
            else:
                texts = [[str(value).lower() for value in column.fillna("").replace("nan", "")] for column in (ours, exported[name])]
                if not name.startswith("parameter."):
                    self.assertEqual(*texts, name)
        self.assertEqual(len(frames.references), 1)
        self.assertGreater(frames.references["mean_visibility_se"][0], 0)

    def test_sql_has_a_row_a_run_and_metric(self):
        runs = um.sweep(self.study(), self.folder / "store", **SMALL).runs
        with contextlib.closing(sqlite3.connect(self.folder / "store" / "store.sqlite")) as database:
            rows = database.execute("SELECT label, metric, value FROM measurements").fetchall()
        for metric in ("rmse", "max_error", "worst_pixels_rmse"):
            ours = sorted((label, value) for label, name, value in rows if name == metric)
            self.assertEqual(ours, sorted(zip(runs["label"], runs[metric])))

    def test_it_goes_on_where_it_was(self):
        first = um.sweep(self.study(), self.folder / "store", shard="1/2", **SMALL)
        self.assertLess(len(first.runs), 6)
        both = um.sweep(self.study(), self.folder / "store", **SMALL)
        self.assertEqual(len(both.runs), 6)
        merged = both.runs.merge(first.runs, on=["label", "seed"], suffixes=("", "_first"))
        self.assertTrue((merged["started"] == merged["started_first"]).all())

    def test_of_entries_that_are_the_same_the_newest_counts(self):
        store = self.folder / "store"
        frames = um.sweep(self.study(), store, **SMALL)
        database = sqlite3.connect(store / "store.sqlite")
        key, text = database.execute("SELECT key, json FROM entries WHERE kind = 'run' LIMIT 1").fetchone()
        record = json.loads(text)
        record.update({"started": "2999-01-01T00:00:00.000Z", "commit": "later"})
        database.execute("INSERT INTO entries VALUES ('x', 'run', ?, '')", (json.dumps(record),))
        database.execute("INSERT INTO entries VALUES ('y', 'run', '{}', '')")
        database.commit()
        database.close()
        with self.assertWarnsRegex(UserWarning, "1 entries of another version"):
            again = um.frames(store)
        self.assertEqual(len(again.runs), len(frames.runs))
        self.assertEqual(list(again.runs["commit"]).count("later"), 1)


class Records(InFolder):
    def test_validate(self):
        out = self.folder / "out"
        record = um.command("validate", "plate", "--technique", "hard", "--width", 96, "--height", 54, "--spp", 32, "-o", out)
        run = record["scenes"][0]["techniques"][0]
        row = um.frames(out).runs.iloc[0]
        older = json.loads((out / "results.json").read_text())
        for one in older["scenes"][0]["techniques"]:
            del one["measurements"]
        (self.folder / "older").mkdir()
        (self.folder / "older" / "results.json").write_text(json.dumps(older))
        before = um.frames(self.folder / "older").runs.iloc[0]
        for name in ("rmse", "rmse_low", "bias", "max_error", "penumbra.rmse", "flip_mean", "fault.acne", "memory_bytes"):
            self.assertEqual(before[name], row[name], name)
        self.assertEqual(row["rmse_low"], run["error"]["rmse"]["low"])
        self.assertEqual(row["penumbra.rmse"], run["error"]["penumbra"]["rmse"])
        self.assertEqual(row["width_octaves"], run["penumbra"]["width_octaves"]["median"])
        self.assertEqual(row["worst_fault"], run["faults"]["worst"])
        self.assertEqual(row["time_ms"], run["pass_times"][-1]["median_ms"])
        self.assertEqual(row["parameter.map_size"], run["parameters"]["map_size"])
        self.assertAlmostEqual(sum(row[f"fault.{name}"] for name in um.FAULTS), row["mae"], places=6)

    def test_bench(self):
        frames = um.bench(self.study(), frames=6, **SMALL)
        self.assertEqual(len(frames.runs), 6)
        self.assertTrue((frames.runs["time_low"] <= frames.runs["time_ms"]).all())
        claim = frames.claims.iloc[0]
        self.assertEqual((claim["paper_low"], claim["text"]), (2.0, "hard is faster"))
        self.assertIn(claim["verdict"], ("same order", "opposite order", "cannot tell"))

    def test_tune(self):
        tuning = um.tune(["plate"], "pcf_disk", parameters=["radius_texels", "bias_texels"], evaluations=6, cameras=1,
                         time_limit="30s", width=96, height=54, samples=32, out=self.folder)
        self.assertEqual(tuning.record, {**json.loads((self.folder / "tune.json").read_text())})
        self.assertEqual(tuning.preset, (self.folder / "pcf_disk.toml").read_text())
        self.assertLessEqual(tuning.ratio, 1.0)
        frames = um.frames(self.folder)
        self.assertEqual(len(frames.trials), len(tuning.record["trials"]) + len(tuning.record["coarse_trials"]))
        self.assertEqual(frames.trials["ratio"].iloc[-1], tuning.record["trials"][-1]["ratio"])
        self.assertEqual(list(frames.candidates["name"])[0], "tuned")
        self.assertIn("bias_texels", list(frames.windows["parameter"]))
        picture = um.render(um.load_scene("plate"), tuning.technique, 96, 54, **tuning.parameters)
        self.assertEqual(picture.parameters["radius_texels"], tuning.parameters["radius_texels"])

    def test_what_is_no_record_is_said(self):
        with self.assertRaisesRegex(um.InputError, "is not there"):
            um.frames(self.folder / "none")
        with self.assertRaisesRegex(um.InputError, "holds no record of any verb"):
            um.frames(self.folder)
        (self.folder / "bench.json").write_text('{"mine": 1}')
        with self.assertRaisesRegex(um.InputError, "bench.json: no record of any verb .*mine"):
            um.frames(self.folder)
        (self.folder / "bench.json").write_text('{"schema": 1, "wanted_frames": 6}')
        with self.assertRaisesRegex(um.InputError, "bench.json: bench of schema 1; this version reads 2 .run 'umbrameter bench' again"):
            um.frames(self.folder)
        (self.folder / "bench.json").write_text("{")
        with self.assertRaisesRegex(um.InputError, "bench.json: no record of any verb"):
            um.frames(self.folder)


class Engines(unittest.TestCase):
    def test_engines_say_what_they_are(self):
        engines = {engine["id"]: engine for engine in um.engines()}
        self.assertLessEqual({"three", "babylon", "playcanvas"}, set(engines))
        listed = {engine["id"]: engine for engine in um.command("engines", "list")["engines"]}
        for name, engine in engines.items():
            self.assertEqual(engine["lights"], listed[name]["lights"])
            self.assertEqual(engine["quantity"], listed[name]["quantity"])
            self.assertEqual(not engine["missing"], listed[name]["installed"])
        self.assertTrue(all(engine["parameters"] for engine in engines.values()))

    def test_an_engine_is_rendered_like_a_technique(self):
        adapter = pathlib.Path(__file__).resolve().parents[1] / "engine" / "adapter.py"
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "engine.toml").write_text(ENGINE.format(adapter=adapter))
            scene = um.load_scene("plate")
            with self.assertWarnsRegex(UserWarning, "the engine gave no position"):
                picture = um.render(scene, folder, 64, 36, **{"shadow.grey": 0.25})
        self.assertEqual(picture.shape, (36, 64))
        self.assertEqual(set(picture["visibility"].flat), {0.25})
        self.assertAlmostEqual(um.score(picture, um.truth(scene, 64, 36, samples=32)).bias, -0.7, delta=0.2)


ENGINE = """schema = 1
id = "tried"
title = "An engine of a test"
summary = "Draws one grey."
quantity = "visibility"
adapter = ["python3", "{adapter}"]
[lights]
rect = "a point"
[[parameter]]
name = "misbehave"
type = "choice"
choices = ["no"]
default = "no"
doc = "nothing goes wrong"
[[parameter]]
name = "shadow.grey"
type = "real"
default = 0.5
min = 0.0
max = 1.0
doc = "visibility everywhere"
"""


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
