"""Text: a number belongs to the column of its place in lines of one shape, which is the line without its numbers."""

import re

from content import Content
from masks import Masks

# No part of a word, such as the 0 of wall-x0, and of no version such as 0.1.0.
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?!\w)")


def masked(file: str, data: bytes, masks: Masks) -> bytes:
    return masks.without_measured(file, data.decode()).encode()


def content(file: str, data: bytes, masks: Masks) -> Content:
    found = Content()
    add(found, "", masks.without_noise(file, masked(file, data, masks).decode()))
    return found


def add(to: Content, name: str, text: str) -> None:
    """Adds the lines of a text, whose columns are called `name` and by the shape of their line."""
    for line in text.splitlines():
        # Tables for people are as wide as their numbers.
        shape = " ".join(NUMBER.sub("#", line).split())
        to.texts.append(shape)
        for index, number in enumerate(NUMBER.findall(line)):
            to.column(f"{name}{shape} [{index}]", key="").append(float(number))
