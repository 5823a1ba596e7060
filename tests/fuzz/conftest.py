"""The number of examples of each fuzz test goes into the report, for tests/run to count."""
import fuzzing
import pytest


@pytest.fixture(autouse=True)
def countExamples(record_property):
    before = fuzzing.tried
    yield
    record_property('examples', fuzzing.tried - before)
