# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Tiles by the workers of a Dask cluster.

What a run knows is in a folder that all of them see, so a task's arguments and result are numbers: which task of which
stage, and that it is done. A task may be done again, by any worker; a dead one costs time, never the result.
"""

from __future__ import annotations

import contextlib
import os
import re
from pathlib import Path
from typing import Any, Dict, Iterable, List, Optional, SupportsIndex, Tuple, Union

import numpy as np

from . import _delaunay_from_surface as _core
from ._tiles import Place, Tile, Tiles, bytes_of, name_of, names_of, number_of_tiles
from ._types import Places


class DaskTiles:
    """A Delaunay triangulation in a folder that the workers see, as `delaunay3_dask` returns it.

    Its length is the number of tiles. Its items are read by the workers, when they are computed.
    """

    def __init__(self, folder: str, report: Dict[str, Any], numbers_of_cells: List[int]) -> None:
        self.folder = folder
        self.report = report
        """How many points, tiles and cells there are, how many points were told and kept, in how many rounds."""
        self.numbers_of_cells = numbers_of_cells
        """By tile the number of its finite cells."""

    def __len__(self) -> int:
        return len(self.numbers_of_cells)

    def _key(self, k: int) -> str:
        """A part of the names of tile k's tasks: those of another run in this folder are not the same."""
        return f"{self.report['hash']}-{len(self)}-{self.numbers_of_cells[k]}"

    def __getitem__(self, k: int) -> Any:
        """Tile k: a `dask.delayed` of a `Tile`."""
        from dask import delayed
        if not 0 <= k < len(self):
            raise IndexError(f"there are tiles 0 to {len(self) - 1}")
        return delayed(_read_tile, pure=True)(self.folder, k, self._key(k))

    def cells(self) -> Any:
        """The finite cells of all tiles: a `dask.array` of shape (m, 4) with places in the input, a chunk for each tile."""
        from dask import array, delayed
        read = delayed(_read_cells, pure=True)
        return array.concatenate([array.from_delayed(read(self.folder, k, self._key(k)), (n, 4), np.int64)
                                  for k, n in enumerate(self.numbers_of_cells)])


def delaunay3_dask(points: Any, client: Any, output: Place, *, memory: Union[int, str] = "1G",
                   tiles: Optional[SupportsIndex] = None, vtu: bool = False) -> DaskTiles:
    """Write the Delaunay triangulation of more points than one machine holds, tile by tile, by a Dask cluster.

    The union of the tiles is what `delaunay3` would return for all points, and a certificate is checked before this
    returns. Workers may die, or be stopped, at any time; a run that was stopped resumes when called again.

    Parameters
    ----------
    points
        A file or several, as `delaunay3_tiles` takes them, by names that all workers know; or a `dask.array` of shape
        (n, 3), whose chunks the workers write into the folder first, as float64. Called again, an array of the same
        name (its token) is not written again.
    client
        A `distributed.Client`. Its workers import this package; each of their threads has one tile at a time.
    output
        The folder for the tiles, and for the state of the work, which all workers see by this name: on one machine any
        folder, on a cluster one of a file system that is shared.
    memory
        How much memory one tile may take: bytes, or a text such as "8G". Give the memory of a worker divided by the number of
        its threads. It decides how many tiles there are, at about 300 bytes for a point that a tile keeps; a tile keeps up to
        five times its own points.
    tiles
        How many tiles there are; by default `memory` decides.
    vtu
        Whether to write .vtu files for ParaView, too, with tiles.pvtu over them.

    Returns
    -------
    DaskTiles
        Its tiles and cells as delayed values and a `dask.array`. `Tiles(output)` reads the folder without Dask.

    Raises
    ------
    FileNotFoundError
        If a worker does not see one of the files.
    OSError
        If a file cannot be read or written, or is not what it should be, or the folder is that of another input.
    ValueError
        If a coordinate is not a finite number, all points lie in one plane, or an argument is out of range.
    TypeError
        If `client` is not a `distributed.Client`, or points are neither files nor a `dask.array`.
    MemoryError
        If a tile keeps more points than it may, and more tiles do not help or their number was given.
    distributed.KilledWorker
        If a task's workers died again and again: they may have had too little memory.

    What a task raises is raised when the others of its stage have ended.

    Notes
    -----
    A round has a task for each tile that was told of something in the one before, and no others; in the dashboard they
    are named after the round. The number of rounds is about six, whatever the number of points.
    """
    if not (callable(getattr(client, "submit", None)) and callable(getattr(client, "map", None))):
        raise TypeError(f"client: expected a distributed.Client, got {type(client).__name__}")
    number = number_of_tiles(tiles)
    how = bytes_of(memory), vtu
    folder = os.fsdecode(name_of("output", output))
    files = _files_of(points, client, folder)
    names_of(files)  # what is refused here has no state in the folder
    run = _Run(client, (files, folder), how, files if hasattr(points, "to_delayed") else [])
    run.to_the_end(number)
    report, numbers = run.call("report", _report, folder)
    return DaskTiles(folder, report, numbers)


