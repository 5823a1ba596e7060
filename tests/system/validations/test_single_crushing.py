"""Particles that break once (singlecrushing) against the exact distribution of the cut."""
import numpy as np
import pytest

from yade.superquadric.validations import cutdistribution, singlecrushing


def test_fragmentsFollowTheCutOfTheirExponent():
    parents = singlecrushing.uniformSizes(28e-3, 30e-3, 100, seed=1)
    fragments = singlecrushing.breakEach(parents, 2, seed=1)
    assert fragments.shape == (100, 8)
    np.testing.assert_allclose((fragments ** 3).sum(axis=1), np.array(parents) ** 3, rtol=1e-12)
    assert cutdistribution.agreement(fragments, 2, parents, 30e-3, samples=200)[1] > 0.01
    for wrong in (1, 3):
        assert cutdistribution.agreement(fragments, wrong, parents, 30e-3, samples=200)[1] < 0.01


@pytest.mark.parametrize('call, name', [
    (lambda: singlecrushing.uniformSizes(2, 1, 5, 1), 'low'), (lambda: singlecrushing.uniformSizes(1, 2, 0, 1), 'number'),
    (lambda: singlecrushing.breakEach([1, -1], 2, 1), 'sizes'), (lambda: singlecrushing.breakEach([1], 0, 1), 'cutExponent')])
def test_badInputIsNamed(call, name):
    with pytest.raises(ValueError, match=name):
        call()
