"""Everything that is drawn: figures, particles, animations, the 3D view."""
