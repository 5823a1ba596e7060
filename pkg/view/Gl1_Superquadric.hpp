// Superquadrics in YADE's 3D view.
#pragma once

#include <pkg/common/GLDrawFunctors.hpp>
#include <pkg/superquadric/Superquadric.hpp>

namespace yade {

class Gl1_Superquadric : public GlShapeFunctor {
public:
	void go(const shared_ptr<Shape>&, const shared_ptr<State>&, bool wireAll, const GLViewInfo&) override;
	RENDERS(Superquadric);
	// clang-format off
	YADE_CLASS_BASE_DOC_STATICATTRS(Gl1_Superquadric, GlShapeFunctor,
		"Renders :yref:`Superquadric`: smooth, as finely as the body is large on the screen. Bodies of the same proportions and exponents share what "
			"is "
		"drawn, so that thousands of them stay interactive.",
		((Real, quality, 1,, "Fineness: the surface is drawn with an error of about a pixel divided by this, the wireframe of four. Twice as much "
			"takes "
			"twice the triangles; must be positive."))
		((bool, wire, false,, "Only show wireframe."))
		((bool, stripes, false,, "In non-wire rendering, make every second octant brighter, so that the rotation of round bodies shows (as "
			":yref:`Gl1_Sphere::stripes`)."))
	);
	// clang-format on
};
REGISTER_SERIALIZABLE(Gl1_Superquadric);

} // namespace yade
