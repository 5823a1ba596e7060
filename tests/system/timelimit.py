"""How long a test waits for a program that it starts: half of what tests/run gives the whole file, so that it is the test that fails and says why."""
import os

LIMIT = int(os.environ.get('TEST_TIME_LIMIT', 600)) / 2  # [s]
