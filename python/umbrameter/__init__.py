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
"""
from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Error, Frame as _CoreFrame, Image as _CoreImage, InputError, MachineError, Scene

__all__ = [
    "Error", "InputError", "MachineError", "Interval", "Picture", "Scene", "Score", "FAULTS", "__version__",
    "load_scene", "read", "render", "scenes", "score", "techniques", "truth",
]

__version__: str = _core.version
FAULTS: Tuple[str, ...] = _core.fault_names
"""Names of the values in Score.fault_map."""

FloatArray = npt.NDArray[np.float32]


class Interval(NamedTuple):
    """A value with its 95 % interval."""

    value: float
    low: float
    high: float


class Picture(Mapping[str, FloatArray]):
    """Named channels of one size: picture["visibility"] is an array [height, width] that shares the picture's memory and
    cannot be written."""

    def __init__(self, image: _CoreImage, frame: Optional[_CoreFrame] = None):
        self._image = image
        self._frame = frame

    @classmethod
    def from_arrays(cls, channels: Mapping[str, npt.ArrayLike]) -> "Picture":
        """A picture of your own: at least {"visibility": [height, width]}; with position.x/y/z, normal.x/y/z, primitive_id and
        unshadowed_irradiance its surfaces are compared with the truth's before anything is scored."""
        arrays = {name: np.asarray(values, dtype=np.float32) for name, values in channels.items()}
        if not arrays:
            raise InputError("a picture needs a channel")
        first_name, first = next(iter(arrays.items()))
        if first.ndim != 2:
            raise InputError(f"channel '{first_name}' has {first.ndim} dimensions, not rows and columns")
        image = _CoreImage(first.shape[1], first.shape[0])
        for name, values in arrays.items():
            image.set_plane(name, values)
        return cls(image)

    def __getitem__(self, channel: str) -> FloatArray:
        if channel not in self._image.channels:
            raise KeyError(channel)
        return self._image.plane(channel)

    def __iter__(self):
        return iter(self._image.channels)

    def __len__(self) -> int:
        return len(self._image.channels)

    @property
    def shape(self) -> Tuple[int, int]:
        """Height and width in pixels."""
        return self._image.height, self._image.width

    @property
    def metadata(self) -> Mapping[str, str]:
        """What the file's header says: scene, seed, device, version, commit, ..."""
        return self._image.metadata

    @property
    def device(self) -> str:
        """The renderer; empty when the picture was not rendered here."""
        return self._frame.device if self._frame else ""

    @property
    def parameters(self) -> Mapping[str, Union[bool, int, float, str]]:
        """Every parameter of the technique with the value that was used."""
        return self._frame.parameters if self._frame else {}

    @property
    def warnings(self) -> Sequence[str]:
        return self._frame.warnings if self._frame else []

    @property
    def wall_time_s(self) -> float:
        return self._frame.wall_time_s if self._frame else 0.0

    def write(self, file: Union[str, os.PathLike]) -> None:
        """Writes an EXR file of all channels, whole or not at all."""
        self._image.write(os.fspath(file))


@dataclass(frozen=True)
class Score:
    """How far a picture is from the truth. A number that could not be measured is None."""

    record: Mapping[str, Any] = field(repr=False)
    """Everything `umbrameter score --json` says (docs/results.md)."""
    fault_map: Optional[npt.NDArray[np.uint8]] = field(repr=False)
    """The class of every pixel, an index into FAULTS; None without diagnosis."""
    surfaces_agree: bool
    """Whether both renderers see the same surfaces; nothing is scored otherwise."""
    rmse: Optional[Interval]
    bias: Optional[float]
    """Mean error; positive is too bright."""
    worst_fault: Optional[str]

    def fault(self, name: str) -> Mapping[str, float]:
        """pixels, components (connected places) and mean_abs_error (part of the whole picture's) of a class of FAULTS."""
        if name not in FAULTS:
            raise InputError(f"no fault is called '{name}' (known: {', '.join(FAULTS)})")
        faults = self.record.get("faults")
        if faults is None:
            raise InputError("this score has no diagnosis")
        return faults["classes"][name]


def _data() -> str:
    return _core.data_folder()


