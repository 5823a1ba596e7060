"""What every experiment has; each one has a folder of its own here."""
