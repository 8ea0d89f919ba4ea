# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Builds the extension with nothing but a C++ compiler: CXX, CXXFLAGS and LDFLAGS in the environment are obeyed.

The core lies beside this folder in a clone of the project, and in core/ in a source distribution: `sdist` puts it there.
"""

import os
import re
import shutil
import sys
from pathlib import Path

import pybind11
from pybind11.setup_helpers import ParallelCompile, Pybind11Extension
from setuptools import setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

HERE = Path(__file__).resolve().parent
ROOT = HERE / "core" if (HERE / "core").is_dir() else HERE.parent
VERSION = re.search(r"^  VERSION ([0-9.]+)$", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M).group(1)


class BuildExtension(build_ext):
    """Says what a compiler needs to be told. The filters are proved for operations that are rounded one by one."""

    def build_extensions(self):
        is_msvc = self.compiler.compiler_type == "msvc"
        for extension in self.extensions:
            extension.extra_compile_args += (["/O2", "/fp:precise", "/DNDEBUG"] if is_msvc else
                                             ["-O3", "-DNDEBUG", "-fno-fast-math", "-ffp-contract=off", "-g0"])
            if sys.platform.startswith("linux"):
                extension.extra_link_args += ["-pthread", "-Wl,-s", *self.static_runtime()]
        super().build_extensions()

    @staticmethod
    def static_runtime():
        """A wheel need not find the compiler's library for C++ at run time; elsewhere the system's is used.

        The unwinder is the system's always: pthread_exit() unwinds with it, and two of them in one stack abort.
        """
        return ["-static-libstdc++"] if os.environ.get("DELAUNAY_FROM_SURFACE_STATIC") else []


class SourceDistribution(sdist):
    """Adds what the extension is made of and lies outside this folder."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        core = Path(base_dir) / "core"
        shutil.copytree(ROOT / "include/CGAL/Delaunay_from_surface_3", core / "include/CGAL/Delaunay_from_surface_3")
        shutil.copytree(ROOT / "src/tiles", core / "src/tiles")
        for source, target in (("src/core.cpp", core / "src"), ("src/core_regular.cpp", core / "src"),
                               ("src/core_periodic.cpp", core / "src"),
                               ("CMakeLists.txt", core), ("LICENSE", base_dir), ("LICENSE.LGPL", base_dir)):
            shutil.copy(ROOT / source, target)


ParallelCompile("DELAUNAY_FROM_SURFACE_JOBS", default=0).install()
NUMPY = "numpy>=1.20" if pybind11.version_info[:2] >= (2, 12) else "numpy>=1.20,<2"  # whose arrays it does not know
setup(
    version=VERSION,
    install_requires=[NUMPY],
    cmdclass={"build_ext": BuildExtension, "sdist": SourceDistribution},
    ext_modules=[Pybind11Extension(
        "delaunay_from_surface._delaunay_from_surface",
        sorted(file.name for file in HERE.glob("*.cpp")),
        include_dirs=["include", os.path.relpath(ROOT, HERE), os.path.relpath(ROOT / "include", HERE)],
        define_macros=[("DELAUNAY_FROM_SURFACE_3_VERSION", f'"{VERSION}"'),
                       ("CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED", None)],
        depends=[os.path.relpath(file, HERE) for folder in (HERE, ROOT) for file in sorted((folder / "include").rglob("*.h"))],
        cxx_std=17)])
