"""Pages: text, with pictures in it (a column is a channel), and the packed numbers of walk-throughs (a column is their bytes)."""

import base64
import re
import zlib

from content import Content
from formats import png, text
from formats.text import masked
from masks import Masks

__all__ = ["content", "masked"]

PICTURE = re.compile(r"(?<=data:image/png;base64,)[A-Za-z0-9+/=]+")
PACKED = re.compile(r'(?<=<script type="text/plain" id=")(light|shape)">([A-Za-z0-9+/=]*)')


def content(file: str, data: bytes, masks: Masks) -> Content:
    found, page = Content(), masks.without_noise(file, masked(file, data, masks).decode())
    for index, picture in enumerate(PICTURE.findall(page)):
        png.add(found, f"picture {index} ", base64.b64decode(picture))
    for name, packed in PACKED.findall(page):
        # Deflated without a header (RFC 1951).
        found.column(name).extend(zlib.decompress(base64.b64decode(packed), -zlib.MAX_WBITS))
    text.add(found, "", PACKED.sub(r'\1">', PICTURE.sub("", page)))
    return found
