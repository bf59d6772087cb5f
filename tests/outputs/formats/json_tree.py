"""JSON: a column is all numbers of one path of keys, whatever their indices in lists."""

import json

from content import Content
from formats import text
from masks import Masks


class Literal(str):
    """A number as it is written."""


def masked(file: str, data: bytes, masks: Masks) -> bytes:
    return json.dumps(_without(parse(data), masks.measured_keys), ensure_ascii=False).encode()


def content(file: str, data: bytes, masks: Masks) -> Content:
    found = Content()
    add(found, "", "", _without(parse(data), masks.measured_keys | masks.uncompared_keys))
    return found


def add(to: Content, path: str, key: str, tree: object) -> None:
    """Adds a tree that stands at this path, under this key."""
    match tree:
        case Literal():
            to.texts.append(f"{path}: #")
            to.column(path, key).append(float(tree))
        case str():
            to.texts.append(f"{path}: text")
            text.add(to, f"{path}: ", tree)
        case dict():
            to.texts.append(f"{path}: {{{', '.join(tree)}}}")
            for own, value in tree.items():
                add(to, f"{path}.{own}", own, value)
        case list():
            to.texts.append(f"{path}: list of {len(tree)}")
            for value in tree:
                add(to, path, key, value)
        case _:
            to.texts.append(f"{path}: {tree}")


def parse(data: bytes) -> object:
    """The tree, its numbers as they are written."""
    return json.loads(data, parse_int=Literal, parse_float=Literal, parse_constant=Literal)


def _without(tree: object, keys: frozenset[str]) -> object:
    """The tree without what stands under these keys."""
    match tree:
        case dict():
            return {key: _without(value, keys) for key, value in tree.items() if key not in keys}
        case list():
            return [_without(value, keys) for value in tree]
        case _:
            return tree
