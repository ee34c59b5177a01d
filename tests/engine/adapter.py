#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An adapter that draws nothing: a flat grey picture, or whatever misbehaviour a parameter asks for (docs/engines.md)."""
import json
import os
import pathlib
import struct
import sys
import time


def write_pfm(file, width, height, values):
    """`values`: one number, or one a pixel, bottom row first."""
    numbers = values if isinstance(values, list) else [values] * (width * height)
    file.write_bytes(f"Pf\n{width} {height}\n-1.0\n".encode() + struct.pack(f"<{len(numbers)}f", *numbers))


def say(answer):
    print(json.dumps(answer), flush=True)


def misbehave(kind, out, width, height):
    """True when nothing more is to be said."""
    if kind == "hang":
        time.sleep(3600)
    if kind == "crash":
        sys.exit("the driver is gone")
    if kind == "signal":
        os.abort()
    if kind == "garbage":
        print("<html>not JSON</html>", flush=True)
        return True
    if kind == "close":
        print("closing time", file=sys.stderr, flush=True)
        os.close(1)
        time.sleep(3600)
    if kind == "memory":
        held = bytearray(400 << 20)
        for i in range(0, len(held), 4096):
            held[i] = 1
        time.sleep(3600)
    if kind == "long_line":
        print("x" * (2 << 20), flush=True)
        return True
    if kind == "chatter":
        for _ in range(3000):
            print("a warning of the driver that nobody reads", file=sys.stderr)
    return False


def answer(request):
    width, height = request["width_px"], request["height_px"]
    parameters, out = request["parameters"], pathlib.Path(request["out"])
    kind = parameters["misbehave"]
    if misbehave(kind, out, width, height):
        return
    if kind == "error":
        return say({"id": request["id"], "error": "this light has no shadow in the engine"})
    if kind == "other_id":
        return say({"id": request["id"] + 1, "visibility": "v.pfm"})
    if kind == "escape":
        return say({"id": request["id"], "visibility": "../scenes/v.pfm"})
    if kind == "link":
        (out / "v.pfm").symlink_to("/etc/hostname")
        return say({"id": request["id"], "visibility": "v.pfm"})
    if kind == "missing":
        return say({"id": request["id"], "visibility": "v.pfm"})
    write_pfm(out / "v.pfm", width + (1 if kind == "size" else 0), height,
              float("nan") if kind == "nan" else parameters["shadow.grey"])
    if kind == "half":
        data = (out / "v.pfm").read_bytes()
        (out / "v.pfm").write_bytes(data[:len(data) // 2])
    if kind == "nothing":
        return say({"id": request["id"]})
    if kind == "pair":
        write_pfm(out / "lit.pfm", width, height, [0.25 * (i % 3) for i in range(width * height)])
        write_pfm(out / "unlit.pfm", width, height, [0.5 if i % 5 else 0.0 for i in range(width * height)])
        return say({"id": request["id"], "lit": "lit.pfm", "unlit": "unlit.pfm"})
    if kind == "rows":
        write_pfm(out / "v.pfm", width, height, [(i // width) / height for i in range(width * height)])
    times = {}
    if "timed_frames" in request:  # three at most: whoever wants more asks again
        frames = min(3, request["timed_frames"])
        times = {"frame_ms": ["soon"] if kind == "no_times" else [2.5] * frames, "timer": "a clock"}
    say({"id": request["id"], "visibility": "v.pfm", "warnings": ["seed %d" % request["seed"]], "memory_bytes": 4096,
         **times})


def main():
    start = pathlib.Path(os.environ["UMBRAMETER_ENGINE_FOLDER"], "start.txt")
    how = start.read_text().strip() if start.exists() else ""
    if how == "hang":
        time.sleep(3600)
    if how == "fail":
        sys.exit("no such device")
    if how == "error":
        return say({"error": "WebGL2 is not there"})
    say({"ready": True, "version": "test engine 1.2", "device": "no device", "is_software": True})
    for line in sys.stdin:
        answer(json.loads(line))


if __name__ == "__main__":
    main()
