"""Whether as many particles as are asked for fit into the memory: the system may kill the process without a word, hours later perhaps."""
from __future__ import annotations

import math
from pathlib import Path

# Measured: 9,600 a body in a bed of 10^5 cubes with 2.27 contacts each; deeper beds have more contacts.
BYTES_A_PARTICLE = 11000
MEMORY = Path('/proc/meminfo')
GROUPS = Path('/sys/fs/cgroup')  # limits of a container, or of a job on a cluster (control groups, version 2)
OWN = Path('/proc/self/cgroup')
RECLAIMABLE = ('inactive_file', 'active_file')  # the page cache: most of it is given back when memory is short


def available() -> float:
    """Bytes that this process may still use, as far as the system tells; infinite where it does not. Control groups of version 1 are not seen."""
    return min(_ofSystem(), *map(_ofGroup, _groups()))


def check(particles: int) -> None:
    """ValueError if a bed of so many `particles` would hardly fit into the available memory."""
    needed, left = BYTES_A_PARTICLE * particles, available()
    if needed > left:
        raise ValueError(f'number of particles = {particles}: with their contacts they need about {needed / 1e9:.3g} GB of memory, '
                         f'{left / 1e9:.3g} GB are available; share them among several machines (docs/scaling.md)')


def _ofSystem() -> float:
    try:
        return next(1024 * int(line.split()[1]) for line in MEMORY.read_text().splitlines() if line.startswith('MemAvailable'))
    except (OSError, StopIteration):
        return math.inf


def _groups() -> list[Path]:
    """The folders of this process's control group and of all above it, each of which may have a limit."""
    try:
        own = next((line[3:].strip('/') for line in OWN.read_text().splitlines() if line.startswith('0::')), '')
    except OSError:
        own = ''
    folder = GROUPS / own
    return [folder, *(parent for parent in folder.parents if parent.is_relative_to(GROUPS))]


def _ofGroup(folder: Path) -> float:
    try:
        most, used = (int((folder / name).read_text()) for name in ('memory.max', 'memory.current'))
        parts = dict(line.split() for line in (folder / 'memory.stat').read_text().splitlines())
        return most - used + sum(int(parts.get(name, 0)) for name in RECLAIMABLE)
    except (OSError, ValueError):  # there is none, or its limit is "max"
        return math.inf
