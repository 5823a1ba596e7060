#include "CurvaturePhys.hpp"

#include <pkg/mechanics/HertzMindlin.hpp>

namespace yade {

YADE_PLUGIN((CurvaturePhys));

Real CurvaturePhys::storedEnergy() const { return superquadric::hertzMindlin::normalEnergy(hertzStiffness, overlap) + shearEnergy; }

} // namespace yade
