# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""More points than fit into memory: files of points become files of tiles."""

from __future__ import annotations

import json
import numbers
import os
import re
from pathlib import Path
from typing import Any, Callable, Dict, Iterable, Iterator, List, NamedTuple, Optional, SupportsIndex, Tuple, Union

import numpy as np

from . import _delaunay_from_surface as _core
from ._arguments import number_of_threads, whole_number
from ._progress import shown
from ._types import Places, Reals

Place = Union[str, bytes, "os.PathLike[str]"]


class Tile(NamedTuple):
    """The cells that a tile owns; each cell of the triangulation is owned by one tile."""

    ids: Places
    """(k,) int64: by vertex its place in the input, of equal points the smallest."""
    points: Reals
    """(k, 3) float64: by vertex its coordinates."""
    cells: Places
    """(m, 4) int64: by cell its four vertices, as places in `points`."""


class Tiles:
    """A Delaunay triangulation in a folder, as `delaunay3_tiles` or the program writes it.

    Its length is the number of tiles, and `tiles[k]` reads one. Iterating yields the arrays (points, cells) of
    each `Tile` in turn, so a loop needs memory for only one tile.
    """

    def __init__(self, folder: Place) -> None:
        self.folder = Path(os.fsdecode(name_of("folder", folder)))
        report = self.folder / "tiles.json"
        if not report.is_file():
            raise FileNotFoundError(f"{report}: does not exist, so no run has finished there")
        self.report: Dict[str, Any] = json.loads(report.read_text(encoding="utf-8"))
        """How many points, tiles and cells there are, how many points were told and kept, in how many rounds."""

    def __len__(self) -> int:
        return int(self.report["tiles"])

    def file(self, kind: str, k: int) -> Path:
        """The file of tile k with its "cells", "ids" or "points"."""
        return self.folder / f"{kind}-{k:05}.npy"

    def __getitem__(self, k: int) -> Tile:
        if not 0 <= k < len(self):
            raise IndexError(f"there are tiles 0 to {len(self) - 1}")
        ids, points, cells = (np.load(self.file(kind, k)) for kind in ("ids", "points", "cells"))
        order = np.argsort(ids)
        return Tile(ids, points, order[np.searchsorted(ids, cells, sorter=order)])

    def __iter__(self) -> Iterator[Tuple[Reals, Places]]:
        for k in range(len(self)):
            tile = self[k]
            yield tile.points, tile.cells


def bytes_of(memory: Union[int, str]) -> int:
    """A size such as 8000000000, "500M" or "8G", in bytes."""
    if isinstance(memory, str):
        found = re.fullmatch(r"(\d+(?:\.\d*)?)([KMGT]?)B?", memory.strip().upper())
        if not found:
            raise ValueError(f"memory: {memory!r} is no size such as '500M' or '8G'")
        return bytes_of(int(float(found.group(1)) * 1024 ** " KMGT".index(found.group(2) or " ")))
    if not isinstance(memory, numbers.Real):
        raise TypeError(f"memory: expected bytes, or a text such as '8G', got {memory!r}")
    if not 10**6 <= memory < 2**63:
        raise ValueError(f"memory: a tile needs 1 MB at least, and 2**63 bytes are too many, got {memory!r}")
    return int(memory)


def number_of_tiles(tiles: Optional[SupportsIndex]) -> int:
    """0 if it is None: it is not given."""
    return 0 if tiles is None else whole_number("tiles", tiles, 1, 10**6)


def name_of(argument: str, place: Any) -> bytes:
    """The name of a file or a folder, whatever bytes it has."""
    if isinstance(place, (str, bytes, os.PathLike)):
        return os.fsencode(place)
    shape = getattr(place, "shape", None)
    of_array = f"an array of shape {tuple(shape or ())}: numpy.save() writes it into a file"
    what = type(place).__name__ if shape is None else of_array
    raise TypeError(f"{argument}: expected the name of a file or folder, got {what}")


def names_of(files: Any) -> List[bytes]:
    """The names of one file or of several, which are there."""
    is_sequence = isinstance(files, Iterable) and not isinstance(files, (str, bytes)) and not hasattr(files, "shape")
    names = [name_of("files", file) for file in (files if is_sequence else [files])]
    for name in names:
        os.stat(name)  # FileNotFoundError says which one is not there
    return names


def delaunay3_tiles(files: Union[Place, Iterable[Place]], output: Place, *, memory: Union[int, str] = "4G",
                    tiles: Optional[SupportsIndex] = None, threads: Optional[SupportsIndex] = 1, vtu: bool = False,
                    progress: Union[Callable[[str, int, int], object], bool, None] = None,
                    workers: Optional[SupportsIndex] = 1) -> Tiles:
    """Write the Delaunay triangulation of more points than fit into memory, tile by tile.

    A run that was stopped, for whatever reason, resumes when called again. The union of the tiles is what `delaunay3`
    would return for all points, and a certificate is checked before this returns.

    Parameters
    ----------
    files
        One file or several, whose points are numbered one after the other: .npy with an array of shape (n, 3) of
        float64 or float32, stored row by row; binary .ply; or .raw, .bin, .f64 with little-endian float64 alone.
        They are read by ranges.
    output
        The folder for the tiles, and for the state of the work. It is made if need be.
    memory
        How much memory the tiles that are in memory at once may take: bytes, or a text such as "8G". It decides how many tiles
        there are, at about 300 bytes for a point that a tile keeps; a tile keeps up to five times its own points.
    tiles
        How many tiles there are; by default `memory` decides.
    threads
        How many tiles are in memory at once, each worked on by one thread; None: as many as there are processors.
    vtu
        Whether to write .vtu files for ParaView, too, with tiles.pvtu over them.
    progress
        Is called after each task with a word for what is done, how much of it is done and how much there is. If it
        returns False, the work stops and `Stopped` is raised. The interpreter lock is released in between. True shows a
        bar of tqdm for each kind of work on stderr, or a line of text where there is no tqdm.
    workers
        Another name of `threads`, for programs that use it.

    Raises
    ------
    FileNotFoundError
        If one of the files is not there.
    OSError
        If a file cannot be read or written, or is not what it should be, or the folder is that of another input.
    ValueError
        If a coordinate is not a finite number, all points lie in one plane, or an argument is out of range.
    MemoryError
        If a tile keeps more points than it may, and more tiles do not help or their number was given.
    """
    names = names_of(files)
    if not names:
        raise ValueError("files: the list is empty; name at least one file of points")
    folder, number = name_of("output", output), number_of_threads("threads", threads, most=None)
    if workers != 1:
        if number != 1:
            raise TypeError("workers: it is another name of threads: give one of them")
        number = number_of_threads("workers", workers, most=None)
    with shown(progress, lambda bar: bar.show) as called:
        _core.delaunay3_tiles(names, folder, number_of_tiles(tiles), bytes_of(memory), number, vtu, called)
    return Tiles(output)
