#include "Gl1_HollowCylinder.hpp"

#include <GL/gl.h>

namespace yade {

YADE_PLUGIN((Gl1_HollowCylinder));

bool Gl1_HollowCylinder::wire;
int Gl1_HollowCylinder::div;

namespace {

	// The part of the cylinder that is drawn, in the frame of the body.
	struct Tube {
		Real radius, bottom, top;
		int divisions;

		Vector3r inward(int i) const { return { -std::cos(2 * M_PI * i / divisions), -std::sin(2 * M_PI * i / divisions), 0 }; }
		// Of a prism about the cylinder: an inscribed one would cut into particles at the wall.
		Vector3r point(int i, Real z) const { return z * Vector3r::UnitZ() - radius / std::cos(M_PI / divisions) * inward(i); }
	};

	Tube visiblePart(const HollowCylinder& cylinder, const State& state, const GLViewInfo& view, int divisions)
	{
		const Real middle = (view.sceneCenter - state.pos).dot(HollowCylinder::axis(state)), half = cylinder.height / 2;
		const Real bottom = std::max(-half, middle - 2 * view.sceneRadius), top = std::min(half, middle + 2 * view.sceneRadius);
		return { cylinder.radius, std::min(bottom, top), top, std::max(3, divisions) };
	}

	// Counterclockwise from inside: YADE leaves out what is seen from its back.
	void drawInnerSide(const Tube& tube)
	{
		glBegin(GL_QUAD_STRIP);
		for (int i = 0; i <= tube.divisions; ++i) {
			glNormal3dv(tube.inward(i).data());
			glVertex3dv(tube.point(i, tube.bottom).data());
			glVertex3dv(tube.point(i, tube.top).data());
		}
		glEnd();
	}

	void drawRing(const Tube& tube, Real z)
	{
		glBegin(GL_LINE_LOOP);
		for (int i = 0; i < tube.divisions; ++i)
			glVertex3dv(tube.point(i, z).data());
		glEnd();
	}

	// A net of about square meshes.
	void drawNet(const Tube& tube)
	{
		const Real mesh = 2 * M_PI * tube.radius / tube.divisions;
		const int rings = int(std::max<Real>(1, std::min<Real>(1000, std::round((tube.top - tube.bottom) / mesh))));
		for (int i = 1; i < rings; ++i)
			drawRing(tube, tube.bottom + (tube.top - tube.bottom) * i / rings);
		glBegin(GL_LINES);
		for (int i = 0; i < tube.divisions; ++i) {
			glVertex3dv(tube.point(i, tube.bottom).data());
			glVertex3dv(tube.point(i, tube.top).data());
		}
		glEnd();
	}

} // namespace

void Gl1_HollowCylinder::go(const shared_ptr<Shape>& shape, const shared_ptr<State>& state, bool wireAll, const GLViewInfo& view)
{
	const Tube tube = visiblePart(static_cast<const HollowCylinder&>(*shape), *state, view, div);
	const bool wired = wire || wireAll;
	glColor3dv(shape->color.data());
	if (!wired) drawInnerSide(tube);
	// Lines have no side that light could fall on.
	glPushAttrib(GL_ENABLE_BIT);
	glDisable(GL_LIGHTING);
	drawRing(tube, tube.bottom);
	drawRing(tube, tube.top);
	if (wired) drawNet(tube);
	glPopAttrib();
}

} // namespace yade
