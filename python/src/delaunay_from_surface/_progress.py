# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: LGPL-3.0-or-later

"""Shows how far a call is, for `progress=True`."""

from __future__ import annotations

import contextlib
import sys
from typing import Any, Callable, Iterator, Optional

import numpy as np


class Bar:
    """A bar of tqdm on stderr, a new one for each kind of work; where there is no tqdm, a line of text."""

    def __init__(self) -> None:
        self._makes: Any = None
        with contextlib.suppress(ImportError):
            from tqdm.auto import tqdm
            self._makes = tqdm
        self._bar: Any = None
        self._what: Optional[str] = None

    def show(self, what: str, done: int, of: int) -> None:
        """Shows how much is done of what is to be done."""
        if what != self._what:
            self.close()
            self._what = what
            self._bar = None if self._makes is None else self._makes(total=of, desc=what)
        if self._bar is not None:
            self._bar.update(done - self._bar.n)
        else:
            print(f"\r{what}: {done} of {of}", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Ends the line."""
        if self._bar is not None:
            self._bar.close()
        elif self._what is not None:
            print(file=sys.stderr)
        self._bar = self._what = None


@contextlib.contextmanager
def shown(progress: Any, step: Callable[[Bar], Callable[..., object]]) -> Iterator[Optional[Callable[..., object]]]:
    """What to call with the progress: the caller's function, or for True step(bar), which shows it; else None."""
    if isinstance(progress, np.bool_):
        progress = bool(progress)
    if progress is None or progress is False:
        yield None
    elif progress is not True:
        if not callable(progress):
            raise TypeError(f"progress: expected a function, or True for a bar, got {progress!r}")
        yield progress
    else:
        bar = Bar()
        try:
            yield step(bar)
        finally:
            bar.close()
