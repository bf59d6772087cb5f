"""The tutorial runs, and prints what it says it prints.

python python/tests/test_tutorial.py        # writes down what its blocks print
"""

import contextlib
import io
import os
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TUTORIAL = ROOT / "python" / "docs" / "tutorial.md"
BLOCKS = re.compile(r"```python\n(?P<code>.*?)```\n(?:\n```text\n(?P<output>.*?)```\n)?", re.DOTALL)
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def printed(code: str, names: dict) -> str:
    """What a block prints."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(code, str(TUTORIAL), "exec"), names)
    return out.getvalue()


def same(ours: str, stated: str) -> bool:
    """Whether texts agree: words exactly, numbers within a unit and a half of the last digit, rounding errors in being small."""
    numbers = [list(map(float, NUMBER.findall(text))) for text in (ours, stated)]
    words = [NUMBER.sub("#", text).split() for text in (ours, stated)]
    return words[0] == words[1] and all(
        abs(a - b) <= 1.5 * step or (max(abs(a), abs(b)) < 1e-9) for a, b, step in zip(*numbers, steps(stated), strict=True)
    )


def steps(text: str) -> list[float]:
    """A unit of the last digit of each number."""
    found = []
    for number in NUMBER.findall(text):
        digits, _, power = number.partition("e")
        found.append(10.0 ** (int(power or 0) - len(digits.partition(".")[2])))
    return found


def test_the_tutorial_prints_what_it_says(monkeypatch):
    pytest.importorskip("matplotlib")
    pytest.importorskip("pandas")
    monkeypatch.chdir(ROOT)
    picture = ROOT / "python" / "docs" / "desk.png"
    kept = picture.read_bytes()
    names = {}
    blocks = list(BLOCKS.finditer(TUTORIAL.read_text()))
    assert len(blocks) > 10
    try:
        for block in blocks:
            ours, stated = printed(block["code"], names), block["output"] or ""
            assert same(ours, stated), f"{block['code']}\nprints\n{ours}\ninstead of\n{stated}"
    finally:
        picture.write_bytes(kept)


def test_numbers_that_differ_are_found():
    assert same("mean 274.1 lx", "mean 274.0 lx")
    assert not same("mean 275.0 lx", "mean 274.0 lx")
    assert not same("mean 274.0 lux", "mean 274.0 lx")


def main() -> None:
    """Fills in what the blocks print."""
    os.chdir(ROOT)
    names: dict = {}

    def filled(block: re.Match) -> str:
        ours = printed(block["code"], names)
        text = f"\n```text\n{ours}```\n" if ours else ""
        return f"```python\n{block['code']}```\n{text}"

    TUTORIAL.write_text(BLOCKS.sub(filled, TUTORIAL.read_text()))


if __name__ == "__main__":
    sys.exit(main())
