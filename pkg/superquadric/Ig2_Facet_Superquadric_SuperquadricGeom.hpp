#pragma once

#include "SuperquadricGeomFunctor.hpp"
#include "FacetNeighbours.hpp"

#include <pkg/common/Facet.hpp>

namespace yade {

class Ig2_Facet_Superquadric_SuperquadricGeom : public SuperquadricGeomFunctor {
public:
	FUNCTOR2D(Facet, Superquadric);
	DEFINE_FUNCTOR_ORDER_2D(Facet, Superquadric);
	void findNeighbours();

	// clang-format off
	YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(Ig2_Facet_Superquadric_SuperquadricGeom, SuperquadricGeomFunctor,
		"Creates/updates a :yref:`SuperquadricGeom` of a :yref:`Facet`, a sheet without thickness that pushes to the side on which the "
		"particle's centre is, and a :yref:`Superquadric`. Facets that share vertices act as one surface: a flat mesh pushes like a :yref:`Wall` "
			"however "
		"it is cut into triangles, a ridge pushes once, a hollow corner from both sides. The facets of the scene are looked through when the number "
			"of bodies has "
		"changed; a mesh may move, as long as its facets move together."
		, , , .def("findNeighbours", &Ig2_Facet_Superquadric_SuperquadricGeom::findNeighbours, "Look again which facets of the scene share vertices: "
			"needed only after facets were "
			"moved onto each other, or replaced by as many others.")
	);
	// clang-format on

protected:
	bool solve(const Shape& shape1, const Shape& shape2, const ContactPair& pair) override;

private:
	bool pushes(const superquadric::Placement& body, const superquadric::MeshFacet& facet, const superquadric::Contact& contact, const Scene& scene,
	        superquadric::SolverCounters& counters);

	FacetNeighbours neighbours;
};
REGISTER_SERIALIZABLE(Ig2_Facet_Superquadric_SuperquadricGeom);

} // namespace yade
