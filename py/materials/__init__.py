"""Material files and the shipped materials."""
