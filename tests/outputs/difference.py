"""By how much two recordings differ: |a - b| over the largest absolute value of the column, in both of them."""

import math
import pathlib
from collections.abc import Iterator
from dataclasses import dataclass

from content import Column, Content
from formats import format_of
from masks import Masks
from recording import outputs


@dataclass(frozen=True)
class Difference:
    """A difference at a place, which words tell; infinite between texts."""

    place: str
    size: float
    words: str


def between(one: pathlib.Path, other: pathlib.Path, masks: Masks) -> Iterator[tuple[str, list[Difference]]]:
    """The name of each command with its differences, one for each column and file at the most."""
    files, others = outputs(one), outputs(other)
    for command, names in files.items():
        yield command, list(_of_command(one / command, other / command, names, others[command], masks))


def _of_command(
    one: pathlib.Path, other: pathlib.Path, names: list[str], others: list[str], masks: Masks
) -> Iterator[Difference]:
    for name in sorted({*names} ^ {*others}):
        yield Difference(name, math.inf, f"is in one recording only, {one if name in names else other}")
    for name in sorted({*names} & {*others}):
        pair = [(folder / name).read_bytes() for folder in (one, other)]
        if pair[0] != pair[1]:
            contents = [format_of(name).content(name, data, masks) for data in pair]
            yield from of_file(name, contents[0], contents[1], masks)


def of_file(file: str, one: Content, other: Content, masks: Masks) -> Iterator[Difference]:
    """The differences of two contents of a file."""
    differ = one.texts != other.texts
    if differ:
        yield Difference(file, math.inf, _first(one.texts, other.texts))
    for name, column in one.columns.items():
        if name in other.columns and column.numbers != other.columns[name].numbers:
            yield from _of_column(f"{file}: {name}", column, other.columns[name], _scale(name, one, other, masks))
    # Where texts differ, so do the names of columns.
    for name in () if differ else sorted(one.columns.keys() ^ other.columns.keys()):
        yield Difference(f"{file}: {name}", math.inf, "is in one recording only")


def _first(one: list[str], other: list[str]) -> str:
    """The first texts that differ."""
    for mine, yours in zip(one, other):
        if mine != yours:
            return f"{_short(mine)} became {_short(yours)}"
    return f"{len(one)} pieces of text became {len(other)}"


def _short(text: str) -> str:
    return repr(text) if len(text) <= 200 else f"{text[:200]!r}…"


def _scale(name: str, one: Content, other: Content, masks: Masks) -> float:
    """Scale of the differences of a column."""
    key = one.columns[name].key
    match masks.scales.get(key):
        case None:
            return _largest(one.columns[name], other.columns[name])
        case str(beside):
            beside = name.removesuffix(key) + beside
            return _largest(one.columns[beside], other.columns[beside])
        case scale:
            return float(scale)


def _largest(*columns: Column) -> float:
    return max((abs(x) for column in columns for x in column.numbers if math.isfinite(x)), default=0.0)


def _of_column(place: str, one: Column, other: Column, scale: float) -> Iterator[Difference]:
    if len(one.numbers) != len(other.numbers):
        yield Difference(place, math.inf, f"{len(one.numbers)} numbers became {len(other.numbers)}")
        return
    pairs = list(zip(one.numbers, other.numbers))
    differing = [index for index, (a, b) in enumerate(pairs) if not _same(a, b)]
    if differing:
        worst = max(differing, key=lambda index: _relative(*pairs[index], scale))
        a, b = pairs[worst]
        words = f"{a!r} became {b!r}, number {worst} of {len(pairs)}, of which {len(differing)} differ"
        yield Difference(place, _relative(a, b, scale), words)


def _same(a: float, b: float) -> bool:
    return a == b or (math.isnan(a) and math.isnan(b))


def _relative(a: float, b: float, scale: float) -> float:
    if not (math.isfinite(a) and math.isfinite(b) and scale > 0):
        return math.inf
    return abs(a - b) / scale
