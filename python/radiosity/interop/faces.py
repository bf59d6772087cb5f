"""Faces of a mesh with a label each, before they become surfaces of a scene."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arguments import Array, array_of, real, refusal, rows


@dataclass
class Faces:
    """Faces that share vertices: corners counter-clockwise seen from the front, one face behind the other."""

    vertices: Array
    """(v, 3), scene length."""
    corners: NDArray[np.int64]
    """Rows of `vertices`, (c,)."""
    ends: NDArray[np.int64]
    """Where the corners of each face end, (f,)."""
    labels: NDArray[np.int64]
    """Index of the label of each face, (f,)."""
    names: list[str]
    """The labels."""

    @classmethod
    def of(cls, vertices: ArrayLike, blocks: Iterable[ArrayLike], labels: Sequence[Any]) -> Faces:
        """Blocks of faces (n, k) of equally many corners k; `labels` has one entry for each face, over all blocks."""
        lists = [whole_numbers("faces", block) for block in blocks]
        lists = [block for block in lists if block.size]
        sizes = np.concatenate([np.full(len(block), block.shape[1]) for block in lists] or [np.zeros(0, np.int64)])
        corners = np.concatenate([block.reshape(-1) for block in lists] or [np.zeros(0, np.int64)])
        return cls.ragged(vertices, corners, sizes, labels)

    @classmethod
    def ragged(cls, vertices: ArrayLike, corners: ArrayLike, sizes: ArrayLike, labels: Sequence[Any]) -> Faces:
        """Faces with `sizes` corners each."""
        sizes = np.asarray(sizes, np.int64)
        names, own = np.unique(np.array([str(label) for label in labels], dtype=str), return_inverse=True)
        if len(own) != len(sizes):
            raise refusal(f"{len(own)} labels for {len(sizes)} faces", "give one label for each face")
        flat = np.ascontiguousarray(corners, dtype=np.int64).reshape(-1)
        return cls(positions(vertices), flat, np.cumsum(sizes), own.astype(np.int64), names.tolist())

    def turned_over(self) -> Faces:
        """The same faces, their backs in front."""
        backwards = np.arange(len(self.corners))
        starts = np.concatenate([[0], self.ends[:-1]])
        order = np.repeat(starts + self.ends - 1, self.ends - starts) - backwards
        return Faces(self.vertices, self.corners[order], self.ends, self.labels, self.names)


def positions(vertices: ArrayLike) -> Array:
    """Vertices (v, 3); those in a plane, (v, 2), lie at z = 0."""
    array = real("vertices", vertices)
    if array.ndim == 2 and array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    return rows("vertices", array)


def whole_numbers(name: str, block: ArrayLike) -> NDArray[np.int64]:
    """Faces of equally many corners, (n, k)."""
    array = array_of(name, block)
    if array.ndim != 2 or (array.size and array.dtype.kind not in "iu"):
        raise refusal(
            f"{name}: an array of {array.dtype} of shape {array.shape} instead of whole numbers of shape (f, k)",
            "give a row of indices of vertices for each of them",
        )
    return array.astype(np.int64)
