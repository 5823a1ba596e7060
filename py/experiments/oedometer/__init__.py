"""A bed of particles that break, compressed by a plate."""
