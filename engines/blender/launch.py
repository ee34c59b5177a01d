#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""launch.py cycles|eevee: becomes a background Blender that speaks the protocol of docs/engines.md (serve.py).

Blender writes what it likes to standard output: answers go to a copy of it, whose number serve.py gets. EEVEE draws with
OpenGL and needs a display: where there is none, a virtual one is started, which ends with Blender.
"""
import ctypes
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys

SERVE = pathlib.Path(__file__).resolve().parent / "serve.py"
PR_SET_PDEATHSIG = 1


def give_up(sentence):
    print(json.dumps({"error": sentence}), flush=True)
    sys.exit(1)


def end_with_parent():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def start_display():
    """The name of a new X display without a screen to look at. RuntimeError: why there is none."""
    if shutil.which("Xvfb") is None:
        raise RuntimeError("EEVEE needs a display: install xvfb")
    reader, writer = os.pipe()
    subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "64x64x24", "-nolisten", "tcp"],
                     pass_fds=(writer,), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                     preexec_fn=end_with_parent)
    os.close(writer)
    number = os.read(reader, 64).decode().strip()
    if not number:
        raise RuntimeError("EEVEE needs a display, and Xvfb does not start")
    return ":" + number


def main():
    engine = sys.argv[1]
    blender = shutil.which("blender")
    if blender is None:
        give_up("Blender is not installed")
    if engine == "eevee":
        os.environ.pop("WAYLAND_DISPLAY", None)
        try:
            os.environ["DISPLAY"] = start_display()
        except RuntimeError as why:
            give_up(str(why))
        os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"
    answers = os.dup(1)
    os.set_inheritable(answers, True)
    os.dup2(2, 1)
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    os.environ["PATH"] = os.defpath  # Debian's Blender takes its modules from beside the first python3 there
    os.execv(blender, [blender, "-b", "--factory-startup", "-noaudio", "--python-exit-code", "9", "-P", str(SERVE), "--",
                       engine, str(answers)])


if __name__ == "__main__":
    main()
