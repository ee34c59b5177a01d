# SPDX-License-Identifier: Apache-2.0
"""Umbrameter: how wrong a real-time shadow is, why, and what it costs.

    import umbrameter as um
    scene = um.load_scene("plate")
    truth = um.truth(scene, width=160, height=90)
    picture = um.render(scene, "pcss:filter_taps=64", width=160, height=90)
    score = um.score(picture, truth)
    print(score.rmse, score.worst_fault)

Pictures are numpy arrays of 32-bit floats, row 0 on top. Work in C++ runs without Python's lock and stops at Ctrl-C.
What the user did wrong is InputError, what the machine lacks is MachineError; both say the same sentence as the program.
Figures and LaTeX tables for papers are in umbrameter.figures (matplotlib) and umbrameter.tables.
"""
from __future__ import annotations

import os
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._core import Error, InputError, MachineError, Scene
from ._frames import Frames, frames
from ._picture import ParameterValue, Picture, read
from ._program import command
from ._score import FAULTS, METRICS, PROFILE_OUTCOMES, Interval, Score, Walk, score
from ._searches import Tuning, bench, check_engine, render_engine as _render_engine, sweep, tune

__all__ = [
    "Error", "InputError", "MachineError", "Frames", "Interval", "Picture", "Scene", "Score", "Tuning", "Walk", "FAULTS",
    "PROFILE_OUTCOMES", "__version__", "bench", "check_engine", "command", "engines", "frames", "load_scene", "metrics", "read", "render",
    "scenes", "score", "sweep", "techniques", "truth", "tune",
]

__version__: str = _core.version

Path = Union[str, "os.PathLike[str]"]


def scenes(assets: Optional[str] = None) -> Sequence[Mapping[str, Any]]:
    """The scenes of the library: name, title, file and the model files that `assets` (default: UMBRAMETER_ASSETS) lacks."""
    return _core.list_scenes(_library(), _assets(assets))


def load_scene(name_or_path: Path, assets: Optional[str] = None, light: str = "", time_s: Optional[float] = None,
               animation: str = "") -> Scene:
    """A scene of the library by name, or a scene file. One with several lights is seen under the `light` of that name or
    number. With `time_s` its animated meshes stand where the `animation` of that name or number, else the first, has them then."""
    scene = _core.load_scene(os.fspath(name_or_path), _library(), _assets(assets), light, time_s, animation)
    scene.time_s, scene.animation = time_s, animation
    return scene


def techniques() -> Sequence[Mapping[str, Any]]:
    """The built-in techniques: id, title, summary, lights, parameters (with default, min, max, unit, doc) and presets."""
    return _core.list_techniques(_core.data_folder())


def metrics() -> Sequence[Mapping[str, Any]]:
    """Every number that a run is given: key, label, group, unit, better (lower, higher, nearest_zero, nearest_one), form and doc.
    Columns of frames().runs and `record["measurements"]` of a score are called by their keys."""
    return [dict(metric) for metric in METRICS]


def engines() -> Sequence[Mapping[str, Any]]:
    """Other renderers that render() takes: id, title, summary, quantity, lights (and what becomes of each), parameters, presets,
    known_failures, and `missing`: what scripts/install_engines.sh has yet to install; empty when it can run."""
    return _core.list_engines(*_engine_places())


def truth(scene: Scene, width: int = 480, height: int = 270, samples: int = 256, target_se: Optional[float] = None,
          seed: int = 1, threads: int = 0) -> Picture:
    """The ray traced truth. `samples` per pixel, a multiple of 8; with `target_se` sampling stops where the standard error of
    visibility is that small. 0 threads are all."""
    _require_size(width, height)
    if samples < 1:
        raise InputError(f"samples is {samples}, not at least 1")
    frame = _core.truth(scene, width, height, samples, target_se, seed, threads)
    return Picture(frame.image, frame)


def render(scene: Scene, technique: Path, width: int = 480, height: int = 270, seed: int = 1, device: str = "",
           **parameters: ParameterValue) -> Picture:
    """A technique's or an engine's picture. `technique` is "ID[:name=value,...]" or the path of a folder; `parameters` set
    further values; preset="NAME" chooses a preset. Each thread has a GL context of its own. An engine is started for each
    picture, and draws the scene's file."""
    _require_size(width, height)
    name, values = _split(os.fspath(technique), parameters)
    if _core.is_engine(name, *_engine_places()):
        assignments = ",".join(f"{key}={_word(value)}" for key, value in values.items())
        return _render_engine(scene, f"{name}:{assignments}" if values else name, width, height, seed, device)
    frame = _core.render(scene, name, values, width, height, seed, _core.data_folder(), device)
    return Picture(frame.image, frame)


def _split(text: str, parameters: Mapping[str, ParameterValue]) -> Tuple[str, Dict[str, ParameterValue]]:
    """"ID:name=value,..." and further values."""
    values = dict(parameters)
    if os.path.isdir(text) or ":" not in text:
        return text, values
    name, assignments = text.split(":", 1)
    for assignment in assignments.split(","):
        key, equals, value = assignment.partition("=")
        if not equals:
            raise InputError(f"'{assignment}' is not name=value")
        if key in values:
            raise InputError(f"parameter '{key}' of '{name}' is given twice")
        values[key] = value
    return name, values


def _word(value: ParameterValue) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _library() -> str:
    return os.path.join(_core.data_folder(), "scenes", "library")


def _assets(assets: Optional[str]) -> str:
    return assets if assets is not None else os.environ.get("UMBRAMETER_ASSETS", "")


def _engine_places() -> Tuple[str, str]:
    folder = os.path.join(_core.data_folder(), "engines")
    return folder, os.environ.get("UMBRAMETER_ENGINES") or os.path.join(folder, "installed")


def _require_size(width: int, height: int) -> None:
    if not (1 <= width <= 16384 and 1 <= height <= 16384):
        raise InputError(f"{width} x {height} px is not between 1 x 1 and 16384 x 16384")
