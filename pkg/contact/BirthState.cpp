#include "BirthState.hpp"

namespace yade {

YADE_PLUGIN((BirthState));

} // namespace yade
