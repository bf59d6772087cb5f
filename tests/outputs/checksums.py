"""SHA-256 of the outputs of each command, and the file `checksums` that keeps them.

Its first line tells the features of the processor and the C library: kernels of linear algebra and functions such as sin are
chosen by them at run time, and round differently.
"""

import hashlib
import pathlib
import platform

from formats import format_of
from masks import Masks
from recording import outputs

PLACE = pathlib.Path(__file__).with_name("checksums")
# Features that numerical libraries look for.
LOOKED_FOR = ("avx2", "fma", "avx512f")
HEAD = "made with: "


def of_recording(folder: pathlib.Path, masks: Masks) -> dict[str, str]:
    """The checksum of each command: of the names of its files and what they hold, without what was measured."""
    return {command: _of_command(folder / command, names, masks) for command, names in outputs(folder).items()}


def _of_command(folder: pathlib.Path, names: list[str], masks: Masks) -> str:
    digest = hashlib.sha256()
    for name in names:
        data = format_of(name).masked(name, (folder / name).read_bytes(), masks)
        digest.update(f"{name} {len(data)}\n".encode() + data)
    return digest.hexdigest()


def machine(info: pathlib.Path = pathlib.Path("/proc/cpuinfo")) -> str:
    """The kind of processor, which of the features it has ("unknown" where the system does not tell), the C library."""
    lines = info.read_text().splitlines() if info.exists() else []
    flags = next((line.partition(":")[2].split() for line in lines if line.startswith(("flags", "Features"))), None)
    features = ["unknown"] if flags is None else [feature for feature in LOOKED_FOR if feature in flags]
    return " ".join([platform.machine(), *features, *platform.libc_ver()])


def text(checksums: dict[str, str]) -> str:
    """The file of these checksums, as they come out here."""
    return "\n".join([HEAD + machine(), *(f"{digest}  {name}" for name, digest in checksums.items()), ""])


def read() -> tuple[str, dict[str, str]]:
    """The processor features of the committed file, and its checksums."""
    head, *lines = PLACE.read_text().splitlines()
    pairs = [line.split() for line in lines]
    return head.removeprefix(HEAD), {name: digest for digest, name in pairs}
