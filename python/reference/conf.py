# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Sphinx: the reference of the Python module, from its docstrings. Its extension needs not be built: what is declared of it
takes its place."""

import importlib.machinery
import importlib.util
import re
import sys
from pathlib import Path

PYTHON = Path(__file__).resolve().parents[1]
PACKAGE = PYTHON / "src/delaunay_from_surface"


class Declared(importlib.machinery.SourceFileLoader):
    """Finds the declarations where the extension would be."""

    @classmethod
    def find_spec(cls, name, path=None, target=None):
        if name != "delaunay_from_surface._delaunay_from_surface":
            return None
        return importlib.util.spec_from_loader(name, cls(name, str(PACKAGE / "_delaunay_from_surface.pyi")))

    def exec_module(self, module):
        super().exec_module(module)
        module.__version__ = release
        module.Stopped.__module__ = module.InsertionOrder.__module__ = "delaunay_from_surface"


release = re.search(r"^  VERSION ([\d.]+)$", (PYTHON.parent / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(PYTHON / "src"))
sys.meta_path.insert(0, Declared)

project = "delaunay_from_surface"
version = release
copyright = "2026 The authors of Delaunay_from_surface_3"
extensions = ["sphinx.ext.autodoc", "sphinx.ext.viewcode", "numpydoc"]
autodoc_member_order = "bysource"
autodoc_typehints = "none"
numpydoc_show_class_members = False
default_role = "code"
html_theme = "alabaster"
html_theme_options = {"description": "3D Delaunay triangulations in NumPy arrays", "page_width": "70rem", "sidebar_width": "18rem",
                      "show_powered_by": False, "extra_nav_links": {"The manual": "../index.html", "C++ reference":
                                                                   "../group__PkgDelaunayFromSurface3Ref.html"}}
html_sidebars = {"**": ["about.html", "navigation.html", "localtoc.html", "searchbox.html"]}
html_show_sourcelink = False
html_copy_source = False
