#include "BodyArrays.hpp"

#include <core/Omega.hpp>
#include <lib/high-precision/Constants.hpp>
#include <pkg/common/Facet.hpp>
#include <pkg/common/NormShearPhys.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/common/Wall.hpp>
#include <pkg/dem/ScGeom.hpp>
#include <pkg/mechanics/OctahedralStress.hpp>
#include <pkg/support/Buffers.hpp>
#include <pkg/support/Checks.hpp>
#include <pkg/superquadric/HollowCylinder.hpp>
#include <pkg/superquadric/Superquadric.hpp>

#include <boost/python/stl_iterator.hpp>

#include <algorithm>

namespace yade {

YADE_PLUGIN((BodyArrays));

namespace {
	static_assert(sizeof(Real) == sizeof(double) && sizeof(rows::Particle) == 33 * sizeof(double));
	static_assert(sizeof(rows::Contact) == 18 * sizeof(double) && sizeof(rows::Border) == 18 * sizeof(double));

	template <class Vector> void put(const Vector& from, double* to) { std::copy(from.data(), from.data() + from.size(), to); }

	bool isParticle(const Body& body) { return dynamic_cast<const Sphere*>(body.shape.get()) || dynamic_cast<const Superquadric*>(body.shape.get()); }

	// Into the periodic cell, as YADE's 3D view does it.
	Vector3r shiftIntoCell(const Vector3r& position, const Scene& scene)
	{
		return scene.isPeriodic ? Vector3r(scene.cell->wrapShearedPt(position) - position) : Vector3r(Vector3r::Zero());
	}

	// A real contact, and what is asked of it.
	struct Touch {
		const Interaction* interaction;
		const NormPhys* phys;
		const GenericSpheresContact* geom;

		Vector3r shearForce() const
		{
			const auto* shearing = dynamic_cast<const NormShearPhys*>(phys);
			return shearing ? shearing->shearForce : Vector3r(Vector3r::Zero());
		}
		Real overlap() const
		{
			const auto* sphereLike = dynamic_cast<const ScGeom*>(geom);
			return sphereLike ? sphereLike->penetrationDepth : NaN;
		}
	};

	// Sorted: the scene's own order has a history, and sums would have it in their last digits.
	std::vector<Touch> realContacts(const Scene& scene)
	{
		std::vector<Touch> found;
		for (const auto& interaction : *scene.interactions) {
			if (!interaction || !interaction->isReal()) continue;
			const auto* phys = dynamic_cast<const NormPhys*>(interaction->phys.get());
			const auto* geom = dynamic_cast<const GenericSpheresContact*>(interaction->geom.get());
			if (phys && geom) found.push_back({ interaction.get(), phys, geom });
		}
		const auto ids = [](const Touch& touch) { return std::make_pair(touch.interaction->getId1(), touch.interaction->getId2()); };
		std::sort(found.begin(), found.end(), [&](const Touch& a, const Touch& b) { return ids(a) < ids(b); });
		return found;
	}

	// Where the image of the second body lies that the contact is with.
	Vector3r imagePosition2(const Touch& touch, const Scene& scene)
	{
		const Vector3r position = (*scene.bodies)[touch.interaction->getId2()]->state->pos;
		return scene.isPeriodic ? Vector3r(position + scene.cell->intrShiftPos(touch.interaction->cellDist)) : position;
	}

	// Of all contacts of a body.
	struct Load {
		Matrix3r stressSum = Matrix3r::Zero(); // volume times mean stress [N m]
		std::int64_t pushing = 0;
	};

	std::vector<Load> loads(const Scene& scene)
	{
		std::vector<Load> result(scene.bodies->size());
		for (const Touch& touch : realContacts(scene)) {
			const Vector3r force = touch.phys->normalForce + touch.shearForce(), point = touch.geom->contactPoint;
			const auto id1 = touch.interaction->getId1(), id2 = touch.interaction->getId2();
			result[id1].stressSum -= (point - (*scene.bodies)[id1]->state->pos) * force.transpose();
			result[id2].stressSum += (point - imagePosition2(touch, scene)) * force.transpose();
			if (touch.phys->normalForce.isZero(0)) continue;
			++result[id1].pushing;
			++result[id2].pushing;
		}
		return result;
	}

