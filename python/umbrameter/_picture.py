# SPDX-License-Identifier: Apache-2.0
"""Pictures: named planes of one size."""
from __future__ import annotations

import os
from typing import Iterator, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._core import Frame as _CoreFrame, Image as _CoreImage, InputError, read_image

FloatArray = npt.NDArray[np.float32]
ParameterValue = Union[bool, int, float, str]


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

    def __iter__(self) -> Iterator[str]:
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
        """The renderer; empty when it is not known."""
        return self._frame.device if self._frame else self.metadata.get("device", "")

    @property
    def parameters(self) -> Mapping[str, ParameterValue]:
        """Every parameter of the technique with the value that was used; empty when the picture was not rendered here."""
        return self._frame.parameters if self._frame else {}

    @property
    def warnings(self) -> Sequence[str]:
        """What the renderer warned of."""
        return self._frame.warnings if self._frame else []

    @property
    def wall_time_s(self) -> float:
        """Seconds that rendering took, with everything around it; 0 when the picture was not rendered here."""
        return self._frame.wall_time_s if self._frame else 0.0

    def write(self, file: Union[str, os.PathLike[str]]) -> None:
        """Writes an EXR file of all channels, whole or not at all."""
        self._image.write(os.fspath(file))


def read(file: Union[str, os.PathLike[str]]) -> Picture:
    """Any image file; channels as they are called there."""
    return Picture(read_image(os.fspath(file)))
