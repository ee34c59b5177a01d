#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test_window.py PROGRAM: the live window on an X server of its own (Xvfb), with scripts and with real keys and mouse (xdotool).
Without it a key could do nothing, the picture differ from what `render` draws, or closing leave a process behind.
Exit codes: 0 fine, 1 a check failed, 3 something is not installed."""
import contextlib
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else None
NEEDED = ("Xvfb", "xdotool", "oiiotool", "idiff")
WIDTH, HEIGHT = 320, 180
SWITCHES = 500  # at least
LEAK_MIB = 24  # what they may add after each technique was shown once; a leaked map of 2048^2 alone is 16


class Display:
    """An X server on a free display."""

    def __init__(self):
        read, write = os.pipe()
        self.process = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x1000x24", "-nolisten", "tcp"],
                                        pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as numbers:
            self.name = ":" + numbers.readline().strip()

    def close(self):
        self.process.terminate()
        self.process.wait()


def environment():
    return {**os.environ, "DISPLAY": WindowTest.display.name, "UMBRAMETER_ASSETS": ""}


def xdotool(*words):
    done = subprocess.run(["xdotool", *map(str, words)], env=environment(), capture_output=True, text=True, timeout=60)
    return done.stdout.strip()


class WindowTest(unittest.TestCase):
    display = None

    @classmethod
    def setUpClass(cls):
        WindowTest.display = Display()

    @classmethod
    def tearDownClass(cls):
        WindowTest.display.close()

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="umbrameter-view-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def arguments(self, *words):
        return [str(PROGRAM), "view", *words, "--width", str(WIDTH), "--height", str(HEIGHT), "--out", str(self.folder)]

    def run_program(self, *words, timeout=300):
        return subprocess.run([str(PROGRAM), *words], cwd=self.folder, env=environment(), capture_output=True, text=True,
                              timeout=timeout)

    def follow(self, script, *words, scene="plate"):
        """The report of a window that followed `script`."""
        (self.folder / "script.txt").write_text(script)
        done = subprocess.run([*self.arguments(scene, *words), "--script", "script.txt", "--json"], cwd=self.folder,
                              env=environment(), capture_output=True, text=True, timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    @contextlib.contextmanager
    def opened(self, *words, scene="plate"):
        """A window with the focus, and its X number."""
        process = subprocess.Popen(self.arguments(scene, *words), cwd=self.folder, env=environment(), stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        try:
            window = xdotool("search", "--sync", "--onlyvisible", "--name", "^Umbrameter: ").splitlines()[0]
            xdotool("windowfocus", "--sync", window)
            yield process, window
        finally:
            if process.poll() is None:
                process.kill()
            process.communicate()

    def wait_for(self, what, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            found = what()
            if found:
                return found
            time.sleep(0.05)
        self.fail(f"nothing after {seconds} s: {sorted(p.name for p in self.folder.iterdir())}")

    def saved(self, pattern):
        return self.wait_for(lambda: next(iter(sorted(self.folder.glob(pattern))), None))

    def size_of(self, picture):
        text = subprocess.run(["oiiotool", "--info", str(picture)], capture_output=True, text=True, check=True).stdout
        return tuple(map(int, re.search(r"(\d+) x +(\d+)", text).groups()))

    def assert_same_pictures(self, one, two):
        done = subprocess.run(["idiff", "-fail", "0", str(one), str(two)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)

    def render(self, scene, technique, preset):
        """What `render` says of the same state, as the window shows visibility: round(255 V) as grey."""
        done = self.run_program("render", scene, "--technique", technique, "--preset", preset, "--width", str(WIDTH), "--height",
                                str(HEIGHT), "--quality", "quick", "--out", "rendered.exr")
        self.assertEqual(done.returncode, 0, done.stderr)
        subprocess.run(["oiiotool", "rendered.exr", "--ch", "visibility,visibility,visibility", "--chnames", "R,G,B", "-d", "uint8",
                        "-o", "rendered.png"], cwd=self.folder, check=True)
        return self.folder / "rendered.png"

    def test_picture_is_what_render_draws_of_the_saved_state(self):
        self.follow("wait full\norbit 5\nset filter_taps 32\nlayout technique\nlayer visibility\nwait full\nframes 3\n"
                    "window window.png\npicture shown.png\nscene saved.toml\npreset saved.preset.toml\nframes 1\n",
                    scene="under_a_bulb")
        rendered = self.render("saved.toml", "pcss", "saved.preset.toml")
        # No background in this room, which the window would draw blue.
        self.assert_same_pictures(self.folder / "shown.png", rendered)
        below_label = f"{WIDTH}x{HEIGHT - 50}+0+50"  # the window writes times over its picture
        for name in ("window", "rendered"):
            subprocess.run(["oiiotool", f"{name}.png", "--crop", below_label, "--fullpixels", "-o", f"{name}-part.png"],
                           cwd=self.folder, check=True)
        self.assert_same_pictures(self.folder / "window-part.png", self.folder / "rendered-part.png")

    def pixels_of(self, picture):
        """Rows of (red, green, blue)."""
        plain = self.folder / "plain.ppm"
        subprocess.run(["oiiotool", str(picture), "--ch", "0,1,2", "-d", "uint8", "-o", str(plain)], check=True)
        _magic, width, _height, _most, rest = plain.read_bytes().split(maxsplit=4)
        pixels = list(zip(rest[0::3], rest[1::3], rest[2::3]))
        return [pixels[begin:begin + int(width)] for begin in range(0, len(pixels), int(width))]

    def test_another_scene_is_opened_as_if_it_were_the_first(self):
        self.follow("wait full\nset filter_taps 32\nlayer visibility\nlayout technique\nopen under_a_bulb\nwait full\nframes 2\n"
                    "picture opened.png\npreset opened.preset.toml\nscene opened.toml\nopen fence\nopen plate\nwait full\nframes 1\n")
        self.assertIn("filter_taps = 32\n", (self.folder / "opened.preset.toml").read_text())  # what means the same there stays
        self.assert_same_pictures(self.folder / "opened.png", self.render("under_a_bulb", "pcss", "opened.preset.toml"))
        self.assertIn('title = "Bulb in a room"', (self.folder / "opened.toml").read_text())

    def test_scene_that_is_none_leaves_the_one_that_is_shown(self):
        (self.folder / "script.txt").write_text("wait full\nopen no_such_scene\n")
        done = subprocess.run([*self.arguments("plate"), "--script", "script.txt"], cwd=self.folder, env=environment(),
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no_such_scene", done.stderr)

    def test_scenes_are_picked_with_the_mouse(self):
        with self.opened() as (process, window):
            xdotool("key", "F2")
            self.saved("plate-pcss-1.png")
            xdotool("mousemove", "--window", window, WIDTH + 150, 18)
            time.sleep(0.3)
            xdotool("click", 1)
            time.sleep(0.5)
            xdotool("mousemove", "--window", window, WIDTH + 150, 48)
            time.sleep(0.3)
            xdotool("click", 1)
            self.wait_for(lambda: xdotool("getwindowname", window) not in ("", "Umbrameter: plate"))
            name = xdotool("getwindowname", window).removeprefix("Umbrameter: ")
            xdotool("mousemove", "--window", window, WIDTH // 2, HEIGHT // 2)
            xdotool("key", "F2")
            self.saved(f"{name}-*-1.png")
            xdotool("key", "ctrl+q")
            self.assertEqual(process.wait(timeout=30), 0, process.stderr.read())

    def test_cascades_are_coloured(self):
        self.follow("wait full\nlayout technique\ntechnique hard_cascades\nwait full\npicture plain.png\nframes 1\n"
                    "key C\nwait full\nframes 5\npicture maps.png\nframes 1\n", scene="long_street")
        plain, coloured = (self.pixels_of(self.folder / name) for name in ("plain.png", "maps.png"))
        # .45 of the map's colour over .55 of the picture; Okabe and Ito's first four
        found = set()
        for row, (below, over) in enumerate(zip(plain, coloured)):
            for before, after in zip(below, over):
                for number, colour in enumerate(((230, 159, 0), (86, 180, 233), (0, 158, 115), (240, 228, 66))):
                    if all(abs(0.55 * b + 0.45 * c - a) <= 1 for b, c, a in zip(before, colour, after)):
                        found.add((number, row))
        rows = [[row for number, row in found if number == cascade] for cascade in range(3)]
        self.assertTrue(all(rows), f"cascades seen: {sorted({number for number, _row in found})}")
        # The first is nearest to the camera: lowest in a picture of a street.
        self.assertGreater(max(rows[0]), max(rows[1]))
        self.assertGreater(max(rows[1]), max(rows[2]))

    def test_frame_graph_times_every_pass_and_shows_its_textures(self):
        self.follow("technique pcss\nwait full\nunfold passes\nframes 3\nwait full\nframes 60\nwindow graph.png\n"
                    "layout resource\nframes 20\nwindow texture.png\nframes 1\n")
        graph, texture = (self.pixels_of(self.folder / name) for name in ("graph.png", "texture.png"))
        self.assertNotEqual([row[:WIDTH] for row in graph], [row[:WIDTH] for row in texture])

    def test_light_is_turned_by_a_drag_with_shift(self):
        with self.opened() as (process, window):
            xdotool("key", "ctrl+s")
            before = self.saved("plate-pcss-1.toml").read_text()
            xdotool("mousemove", "--window", window, WIDTH // 4, HEIGHT // 2)
            xdotool("keydown", "shift", "mousedown", 1)
            xdotool("mousemove_relative", "--sync", 40, 10)
            xdotool("mouseup", 1, "keyup", "shift")
            xdotool("key", "ctrl+s")
            after = self.saved("plate-pcss-2.toml").read_text()
            value = lambda key, text: re.search(rf"^{key} = (.*)$", text, re.M)[1]  # noqa: E731
            self.assertEqual(value("eye", before), value("eye", after))
            self.assertNotEqual(value("center", before), value("center", after))
            xdotool("key", "ctrl+q")
            self.assertEqual(process.wait(timeout=30), 0, process.stderr.read())

    def test_saved_study_runs(self):
        self.follow("wait full\nstudy saved.study.toml\nframes 1\n")
        done = self.run_program("plan", "saved.study.toml", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_truth_scores_and_faults_come(self):
        report = self.follow("wait full\nwait truth 0.02\nwait faults\nlayer faults\nframes 2\nwindow faults.png\nframes 1\n",
                             "--technique", "hard")
        self.assertLessEqual(report["truth_se_rms"], 0.02)
        # A hard shadow of a panel of .8 x .4 m is wrong all over its penumbra.
        self.assertGreater(report["rmse"], 0.05)
        self.assertEqual(self.size_of(self.folder / "faults.png"), (WIDTH + 400, HEIGHT))

    def test_path_is_played_to_its_end(self):
        self.follow("wait full\nkey R\norbit 10\nkey R\npath flight.path.toml\nscene end.toml\nkey HOME\n"
                    "play flight.path.toml\nscene played.toml\nframes 1\n")
        eyes = [re.search(r"^eye = (.*)$", (self.folder / name).read_text(), re.M)[1] for name in ("end.toml", "played.toml")]
        self.assertGreater((self.folder / "flight.path.toml").read_text().count("[[camera]]"), 1)
        end, played = ([float(number) for number in eye.strip("[]").split(",")] for eye in eyes)
        self.assertEqual(end, played)

    def test_real_keys_and_mouse(self):
        with self.opened() as (process, window):
            xdotool("key", "F2")
            first = self.saved("plate-pcss-1.png")
            self.assertEqual(self.size_of(first), (WIDTH, HEIGHT))
            xdotool("key", "Next")  # Page Down: the technique after pcss
            xdotool("key", "F2")
            after = self.saved("plate-pcss_*-1.png")
            xdotool("key", "Prior", "Prior")
            xdotool("key", "F2")
            before = self.saved("plate-pcf*-1.png")
            self.assertNotEqual(after.name, before.name)

            xdotool("key", "ctrl+s")
            still = self.saved("plate-pcf*-1.toml").read_text()
            xdotool("mousemove", "--window", window, WIDTH // 4, HEIGHT // 2)  # not on the divider
            xdotool("mousedown", 1)
            xdotool("mousemove_relative", "--sync", 60, 20)
            xdotool("mouseup", 1)
            xdotool("key", "ctrl+s")
            moved = self.saved("plate-pcf*-2.toml").read_text()
            eye, at = (re.compile(rf"^{key} = (.*)$", re.M) for key in ("eye", "at"))
            self.assertNotEqual(eye.search(still)[1], eye.search(moved)[1])
            self.assertEqual(at.search(still)[1], at.search(moved)[1])  # orbit keeps its target

            xdotool("mousemove", "--window", window, WIDTH + 200, HEIGHT // 2)  # the panel: scrolls, does not dolly
            xdotool("click", 5)
            xdotool("key", "space")  # the light comes to the camera
            xdotool("key", "ctrl+s")
            lit = self.saved("plate-pcf*-3.toml").read_text()
            self.assertEqual(eye.search(moved)[1], eye.search(lit)[1])
            self.assertEqual(re.search(r"^center = (.*)$", lit, re.M)[1], eye.search(lit)[1])

            xdotool("windowsize", "--sync", window, 900, 400)
            self.wait_for(lambda: self.resized())
            xdotool("key", "ctrl+q")
            self.assertEqual(process.wait(timeout=30), 0, process.stderr.read())

    def resized(self):
        xdotool("key", "F2")
        time.sleep(0.5)
        newest = max(self.folder.glob("plate-*.png"), key=lambda file: file.stat().st_mtime)
        return self.size_of(newest) == (500, 400)

    def test_shader_is_read_again_when_saved(self):
        home = PROGRAM.parent.parent / "share" / "umbrameter"
        own = self.folder / "mine"
        shutil.copytree(home / "realtime" / "techniques" / "hard", own)
        shader = next(own.glob("*.frag"))
        good = shader.read_text()
        (self.folder / "script.txt").write_text("wait full\npicture before.png\nframes 1\nwait problem\npicture broken.png\n"
                                                "frames 1\nwait full\npicture after.png\nframes 1\n")
        process = subprocess.Popen([*self.arguments("plate", "--technique", "./mine"), "--script", "script.txt", "--json"],
                                   cwd=self.folder, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            before = self.saved("before.png")
            shader.write_text(good + "\nno glsl;\n")
            broken = self.saved("broken.png")
            shader.write_text(good)
            out, err = process.communicate(timeout=120)
        finally:
            process.kill()
        self.assertEqual(process.returncode, 0, err)
        self.assertEqual(json.loads(out)["problem"], "")
        self.assert_same_pictures(before, broken)  # the last good one stays
        self.assert_same_pictures(before, self.folder / "after.png")

    def test_broken_shader_is_named_with_its_line(self):
        home = PROGRAM.parent.parent / "share" / "umbrameter"
        own = self.folder / "mine"
        shutil.copytree(home / "realtime" / "techniques" / "hard", own)
        shader = next(own.glob("*.frag"))
        shader.write_text(shader.read_text() + "\nno glsl;\n")
        line = shader.read_text().splitlines().index("no glsl;") + 1
        report = self.follow("wait problem\nframes 1\n", "--technique", "./mine")
        self.assertIn(f"{shader.name}:{line}", report["problem"])

    def test_many_switches_leak_nothing(self):
        techniques = len(json.loads(self.run_program("techniques", "list", "--json").stdout)["techniques"])
        switches = -(-SWITCHES // techniques) * techniques  # whole rounds: the same technique is shown before and after
        report = self.follow(f"wait full\nresize 464 64\nswitch {2 * techniques}\nmark\nswitch {switches}\n")
        self.assertEqual(report["switches"], 2 * techniques + switches)
        growth_mib = report["memory_last_mib"] - report["memory_first_mib"]
        print(f"{switches} switches: {report['memory_first_mib']:.0f} MiB before, {growth_mib:+.1f} MiB after", file=sys.stderr)
        self.assertLess(growth_mib, LEAK_MIB)

    def test_closing_at_any_moment_is_clean(self):
        moments = random.Random(1)
        for _ in range(12):
            with self.opened() as (process, _window):
                xdotool("keydown", "d")
                time.sleep(moments.uniform(0.0, 1.5))
                xdotool("keyup", "d")
                xdotool("key", "ctrl+q")
                self.assertEqual(process.wait(timeout=60), 0)
                self.assertEqual(process.stderr.read(), "")

    def test_signal_ends_it(self):
        with self.opened() as (process, _window):
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(timeout=30), 128 + signal.SIGTERM)

    def test_without_a_display_it_says_what_is_missing(self):
        done = subprocess.run(self.arguments("plate"), env={**environment(), "DISPLAY": ""}, capture_output=True, text=True,
                              timeout=60)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, r"^umbrameter: error: no window can be opened: .*display.*\n$")

    def test_bad_script_is_refused_at_its_line(self):
        (self.folder / "script.txt").write_text("wait full\nkay A\n")
        done = subprocess.run([*self.arguments("plate"), "--script", "script.txt"], cwd=self.folder, env=environment(),
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("script.txt:2: unknown command 'kay' (did you mean 'key'?)", done.stderr)


def main():
    missing = [name for name in NEEDED if shutil.which(name) is None]
    if missing:
        print(f"test_window: not installed: {', '.join(missing)}", file=sys.stderr)
        return 3
    probe = subprocess.run([PROGRAM, "view", "plate"], env={**os.environ, "DISPLAY": ""}, capture_output=True, text=True)
    if "built without its window" in probe.stderr:
        print(f"test_window: {probe.stderr.strip()}", file=sys.stderr)
        return 3
    return 0 if unittest.main(argv=[sys.argv[0], *sys.argv[2:]], exit=False, verbosity=2).result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
