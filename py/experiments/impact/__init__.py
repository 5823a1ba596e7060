"""An impactor falls on a bed of particles."""
