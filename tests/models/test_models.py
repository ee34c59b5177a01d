#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test_models.py SOURCE_DIR PROGRAM: get_models.sh with an npm of our own, its table in docs/models.md, and the models themselves
where npm has a network. Without it a changed package could become a model, or a broken download half of one.
Exit codes: 0 fine, 1 a check failed."""
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

SOURCE, PROGRAM = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SCRIPT = SOURCE / "scripts/get_models.sh"
TABLE = [line.split("\t") for line in (SOURCE / "scripts/models/models.tsv").read_text().splitlines() if not line.startswith("#")]
TRIANGLES = {"bunny": 3674, "dragon": 202520, "teapot": 992}


class ModelsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.at = pathlib.Path(folder.name)
        self.target = self.at / "models"
        (self.at / "bin").mkdir()

    def run_script(self, *words, path=None):
        environment = {**os.environ, "PATH": path or os.environ["PATH"]}
        return subprocess.run([shutil.which("bash"), str(SCRIPT), "-o", str(self.target), *words], env=environment,
                              capture_output=True, text=True)

    def with_npm(self, script):
        """A PATH whose npm runs `script`; $target is where packages go."""
        npm = self.at / "bin/npm"
        npm.write_text('#!/bin/sh\nwhile [ $# -gt 1 ]; do [ "$1" = --pack-destination ] && target=$2; shift; done\n' + script)
        npm.chmod(0o755)
        return f"{self.at / 'bin'}:{os.environ['PATH']}"

    def assert_nothing_written(self):
        self.assertEqual(list(self.target.glob("*")) + list(self.target.glob(".part-*")), [])

    def assert_one_sentence(self, done, code, words):
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(words, done.stderr)

    def test_the_page_has_the_table(self):
        page = (SOURCE / "docs/models.md").read_text()
        self.assertEqual([row[0] for row in TABLE], sorted(TRIANGLES))
        for name, package, version, checksum, _, _, licence in TABLE:
            row = next(line for line in page.splitlines() if line.startswith(f"| `{name}` |"))
            for fact in (f"{package} {version}", f"`{checksum}`", licence, f"{TRIANGLES[name]:,}"):
                self.assertIn(fact, row)

    def test_wrong_commands(self):
        self.assert_one_sentence(self.run_script(), 2, "name a model (there are bunny dragon teapot)")
        self.assert_one_sentence(self.run_script("cow"), 2, "there is no model 'cow'")
        self.assert_one_sentence(self.run_script("--fast", "bunny"), 2, "there is no option '--fast'")
        self.assert_nothing_written()

    def test_another_package_is_refused(self):
        with tarfile.open(self.at / "other.tgz", "w:gz") as archive:
            text = b"exports.positions=[[0,0,0],[1,0,0],[0,1,0]]\nexports.cells=[[0,1,2]]\n"
            entry = tarfile.TarInfo("package/index.js")
            entry.size = len(text)
            archive.addfile(entry, io.BytesIO(text))
        done = self.run_script("bunny", path=self.with_npm(f'cp {self.at / "other.tgz"} "$target/bunny-1.0.1.tgz"'))
        self.assert_one_sentence(done, 1, "bunny: bunny@1.0.1 has another checksum")
        self.assert_nothing_written()

    def test_no_network_and_no_npm(self):
        done = self.run_script("bunny", path=self.with_npm("echo 'npm ERR! network ENOTFOUND' >&2; exit 1"))
        self.assert_one_sentence(done, 1, "npm does not hand out bunny@1.0.1: npm ERR! network ENOTFOUND")
        self.assert_nothing_written()
        for program in ("awk", "cat", "grep", "paste", "dirname", "realpath", "sha256sum", "mkdir"):
            (self.at / "few").mkdir(exist_ok=True)
            (self.at / "few" / program).symlink_to(shutil.which(program))
        self.assert_one_sentence(self.run_script("bunny", path=str(self.at / "few")), 3, "npm is not there")

    def test_what_is_no_mesh_is_refused(self):
        convert = SOURCE / "scripts/models/to_obj.py"
        for text, words in (("exports.positions=[[0,0,0]];exports.cells=[[0,0,1]];", "a face refers to a vertex that is not there"),
                            ("exports.positions=[[0,0]];exports.cells=[[0,0,0]];", "a position has 2 numbers"),
                            ("exports.positions=[[0,0,evil()]];exports.cells=[[0,0,0]];", "could not convert string to float"),
                            ("while(1);", "it does not set exports.positions and exports.cells")):
            (self.at / "x.js").write_text(text)
            done = subprocess.run([sys.executable, convert, self.at / "x.js", self.at / "x.obj", "x"], capture_output=True, text=True)
            self.assert_one_sentence(done, 1, words)
            self.assertFalse((self.at / "x.obj").exists())

    def test_folders_in_their_places_are_refused(self):
        for name in ("teapot.obj", "teapot.toml"):
            (self.target / name).mkdir(parents=True)
            done = self.run_script("teapot", path=self.with_npm("exit 1"))
            self.assert_one_sentence(done, 1, f"{name} is a folder, where a file has to be")
            (self.target / name).rmdir()
            self.assert_nothing_written()

    def test_models_arrive_and_are_measured(self):
        done = self.run_script("bunny", "teapot", "dragon")
        if done.returncode != 0:
            self.skipTest(f"NOT CHECKED: {done.stderr.strip()}")
        self.assertEqual(sorted(path.name for path in self.target.iterdir()),
                         sorted(f"{name}.{ending}" for name in TRIANGLES for ending in ("obj", "toml")))
        before = {path: path.stat().st_mtime_ns for path in self.target.iterdir()}
        again = self.run_script("bunny", "teapot", "dragon", path=self.with_npm("exit 1"))  # npm is not asked
        self.assertEqual((again.returncode, again.stdout.count(": is there")), (0, 3), again.stderr)
        self.assertEqual(before, {path: path.stat().st_mtime_ns for path in self.target.iterdir()})
        for name, count in TRIANGLES.items():
            faces = sum(line.startswith("f ") for line in (self.target / f"{name}.obj").read_text().splitlines())
            self.assertEqual(faces, count)
            check = subprocess.run([PROGRAM, "scene", "check", self.target / f"{name}.toml"], capture_output=True, text=True)
            self.assertEqual(check.returncode, 0, check.stderr)
        # A scene file that is cut off or another's is put right, without npm, and kept beside it.
        whole = (SOURCE / "scripts/models/teapot.toml").read_text()
        for text in ("", whole[:len(whole) // 2]):
            (self.target / "teapot.toml").write_text(text)
            done = self.run_script("teapot", path=self.with_npm("exit 1"))
            self.assertEqual((done.returncode, done.stdout.count(": is there")), (0, 0), done.stderr)
            self.assertIn("teapot.toml was another one, and is now teapot.toml.old", done.stderr)
            self.assertEqual((self.target / "teapot.toml").read_text(), whole)
            self.assertEqual((self.target / "teapot.toml.old").read_text(), text)
        for old in self.target.glob("teapot.toml.old*"):
            old.unlink()
        # A mesh that was changed is brought again.
        (self.target / "teapot.obj").write_text("v 0 0 0\n")
        self.assertEqual(self.run_script("teapot").returncode, 0)
        self.assertEqual(before.keys(), {path: 0 for path in self.target.iterdir()}.keys())
        self.assertGreater((self.target / "teapot.obj").stat().st_size, 30000)


if __name__ == "__main__":
    sys.exit(0 if unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result.wasSuccessful() else 1)
