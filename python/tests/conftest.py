"""What the tests have in common: the command beside which the package is held."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
COMMAND = Path(os.environ.get("RADIOSITY", ROOT / "target" / "release" / "radiosity"))


@pytest.fixture
def command(tmp_path: Path):
    """Runs the command in an empty folder; returns what it printed."""

    def run(*words: object) -> bytes:
        typed = [str(COMMAND), *map(str, words)]
        done = subprocess.run(typed, cwd=tmp_path, capture_output=True)
        assert done.returncode == 0, done.stderr.decode()
        return done.stdout

    return run
