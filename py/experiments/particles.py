"""The particles of an experiment, in the one form that equal beds have in common."""
from ..scene.shapes import BLOCK_EXPONENT, particleShape

# Exponents that a shape has by its name, and the names: with aspect 1, and with any other.
NAMED = {(2.0, 2.0): ('ellipsoid', 'ellipsoid'), (BLOCK_EXPONENT, 2.0): ('cylinder', 'cylinder'), (BLOCK_EXPONENT, BLOCK_EXPONENT): ('cube', 'block')}


def standard(values):
    """The complete parameters `values` with the shape in its one standard form, so that equal particles are the same bed.

    A shape is its exponents and its aspect: a cylinder with n2 = 8 is a cube or block, a cube with n1 = n2 = 2 an ellipsoid. Only
    the sphere stays one by name, as it is YADE's own.
    """
    shape = particleShape(values['shape'], 1.0, values['aspect'], values['n1'], values['n2'])
    if shape.asSphere:
        return {**values, 'n1': None, 'n2': None}
    exponents, regular = (shape.n1, shape.n2), values['aspect'] == 1
    if exponents in NAMED:
        return {**values, 'shape': NAMED[exponents][0 if regular else 1], 'n1': None, 'n2': None}
    return {**values, 'shape': 'cube' if regular else 'block', 'n1': shape.n1, 'n2': shape.n2}