	void describe(const Shape& shape, rows::Particle& row)
	{
		if (const auto* sphere = dynamic_cast<const Sphere*>(&shape)) {
			row.kind = rows::SphereKind;
			put(Vector3r(Vector3r::Constant(sphere->radius)), row.extents);
			row.exponents[0] = row.exponents[1] = 2;
			row.volume = 4 * Mathr::PI / 3 * std::pow(sphere->radius, 3);
		} else {
			const auto& particle = static_cast<const Superquadric&>(shape);
			row.kind = rows::SuperquadricKind;
			put(particle.getExtents(), row.extents);
			row.exponents[0] = particle.n1;
			row.exponents[1] = particle.n2;
			row.volume = particle.volume();
		}
	}

	rows::Particle particleRow(const Body& body, const Load& load, const Scene& scene)
	{
		rows::Particle row {};
		describe(*body.shape, row);
		const Matrix3r stress = load.stressSum / row.volume;
		row.id = body.getId();
		row.material = body.material ? body.material->id : -1;
		row.contacts = load.pushing;
		put(Vector3r(body.state->pos + shiftIntoCell(body.state->pos, scene)), row.position);
		put(body.state->ori.coeffs(), row.orientation);
		put(body.state->vel, row.velocity);
		put(body.state->angVel, row.spin);
		put(Matrix3r(stress.transpose()), row.stress); // Eigen stores columns
		row.octahedralStress = superquadric::octahedralShearStress(stress);
		return row;
	}

	rows::Contact contactRow(const Touch& touch, const Scene& scene)
	{
		rows::Contact row {};
		row.id1 = touch.interaction->getId1();
		row.id2 = touch.interaction->getId2();
		const Body &body1 = *(*scene.bodies)[row.id1], &body2 = *(*scene.bodies)[row.id2];
		const Vector3r shift = shiftIntoCell(body1.state->pos, scene), point = touch.geom->contactPoint + shift;
		put(point, row.point);
		put(isParticle(body1) ? Vector3r(body1.state->pos + shift) : point, row.centre1);
		put(isParticle(body2) ? Vector3r(imagePosition2(touch, scene) + shift) : point, row.centre2);
		put(touch.phys->normalForce, row.normalForce);
		put(touch.shearForce(), row.shearForce);
		row.overlap = touch.overlap();
		return row;
	}

	// Whether the body is part of a container; then its kind and numbers are put into the row.
	bool describe(const Body& body, rows::Border& row)
	{
		if (const auto* wall = dynamic_cast<const Wall*>(body.shape.get())) {
			row.kind = rows::WallKind;
			row.numbers[0] = wall->axis;
			row.numbers[1] = wall->sense;
		} else if (const auto* cylinder = dynamic_cast<const HollowCylinder*>(body.shape.get())) {
			row.kind = rows::CylinderKind;
			row.numbers[0] = cylinder->radius;
			row.numbers[1] = cylinder->height;
		} else if (const auto* facet = dynamic_cast<const Facet*>(body.shape.get())) {
			row.kind = rows::FacetKind;
			for (std::ptrdiff_t i = 0; i < 3; ++i)
				put(Vector3r(body.state->pos + body.state->ori * facet->vertices[i]), row.numbers + 3 * i);
		} else {
			return false;
		}
		return true;
	}

	const Scene& presentScene() { return *Omega::instance().getScene(); }
}

boost::python::object BodyArrays::particles(const boost::python::object& ids) const
{
	const Scene& scene = presentScene();
	const std::vector<Load> load = loads(scene);
	std::vector<rows::Particle> table;
	const auto add = [&](const Body& body) {
		if (isParticle(body)) table.push_back(particleRow(body, load[body.getId()], scene));
	};
	if (ids.is_none()) {
		for (const auto& body : *scene.bodies)
			if (body) add(*body);
	} else {
		for (boost::python::stl_input_iterator<Body::id_t> id(ids), end; id != end; ++id) {
			if (!scene.bodies->exists(*id)) refuse("ids", "those of bodies in the scene", *id);
			add(*(*scene.bodies)[*id]);
		}
	}
	return bytesOf(table);
}

boost::python::object BodyArrays::contacts() const
{
	const Scene& scene = presentScene();
	std::vector<rows::Contact> table;
	for (const Touch& touch : realContacts(scene))
		table.push_back(contactRow(touch, scene));
	return bytesOf(table);
}

boost::python::object BodyArrays::container() const
{
	const Scene& scene = presentScene();
	std::vector<rows::Border> table;
	for (const auto& body : *scene.bodies) {
		rows::Border row {};
		if (!body || !describe(*body, row)) continue;
		row.id = body->getId();
		put(body->state->pos, row.position);
		put(body->state->ori.coeffs(), row.orientation);
		table.push_back(row);
	}
	return bytesOf(table);
}

} // namespace yade
