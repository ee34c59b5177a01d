#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""run_notebooks.py FOLDER [OUT]: runs every notebook of FOLDER in an empty place of its own, with this Python; a cell that raises,
an assertion among them, fails. OUT keeps the notebooks with what they showed. Without it the first page that a researcher copies
could be wrong. Exit codes: 0 fine, 1 one fails, 3 nbclient is not installed."""
import pathlib
import sys
import tempfile
import time

try:
    import ipykernel  # noqa: F401
    import nbclient
    import nbformat
    from jupyter_client import KernelManager
except ImportError as error:
    print(f"run_notebooks: {error} (packages python3-nbclient, python3-ipykernel): nothing was run", file=sys.stderr)
    sys.exit(3)

LEAST = 4


def run(file, out):
    """None, or what is wrong."""
    notebook = nbformat.read(file, as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    if any(cell.outputs or cell.execution_count for cell in code):
        return "holds outputs; clear them"
    if not any("assert " in cell.source for cell in code):
        return "asserts nothing"
    with tempfile.TemporaryDirectory() as place:
        manager = KernelManager(kernel_name="python3")
        manager.kernel_spec.argv[0] = sys.executable
        client = nbclient.NotebookClient(notebook, km=manager, timeout=300, resources={"metadata": {"path": place}})
        try:
            client.execute()
        except nbclient.exceptions.CellExecutionError as error:
            return str(error)
    if out is not None:
        nbformat.write(notebook, out / file.name)
    return None


def main():
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.ipynb"))
    out = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    problems = 0
    for file in files:
        start = time.monotonic()
        problem = run(file, out)
        print(f"{file.name}: {problem or 'fine'} ({time.monotonic() - start:.1f} s)", flush=True)
        problems += problem is not None
    if len(files) < LEAST:
        print(f"only {len(files)} notebooks in {sys.argv[1]}", file=sys.stderr)
        return 1
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
