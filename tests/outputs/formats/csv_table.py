"""Tables of comma-separated values: a column is one of the table."""

import csv
import io

from content import Content
from formats.text import NUMBER
from masks import Masks


def masked(file: str, data: bytes, masks: Masks) -> bytes:
    out = io.StringIO()
    csv.writer(out).writerows(_rows(data, masks))
    return out.getvalue().encode()


def content(file: str, data: bytes, masks: Masks) -> Content:
    found = Content()
    header, *rows = _rows(data, masks) or [[]]
    found.texts.append(",".join(header))
    for row in rows:
        shape = []
        for index, cell in enumerate(row):
            name = header[index] if index < len(header) else f"column {index}"
            is_number = NUMBER.fullmatch(cell)
            shape.append("#" if is_number else cell)
            if is_number:
                found.column(name).append(float(cell))
        found.texts.append(",".join(shape))
    return found


def _rows(data: bytes, masks: Masks) -> list[list[str]]:
    """All rows, the header among them, without the columns that were measured."""
    rows = list(csv.reader(io.StringIO(data.decode())))
    measured = [index for index, name in enumerate(rows[0] if rows else []) if name in masks.measured_keys]
    return [[cell for index, cell in enumerate(row) if index not in measured] for row in rows]
