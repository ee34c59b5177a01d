# SPDX-License-Identifier: Apache-2.0
"""Searches and studies: what draws many pictures runs in the program and comes back as data frames."""
from __future__ import annotations

import os
import pathlib
import tempfile
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional, Sequence, Union

from ._core import InputError, Scene
from ._frames import Frames, frames, frames_of
from ._picture import ParameterValue, Picture, read
from ._program import command, options
from ._score import Interval

if TYPE_CHECKING:
    import pandas

Path = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Tuning:
    """The best parameters of a technique on some scenes, and what they are worth."""

    record: Mapping[str, Any] = field(repr=False)
    """tune.json (docs/tuning.md)."""
    technique: str
    scenes: Sequence[str]
    parameters: Mapping[str, ParameterValue]
    """Every parameter; `render(scene, tuning.technique, **tuning.parameters)` draws with them."""
    ratio: float
    """Objective over the default's, mean over the cameras that were searched."""
    gains: Mapping[str, Optional[Interval]]
    """By default and preset: how much the tuned values are better on cameras that were held out, in ratios to the default's
    objective. None: a single camera."""
    preset: str = field(repr=False)
    """The text of a file for the program's --preset."""

    @property
    def trials(self) -> "pandas.DataFrame":
        """Every set that was tried, in order: `ratio`, `is_coarse`, `parameter.<name>`."""
        return frames_of(self.record).trials

    @property
    def windows(self) -> "pandas.DataFrame":
        """Safe windows of biases and light sizes, a row each."""
        return frames_of(self.record).windows


def tune(scenes: Union[str, Path, Iterable[Path]], technique: Path, *, out: Optional[Path] = None, objective: str = "rmse",
         parameters: Sequence[str] = (), time_limit: str = "60s", evaluations: Optional[int] = None, cameras: int = 5,
         width: Optional[int] = None, height: Optional[int] = None, samples: Optional[int] = None, light: str = "",
         **further: Union[bool, int, float, str]) -> Tuning:
    """Searches the parameters of `technique` ("ID[:name=value,...]") that make `objective` (rmse, penumbra, faults or a metric's key) least on
    all `scenes` under all their lights. `parameters` names what to tune; default: whatever does not count work. With `out` a folder keeps preset,
    record and truths. `further`: other options of the verb, such as no_coarse=True or grid=5."""
    names = [scenes] if isinstance(scenes, (str, os.PathLike)) else list(scenes)
    if not names:
        raise InputError("tuning needs a scene")
    chosen = options({"objective": objective, "parameters": ",".join(parameters) or None, "time_limit": time_limit,
                      "evaluations": evaluations, "cameras": cameras, "width": width, "height": height, "spp": samples,
                      "light": light or None, **further})
    with tempfile.TemporaryDirectory(prefix="umbrameter-") as scratch:
        folder = pathlib.Path(out if out is not None else scratch)
        record = command("tune", *names, "--technique", technique, "--together", *chosen, "--out", folder)
        preset = (folder / f"{record['technique']}.toml").read_text()
    return Tuning(
        record=record,
        technique=record["technique"],
        scenes=record["scenes"],
        parameters=record["best"]["parameters"],
        ratio=record["best"]["ratio"],
        gains={other["name"]: Interval(**other["held_out_gain"]) if other["held_out_gain"] else None
               for other in record["others"]},
        preset=preset,
    )


def sweep(study: Path, out: Path, *, shard: str = "", **further: Union[bool, int, float, str]) -> Frames:
    """Renders and scores every run of a study file into the store of `out`, which remembers them, and returns what is there.
    Stopped by Ctrl-C, the same call goes on. `shard` "i/n" does a part; `further`: options of the verb, such as time=True,
    width=96, spp=64."""
    command("sweep", study, *options({"shard": shard or None, **further}), "--out", out)
    return frames(out)


def bench(study: Path, **further: Union[bool, int, float, str]) -> Frames:
    """Times and scores every run of a study file, and judges its claims. `further`: options of the verb, such as width=96,
    frames=10, best_under="1ms"."""
    return frames_of(command("bench", study, *options(further)))


def check_engine(engine: Path) -> Mapping[str, Any]:
    """Starts an engine and lets it draw once for every type of light: version, device, and of each light what it becomes and
    whether its surfaces agree. MachineError when it is not installed."""
    return command("engines", "check", engine)


def render_engine(scene: Scene, request: str, width: int, height: int, seed: int, device: str) -> Picture:
    """An engine's picture of the scene's file; its warnings become Python's."""
    with tempfile.TemporaryDirectory(prefix="umbrameter-") as folder:
        file = pathlib.Path(folder) / "picture.exr"
        command("render", scene.file, "--technique", request, *options({
            "width": width, "height": height, "seed": seed, "device": device or None, "light": scene.light or None,
            "time": scene.time_s, "animation": scene.animation or None}), "--out", file)
        return read(file)
