"""The contact laws by name, and the defaults of their settings as numbers: those of the C++ classes, for parameters that need no YADE."""
from __future__ import annotations

CURVATURE, ELASTOPLASTIC = 'curvature', 'elastoplastic'
CONTACT_LAWS = (CURVATURE, ELASTOPLASTIC)  # Wang & Ji (2018); Li et al. (2018)

OVERLAP_LIMIT = 0.1  # largest overlap that the laws are meant for, over the smallest half size
EFFECTIVE_MASS_AT_CONTACT = True  # whether the mass m* of the normal damping counts that a push beside the centre also turns the bodies
