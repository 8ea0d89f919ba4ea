# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Makes a wheel, looks into it, installs it from its index into a fresh virtual environment, and runs its tests there.

FOLDER names the folder for all that is made. The tests are those of test_module.py and of the kits, test_<kit>.py."""

import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

import pybind11

HERE = Path(__file__).resolve().parent
FOLDER = Path(os.environ["FOLDER"]).resolve()


def foreign_headers():
    """Headers of CGAL and Boost that the extension is made of: there shall be none."""
    includes = [f"-I{path}" for path in (HERE / "include", HERE.parent, HERE.parent / "include",
                                         sysconfig.get_path("include"), pybind11.get_include())]
    found = set()
    for source in HERE.glob("*.cpp"):
        rule = subprocess.run(["c++", "-std=c++17", *includes, "-M", source], check=True, capture_output=True,
                              text=True).stdout
        found |= {name for name in rule.split() if re.search(r"/boost/|/CGAL/(?!Delaunay_from_surface_3/)", name)}
    return sorted(found)


def check_files(index):
    """What is wrong: the wheel is small, needs nothing but libc, and has the licences; so have the sources."""
    built, = index.glob("*.whl")
    archive, = index.glob("*.tar.gz")
    with zipfile.ZipFile(built) as files, tarfile.open(archive) as sources:
        names = files.namelist()
        extension, = (name for name in names if name.endswith(".so"))
        files.extract(extension, FOLDER)
        metadata = files.read(next(name for name in names if name.endswith("/METADATA"))).decode()
        problems = [f"{name} is not in it" for name in ("LICENSE", "LICENSE.LGPL", "py.typed", "_delaunay_from_surface.pyi", "cpp.py")
                    if not any(file.endswith("/" + name) for file in names)]
        problems += [f"{name} is not in the sources"
                     for name in ("core/src/core.cpp", "core/src/tiles/Records.h", "LICENSE.LGPL", "include/functions.h")
                     if not any(file.endswith("/" + name) for file in sources.getnames())]
    needed = re.findall(r"NEEDED +(\S+)", subprocess.run(["objdump", "-p", FOLDER / extension], check=True,
                                                         capture_output=True, text=True).stdout)
    problems += [f"it needs {name}" for name in needed if not re.match(r"lib(c|m|pthread|gcc_s)\.so|ld-linux", name)]
    if built.stat().st_size > 3e6:
        problems.append(f"it has {built.stat().st_size} bytes")
    if (pybind11.version_info[:2] < (2, 12)) != ("<2" in re.search("^Requires-Dist: numpy.*$", metadata, re.M).group()):
        problems.append("it does not say which NumPy its pybind11 knows")
    if sys.platform == "linux" and "-manylinux_2_" not in built.name:
        problems.append("its name does not say which glibc it needs")
    return problems


def main():
    if foreign_headers():
        sys.exit(f"the extension needs headers of others: {foreign_headers()[:5]} ...")
    subprocess.run([sys.executable, HERE.parent / "scripts/wheel", "--output", FOLDER / "wheels", sys.executable],
                   check=True)
    index = FOLDER / "wheels/simple"
    problems = check_files(index / "delaunay-from-surface")
    if problems:
        sys.exit(f"the wheel: {'; '.join(problems)}")
    environment = FOLDER / "venv"
    subprocess.run([sys.executable, "-m", "venv", "--clear", "--system-site-packages", environment], check=True)
    python = environment / "bin/python"
    subprocess.run([python, "-m", "pip", "install", "--index-url", index.as_uri(), "--only-binary", ":all:",
                    "--disable-pip-version-check", "delaunay-from-surface"], check=True)
    others = {"test_wheel.py", "test_dask.py", "test_notebook.py"}
    tests = sorted(file for file in HERE.glob("test_*.py") if file.name not in others)
    codes = [subprocess.run([python, "-B", test, *sys.argv[1:]], cwd=FOLDER, check=False).returncode for test in tests]
    return max(codes, key=abs)


if __name__ == "__main__":
    sys.exit(main())
