# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A recipe for Conan 2, of the source around it: conan create packaging/conan"""

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class DelaunayFromSurface3(ConanFile):
    name = "delaunay_from_surface_3"
    version = "0.1.0"
    description = "The 3D Delaunay triangulation of a surface mesh's vertices, in CGAL's own type"
    license = "GPL-3.0-or-later AND LGPL-3.0-or-later"
    topics = ("geometry", "delaunay", "cgal", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "LICENSE.LGPL", "cmake/*", "doc/*", "include/*", "src/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("cgal/[>=5.5.1]", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 17)

    def package_id(self):
        self.info.clear()

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BUILD_TESTING"] = False
        for part in ("PROGRAMS", "EXAMPLES", "BENCHMARK"):
            toolchain.cache_variables[f"DELAUNAY_FROM_SURFACE_3_BUILD_{part}"] = False
        toolchain.cache_variables["DELAUNAY_FROM_SURFACE_3_INSTALL_COMPILED"] = False
        toolchain.generate()

    def build(self):
        CMake(self).configure()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE*", self.source_folder, os.path.join(self.package_folder, "licenses"))
        rmdir(self, os.path.join(self.package_folder, "share"))

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "Delaunay_from_surface_3")
        self.cpp_info.set_property("cmake_target_name", "Delaunay_from_surface_3::Delaunay_from_surface_3")
        self.cpp_info.set_property("pkg_config_name", "delaunay_from_surface_3")
