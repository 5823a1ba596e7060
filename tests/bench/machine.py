"""What was measured on: processor, load, versions. No names of machines or paths."""
import os
import platform
import re
import subprocess
import time
from pathlib import Path

project = Path(__file__).resolve().parents[2]


def describe():
    """A dict of plain values."""
    return {
        'processor': _processor(),
        'cores': os.cpu_count(),
        'loadAverage': os.getloadavg()[0],
        'system': platform.freedesktop_os_release().get('PRETTY_NAME', ''),
        'yade': _output('dpkg-query', '-W', '-f', '${Version}', 'yade'),
        'compiler': _output('g++', '-dumpfullversion'),
        'commit': commit(),
        'date': time.strftime('%Y-%m-%d', time.gmtime()),
    }


def _processor():
    with open('/proc/cpuinfo') as info:
        found = re.search(r'^model name\s*: (.*)$', info.read(), re.MULTILINE)
    return found.group(1) if found else platform.machine()


def commit():
    """The commit, with a + where the checkout differs from it; empty where it cannot be told."""
    git = ['git', '-C', str(project), '-c', 'safe.directory=*']
    name = _output(*git, 'rev-parse', '--short', 'HEAD')
    return name + ('+' if name and _output(*git, 'status', '--porcelain', '--untracked-files=no') else '')


def _output(*command):
    """What a command writes; empty where it fails or is not there."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ''
