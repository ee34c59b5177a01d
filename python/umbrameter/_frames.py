# SPDX-License-Identifier: Apache-2.0
"""What verbs leave in folders, as pandas data frames."""
from __future__ import annotations

import json
import os
import pathlib
import sqlite3
import warnings
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Tuple, Union

from ._core import InputError, MachineError
from ._rows import Record, Row, baseline_times, case_row, cell_row, context, interval, parameters, plain, run_row, window_row

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True, repr=False)
class Frames:
    """Data frames, empty where nothing was found. Columns are called as in `umbrameter export --csv` and docs/results.md; an
    interval `x` has `x_low` and `x_high`; what was not measured is NaN or None."""

    runs: "pandas.DataFrame"
    """Of `validate`, `sweep` and `bench`: a row a scene and run, with errors, those of regions (`penumbra.rmse`, ...),
    `fault.<class>` (mean absolute error), `parameter.<name>`, times and context."""
    references: "pandas.DataFrame"
    """Of `validate` and `sweep`: a row a truth."""
    claims: "pandas.DataFrame"
    """Of `bench`: a row a scene and claim, the paper's ratio beside ours, and the verdict."""
    candidates: "pandas.DataFrame"
    """Of `tune`: tuned, default and presets, with ratios to the default and the tuned values' gain."""
    trials: "pandas.DataFrame"
    """Of `tune`: every set of values that was tried, in order."""
    windows: "pandas.DataFrame"
    """Of `tune`: safe windows of biases (texels) and light sizes (scale)."""
    cases: "pandas.DataFrame"
    """Of `regress check`: a row a case, before and now."""
    cells: "pandas.DataFrame"
    """Of `stress`: a row an axis, technique and value."""

    def __repr__(self) -> str:
        sizes = (f"{part.name} {len(getattr(self, part.name))}" for part in fields(self))
        return f"Frames(rows: {', '.join(sizes)})"


def frames(folder: Union[str, "os.PathLike[str]"]) -> Frames:
    """The records that any verb left in `folder`: results.json (`validate`), else the store (`sweep`), and bench*.json,
    tune*.json, regress*.json and stress*.json. Of a run that was stored several times the newest counts."""
    place = pathlib.Path(folder)
    if not place.is_dir():
        raise InputError(f"the folder '{place}' is not there")
    tables = _Tables()
    files = [file for stem in ("results", "bench", "tune", "regress", "stress") for file in sorted(place.glob(f"{stem}*.json"))]
    for file in files:
        try:
            tables.add(json.loads(file.read_text()))
        except InputError as error:
            raise InputError(f"{file}: {error}") from None
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise InputError(f"{file}: no record of any verb ({type(error).__name__}: {error})") from None
    store = place / "store.sqlite"
    if store.is_file() and not (place / "results.json").is_file():
        _add_store(store, tables)
    elif not files:
        raise InputError(f"the folder '{place}' holds no record of any verb")
    return tables.frames()


def frames_of(record: Record) -> Frames:
    """The same of one record, such as command() returns."""
    tables = _Tables()
    tables.add(record)
    return tables.frames()


def require_pandas() -> Any:
    try:
        import pandas
    except ImportError:
        raise MachineError("data frames need pandas, which is not installed (Debian: python3-pandas)") from None
    return pandas


# Verb, a key that only it writes, and the schema that is read (results/json/schemas.h).
SCHEMAS = (("validate", "parity_passes", 4), ("bench", "wanted_frames", 2), ("tune", "coarse_trials", 1), ("regress", "cases", 1),
           ("stress", "cells", 1))


