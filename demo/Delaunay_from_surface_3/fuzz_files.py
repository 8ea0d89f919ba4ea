# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Mutates small files of every format that the program reads, and runs the program on them.

Every run must end with 0, or with 1 and one line on the standard error that begins with "error: "; without a crash, a
report of a sanitizer, or more memory and time than such a small file can need. FUZZ_MINUTES says how long (1), FUZZ_SEED
where to begin (1): run i of a seed is always the same. What fails is kept in the folder that FUZZ_KEEP names."""

import collections
import os
import random
import re
import resource
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAM = os.path.abspath(os.environ["DELAUNAY_FROM_SURFACE"])
IS_SANITIZED = b"__asan_init" in Path(PROGRAM).read_bytes()
SECONDS = 20  # of CPU time; what a sanitizer needs for a file of a few kilobytes is far less
MEGABYTES = 512  # of address space, or of resident memory with a sanitizer, which reserves terabytes
NUMBERS = ["0", "-1", "1", "3", "255", "65535", "2147483647", "2147483648", "4294967295", "4000000000", "-2147483649",
           "18446744073709551615", "99999999999999999999", "1e400", "-1e-400", "nan", "-nan", "inf", "0x10", "1e308",
           "4.9e-324", "+1", "--1", "", "1.5", "ä"]
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1.5), (0.25, 0.5, -3)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 4), (0, 3, 2), (1, 4, 3), (2, 5, 4)]
NOTE = re.compile(r"note: [^\n]*\n")
ERROR = re.compile(r"error: [^\n]+\n")


def text(lines):
    return "".join(line + "\n" for line in lines).encode()


def words(numbers):
    return " ".join(map(str, numbers))


def ply(order, count, index, code):
    """Binary, with lists of all kinds."""
    header = text(["ply", f"format binary_{'little' if order == '<' else 'big'}_endian 1.0", "comment c",
                   f"element vertex {len(POINTS)}", "property float x", "property double y", "property float z",
                   "property uchar red", f"element face {len(FACES)}", f"property list {count} {index} vertex_indices",
                   "property int flags", "element other 2", "property list short double a", "end_header"])
    body = [struct.pack(order + "fdfB", *p, 7) for p in POINTS]
    body += [struct.pack(order + code, 3, *f, -1) for f in FACES]
    return header + b"".join(body) + 2 * struct.pack(order + "h2d", 2, 0.5, 1)


def stl_text():
    lines = ["solid s"]
    for face in FACES:
        lines += ["facet normal 0 0 0", "outer loop", *("vertex " + words(POINTS[i]) for i in face), "endloop", "endfacet"]
    return text([*lines, "endsolid s"])


def seeds():
    points, faces = [words(p) for p in POINTS], [words((3, *f)) for f in FACES]
    counts = f"{len(POINTS)} {len(FACES)} 0"
    ascii_ply = ["ply", "format ascii 1.0", f"element vertex {len(POINTS)}", "property double x", "property float y",
                 "property double z", f"element face {len(FACES)}", "property list uint int vertex_indices", "end_header"]
    triangles = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in f for x in POINTS[i]), 0) for f in FACES)
    return [
        ("off", text(["OFF", counts, "# comment", *points, *faces])),
        ("off", text(["STCN4OFF", counts, *(p + " 1 0 0 1 1 255 0 0 1 0.5 0.5 1" for p in points),
                      *(f + " 0.5 0.5 0.5" for f in faces)])),
        ("off", b"OFF BINARY\n" + struct.pack(">iii", 6, 6, 0) + b"".join(struct.pack(">3f", *p) for p in POINTS)
         + b"".join(struct.pack(">5i", 3, *f, 0) for f in FACES)),
        ("ply", text([*ascii_ply, *points, *faces])),
        ("ply", text([*ascii_ply[:6], "property float radius", *ascii_ply[6:], *(p + " 0.5" for p in points), *faces])),
        ("ply", ply("<", "uchar", "int", "B3ii")), ("ply", ply(">", "uint", "uint", "I3Ii")),
        ("ply", ply("<", "int", "ushort", "i3Hi")),
        ("obj", text(["# comment", "o name", *("v " + p for p in points), "vt 0 0", "vn 0 0 1",
                      *("f " + " ".join(f"{i + 1}/1/1" for i in f) for f in FACES), "f -1 -2 -3"])),
        ("obj", text(["v " + p.replace(" ", " \\\n") for p in points] + ["f 1 \\\r", "2\\", "3"])),
        ("off", text(["OFF", counts, *points, *faces]).replace(b"\n", b"\r")),
        ("obj", text(["v " + p for p in points])), ("xyz", text(["# comment", *(p + " 0 0 1" for p in points)])),
        ("pts", text([str(len(POINTS)), *(p + " -1200 255 0 0" for p in points), "2", *points[:2]])),
        ("stl", stl_text()), ("stl", b"\xef\xbb\xbf" + stl_text().replace(b"\n", b" ")),
        ("off", text(["OFF" + counts, *points, *(f.replace(" ", "\n") for f in faces)])),
        ("stl", b"binary".ljust(80) + struct.pack("<I", len(FACES)) + triangles)]


def replace_a_number(data, random):
    places = list(re.finditer(rb"-?\d[\d.e+-]*", data[:4000]))
    if not places:
        return data
    place = random.choice(places)
    return data[:place.start()] + random.choice(NUMBERS).encode() + data[place.end():]


def move_a_line(data, random):
    lines = data.split(b"\n")
    line = lines.pop(random.randrange(len(lines)))
    if random.random() < 0.6:  # else it is removed
        lines.insert(random.randrange(len(lines) + 1), line)
    return b"\n".join(lines)


def flip_bytes(data, random):
    data = bytearray(data)
    for _ in range(random.choice((1, 1, 1, 2, 5, 20))):
        if data:
            data[random.randrange(len(data))] = random.choice((0, 10, 13, 32, 45, 57, 92, 127, 255, random.randrange(256)))
    return bytes(data)


def repeat_a_part(data, random):
    begin = random.randrange(len(data) + 1)
    end = min(len(data), begin + random.choice((1, 4, 20, 200)))
    return data[:end] + random.choice((1, 1, 2, 300)) * data[begin:end] + data[end:]


MUTATIONS = {
    "numbers": replace_a_number, "lines": move_a_line, "bytes": flip_bytes, "repeated": repeat_a_part,
    "cut short": lambda data, random: data[:random.randrange(len(data) + 1)],
    "huge words": lambda data, random: re.sub(rb"(?s)\A(.{%d}\S*) " % random.randrange(len(data) + 1),
                                              rb"\1 " + struct.pack("<I", 4000000000), data, count=1)}


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if not IS_SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (MEGABYTES << 20, MEGABYTES << 20))


def what_is_wrong(run):
    if IS_SANITIZED and ("Sanitizer" in run.stderr or "runtime error" in run.stderr):
        return "a sanitizer reports"
    if run.returncode not in (0, 1):
        return f"exit code {run.returncode}"
    rest = NOTE.sub("", run.stderr) if run.returncode == 0 else run.stderr
    rest = rest if run.returncode == 0 else ERROR.sub("", NOTE.sub("", rest), count=1)
    if rest or (run.returncode == 1 and "error: " not in run.stderr):
        return "the standard error is not one clear line"
    return "there is not enough memory" if "not enough memory" in run.stderr else None


def main():
    seconds = 60 * float(os.environ.get("FUZZ_MINUTES", "1"))
    seed = int(os.environ.get("FUZZ_SEED", "1"))
    keep = Path(os.environ.get("FUZZ_KEEP", "fuzz_files_failures"))
    environment = {**os.environ, "UBSAN_OPTIONS": "halt_on_error=1", "ASAN_OPTIONS":
                   f"allocator_may_return_null=0:hard_rss_limit_mb={MEGABYTES}:max_allocation_size_mb={MEGABYTES}"}
    counts, failures = collections.Counter(), 0
    begin, i = time.monotonic(), 0
    formats = seeds()
    with tempfile.TemporaryDirectory() as folder:
        while time.monotonic() - begin < seconds:
            generator = random.Random(f"{seed} {i}")
            extension, data = generator.choice(formats)
            names = [] if i < len(formats) else generator.choices(list(MUTATIONS), k=generator.choice((1, 1, 2, 3)))
            if i < len(formats):  # begins with what is not mutated
                extension, data = formats[i]
            for name in names:
                data = MUTATIONS[name](data, generator)
            file = Path(folder) / f"{seed}-{i}.{extension}"
            file.write_bytes(data)
            output = Path(folder) / f"output.{generator.choice(('vtu', 'vtk', 'msh', 'mesh', 'cgal'))}"
            weights = ["--weights"] if extension in ("ply", "xyz", "pts") and generator.random() < .4 else []
            run = subprocess.run([PROGRAM, file, "--compare", "--repetitions", "1", "--output", output, *weights],
                                 capture_output=True, text=True, errors="replace", env=environment, preexec_fn=limits)
            counts[extension, "taken" if run.returncode == 0 else "refused"] += 1
            counts.update(names)
            problem = what_is_wrong(run)
            if problem:
                failures += 1
                keep.mkdir(exist_ok=True)
                (keep / file.name).write_bytes(data)
                print(f"FAILED: {keep / file.name} ({', '.join(names)}): {problem}\n{run.stderr[:2000]}", flush=True)
            file.unlink()
            output.unlink(missing_ok=True)
            i += 1
    for key, count in sorted(counts.items(), key=str):
        print(f"{key if isinstance(key, str) else ' '.join(key)}: {count}")
    print(f"{i} files, {failures} failures, {'with' if IS_SANITIZED else 'without'} sanitizers")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
