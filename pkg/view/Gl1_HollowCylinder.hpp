// The container in YADE's 3D view.
#pragma once

#include <pkg/common/GLDrawFunctors.hpp>
#include <pkg/superquadric/HollowCylinder.hpp>

namespace yade {

class Gl1_HollowCylinder : public GlShapeFunctor {
public:
	void go(const shared_ptr<Shape>&, const shared_ptr<State>&, bool wireAll, const GLViewInfo&) override;
	RENDERS(HollowCylinder);
	// clang-format off
	YADE_CLASS_BASE_DOC_STATICATTRS(Gl1_HollowCylinder, GlShapeFunctor,
		"Renders :yref:`HollowCylinder`: its inner side only, which holds the particles, so that one sees them from outside; or as wire. What lies "
		"outside the scene's radius is left out.",
		((bool, wire, false,, "Only show wireframe."))
		((int, div, 48,, "Number of divisions around the axis; at least 3."))
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Gl1_HollowCylinder);

} // namespace yade
