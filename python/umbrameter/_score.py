# SPDX-License-Identifier: Apache-2.0
"""How far a picture is from the truth: numbers, faults and penumbrae."""
from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import InputError
from ._picture import Picture

FAULTS: Tuple[str, ...] = _core.fault_names
"""Names of the values in Score.fault_map."""
METRICS: Sequence[Mapping[str, Any]] = json.loads(_core.metrics)
PROFILE_OUTCOMES: Tuple[str, ...] = _core.profile_outcomes
"""Names of the values in the field `outcome` of Score.profiles(): `accepted`, and the causes of rejection."""


class Interval(NamedTuple):
    """A value with its 95 % interval."""

    value: float
    low: float
    high: float


class Walk(NamedTuple):
    """Pixels across a penumbra, from dark to light."""

    rows: npt.NDArray[np.int32]
    columns: npt.NDArray[np.int32]
    distance_world: npt.NDArray[np.float64]
    """Along the receiver, 0 at the pixel that was asked for."""


@dataclass(frozen=True)
class Score:
    """How far a picture is from the truth. A number that could not be measured is None."""

    record: Mapping[str, Any] = field(repr=False)
    """Everything `umbrameter score --json` says (docs/results.md)."""
    fault_map: Optional[npt.NDArray[np.uint8]] = field(repr=False)
    """The class of every pixel, an index into FAULTS; None without diagnosis."""
    scored: Optional[npt.NDArray[np.uint8]] = field(repr=False)
    """1 where the pixel counts; None when the surfaces disagree."""
    surfaces_agree: bool
    """Whether both renderers see the same surfaces; nothing is scored otherwise."""
    rmse: Optional[Interval]
    bias: Optional[float]
    """Mean error; positive is too bright."""
    worst_fault: Optional[str]
    _picture: Picture = field(repr=False, compare=False)
    _truth: Picture = field(repr=False, compare=False)

    def fault(self, name: str) -> Mapping[str, float]:
        """pixels, components (connected places) and mean_abs_error (part of the whole picture's) of a class of FAULTS."""
        if name not in FAULTS:
            raise InputError(f"no fault is called '{name}' (known: {', '.join(FAULTS)})")
        faults = self.record.get("faults")
        if faults is None:
            raise InputError("this score has no diagnosis")
        return faults["classes"][name]

    @property
    def faults(self) -> Mapping[str, Mapping[str, float]]:
        """fault() of every class by name, the largest part of the error first."""
        parts = {name: self.fault(name) for name in FAULTS}
        return dict(sorted(parts.items(), key=lambda item: -item[1]["mean_abs_error"]))

    def profiles(self) -> npt.NDArray[Any]:
        """Every penumbra profile, a structured array that pandas.DataFrame takes: pixel `x`, `y`; `outcome`, an index into
        PROFILE_OUTCOMES; `is_partial`; `reference_width_px`, `reference_width_world`, `test_width_world`, `width_octaves`
        (log2 of test / true width) and `offset_world`. The last three are 0 unless accepted. Measured anew at each call."""
        return _core.profiles(*self._pair())

    def walk(self, x: int, y: int) -> Walk:
        """The pixels across the penumbra at pixel (x, y) along the true visibility's ascent, until both pictures have
        reached full light and full shadow, or the surface ends. InputError where there is no penumbra."""
        pixels, distance = _core.walk(*self._pair(), x, y)
        return Walk(pixels[:, 0], pixels[:, 1], distance)

    def _pair(self) -> Tuple[_core.Image, _core.Image, npt.NDArray[np.uint8], str]:
        if self.scored is None:
            raise InputError("nothing was scored: the renderers see different surfaces")
        return self._picture._image, self._truth._image, self.scored, self.record["quantity"]


def score(picture: Union[Picture, npt.ArrayLike, Mapping[str, npt.ArrayLike]], truth: Picture, metrics: str = "",
          limit_rmse: Optional[float] = None, quantity: str = "visibility") -> Score:
    """Scores a picture's "visibility" against the truth's visibility, or with quantity="irradiance" against its irradiance
    ratio, which renderers that integrate the light yield. `picture` may be an array [height, width] or channels by name. `metrics`:
    comma-separated error, significance, verdict, diagnosis, similarity; empty is all."""
    if not isinstance(picture, Picture):
        picture = Picture.from_arrays(picture if isinstance(picture, Mapping) else {"visibility": picture})
    answer = _core.score(picture._image, truth._image, _core.eye_of(truth._image), metrics, limit_rmse, quantity)
    record = json.loads(answer.json)
    error = record["error"]
    faults = record.get("faults")
    return Score(
        record=record,
        fault_map=answer.fault_map,
        scored=answer.scored,
        surfaces_agree=record["parity"] is None or record["parity"]["passes"],
        rmse=Interval(**error["rmse"]) if error and error["rmse"] else None,
        bias=error["bias"] if error else None,
        worst_fault=faults["worst"] if faults else None,
        _picture=picture,
        _truth=truth,
    )
