#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Figures and tables as a paper takes them. Without it a figure could show other numbers than the frame, lack a unit, or need
fonts that a publisher refuses; a table could call a run best that is not, or let a missing number pass as measured."""
import pathlib
import re
import tempfile
import unittest

import matplotlib

matplotlib.use("Agg")

import numpy as np
import pandas
from matplotlib import pyplot

import umbrameter as um
from umbrameter import _crops, figures, tables

SIZE = {"width": 96, "height": 54}
RUNS = pandas.DataFrame({
    "scene": ["a"] * 4 + ["b"], "label": ["slow_good", "fast_bad", "slow_bad", "failed", "fast_bad"],
    "rmse": [0.01, 0.05, 0.06, None, 0.02], "rmse_low": [0.008, 0.04, 0.055, None, 0.01], "rmse_high": [0.012, 0.052, 0.07, None, 0.03],
    "time_ms": [4.0, 1.0, 4.1, 2.0, 1.0], "time_low": [3.9, 0.9, 4.0, 1.9, 0.9], "time_high": [4.1, 1.1, 4.2, 2.1, 1.1],
    "device": "llvmpipe (LLVM 15)", "seed": 1, "commit": "abc",
})


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = um.load_scene("plate")
        cls.truth = um.truth(cls.scene, samples=64, **SIZE)
        try:
            cls.pictures = {name: um.render(cls.scene, name, **SIZE) for name in ("hard", "pcss")}
        except um.MachineError as error:
            raise unittest.SkipTest(f"no usable GL: {error}")

    def tearDown(self):
        pyplot.close("all")

    def test_the_front_joins_what_nothing_beats(self):
        figure = figures.front(RUNS, scene="a")
        axes = figure.axes[0]
        line = axes.lines[0]
        self.assertEqual([tuple(point) for point in line.get_xydata()], [(1.0, 0.05), (4.0, 0.01)])
        labels = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(labels, ["fast_bad", "slow_good", "slow_bad"])
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        self.assertIn("(ms, software rasteriser)", axes.get_xlabel())
        bars = [collection.get_segments()[0] for collection in axes.collections]
        self.assertTrue(any(np.allclose(bar, [[0.9, 0.05], [1.1, 0.05]]) for bar in bars), bars)
        self.assertTrue(any(np.allclose(bar, [[1.0, 0.04], [1.0, 0.052]]) for bar in bars), bars)
        with self.assertRaisesRegex(um.InputError, "not one of: a, b"):
            figures.front(RUNS)
        with self.assertRaisesRegex(um.InputError, "both a time and an error"):
            figures.front(RUNS[RUNS.label == "failed"])

    def test_the_penumbra_s_lines_are_the_pictures(self):
        score = um.score(self.pictures["hard"], self.truth)
        figure = figures.penumbra(self.truth, self.pictures)
        axes = figure.axes[0]
        lines = {line.get_label(): line for line in axes.lines}
        self.assertEqual(list(lines), ["truth", "hard", "pcss"])
        profiles = score.profiles()
        whole = profiles[(profiles["outcome"] == 0) & ~profiles["is_partial"]]
        widest = whole[np.argmax(whole["reference_width_px"])]
        walks = [um.score(picture, self.truth).walk(int(widest["x"]), int(widest["y"])) for picture in self.pictures.values()]
        walk = max(walks, key=lambda one: len(one.rows))
        for name, picture in {"truth": self.truth, **self.pictures}.items():
            np.testing.assert_array_equal(lines[name].get_xdata(), walk.distance_world)
            np.testing.assert_array_equal(lines[name].get_ydata(), picture["visibility"][walk.rows, walk.columns])
        self.assertIn("units", axes.get_xlabel())
        self.assertEqual(len({(str(line.get_color()), str(line.get_linestyle())) for line in lines.values()}), 3)

    def test_crops_show_errors_and_the_worst_place(self):
        figure = figures.error_crops(self.truth, self.pictures)
        grid = figure.axes[:6]
        self.assertEqual([axes.get_title().split(",")[0] for axes in grid[:3]], ["truth", "hard", "pcss"])
        rmse = um.score(self.pictures["hard"], self.truth, metrics="error").rmse.value
        self.assertIn(f"RMSE {rmse:.3f}", grid[1].get_title())
        error = self.pictures["hard"]["visibility"] - self.truth["visibility"]
        shown = grid[4].images[0].get_array()
        self.assertGreater(shown.count(), 1000)
        np.testing.assert_array_equal(shown.compressed(), error[~np.ma.getmaskarray(shown)])
        inset = grid[4].child_axes[0].images[0].get_array()
        self.assertEqual(inset.shape, (12, 12))
        self.assertGreater(np.abs(inset).max(), 0.3)

    def test_the_worst_place_is_found(self):
        error = np.zeros((20, 30))
        error[12:14, 21:23] = 0.5
        error[3, 3] = 0.6
        x, y = _crops.worst_place([error, np.full((20, 30), np.nan)], 4)
        box = _crops.box_around((x, y), 4, error.shape)
        self.assertEqual(np.count_nonzero(error[box.top:box.top + 4, box.left:box.left + 4]), 4)
        self.assertEqual(_crops.box_around((0, 19), 8, error.shape), (0, 12, 8))

    def test_fault_classes_are_named(self):
        score = um.score(self.pictures["hard"], self.truth)
        figure = figures.fault_classes(score)
        texts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
        self.assertTrue(any(text.startswith(score.worst_fault.replace("_", " ") + ",") for text in texts), texts)
        shares = [float(re.search(r"([\d.]+)%", text).group(1)) for text in texts]
        self.assertAlmostEqual(sum(shares), 100.0, delta=0.5)
        with self.assertRaisesRegex(um.InputError, "no diagnosis"):
            figures.fault_classes(um.score(self.pictures["hard"], self.truth, metrics="error"))

    def test_files_hold_their_fonts(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.pdf"
            figures.save(figures.front(RUNS, scene="a"), file)
            data = file.read_bytes()
            self.assertIn(b"/FontFile2", data)
            self.assertNotIn(b"/Type3", data)

    def test_sizes_are_a_page_s(self):
        self.assertEqual(figures.front(RUNS, scene="a").get_size_inches()[0], 3.5)
        self.assertEqual(figures.error_crops(self.truth, self.pictures).get_size_inches()[0], 7.16)
        with self.assertRaisesRegex(um.InputError, "width is 'wide', not column or page"):
            figures.front(RUNS, scene="a", width="wide")


class Tables(unittest.TestCase):
    def test_intervals_and_the_least(self):
        text = tables.latex(RUNS)
        rows = dict(re.findall(r"^(\w+(?:\\_\w+)*) & (.*) \\\\$", text, re.M))
        self.assertEqual(rows[r"slow\_good"], r"\textbf{0.010} {\footnotesize [0.008, 0.012]} & --")
        self.assertEqual(rows[r"fast\_bad"], r"0.050 {\footnotesize [0.040, 0.052]} & \textbf{0.020} {\footnotesize [0.010, 0.030]}")
        self.assertEqual(rows["failed"], "-- & --")
        self.assertEqual(text.count(r"\begin{"), text.count(r"\end{"))
        self.assertIn("% commit: abc\n", text)

    def test_what_cannot_be_told_apart_is_bold_too(self):
        runs = RUNS[RUNS.scene == "a"].assign(rmse_low=0.011)
        self.assertEqual(tables.latex(runs).count("textbf"), 3)

    def test_times_and_captions(self):
        text = tables.latex(RUNS, value="time_ms", digits=1, caption="Times.", label="tab:t")
        self.assertIn(r"1.0} {\footnotesize [0.9, 1.1]}", text)
        self.assertTrue(text.startswith("\\begin{table}\n\\centering\n\\caption{Times.}\n\\label{tab:t}\n"))

    def test_what_has_no_interval_is_refused(self):
        with self.assertRaisesRegex(um.InputError, r"'seed' has no interval here \(with one: rmse, time_ms\)"):
            tables.latex(RUNS, value="seed")
        with self.assertRaisesRegex(um.InputError, r"there is no column 'rsme' \(with an interval: rmse, time_ms\)"):
            tables.latex(RUNS, value="rsme")
        with self.assertRaisesRegex(um.InputError, "two runs are called 'fast_bad'"):
            tables.latex(pandas.concat([RUNS, RUNS[RUNS.label == "fast_bad"]]))


if __name__ == "__main__":
    unittest.main()
