"""What a scene is made of and how it is run."""
