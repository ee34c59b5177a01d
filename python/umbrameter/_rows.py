# SPDX-License-Identifier: Apache-2.0
"""Rows of data frames from the records' JSON. Columns are called as in `umbrameter export --csv`."""
from __future__ import annotations

from typing import Any, Dict, Iterable, Mapping, Optional

from ._score import METRICS

Row = Dict[str, Any]
Record = Mapping[str, Any]


def run_row(run: Record) -> Row:
    """A technique's entry of results.json."""
    error, faults, verdict = run["error"] or {}, run.get("faults") or {}, run.get("verdict") or {}
    row = {**identity(run), **interval("rmse", error.get("rmse")), **interval("mse", error.get("mse"))}
    measurements = run["measurements"] if "measurements" in run else _older_measurements(run)
    row.update({metric["key"]: measurements.get(metric["key"]) for metric in METRICS})
    row.update({f"fault.{name}": part["mean_abs_error"] for name, part in (faults.get("classes") or {}).items()})
    for name in ("noise_floor_mse", "scored_pixels"):
        row[name] = error.get(name)
    row.update({f"{region}.share": (error.get(region) or {}).get("share") for region in ("lit", "umbra", "penumbra")})
    row.update({"accepted_profiles": (run.get("penumbra") or {}).get("accepted"), "worst_fault": faults.get("worst")})
    row.update({**time_of_frame(run["pass_times"]), "timer": run["timer"], "baseline": verdict.get("baseline"),
                "verdict": verdict.get("outcome"), **interval("mse_difference", verdict.get("mse_difference")),
                "device": run["device"], "image": run["image_file"]})
    return {**row, **parameters(run)}


def _older_measurements(run: Record) -> Row:
    """Of files from before `measurements`, those numbers that have a place of their own."""
    error, penumbra, similarity = run["error"] or {}, run.get("penumbra") or {}, run.get("similarity") or {}
    values: Row = {**similarity, "rmse": (error.get("rmse") or {}).get("value"), "lit_rmse": run.get("lit_rmse"),
                   "contact_hardening_slope": (run.get("contact_hardening") or {}).get("slope"),
                   "memory_bytes": run.get("memory_bytes")}
    values.update({name: error.get(name) for name in ("bias", "mae", "max_error", "over_shadowing", "under_shadowing")})
    values.update({f"{region}.rmse": (error.get(region) or {}).get("rmse") for region in ("lit", "umbra", "penumbra")})
    values.update({name: (penumbra.get(name) or {}).get("median") for name in ("width_octaves", "offset_widths", "offset_world")})
    return values


def identity(run: Record) -> Row:
    return {"label": run["label"], "technique": run["technique"], "failure": (run["failure"] or {}).get("message", "")}


def context(record: Record) -> Row:
    names = ("width_px", "height_px", "samples_per_pixel", "target_se", "seed", "quality", "version", "commit")
    return {name: record[name] for name in names if name in record}


def parameters(run: Record) -> Row:
    return {f"parameter.{name}": value for name, value in run["parameters"].items()}


def interval(name: str, interval: Optional[Record]) -> Row:
    return {name + end: interval[key] if interval else None
            for end, key in (("", "value"), ("_low", "low"), ("_high", "high"))}


def time_of_frame(pass_times: Iterable[Record]) -> Row:
    """Of the whole frame, which comes last."""
    total: Record = (list(pass_times) or [{}])[-1]
    return {"time_ms": total.get("median_ms"), "time_mad_ms": total.get("mad_ms"), "frames": total.get("frames", 0)}


def baseline_times(record: Record) -> Row:
    return {"baseline_ms": time_of_frame(record["baseline_times"])["time_ms"]}


def plain(record: Record) -> Row:
    return {name: value for name, value in record.items() if not isinstance(value, (dict, list))}


def window_row(window: Record) -> Row:
    return {name: window[name] for name in ("parameter", "unit", "beside", "has_window", "is_complete", "tolerance")}


def case_row(record: Record, case: Record) -> Row:
    row = {"suite": record["suite"], **plain(case)}
    for when in ("before", "now"):
        row.update(interval(f"{when}_rmse", (case[when] or {}).get("rmse")))
    return row


def cell_row(record: Record, cell: Record) -> Row:
    axis = next(axis for axis in record["axes"] if axis["name"] == cell["axis"])
    return {**plain(cell), "value": axis["values"][cell["value"]], "unit": axis["unit"],
            "is_nominal": cell["value"] == axis["nominal"], **interval("rmse", cell["rmse"])}
