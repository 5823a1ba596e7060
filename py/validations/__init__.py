"""Checks against closed forms, which the studies run."""