class _Run:
    """The stages of a run, one after the other: the driver is the folder's state, the client hands out its tasks."""

    def __init__(self, client: Any, places: Tuple[List[str], str], how: Tuple[int, bool], written: List[str]) -> None:
        """`written`: files of points that are not the caller's."""
        self.client, self.places, self.how, self.written = client, places, how, written

    def call(self, name: str, function: Any, *arguments: Any) -> Any:
        """What one worker returns: it, too, may die and be replaced."""
        return self.client.submit(function, *arguments, key=f"{name}-{_unique()}", pure=False).result()

    def to_the_end(self, tiles: int) -> None:
        starts_again = tiles == 0
        while True:
            try:
                number, stage, tiles_now = self.call("next", _next, *self.places, tiles, *self.how)
                if number == 0:
                    return
                more = self.stage(number, stage, tiles, starts_again)
            except ValueError:  # of a refused input nothing is left
                self.call("forget", _forget_input, self.places[1], self.written)
                raise
            if more > tiles_now:
                self.call("begin again", _forget, self.places[1])
                tiles = more

    def stage(self, number: int, name: str, tiles: int, starts_again: bool) -> int:
        """Its tasks. Returns with how many tiles to begin again, if one was too large."""
        from distributed import as_completed, wait
        futures = self.client.map(_do_task, range(number), places=self.places, tiles=tiles, how=self.how,
                                  starts_again=starts_again, pure=False, key=f"{name}-{_unique()}")
        try:
            return max(future.result() for future in as_completed(futures))
        except Exception:
            wait(futures)  # so that nobody writes any more
            raise


def _unique() -> str:
    """Part of a name that nobody else has: uuid is slower to import than most of this package."""
    return os.urandom(16).hex()


def _names_of(files: List[str], folder: str) -> Tuple[List[bytes], bytes]:
    return [os.fsencode(file) for file in files], os.fsencode(folder)


# Functions of an extension cannot be sent to workers; these can.
def _next(files: List[str], folder: str, *how: Any) -> Tuple[int, str, int]:
    number, stage, tiles = _core.next_of_tiles(names_of(files), os.fsencode(folder), *how)
    return number, stage, tiles


def _forget(folder: str) -> None:
    _core.forget_tiles(os.fsencode(folder))


def _forget_input(folder: str, written: List[str]) -> None:
    """And what was written of an array: these files, and nothing that others have beside them."""
    _core.forget_tiles(os.fsencode(folder))
    for file in written:
        Path(file).unlink(missing_ok=True)
    if written:
        (Path(folder) / "points" / "name").unlink(missing_ok=True)
        with contextlib.suppress(OSError):
            (Path(folder) / "points").rmdir()


def _do_task(k: int, places: Tuple[List[str], str], tiles: int, how: Tuple[int, bool], starts_again: bool) -> int:
    return int(_core.do_task_of_tiles(*_names_of(*places), tiles, *how, k, starts_again))


def _files_of(points: Any, client: Any, folder: str) -> List[str]:
    if isinstance(points, (str, bytes, os.PathLike)):
        return [os.fsdecode(points)]
    if not hasattr(points, "to_delayed"):
        if isinstance(points, np.ndarray) or not isinstance(points, Iterable):
            raise TypeError("points: expected files or a dask.array; dask.array.from_array converts a NumPy array")
        return [os.fsdecode(name_of("points", file)) for file in points]
    return _write_array(points, client, Path(folder) / "points")


def _write_array(points: Any, client: Any, folder: Path) -> List[str]:
    """The chunks of an array as files, by the workers that have them; those of an array of another name are refused."""
    from dask import delayed
    from distributed import wait
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"points: an array of shape (n, 3) is needed, and this one has {points.shape}")
    meta = points.rechunk({1: 3})._meta  # of no rows, but of the chunks' kind
    _core.array_of_points(meta.reshape(0, 3), "points")
    chunks = points.rechunk({1: 3}).to_delayed().ravel()
    files = [str(folder / f"{k:05}.npy") for k in range(len(chunks))]
    client.submit(_claim, str(folder), points.name, key=f"claim-{_unique()}", pure=False).result()
    write = delayed(_write_chunk, pure=False)
    writes = [write(chunk, file) for chunk, file in zip(chunks, files)]
    written = client.compute(writes)
    wait(written)  # so that nobody writes any more if one has failed
    client.gather(written)
    return files


def _claim(folder: str, name: str) -> None:
    """Notes the array's name, before any of it is written: the folder is not that of another one."""
    note = Path(folder) / "name"
    note.parent.mkdir(parents=True, exist_ok=True)
    if not note.exists():
        if any(re.fullmatch(r"[0-9]{5,}\.npy", file.name) for file in note.parent.iterdir()):
            raise OSError(f"{folder}: has files of points that are not of this array: name another folder for the tiles")
        aside = note.with_name(f"name-{_unique()}.unfinished")
        aside.write_text(name, encoding="utf-8")
        os.replace(aside, note)
    elif note.read_text(encoding="utf-8") != name:
        raise OSError(f"{folder}: is of another array: remove the folder, or name another one")


def _write_chunk(chunk: Any, file: str) -> None:
    """Written aside and renamed; not again if it is there. What an array of points may not be is refused, and so is another
    array of the same name."""
    place = Path(file)
    points = np.ascontiguousarray(_core.array_of_points(chunk, "points"), dtype=np.float64)
    if place.exists():
        if not np.array_equal(np.load(place, mmap_mode="r" if points.size else None), points):
            raise OSError(f"{place}: is of another array of this name: remove the folder, or name another one")
        return
    aside = place.with_name(f"{place.name}-{_unique()}.unfinished")
    try:
        with open(aside, "wb") as stream:
            np.save(stream, points)
            stream.flush()
            os.fsync(stream.fileno())  # before the name that says that it is whole
        if not place.exists():  # else another worker was asked, too
            os.replace(aside, place)
    finally:
        aside.unlink(missing_ok=True)


def _report(folder: str) -> Tuple[Dict[str, Any], List[int]]:
    tiles = Tiles(folder)
    numbers = [len(np.load(tiles.file("cells", k), mmap_mode="r")) for k in range(len(tiles))]
    return tiles.report, numbers


def _read_tile(folder: str, k: int, _key: Any) -> Tile:
    return Tiles(folder)[k]


def _read_cells(folder: str, k: int, _key: Any) -> Places:
    return np.asarray(np.load(Tiles(folder).file("cells", k)))