class _Tables:
    """Rows by frame, until they are frames."""

    def __init__(self) -> None:
        self.rows: Dict[str, List[Row]] = {part.name: [] for part in fields(Frames)}

    def add(self, record: Record) -> None:
        """A record is known by the keys that only its verb writes."""
        _require_schema(record)
        if "studies" in record:
            for study in record["studies"]:
                self.add(study)
        elif "wanted_frames" in record:
            self._add_bench(record)
        elif "parity_passes" in record:
            self._add_results(record)
        elif "coarse_trials" in record:
            self._add_tune(record)
        elif "cases" in record:
            self.rows["cases"] += [case_row(record, case) for case in record["cases"]]
        elif "cells" in record:
            self.rows["cells"] += [cell_row(record, cell) for cell in record["cells"]]
        else:
            raise KeyError("its keys are " + ", ".join(list(record)[:5]))

    def _add_results(self, record: Record) -> None:
        for scene in record["scenes"]:
            head = {"scene": scene["name"], "camera": "", "scene_hash": scene["hash"], "light": scene["light"]["type"],
                    "quantity": scene["quantity"], **context(record)}
            if scene["reference"]:
                self.rows["references"].append({**head, **plain(scene["reference"])})
            for run in scene["techniques"]:
                self.rows["runs"].append({**head, **run_row(run)})

    def _add_bench(self, record: Record) -> None:
        for scene in record["scenes"]:
            head = {"scene": scene["scene"], "camera": scene["camera"], "scene_hash": scene["hash"], "light": scene["light"],
                    **context(record), "study": record["title"]}
            for run in scene["runs"]:
                times = interval("time_ms", run["time_ms"])
                times = {"time_ms": times["time_ms"], "time_low": times["time_ms_low"], "time_high": times["time_ms_high"]}
                self.rows["runs"].append({**head, **run_row(run), "seed": run["seed"], **times, "is_on_front": run["is_on_front"],
                                          "is_software": run["is_software"]})
            for claim in scene["claims"]:
                paper = claim["paper"]
                self.rows["claims"].append({**head, **plain(claim), "paper_low": paper["low"], "paper_high": paper["high"],
                                            **interval("ours", claim["ours"])})

    def _add_tune(self, record: Record) -> None:
        head = {"scenes": ", ".join(record["scenes"]), "technique": record["technique"], "objective": record["objective"]}
        for one in (record["best"], *record["others"]):
            self.rows["candidates"].append({**head, "name": one["name"], "same_cost": one["same_cost"], "ratio": one["ratio"],
                                            "held_out_ratio": one["held_out_ratio"], **interval("gain", one["gain"]),
                                            **interval("held_out_gain", one["held_out_gain"]), **parameters(one)})
        for is_coarse, key in ((True, "coarse_trials"), (False, "trials")):
            for trial in record[key]:
                self.rows["trials"].append({**head, "is_coarse": is_coarse, "ratio": trial["ratio"], **parameters(trial)})
        for window in record["bias_sweep"]:
            ends = [(window[name] or {}).get("texels") for name in ("acne_free_from", "peter_pan_free_to")]
            self.rows["windows"].append({**head, **window_row(window), "from": ends[0], "to": ends[1]})
        for window in record["light_size_sweep"]:
            self.rows["windows"].append({**head, **window_row(window), "from": window["hard_free_from"], "to": window["soft_free_to"]})

    def frames(self) -> Frames:
        pandas = require_pandas()
        return Frames(**{name: _parameters_last(pandas.DataFrame(rows)) for name, rows in self.rows.items()})


def _require_schema(record: Record) -> None:
    for verb, key, schema in SCHEMAS:
        if key in record and record.get("schema") != schema:
            raise InputError(f"{verb} of schema {record.get('schema')}; this version reads {schema} (run 'umbrameter {verb}' again)")


def _parameters_last(frame: "pandas.DataFrame") -> "pandas.DataFrame":
    return frame[sorted(frame, key=lambda name: name.startswith("parameter."))] if len(frame.columns) else frame


def _add_store(file: pathlib.Path, tables: _Tables) -> None:
    """Of entries that a person would call the same (results/json/export.cpp) the one that was started last."""
    newest: Dict[Tuple[Any, ...], Tuple[str, Row]] = {}
    foreign = 0
    for kind, text in _entries(file):
        try:
            record = json.loads(text)
            head = {key: record[key] for key in ("scene", "camera", "scene_hash", "light", "width_px", "height_px",
                                                 "samples_per_pixel", "target_se", "seed", "status", "commit", "started",
                                                 "duration_s")}
            if kind == "run":
                table, row = "runs", {**head, **run_row(record["result"]), **baseline_times(record)}
                same = (row["technique"], json.dumps(record["result"]["parameters"], sort_keys=True))
            else:
                table, row, same = "references", {**head, **plain(record["result"])}, ()
        except (ValueError, KeyError, TypeError):
            foreign += 1
            continue
        key = (table, *same, *(head[name] for name in ("scene", "camera", "light", "width_px", "height_px",
                                                       "samples_per_pixel", "target_se", "seed")))
        if key not in newest or newest[key][0] < row["started"]:
            newest[key] = (row["started"], row)
    for (table, *_), (_, row) in newest.items():
        tables.rows[table].append(row)
    for table in ("runs", "references"):
        tables.rows[table].sort(key=lambda row: (row["scene"], row["camera"], row.get("label", ""), row["seed"]))
    if foreign:
        warnings.warn(f"{file}: {foreign} entries of another version were left out", stacklevel=3)


def _entries(file: pathlib.Path) -> Iterable[Tuple[str, str]]:
    try:
        database = sqlite3.connect(f"{file.resolve().as_uri()}?mode=ro", uri=True)
        try:
            return database.execute("SELECT kind, json FROM entries WHERE kind IN ('run', 'reference')").fetchall()
        finally:
            database.close()
    except sqlite3.Error as error:
        raise InputError(f"{file}: {error}") from None
