"""Whether as many particles as are asked for fit into the memory: the system would kill the process without a word, hours later perhaps."""
import math
from pathlib import Path

# Of 10^5 cubes with 2.3 contacts and 9.5 candidate pairs each it was 9,600 (docs/scaling.md); deeper beds have a little more of both.
BYTES_A_PARTICLE = 11000
MEMORY = Path('/proc/meminfo')
GROUP = Path('/sys/fs/cgroup')  # limits of a container, or of a job on a cluster


def available():
    """Bytes that this process may still use, as far as the system tells; infinite where it does not."""
    return min(_ofSystem(), _ofGroup())


def check(particles):
    """ValueError if a bed of so many `particles` does not fit into the available memory."""
    needed, left = BYTES_A_PARTICLE * particles, available()
    if needed > left:
        raise ValueError(f'number of particles = {particles}: with their contacts they need about {needed / 1e9:.3g} GB of memory, '
                         f'{left / 1e9:.3g} GB are available; share them among several machines (docs/scaling.md)')


def _ofSystem():
    try:
        return next(1024 * int(line.split()[1]) for line in MEMORY.read_text().splitlines() if line.startswith('MemAvailable'))
    except (OSError, StopIteration):
        return math.inf


def _ofGroup():
    try:
        return int((GROUP / 'memory.max').read_text()) - int((GROUP / 'memory.current').read_text())
    except (OSError, ValueError):  # none, or its limit is "max"
        return math.inf
