#include "CurvaturePhys.hpp"

namespace yade {

YADE_PLUGIN((CurvaturePhys));

} // namespace yade
