# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Executes the notebook of the examples, with the module that this Python has: test_wheel has installed it."""

import importlib.util
import os
import subprocess
import sys
import tempfile
from pathlib import Path

NOTEBOOK = Path(__file__).resolve().parent / "examples/first_steps.ipynb"


def main():
    for name in ("nbconvert", "ipykernel", "matplotlib"):
        if importlib.util.find_spec(name) is None:
            print(f"skipped: the notebook, as {name} (Debian: jupyter-nbconvert, python3-ipykernel, python3-matplotlib) was not found")
            return int("CI" in os.environ)
    module = Path(importlib.util.find_spec("delaunay_from_surface").origin).parents[1]
    with tempfile.TemporaryDirectory() as folder:  # the kernel is the system's Python
        return subprocess.run([sys.executable, "-B", "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", folder, NOTEBOOK],
                              check=False, env={**os.environ, "PYTHONPATH": str(module)}).returncode


if __name__ == "__main__":
    sys.exit(main())
