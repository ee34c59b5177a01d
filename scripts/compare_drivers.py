#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""compare_drivers.py PROGRAM [PAGE]: the same runs on Mesa's llvmpipe and on zink over lavapipe (GL on Vulkan, on the CPU), against the
same truth; their RMSE must agree within LIMIT. With PAGE its table between the markers is written anew (docs/devices.md).
Exit codes: 0 fine, 1 a run differs by more, 3 one of the drivers is not here (packages libgl1-mesa-dri, mesa-vulkan-drivers)."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

LAVAPIPE = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json"
DRIVERS = {
    "llvmpipe": {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe"},
    "zink": {"LIBGL_ALWAYS_SOFTWARE": "1", "MESA_LOADER_DRIVER_OVERRIDE": "zink", "VK_ICD_FILENAMES": LAVAPIPE},
}
SCENES = ("plate", "contact_hardening")
# Not those of several maps in layers: they end lavapipe 22.3 (docs/devices.md).
TECHNIQUES = ("hard", "pcf", "pcf_sampler", "pcf_gather", "pcss", "pcss_vsm", "esm", "edge_mask", "penumbra_mask")
SIZE = ("--width", "160", "--height", "90", "--spp", "64", "--frames", "0")
LIMIT = 0.002  # of visibility: a tenth of what tells the best techniques apart
MARKERS = re.compile(r"(<!-- measured: scripts/compare_drivers.py writes from here -->\n).*?(<!-- to here -->)", re.S)


class Missing(Exception):
    pass


def environment(driver):
    return {**os.environ, **DRIVERS[driver], "UMBRAMETER_HOME": ""}


def run(program, driver, *arguments):
    done = subprocess.run([program, *arguments], env=environment(driver), capture_output=True, text=True)
    if done.returncode == 3:
        raise Missing(done.stderr.strip())
    if done.returncode != 0:
        raise SystemExit(f"compare_drivers: {driver}: {' '.join(arguments)} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def measure(program, driver, folder):
    techniques = [word for technique in TECHNIQUES for word in ("--technique", technique)]
    run(program, driver, "validate", *SCENES, *techniques, *SIZE, "--metrics", "error", "--out", folder)
    results = json.loads((pathlib.Path(folder) / "results.json").read_text())
    runs = {(scene["name"], one["label"]): one for scene in results["scenes"] for one in scene["techniques"] if one.get("error")}
    names = {one["device"] for one in runs.values()}
    if any((driver == "zink") != name.startswith("zink") for name in names):
        raise Missing(f"{driver} is asked for and {names} is there")
    return names.pop(), {key: one["error"]["rmse"]["value"] for key, one in runs.items()}


def table(rmse):
    lines = ["| scene | technique | RMSE, llvmpipe | RMSE, zink | difference |", "|---|---|---|---|---|"]
    for key, value in rmse["llvmpipe"].items():
        other = rmse["zink"][key]
        lines.append(f"| {key[0]} | {key[1]} | {value:.4f} | {other:.4f} | {other - value:+.1e} |")
    return "\n".join(lines)


def main():
    program = os.path.abspath(sys.argv[1])
    try:
        if not pathlib.Path(LAVAPIPE).exists():
            raise Missing("lavapipe is not installed (package mesa-vulkan-drivers)")
        with tempfile.TemporaryDirectory() as folder:
            measured = {driver: measure(program, driver, os.path.join(folder, driver)) for driver in DRIVERS}
    except Missing as missing:
        print(f"compare_drivers: SKIPPED: {missing}", file=sys.stderr)
        return 3
    devices, rmse = ({driver: one[i] for driver, one in measured.items()} for i in range(2))
    assert rmse["llvmpipe"].keys() == rmse["zink"].keys() and len(rmse["zink"]) == len(SCENES) * len(TECHNIQUES), rmse
    worst = max(rmse["zink"], key=lambda key: abs(rmse["zink"][key] - rmse["llvmpipe"][key]))
    difference = abs(rmse["zink"][worst] - rmse["llvmpipe"][worst])
    text = f"{devices['llvmpipe']}; {devices['zink']}. {len(rmse['zink'])} runs, the largest difference {difference:.1e} ({worst[1]} on {worst[0]})."
    print(table(rmse) + "\n\n" + text)
    if len(sys.argv) > 2:
        page = pathlib.Path(sys.argv[2])
        page.write_text(MARKERS.sub(lambda m: f"{m[1]}{table(rmse)}\n\n{text}\n{m[2]}", page.read_text()))
    if difference > LIMIT:
        print(f"compare_drivers: {worst}: {difference:.5f} is more than {LIMIT}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
