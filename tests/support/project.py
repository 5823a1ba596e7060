"""What tests that start programs need: where this checkout is, and how long to wait."""
import os
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
SUPPORT = PROJECT / 'tests' / 'support'
# Half of what tests/run gives the whole file, so that it is the test that fails and says why.
LIMIT = int(os.environ.get('TEST_TIME_LIMIT', 600)) / 2  # [s]
