"""Bars that show how far long work is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

Observer = Callable[[str, int, int], object]
"""Called as observer(stage, done, total) in the calling thread, some twenty times a second at the most."""

_WIDTH = 30


class Bar:
    """A line on stderr, written over and over: stage, done and total, time left."""

    def __init__(self) -> None:
        self._stage = ""
        self._began = 0.0
        self._longest = 0

    def __call__(self, stage: str, done: int, total: int) -> None:
        now = time.monotonic()
        if stage != self._stage:
            self._stage, self._began = stage, now
        share = done / total if total else 1.0
        left = (now - self._began) * (1 - share) / share if share else 0.0
        bar = "=" * int(_WIDTH * share)
        line = f"{stage:12} [{bar:{_WIDTH}}] {done}/{total} {left:.0f} s left"
        self._write(line)

    def _write(self, line: str) -> None:
        self._longest = max(self._longest, len(line))
        sys.stderr.write("\r" + line.ljust(self._longest))
        sys.stderr.flush()

    def close(self) -> None:
        """Removes the line."""
        if self._longest:
            self._write("")
            sys.stderr.write("\r")
            sys.stderr.flush()


class Shown:
    """What watches work: `with Shown(progress) as observer`."""

    def __init__(self, progress: bool | Observer | None) -> None:
        if not (progress is None or isinstance(progress, bool) or callable(progress)):
            raise TypeError(f"progress={progress!r}: True, False, None or a function observer(stage, done, total) is wanted")
        if progress is None:
            progress = sys.stderr is not None and sys.stderr.isatty()
        self._bar = Bar() if progress is True else None
        self._observer = self._bar if isinstance(progress, bool) else progress

    def __enter__(self) -> Observer | None:
        return self._observer

    def __exit__(self, *_: object) -> None:
        if self._bar:
            self._bar.close()
