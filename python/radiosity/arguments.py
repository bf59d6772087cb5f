"""What users give → checked numbers and arrays; messages name the argument, what it is, and what is wanted."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._radiosity import Error

Array = NDArray[np.float64]


def refusal(message: str, cure: str) -> Error:
    """What is wrong, and how to mend it."""
    return Error(f"{message}\nhelp: {cure}")


def whole(name: str, value: Any, least: int, most: int, cure: str) -> int:
    """A whole number in a range; whole floats pass, as in SciPy."""
    if isinstance(value, (float, np.floating)) and float(value).is_integer():
        value = int(value)
    if isinstance(value, (float, np.floating)):
        raise refusal(f"{name} is {value}, not a whole number", f"give a whole number from {least} to {most}")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: a whole number is wanted, not {type(value).__name__}") from None
    if not least <= number <= most:
        raise refusal(f"{name} = {_short(number)} is not in {least} … {most}", cure)
    return number


def _short(number: int) -> str:
    return str(number) if abs(number) < 10**20 else f"±10^{abs(number).bit_length() * 3 // 10}"


def array_of(name: str, value: ArrayLike) -> NDArray[Any]:
    """An array of any kind, none of whose entries is masked."""
    if np.ma.is_masked(value):
        raise refusal(f"{name}: entries are masked", "leave them out, or fill them: value.filled(0)")
    try:
        return np.asarray(value)
    except ValueError:
        raise refusal(f"{name}: rows of different lengths", "give an array, or lists of equal lengths") from None


def real(name: str, value: ArrayLike) -> Array:
    """A contiguous array of floats; nothing complex, no objects, no text."""
    array = array_of(name, value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: real numbers are wanted, not {array.dtype}")
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


def finite(name: str, value: ArrayLike) -> Array:
    """Finite numbers."""
    array = real(name, value)
    if not np.isfinite(array).all():
        raise refusal(f"{name}: an entry is no finite number", "give finite numbers")
    return array


def numbers(name: str, value: ArrayLike, shape: tuple[int | str, ...]) -> Array:
    """Real numbers in an array of this shape, in which a name stands for any length; not copied where it is one."""
    array = real(name, value)
    fits = array.ndim == len(shape) and all(
        isinstance(side, str) or length == side for length, side in zip(array.shape, shape)
    )
    if not fits:
        wanted = ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "")
        raise refusal(f"{name}: an array of shape {array.shape} instead of ({wanted})", f"give an array of shape ({wanted})")
    return array


def rows(name: str, value: ArrayLike, least: int = 0) -> Array:
    """Finite points (n, 3), `least` at least."""
    array = finite(name, numbers(name, value, ("n", 3)))
    if len(array) < least:
        raise refusal(f"{name}: {len(array)} points", f"give {least} points at least")
    return array


def number(name: str, value: Any) -> float:
    """One number; no text that reads as one."""
    if isinstance(value, (str, bytes)):
        raise TypeError(f"{name}: a number is wanted, not {type(value).__name__}")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name}: a number is wanted, not {type(value).__name__}") from None


def pair(name: str, value: Any) -> tuple[Any, Any]:
    """Two things, of whatever kind."""
    try:
        first, second = value
    except (TypeError, ValueError):
        raise TypeError(f"{name}: two numbers are wanted, not {value!r:.60}") from None
    return first, second


def named_numbers(name: str, value: Any) -> dict[str, float]:
    """Numbers by name, of a mapping."""
    if not isinstance(value, Mapping):
        raise TypeError(f"{name}: a mapping of names to numbers is wanted, not {type(value).__name__}")
    return {text(name, key): number(f"{name}[{key!r}]", own) for key, own in value.items()}


def path(name: str, value: Any) -> str:
    """The path of a file."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{name}: a path is wanted, not {type(value).__name__}")
    return text(name, os.fspath(value))


def file_path(name: str, value: Any) -> str:
    """The path of a file that is read; `-`, which stands for standard input in the command, is none."""
    given = path(name, value)
    if given == "-":
        raise refusal(f"{name}: '-' is no file", "read standard input with sys.stdin, and its text with Scene.from_toml")
    return given


def text(name: str, value: Any) -> str:
    """A text."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: a text is wanted, not {type(value).__name__}")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise refusal(f"{name}: {value!r} has half a character", "give a text of whole characters") from None
    return value


def texts(name: str, value: Any) -> list[str]:
    """Texts, in a list, a tuple or an array."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, (str, bytes)) or not isinstance(value, Sequence):
        raise TypeError(f"{name}: a list of texts is wanted, not {type(value).__name__}")
    return [text(f"{name}[{index}]", own) for index, own in enumerate(value)]
