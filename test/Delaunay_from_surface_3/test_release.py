# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes a release of what is committed, twice: PARTS says which parts, all if it is empty. The bytes are the same, and
what is wrong is said."""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PARTS = os.environ.get("PARTS", "source sbom amalgamation recipes changes").split()
GIT = ["git", "-c", "user.name=A", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)


# Where CI is set this is one: else it would pass unseen.
@unittest.skipUnless("CI" in os.environ or shutil.which("git") and (ROOT / ".git").exists(), "this is no git clone")
class Release(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A clone, with the script as it is here."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.clone = cls.folder / "clone"
        done = run("git", "clone", "--quiet", ROOT, cls.clone)
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        for name in ("release", "project_url", "wheel", "amalgamate"):
            shutil.copy(ROOT / "scripts" / name, cls.clone / "scripts" / name)
        cls.commit()
        cls.version = re.search(r"^  VERSION ([\d.]+)$", (cls.clone / "CMakeLists.txt").read_text(), re.M).group(1)

    @classmethod
    def commit(cls):
        run(*GIT, "commit", "--quiet", "--all", "--message", "As it is here", cwd=cls.clone)

    def release(self, *words):
        return run(sys.executable, "-B", self.clone / "scripts/release", "--output", self.folder / "out", *words)

    def test_twice_the_same(self):
        parts = ["--parts", *PARTS] if PARTS else []
        sums = []
        for _ in range(2):
            done = self.release(self.version, *parts)
            self.assertEqual(done.returncode, 0, done.stderr)
            output = self.folder / "out" / self.version
            sums.append((output / "SHA256SUMS").read_text())
        self.assertEqual(*sums)
        digests = dict(reversed(line.split("  ")) for line in sums[0].splitlines())
        for name, digest in digests.items():
            self.assertEqual(hashlib.sha256((output / name).read_bytes()).hexdigest(), digest)
        self.assertEqual(set(digests) | {"SHA256SUMS"}, {path.name for path in output.iterdir()})
        self.assertEqual([path.name for path in (self.folder / "out").iterdir()], [self.version])
        self.check_files(output, digests)

    def check_files(self, output, names):
        top = f"delaunay_from_surface_3-{self.version}"
        with tarfile.open(output / f"{top}.tar.gz") as files:
            members = {member.name for member in files}
            self.assertTrue({f"{top}/{name}" for name in ("README.md", "CMakeLists.txt", "scripts/run")} <= members)
            self.assertFalse([name for name in members if "/build/" in name or "/.git/" in name])
        with zipfile.ZipFile(output / f"delaunay_3-{self.version}.zip") as files:
            self.assertEqual({name.split("/")[1] for name in files.namelist()},
                             {"delaunay_3.h", "delaunay_3.cpp", "LICENSE", "LICENSE.LGPL"})
        sbom = (output / f"{top}.spdx").read_text()
        self.assertRegex(sbom, rf"DocumentName: {top}\n.*\nCreator: Organization: The authors of Delaunay_from_surface_3 ")
        of_file = re.findall(r"^FileName: \./(.*)\n(?:.*\n)*?LicenseConcluded", sbom, re.M)
        self.assertLessEqual({"CMakeLists.txt", "src/core.cpp", "include/CGAL/insert_points_3.h"}, set(of_file))
        with zipfile.ZipFile(output / f"{top}-recipes.zip") as files:
            texts = {name.removeprefix(f"{top}-recipes/"): files.read(name).decode() for name in files.namelist()}
        self.assertLessEqual({"conda/meta.yaml", "conda/build_core.sh", "vcpkg/portfile.cmake", "vcpkg/vcpkg.json"}, set(texts))
        has_address = (ROOT / "packaging/project_url").read_text().strip()
        self.assertEqual({place for text in texts.values() for place in re.findall(r"@\w+@", text)},
                         {"@SOURCE@"} if has_address else {"@SOURCE@", "@HOME@"})
        self.assertIn(f'sha256: "{names[top + ".tar.gz"]}"', texts["conda/meta.yaml"])
        self.assertIn(hashlib.sha512((output / f"{top}.tar.gz").read_bytes()).hexdigest(), texts["vcpkg/portfile.cmake"])
        self.assertEqual(json.loads(texts["vcpkg/vcpkg.json"])["version"], self.version)
        changes = (output / f"CHANGES-{self.version}.md").read_text()
        self.assertTrue(changes.startswith(f"# Delaunay_from_surface_3 {self.version}\n\n"))
        if not PARTS:
            for pattern in (r"\.whl$", r"^delaunay[-_]from[-_]surface-.*\.tar\.gz$", r"-dev_.*\.deb$",
                            r"^delaunay-from-surface_.*\.deb$", r"-manual\.zip$",
                            r"^delaunay-3-.*\.tgz$"):
                self.assertTrue([name for name in names if re.search(pattern, name)], pattern)

    def test_what_is_refused(self):
        self.assertIn("'1.2' is no version", self.release("1.2").stderr)
        self.assertRegex(self.release("9.9.9").stderr, r"^error: the version is not 9\.9\.9 everywhere: CMakeLists\.txt has "
                         rf"{re.escape(self.version)}, CITATION\.cff has .*form\.h has {re.escape(self.version)}\n\Z")
        changelog = self.clone / "debian/changelog"
        before = changelog.read_text()
        changelog.write_text(before.replace(f"({self.version})", "(9.9.9)", 1))
        self.assertRegex(self.release(self.version).stderr, "^error: 1 files are not committed: debian/changelog\n\\Z")
        self.commit()
        self.assertRegex(self.release(self.version).stderr, "everywhere: debian/changelog has 9.9.9\n\\Z")
        changelog.write_text(before)
        changes = self.clone / "CHANGES.md"
        text = changes.read_text()
        changes.write_text(f"# Changes\n\n## {self.version}\n\n## 0.0.1\n")
        self.commit()
        self.assertRegex(self.release(self.version).stderr, "^error: CHANGES.md says nothing about")
        changes.write_text(text)
        self.commit()
        self.assertFalse((self.folder / "out" / "9.9.9").exists())


if __name__ == "__main__":
    unittest.main()
