"""A thousand bad inputs are refused by exceptions; none of them panics or ends the process."""

import re
import subprocess
import sys
from pathlib import Path


def test_a_thousand_bad_inputs_are_refused_and_none_ends_the_process():
    search = [sys.executable, str(Path(__file__).with_name("bad_inputs.py")), "2500"]
    run = subprocess.run(search, capture_output=True, text=True, timeout=600, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "panicked" not in run.stderr
    total = re.search(r"^(\d+) refused$", run.stdout, re.MULTILINE)
    assert total and int(total[1]) >= 1000, run.stdout
