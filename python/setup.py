# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Builds the extension by CMake. CMAKE_ARGS in the environment is passed on to CMake.

It is built inside a clone of the project: the headers are those of the folder include/ beside this one.
"""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent


class CMakeExtension(Extension):
    """An extension without sources: CMake knows them."""

    def __init__(self, name):
        super().__init__(name, sources=[])


class BuildByCMake(build_ext):
    """Configures this folder and builds the extension into the place where setuptools expects it."""

    def build_extension(self, ext):
        output = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cmake", "-S", HERE, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                        f"-DPython_EXECUTABLE={sys.executable}", f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY={output}",
                        f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY_RELEASE={output}", *self.pybind11_folder(),
                        *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", build, "--config", "Release"], check=True)

    @staticmethod
    def pybind11_folder():
        """Where the module pybind11 says that its CMake files are; else CMake looks for them."""
        try:
            import pybind11
            return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]
        except ImportError:
            return []


VERSION = re.search(r"^  VERSION ([0-9.]+)$", (HERE.parent / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)

setup(version=VERSION.group(1), ext_modules=[CMakeExtension("delaunay_from_surface._delaunay_from_surface")],
      cmdclass={"build_ext": BuildByCMake})
