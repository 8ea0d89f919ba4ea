# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Installs the module as a user does, into a fresh virtual environment, and runs its tests there.

FOLDER names the folder for all that is made. The tests are those of test_module.py."""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pybind11

HERE = Path(__file__).resolve().parent
FOLDER = Path(os.environ["FOLDER"]).resolve()


def copy_of_the_project():
    """A copy of this folder beside links to what it needs: nothing is written into the source tree."""
    tree = FOLDER / "tree"
    tree.mkdir(parents=True, exist_ok=True)
    for name in ("CMakeLists.txt", "LICENSE", "LICENSE.LGPL", "include", "src"):
        link = tree / name
        if not link.is_symlink():
            link.symlink_to(HERE.parent / name)
    shutil.copytree(HERE, tree / "python", dirs_exist_ok=True)
    return tree / "python"


def foreign_headers():
    """Headers of CGAL and Boost that the extension is made of: there shall be none."""
    includes = [f"-I{path}" for path in (HERE / "include", HERE.parent, HERE.parent / "include",
                                         sysconfig.get_path("include"), pybind11.get_include())]
    found = set()
    for source in HERE.glob("*.cpp"):
        rule = subprocess.run(["c++", "-std=c++17", *includes, "-M", source], check=True, capture_output=True, text=True)
        found |= {name for name in rule.stdout.split() if re.search(r"/boost/|/CGAL/(?!Delaunay_from_surface_3/)", name)}
    return sorted(found)


def main():
    if foreign_headers():
        sys.exit(f"the extension needs headers of others: {foreign_headers()[:5]} ...")
    environment = FOLDER / "venv"
    subprocess.run([sys.executable, "-m", "venv", "--clear", "--system-site-packages", environment], check=True)
    python = environment / "bin/python"
    subprocess.run([python, "-m", "pip", "install", "--no-index", "--no-build-isolation", "--disable-pip-version-check",
                    copy_of_the_project()], check=True)
    tests = subprocess.run([python, "-B", HERE / "test_module.py", *sys.argv[1:]], cwd=FOLDER, check=False)
    return tests.returncode


if __name__ == "__main__":
    sys.exit(main())
