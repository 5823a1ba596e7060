"""Whether particles are inside their container (enclosure), on places that are known."""
import numpy as np
import pytest

from yade.superquadric.measure import enclosure
from yade.superquadric.measure.snapshot import Snapshot
from yade.superquadric.scene.container import Container

BOX = Container(0, (), None, 0.2, 0.4, 1.0)
CYLINDER = Container(0, (), 0.1, None, None, 1.0)


def snapshot(*positions):
    number = len(positions)
    return Snapshot(ids=range(number), positions=positions, rotations=[np.eye(3)] * number, extents=[(0.01,) * 3] * number,
                    exponents=[(2, 2)] * number)


@pytest.mark.parametrize('container, position, outside', (
    (BOX, (0, 0, 0.15), -0.1), (BOX, (0.095, 0, 0.15), -0.005), (BOX, (-0.12, 0, 0.15), 0.02), (BOX, (0.05, -0.21, 0.15), 0.01),
    (BOX, (0, 0, -0.003), 0.003), (BOX, (0, 0, 0.33), 0.03), (CYLINDER, (0.06, 0.08, 0.15), 0.0),
    (CYLINDER, (0.09, 0.09, 0.15), 0.1 * (0.9 * 2 ** 0.5 - 1))))
def test_distanceOutside(container, position, outside):
    assert enclosure.protrusions(snapshot(position), container, top=0.3) == pytest.approx([outside], abs=1e-12)


def test_describe():
    """Of size 0.02: one inside that touches, one pressed into the wall by a fifth of its size, one with its centre outside, one outside
    altogether."""
    places = ((0.09, 0, 0.1), (0.094, 0, 0.1), (0.103, 0, 0.1), (0, 0, -0.011))
    described = enclosure.describe(snapshot(*places), np.full(4, 0.02), BOX, 0.3)
    assert described == {'centresOutside': 2, 'lost': 1, 'deepest': pytest.approx(1.05)}
    assert enclosure.describe(snapshot(places[1]), np.array([0.02]), BOX, 0.3)['deepest'] == pytest.approx(0.2)
