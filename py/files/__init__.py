"""Files that are whole or not there, with sums that show damage: YAML, CSV, JSON, arrays."""
