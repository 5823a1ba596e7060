"""What Python computes without YADE is what the plugin computes, bit for bit: beds must not depend on who asked."""
import random

import pytest
from yade.wrapper import CurvatureMat, Law2_ScGeom_CurvaturePhys_HertzMindlin, Law2_ScGeom_ElastoplasticPhys_LoadingUnloading, Superquadric

from yade.superquadric.scene.contactlaws import CONTACT_LAWS, EFFECTIVE_MASS_AT_CONTACT, OVERLAP_LIMIT
from yade.superquadric.scene.engines import LAWS
from yade.superquadric.scene.shapes import ParticleShape, unitVolume
from yade.superquadric.scene.timestep import rayleighTimeStep

SEEDS = range(200)
EXPONENTS = (2, 2.5, 3, 4, 8, 20)  # 2 has no dual exponent, 4 has the dual exponent 2


def exponents(rng):
    return tuple(rng.choice([*EXPONENTS, rng.uniform(2, 20)]) for _ in range(2))


@pytest.mark.parametrize('seed', SEEDS)
def test_volumesAreThoseOfThePlugin(seed):
    n1, n2 = exponents(random.Random(seed))
    assert unitVolume(n1, n2) == Superquadric(extents=(1, 1, 1), n1=n1, n2=n2).volume()


@pytest.mark.parametrize('seed', SEEDS)
def test_boundingRadiiAreThoseOfThePlugin(seed):
    rng = random.Random(seed)
    (n1, n2), extents = exponents(rng), tuple(10 ** rng.uniform(-4, 0) for _ in range(3))
    assert ParticleShape(extents, n1, n2, False).boundingRadius == Superquadric(extents=extents, n1=n1, n2=n2).boundingRadius()


@pytest.mark.parametrize('seed', SEEDS)
def test_criticalTimeStepsAreThoseOfThePlugin(seed):
    rng = random.Random(seed)
    size, young, poisson, density = 10 ** rng.uniform(-4, 0), 10 ** rng.uniform(5, 12), rng.uniform(-0.9, 0.49), 10 ** rng.uniform(2, 4)
    plugin = CurvatureMat(young=young, poisson=poisson, density=density).criticalTimeStep(size)
    assert rayleighTimeStep(size, young, poisson, density) == pytest.approx(plugin, rel=1e-15)  # some processors fuse a product and a sum


def test_lawsHaveTheDefaultsOfThePlugin():
    assert tuple(LAWS) == CONTACT_LAWS
    for law in (Law2_ScGeom_CurvaturePhys_HertzMindlin(), Law2_ScGeom_ElastoplasticPhys_LoadingUnloading()):
        assert (law.overlapLimit, law.effectiveMassAtContact) == (OVERLAP_LIMIT, EFFECTIVE_MASS_AT_CONTACT)
