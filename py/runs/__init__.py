"""Runs in stages that can be interrupted and taken up again, and their parameters."""
