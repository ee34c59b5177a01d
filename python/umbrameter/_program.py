# SPDX-License-Identifier: Apache-2.0
"""The program `umbrameter` run for an answer: what plans many pictures is one verb there and one call here."""
from __future__ import annotations

import json
import os
import pathlib
import shutil
import signal
import subprocess
import warnings
from typing import Any, List, Mapping, Optional, Union

from . import _core
from ._core import Error, InputError, MachineError

Argument = Union[str, int, float, "os.PathLike[str]"]
PREFIX = "umbrameter: "
EXIT_GATE_FAILED, EXIT_BAD_INPUT, EXIT_ENVIRONMENT, EXIT_INTERRUPTED = 1, 2, 3, 130


def program_file() -> str:
    """The program that belongs to this module: of its build folder, of its prefix, or on PATH."""
    module = pathlib.Path(_core.file)
    beside = [folder / name / "umbrameter" for folder in module.parents[1:5] for name in ("cli", "bin")]
    for file in beside:
        if file.is_file() and os.access(file, os.X_OK):
            return str(file)
    found = shutil.which("umbrameter")
    if found is None:
        raise MachineError("the program 'umbrameter' is not there: install the package umbrameter, or put it on PATH")
    return found


def options(values: Mapping[str, Optional[Union[Argument, bool]]]) -> List[str]:
    """{"time_limit": "5s", "no_reuse": True} as --time-limit 5s --no-reuse; None and False are left out."""
    words: List[str] = []
    for name, value in values.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(_text(value))
    return words


def command(*arguments: Argument) -> Any:
    """Runs `umbrameter ARGUMENTS --json`, such as command("stress", "--technique", "pcss", "-o", "map"), and returns its
    answer. What the program warns of becomes a warning, what it refuses InputError, MachineError or Error with its own
    sentence. A gate that failed (exit code 1) is an answer, too. Ctrl-C stops the program, which leaves nothing half-written."""
    words = [program_file(), *(_text(argument) for argument in arguments), "--json"]
    # A group of its own: Ctrl-C reaches it once, from here.
    child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             start_new_session=True)
    try:
        answer, said = child.communicate()
    except BaseException:
        child.send_signal(signal.SIGINT)
        child.communicate()
        raise
    return _answer_of(child.returncode, answer, said)


def _text(argument: Argument) -> str:
    return os.fspath(argument) if isinstance(argument, os.PathLike) else str(argument)


def _answer_of(code: int, answer: str, said: str) -> Any:
    sentences = [line[len(PREFIX):] if line.startswith(PREFIX) else line for line in said.splitlines()]
    errors = [line[len("error: "):] for line in sentences if line.startswith("error: ")]
    if code == EXIT_INTERRUPTED:
        raise KeyboardInterrupt
    if code in (0, EXIT_GATE_FAILED) and answer.strip():
        for line in sentences:
            if line.startswith(("warning: ", "error: ")):
                warnings.warn(line.partition(": ")[2], stacklevel=4)
        return json.loads(answer)
    sentence = "; ".join(errors) or f"the program ended with {code}: {said.strip()[-500:]}"
    raise {EXIT_BAD_INPUT: InputError, EXIT_ENVIRONMENT: MachineError}.get(code, Error)(sentence)
