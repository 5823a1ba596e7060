"""What can be measured of a scene."""
