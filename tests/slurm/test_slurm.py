#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""test_slurm.py SOURCE_DIR PROGRAM: scripts/slurm under a Slurm of its own on loopback: 8 shards, one killed, the merge
refused, submitted again, merged; every number equals a single sweep's. Then a list of tunings and a regression, whose answers are those of
the same commands alone. Without it a cluster's results could lack a shard in silence or differ from one machine's. Exit codes: 0 fine, 1 not, 3 no Slurm or no GL here."""
import getpass
import json
import os
import pathlib
import secrets
import shutil
import socket
import subprocess
import sys
import tempfile
import time

SHARDS = 8
STUDY = """schema = 1
title = "Cluster"
scenes = ["plate", "box_contact"]
width_px = 160
height_px = 90
samples_per_pixel = 256
[[run]]
label = "pcf {filter_width_texels}"
technique = "pcf"
[run.values]
filter_width_texels = [2, 3, 4, 5, 6, 7, 8, 9]
"""
TUNE = "tune {} --technique pcf --parameters filter_width_texels --evaluations 4 --time-limit 600s --cameras 1 --width 160 --height 90 --spp 64 --out tuned --json"
SUITE = """schema = 1
title = "Gate"
scenes = ["plate"]
width_px = 160
height_px = 90
samples_per_pixel = 64
[[run]]
label = "pcf"
technique = "pcf"
"""
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo")


class Missing(Exception):
    pass


def find(program):
    found = shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin:/sbin")
    if not found:
        raise Missing(f"{program} is not installed (packages slurm-wlm, munge)")
    return found


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Slurm:
    """The scheduler's own processes, with their files in `folder`."""

    def __init__(self, folder):
        self.folder, self.children = folder, []
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def start(self):
        for name in ("munge", "state", "spool"):
            (self.folder / name).mkdir(mode=0o755)
        munge = self.folder / "munge"
        key = munge / "key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        self.run(find("munged"), "--foreground", "--force", f"--key-file={key}", f"--socket={munge}/socket",
                 f"--pid-file={munge}/pid", f"--log-file={munge}/log", f"--seed-file={munge}/seed")
        self.wait("munged's socket", lambda: (munge / "socket").exists())
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
SlurmUser={getpass.getuser()}
SlurmdUser={getpass.getuser()}
AuthType=auth/munge
AuthInfo=socket={munge}/socket
StateSaveLocation={self.folder}/state
SlurmdSpoolDir={self.folder}/spool
SlurmctldPidFile={self.folder}/slurmctld.pid
SlurmdPidFile={self.folder}/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=test Nodes={host} Default=YES MaxTime=INFINITE State=UP
""")
        self.run(find("slurmctld"), "-D")
        self.run(find("slurmd"), "-D")
        self.wait("an idle node", lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"), 60)

    def run(self, *command):
        log = open(self.folder / (pathlib.Path(command[0]).name + ".log"), "w")
        self.children.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log))

    def stop(self):
        for child in reversed(self.children):
            child.terminate()
        for child in self.children:
            try:
                child.wait(20)
            except subprocess.TimeoutExpired:
                child.kill()

    def ask(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True).stdout

    def wait(self, what, is_there, seconds=30):
        end = time.monotonic() + seconds
        while not is_there():
            if time.monotonic() > end:
                logs = "\n".join(f"== {p.name}\n{p.read_text()[-2000:]}" for p in self.folder.glob("*.log"))
                raise Missing(f"Slurm does not work here: no {what} in {seconds} s\n{logs}")
            time.sleep(0.1)

    def jobs(self):
        return self.ask("squeue", "-h", "-r", "-o", "%i %T").split("\n")[:-1]


def submit(slurm, source, folder, program, *arguments):
    environment = {**slurm.environment, "UMBRAMETER": program, "UMBRAMETER_HOME": "", "UMBRAMETER_ASSETS": ""}
    run = subprocess.run(["bash", str(source / "scripts/slurm/submit.sh"), *arguments],
                         cwd=folder, env=environment, capture_output=True, text=True)
    print(run.stdout + run.stderr, end="", flush=True)
    assert run.returncode == 0, run.returncode
    return run.stdout


def kill_one(slurm, shards):
    """Ends a shard that runs; the number of one that was killed before it was done."""
    end = time.monotonic() + 300
    while time.monotonic() < end:
        for line in slurm.jobs():
            job, state = line.split()
            if "_" not in job or state != "RUNNING":
                continue
            shard = job.split("_")[1]
            if not (shards / shard).is_dir():
                continue  # not begun
            subprocess.run(["scancel", "--full", "--signal=KILL", job], env=slurm.environment, check=True)
            slurm.wait("end of the killed shard", lambda: not any(j.split()[0] == job for j in slurm.jobs()), 120)
            if not (shards / f"{shard}.done").exists():
                return int(shard)
        time.sleep(0.02)
    raise AssertionError("no shard could be killed before it was done")


def numbers(program, store):
    text = subprocess.run([program, "export", str(store), "--json"], check=True, capture_output=True, text=True).stdout
    runs = json.loads(text)["runs"]
    for run in runs:
        for key in ("started", "duration_s", "baseline_times"):
            run.pop(key, None)
        for key in ("wall_time_s", "pass_times"):
            run["result"].pop(key, None)
        run["result"]["measurements"].pop("time_ms", None)
    return runs


def best(answer):
    """What a tuning found, without what differs from run to run: times."""
    tuned = json.loads(answer)
    return {key: tuned[key] for key in ("scenes", "technique", "best") if key in tuned}


def test_commands(slurm, source, folder, program):
    (folder / "suite.toml").write_text(SUITE)
    run = lambda line, where: subprocess.run([program, *line.split()], cwd=where, check=True, capture_output=True, text=True).stdout
    run(f"regress record suite.toml --baseline {folder}/baselines", folder)
    lines = [TUNE.format("plate"), TUNE.format("box_contact"), f"regress check {folder}/suite.toml --baseline {folder}/baselines --json",
             "tune no_such_scene --technique pcf --out tuned"]
    (folder / "list.txt").write_text("\n".join(lines) + "\n")
    submit(slurm, source, folder, program, "-o", "many", "list.txt")
    slurm.wait("end of the commands", lambda: not slurm.jobs(), 600)
    many = folder / "many"
    summary = (many / "summary.txt").read_text().splitlines()
    assert [line.split()[0] for line in summary] == ["0", "0", "0", "not"], summary
    assert "no_such_scene" in (many / "logs/4.txt").read_text()
    again = submit(slurm, source, folder, program, "-o", "many", "list.txt")
    assert f"commands 4 of {len(lines)}" in again, again
    for i, line in enumerate(lines[:2], 1):
        alone = folder / f"alone{i}"
        alone.mkdir()
        theirs, ours = best((many / f"commands/{i}/answer.txt").read_text()), best(run(line, alone))
        assert theirs == ours and "best" in ours, (theirs, ours)
    check = json.loads((many / "commands/3/answer.txt").read_text())
    assert check["passes"] and check["pass"] == 1, check
    print("test_slurm: 2 tunings and a regression of a list equal those alone")


def test(slurm, source, folder, program):
    (folder / "study.toml").write_text(STUDY)
    results = folder / "results"
    sweep = ("-n", str(SHARDS), "-o", "results", "study.toml")
    submit(slurm, source, folder, program, *sweep)
    killed = kill_one(slurm, results / "shards")
    print(f"test_slurm: killed shard {killed}", flush=True)
    slurm.wait("end of the first jobs", lambda: not slurm.jobs(), 900)
    refusal = (results / "logs/merge.txt").read_text()
    assert f"shards {killed} are not done" in refusal, refusal
    assert not (results / "merged").exists()
    again = submit(slurm, source, folder, program, *sweep)
    assert f"shards {killed} of {SHARDS}" in again, again
    slurm.wait("end of the second jobs", lambda: not slurm.jobs(), 600)
    assert (results / "merged").exists(), (results / "logs/merge.txt").read_text()
    subprocess.run([program, "sweep", "study.toml", "--out", "single"], cwd=folder, check=True, capture_output=True)
    merged, single = numbers(program, results / "store"), numbers(program, folder / "single")
    assert len(single) == 16, len(single)
    assert merged == single, "the merged numbers differ from the single sweep's"
    print(f"test_slurm: {len(single)} runs of {SHARDS} shards equal the single sweep's")


def main():
    source, program = pathlib.Path(sys.argv[1]), os.path.abspath(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        slurm = Slurm(folder / "slurm")
        slurm.folder.mkdir(mode=0o755)
        try:
            for needed in PROGRAMS:
                find(needed)
            if subprocess.run([program, "doctor"], capture_output=True).returncode == 3:
                raise Missing("no usable GL")
            slurm.start()
        except Missing as missing:
            slurm.stop()
            print(f"test_slurm: SKIPPED: {missing}", file=sys.stderr)
            return 3
        try:
            test(slurm, source, folder, program)
            test_commands(slurm, source, folder, program)
        finally:
            slurm.stop()
    return 0


if __name__ == "__main__":
    sys.exit(main())
