"""The version of plugin and package, in this place alone: CMake reads it here (tests/unit/py/test_version.py)."""
__version__ = '0.2.0'
