"""`masks.toml`, read: parts of outputs that are no results, or rounding alone."""

import fnmatch
import pathlib
import re
import tomllib
from dataclasses import dataclass

PLACE = pathlib.Path(__file__).with_name("masks.toml")


@dataclass(frozen=True)
class Pattern:
    """A pattern of text in files of some names."""

    files: list[str]
    pattern: re.Pattern[str]

    def is_of(self, file: str) -> bool:
        return any(fnmatch.fnmatch(file, name) for name in self.files)


class Masks:
    """The names and patterns of `masks.toml`."""

    def __init__(self, place: pathlib.Path = PLACE) -> None:
        named = tomllib.loads(place.read_text())
        self.measured_keys = frozenset(named["measured"]["keys"])
        self.scales: dict[str, float | str] = named["noise"]["scales"]
        self.uncompared_keys = frozenset(named["noise"]["keys"])
        self._measured = _patterns(named["measured"]["text"])
        self._noise = _patterns(named["noise"]["text"])

    def without_measured(self, file: str, text: str) -> str:
        """The text of a file without what was measured."""
        return _without(self._measured, file, text)

    def without_noise(self, file: str, text: str) -> str:
        """The content without digits that rounding alone makes."""
        return _without(self._noise, file, text)


def _patterns(tables: list[dict]) -> list[Pattern]:
    return [Pattern(table["files"], re.compile(table["pattern"])) for table in tables]


def _without(patterns: list[Pattern], file: str, text: str) -> str:
    for pattern in patterns:
        if pattern.is_of(file):
            text = pattern.pattern.sub("", text)
    return text
