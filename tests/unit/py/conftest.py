"""These tests need no YADE: `python3 -m pytest tests/unit/py`, with numpy, scipy, pandas, matplotlib, yaml, hypothesis and pytest."""
import plainpackage

plainpackage.provideWhereMissing()
