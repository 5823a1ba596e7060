"""Run pytest inside YADE: `yade -n -x tests/run_pytest.py [PYTEST ARGUMENT]...`."""

import os
import sys

import pytest

sys.stdout.flush()
status = int(pytest.main(sys.argv[1:]))
sys.stdout.flush()
sys.stderr.flush()
# Not sys.exit: a failing test may leave YADE's scene running in a thread which would be waited for.
os._exit(status)
