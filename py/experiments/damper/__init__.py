"""Particles in a box that is shaken."""