def _library() -> str:
    return os.path.join(_data(), "scenes", "library")


def _assets(assets: Optional[str]) -> str:
    return assets if assets is not None else os.environ.get("UMBRAMETER_ASSETS", "")


def scenes(assets: Optional[str] = None) -> Sequence[Mapping[str, Any]]:
    """The scenes of the library: name, title, file and the model files that `assets` (default: UMBRAMETER_ASSETS) lacks."""
    return _core.list_scenes(_library(), _assets(assets))


def load_scene(name_or_path: Union[str, os.PathLike], assets: Optional[str] = None, light: str = "") -> Scene:
    """A scene of the library by name, or a scene file. One with several lights is seen under the `light` of that name or
    number."""
    return _core.load_scene(os.fspath(name_or_path), _library(), _assets(assets), light)


def techniques() -> Sequence[Mapping[str, Any]]:
    """The built-in techniques: id, title, summary, lights, parameters (with default, min, max, unit, doc) and presets."""
    return _core.list_techniques(_data())


def truth(scene: Scene, width: int = 480, height: int = 270, samples: int = 256, target_se: Optional[float] = None,
          seed: int = 1, threads: int = 0) -> Picture:
    """The ray traced truth. `samples` per pixel, a multiple of 8; with `target_se` sampling stops where the standard error of
    visibility is that small. 0 threads are all."""
    _require_size(width, height)
    if samples < 1:
        raise InputError(f"samples is {samples}, not at least 1")
    frame = _core.truth(scene, width, height, samples, target_se, seed, threads)
    return Picture(frame.image, frame)


def render(scene: Scene, technique: Union[str, os.PathLike], width: int = 480, height: int = 270, seed: int = 1,
           device: str = "", **parameters: Union[bool, int, float, str]) -> Picture:
    """A technique's picture. `technique` is "ID[:name=value,...]" or the path of a technique's folder; `parameters` set
    further values; preset="NAME" chooses a preset. Each thread has a GL context of its own."""
    _require_size(width, height)
    text = os.fspath(technique)
    values = dict(parameters)
    if not os.path.isdir(text) and ":" in text:
        text, assignments = text.split(":", 1)
        for assignment in assignments.split(","):
            name, equals, value = assignment.partition("=")
            if not equals:
                raise InputError(f"'{assignment}' is not name=value")
            if name in values:
                raise InputError(f"parameter '{name}' of '{text}' is given twice")
            values[name] = value
    frame = _core.render(scene, text, values, width, height, seed, _data(), device)
    return Picture(frame.image, frame)


def read(file: Union[str, os.PathLike]) -> Picture:
    """Any image file; channels as they are called there."""
    return Picture(_core.read_image(os.fspath(file)))


def score(picture: Union[Picture, npt.ArrayLike, Mapping[str, npt.ArrayLike]], truth: Picture, metrics: str = "",
          limit_rmse: Optional[float] = None, quantity: str = "visibility") -> Score:
    """Scores a picture's "visibility" against the truth's visibility, or with quantity="irradiance" against its irradiance
    ratio, which renderers that integrate the light yield. `picture` may be an array [height, width] or channels by name. `metrics`:
    comma-separated error, significance, verdict, diagnosis, similarity; empty is all."""
    if not isinstance(picture, Picture):
        picture = Picture.from_arrays(picture if isinstance(picture, Mapping) else {"visibility": picture})
    answer = _core.score(picture._image, truth._image, _core.eye_of(truth._image), metrics, limit_rmse,
                         quantity)
    record = json.loads(answer.json)
    error = record["error"]
    faults = record.get("faults")
    return Score(
        record=record,
        fault_map=answer.fault_map,
        surfaces_agree=record["parity"] is None or record["parity"]["passes"],
        rmse=Interval(**error["rmse"]) if error and error["rmse"] else None,
        bias=error["bias"] if error else None,
        worst_fault=faults["worst"] if faults else None,
    )


def _require_size(width: int, height: int) -> None:
    if not (1 <= width <= 16384 and 1 <= height <= 16384):
        raise InputError(f"{width} x {height} px is not between 1 x 1 and 16384 x 16384")
